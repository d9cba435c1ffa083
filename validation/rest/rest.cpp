// Does a wall at rest stay at rest? Runs many steps of a deck without output and
// reports the kinetic energy and the movement of the corners.
#include <algorithm>
#include <cmath>

#include "validation/long_run/long_run.hpp"

namespace {

using blocks::Model;
using blocks::long_run::format_text;

double kinetic_energy(const blocks::Blocks& b) {
  double energy = 0.0;
  for (int k = 0; k < b.size(); ++k)
    energy += 0.5 * (b.mass[k] * b.velocity.col(k).squaredNorm() +
                     b.inertia[k] * b.spin[k] * b.spin[k]);
  return energy;
}

/// The energy of all acting springs if each is compressed by the rounding error of the
/// largest coordinate, u |x|. A smaller kinetic energy cannot be distinguished from
/// rest.
double energy_of_rounding(const Model& model) {
  const double rounding = 0x1p-53 * model.blocks.corner.cwiseAbs().maxCoeff();
  return 0.5 * model.settings.normal_stiffness * rounding * rounding *
         static_cast<double>(model.contacts.size());
}

class Rest : public blocks::long_run::Observer {
 public:
  void start(const Model& model) override { before_ = model.blocks.corner; }

  std::string make_row(long step, const Model& model,
                       const blocks::dynamics::StepResult& result) override {
    energy_ = kinetic_energy(model.blocks);
    rounding_ = energy_of_rounding(model);
    drift_ = (model.blocks.corner - before_).colwise().norm().maxCoeff();
    before_ = model.blocks.corner;
    return format_text("| %ld | %.2e | %.1e | %.1e | %.1e | %ld | %ld |\n", step,
                       energy_, rounding_, result.largest, drift_,
                       model.contacts.size(), model.search.updates);
  }

  blocks::long_run::Verdict judge(long steps, const Model&) const override {
    const bool quiet = energy_ <= rounding_;
    return {
        format_text("At the end the kinetic energy is %.2e, %s the energy of rounding "
                    "%.1e; the corners moved by up to %.1e in the last %ld steps.\n",
                    energy_, quiet ? "at most" : "above", rounding_, drift_,
                    steps / blocks::long_run::row_count),
        quiet};
  }

 private:
  Eigen::Matrix2Xd before_;
  double energy_ = 0.0, rounding_ = 0.0, drift_ = 0.0;
};

}  // namespace

int main(int argc, char** argv) {
  Rest rest;
  return blocks::long_run::run(
      argc, argv,
      {"a deck at rest: kinetic energy and drift over many steps",
       "validation/rest/wall.deck", 1000000, "A wall of 1,000 bricks at rest",
       "Written by `./go validate rest`; do not edit. What the columns mean: "
       "README.md.",
       "| step | kinetic energy | of rounding | largest movement in a step | moved "
       "since the last row | acting | searches |",
       "|---|---|---|---|---|---|---|"},
      rest);
}
