// Runs many steps of the 850 blocks of decks/subsidence without output. Is every number
// finite, is the energy bounded, and do blocks at rest remain at rest?
#include <algorithm>
#include <vector>

#include "validation/long_run/long_run.hpp"

namespace {

using blocks::Blocks;
using blocks::Model;
using blocks::long_run::format_text;

/// Kinetic and gravitational energy per unit thickness.
double energy(const Model& model) {
  const Blocks& b = model.blocks;
  double sum = 0.0;
  for (int k = 0; k < b.size(); ++k)
    sum += 0.5 * (b.mass[k] * b.velocity.col(k).squaredNorm() +
                  b.inertia[k] * b.spin[k] * b.spin[k]) -
           b.mass[k] * model.settings.gravity.dot(b.centroid.col(k));
  return sum;
}

/// Returns the distances that the centroids of the free blocks moved, in ascending
/// order.
std::vector<double> distances_moved(const Blocks& b, const Eigen::Matrix2Xd& before) {
  std::vector<double> distance;
  for (int k = 0; k < b.size(); ++k)
    if (b.is_free(k))
      distance.push_back((b.centroid.col(k) - before.col(k)).norm());
  std::sort(distance.begin(), distance.end());
  return distance;
}

class Soak : public blocks::long_run::Observer {
 public:
  void start(const Model& model) override {
    start_ = energy(model);
    before_ = model.blocks.centroid;
  }

  std::string make_row(long step, const Model& model,
                       const blocks::dynamics::StepResult&) override {
    const double above = energy(model) - start_;
    highest_ = std::max(highest_, above);
    const auto distance = distances_moved(model.blocks, before_);
    before_ = model.blocks.centroid;
    before_last_ = last_;
    largest_distance_ = std::max(largest_distance_, distance.back());
    last_ = distance[distance.size() * 9 / 10];
    return format_text("| %ld | %.3f | %.3e | %.1e | %.1e | %.1e | %.2e |\n", step,
                       model.time, above, distance[distance.size() / 2], last_,
                       distance.back(), model.worst_overlap);
  }

  blocks::long_run::Verdict judge(long steps, const Model& model) const override {
    const bool bounded = highest_ <= 0.0;  // Falling blocks only lose energy.
    const bool quiet = last_ <= 1e-6 * largest_distance_;  // Compared with their fall.
    return {format_text(
                "%ld steps of %d blocks, %.1f of time: every position finite, energy "
                "%s what it was at the start, and nine in ten of the blocks moved by "
                "at most %.1e in the last twentieth (%.1e in the one before).\n",
                steps, model.blocks.size(), model.time,
                bounded ? "never above" : "**above**", last_, before_last_),
            bounded && quiet};
  }

 private:
  double start_ = 0.0, highest_ = 0.0, before_last_ = 0.0, last_ = 0.0;
  double largest_distance_ = 0.0;
  Eigen::Matrix2Xd before_;
};

}  // namespace

int main(int argc, char** argv) {
  Soak soak;
  return blocks::long_run::run(
      argc, argv,
      {"many steps of a deck: finite, bounded, at rest",
       "decks/subsidence/subsidence.deck", 10000000,
       "Soak: many steps of the subsidence deck",
       "Written by `./go validate soak`; do not edit. Energy is kinetic and "
       "gravitational. Movements are those of centroids since the previous row.",
       "| step | t | energy above the start | half of the blocks moved less than | "
       "nine in ten | all | largest overlap |",
       "|---|---|---|---|---|---|---|"},
      soak);
}
