// Many steps of the 850 blocks of decks/subsidence without output: is every number
// finite, is the energy bounded, do blocks at rest stay where they are?
#include <algorithm>
#include <vector>

#include "validation/long_run/long_run.hpp"

namespace {

using blocks::Blocks;
using blocks::Model;
using blocks::long_run::text;

/// Kinetic energy and that of the weight, per unit thickness.
double energy(const Model& model) {
  const Blocks& b = model.blocks;
  double sum = 0.0;
  for (int k = 0; k < b.size(); ++k)
    sum += 0.5 * (b.mass[k] * b.velocity.col(k).squaredNorm() +
                  b.inertia[k] * b.spin[k] * b.spin[k]) -
           b.mass[k] * model.settings.gravity.dot(b.centroid.col(k));
  return sum;
}

/// How far the centroids of the free blocks moved, the least first.
std::vector<double> moved(const Blocks& b, const Eigen::Matrix2Xd& before) {
  std::vector<double> way;
  for (int k = 0; k < b.size(); ++k)
    if (b.is_free(k))
      way.push_back((b.centroid.col(k) - before.col(k)).norm());
  std::sort(way.begin(), way.end());
  return way;
}

class Soak : public blocks::long_run::Watch {
 public:
  void start(const Model& model) override {
    start_ = energy(model);
    before_ = model.blocks.centroid;
  }

  std::string row(long step, const Model& model,
                  const blocks::dynamics::StepResult&) override {
    const double above = energy(model) - start_;
    highest_ = std::max(highest_, above);
    const auto way = moved(model.blocks, before_);
    before_ = model.blocks.centroid;
    before_last_ = last_;
    highest_way_ = std::max(highest_way_, way.back());
    last_ = way[way.size() * 9 / 10];
    return text("| %ld | %.3f | %.3e | %.1e | %.1e | %.1e | %.2e |\n", step, model.time,
                above, way[way.size() / 2], last_, way.back(), model.worst_overlap);
  }

  blocks::long_run::Verdict verdict(long steps, const Model& model) const override {
    const bool bounded = highest_ <= 0.0;             // falling blocks only lose
    const bool quiet = last_ <= 1e-6 * highest_way_;  // of the way they fell at most
    return {text("%ld steps of %d blocks, %.1f of time: every position finite, energy "
                 "%s what it was at the start, and nine in ten of the blocks moved by "
                 "at most %.1e in the last twentieth (%.1e in the one before).\n",
                 steps, model.blocks.size(), model.time,
                 bounded ? "never above" : "**above**", last_, before_last_),
            bounded && quiet};
  }

 private:
  double start_ = 0.0, highest_ = 0.0, before_last_ = 0.0, last_ = 0.0;
  double highest_way_ = 0.0;
  Eigen::Matrix2Xd before_;
};

}  // namespace

int main(int argc, char** argv) {
  Soak soak;
  return blocks::long_run::run(
      argc, argv,
      {"many steps of a deck: finite, bounded, at rest",
       "decks/subsidence/subsidence.deck", 10000000,
       "Soak: the subsidence deck, on and on",
       "Written by `./go validate soak`; do not edit. Energy is kinetic and of the "
       "weight; ways are those of centroids since the row before.",
       "| step | t | energy above the start | half of the blocks moved less than | "
       "nine in ten | all | largest overlap |",
       "|---|---|---|---|---|---|---|"},
      soak);
}
