#include "study/measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>

#include "dynamics/step.hpp"
#include "geometry/overlap.hpp"
#include "study/exact_judge.hpp"

namespace blocks::study {
namespace {

/// The total energy [F L]: kinetic, potential and spring energy. Velocities belong to
/// half a step before the positions. Heights are taken at that time, so that the energy
/// of free fall is constant.
double total_energy(const Model& model, const Eigen::Matrix2Xd& start) {
  const Settings& s = model.settings;
  const Blocks& blocks = model.blocks;
  double energy = totals(model).kinetic_energy;
  for (int b = 0; b < blocks.size(); ++b)
    energy -= blocks.mass[b] *
              s.gravity.dot(Vec2(blocks.centroid.col(b)) - Vec2(start.col(b)) -
                            0.5 * model.time_step.dt * Vec2(blocks.velocity.col(b)));
  for (const Contact& contact : model.contacts)
    energy +=
        0.5 * contact.normal_elastic * contact.normal_elastic / s.normal_stiffness +
        0.5 * contact.shear_elastic * contact.shear_elastic / s.shear_stiffness;
  for (const PlaneContact& contact : model.plane_contacts)
    energy +=
        0.5 * contact.normal_elastic * contact.normal_elastic / s.normal_stiffness;
  return energy;
}

/// The overlap of two blocks: its area [L^2], and the shortest shift that separates
/// them [L].
struct Shared {
  double area = 0.0, depth = 0.0;
};
using SharedByPair = std::map<std::pair<int, int>, Shared>;

/// The overlaps of all pairs of blocks that are not both fixed.
SharedByPair shared_by_pair(const Blocks& blocks) {
  SharedByPair shared;
  for (const geometry::BlockOverlap& pair : geometry::overlapping_pairs(
           blocks.present_outlines(), {}, geometry::Figures::quick))
    if (blocks.is_free(pair.first) || blocks.is_free(pair.second))
      shared[{pair.first, pair.second}] = {pair.area, pair.depth};
  return shared;
}

/// Whether two blocks overlap by more than the scene allows, so that one has passed
/// through the other. Overlaps at the start do not count.
bool passes_through(const Scene& scene, double scale, const Blocks& blocks,
                    const SharedByPair& at_start) {
  for (const auto& [pair, shared] : shared_by_pair(blocks)) {
    const auto before = at_start.find(pair);
    const Shared then = before == at_start.end() ? Shared() : before->second;
    const double smaller = std::min(blocks.area[pair.first], blocks.area[pair.second]);
    if (shared.area - then.area > scene.max_shared * smaller ||
        shared.depth - then.depth > scene.max_depth * scale)
      return true;
  }
  return false;
}

/// Whether overlaps are measured after step k. This happens `looks` times, evenly
/// spread, the last time at the end.
bool is_checkpoint(long k, long steps, long looks) {
  return (k + 1) % ((steps + looks - 1) / looks) == 0 || k + 1 == steps;
}

/// Measures how far blocks fall behind their expected speed.
class Pace {
 public:
  Pace(const Scene& scene, const Frame& frame) : scene_(scene), frame_(frame) {}

  /// Compares the velocities after step k = 1, 2, ... with the displacements expected
  /// from step k - 1 to k.
  void look(const Model& model, long k) {
    if (!scene_.known_motion)
      return;
    const double dt = model.time_step.dt;
    const Eigen::Matrix2Xd here = scene_.expected(k, dt);
    if (before_.size() == 0)
      before_ = scene_.expected(k - 1, dt);
    for (int b = 0; b < model.blocks.size(); ++b) {
      const Vec2 velocity = Vec2(here.col(b) - before_.col(b)) / dt;
      const double speed = velocity.norm();
      if (speed == 0.0 || !model.blocks.is_free(b))
        continue;
      fastest_ = std::max(fastest_, speed);
      const Vec2 actual = frame_.back(model.blocks.velocity.col(b));
      lost_ = std::max(lost_, speed - velocity.dot(actual) / speed);
    }
    before_ = here;
  }
  /// The largest loss as a share of the fastest expected speed; NaN if none was
  /// expected.
  double lost() const { return fastest_ > 0.0 ? lost_ / fastest_ : not_asked; }

 private:
  const Scene& scene_;
  const Frame& frame_;
  Eigen::Matrix2Xd before_;
  double fastest_ = 0.0, lost_ = 0.0;
};

/// Compares the end of a run with the expected motion, and sets whether a block hung or
/// fell through.
void judge_end(const Scene& scene, const Frame& frame, const Model& model,
               const Eigen::Matrix2Xd& start, long steps, Outcome& outcome) {
  const Eigen::Matrix2Xd expected = scene.expected(steps, model.time_step.dt);
  const double gravity = scene.model.settings.gravity.norm();
  if (!std::isnan(outcome.speed_lost)) {
    outcome.could_hang = true;
    outcome.hung |= outcome.speed_lost > scene.max_lost;
  }
  for (int b = 0; b < model.blocks.size(); ++b) {
    if (!model.blocks.is_free(b))
      continue;
    const Vec2 moved =
        frame.back(Vec2(model.blocks.centroid.col(b)) - Vec2(start.col(b)));
    const Vec2 way = expected.col(b);
    if (way.norm() > scene.min_way * scene.size) {
      outcome.could_hang = true;
      outcome.hung |= !(moved.dot(way) >= scene.min_share * way.squaredNorm());
    }
    if (scene.mean_speed && way.squaredNorm() > 0.0) {
      const double lost = std::abs(1.0 - moved.dot(way) / way.squaredNorm());
      outcome.speed_lost = std::fmax(outcome.speed_lost, lost);
      outcome.could_hang = true;
      outcome.hung |= !(lost <= scene.max_lost);
    }
    if (std::isfinite(scene.max_astray)) {
      outcome.could_hang = true;
      outcome.hung |= !((moved - way).norm() <= scene.max_astray);
    }
    if (gravity > 0.0) {
      const double sunk = scene.model.settings.gravity.dot(moved - way) / gravity;
      outcome.fell_through |= !(sunk <= scene.max_sinking * scene.size);
    }
  }
}

double energy_scale(const Scene& scene) {
  const Blocks& blocks = scene.model.blocks;
  double mass = 0.0;
  for (int b = 0; b < blocks.size(); ++b)
    if (blocks.is_free(b))
      mass += blocks.mass[b];
  return mass * scene.model.settings.gravity.norm() * scene.size +
         totals(scene.model).kinetic_energy;
}

bool keeps_books(const Model& model) {
  return model.settings.rigid && model.loads.forces.empty() &&
         model.loads.pressures.empty();
}

}  // namespace

std::uint64_t hash_acting(const std::vector<Contact>& contacts) {
  std::uint64_t state = 0xCBF29CE484222325ULL;
  for (const Contact& contact : contacts)
    for (const int number : {contact.corner, contact.edge})
      state = (state ^ static_cast<std::uint64_t>(number)) * 0x100000001B3ULL;
  return state;
}

Outcome measure(const Scene& scene, const Frame& frame, const Variant& variant,
                long steps, Trace& trace) {
  Outcome outcome;
  Model model = place(scene.model, frame, variant.corners);
  dynamics::Workspace work;
  const std::unique_ptr<VariantRun> run = variant.start();
  ExactJudge judge;
  dynamics::prepare(model);
  const Eigen::Matrix2Xd start = model.blocks.centroid;
  const double energy_at_start = total_energy(model, start);
  const SharedByPair shared_at_start = shared_by_pair(model.blocks);
  double worst_energy = 0.0;
  Pace pace(scene, frame);
  const bool leads = trace.empty(), follows = variant.corners == Corners::sharp;
  for (long k = 0; k < steps; ++k) {
    run->find(model, work);
    judge.decide(model);
    variant.judge_signs(model.blocks, work.index, outcome.signs);
    const bool finite = run->step(model, work).finite;
    judge.compare(model.blocks, model.contacts, outcome);
    const std::uint64_t hash = hash_acting(model.contacts);
    if (leads)
      trace.push_back(hash);
    else if (follows && outcome.diverged < 0 &&
             trace[static_cast<std::size_t>(k)] != hash)
      outcome.diverged = k + 1;
    pace.look(model, k + 1);
    outcome.speed_lost = pace.lost();
    if (!finite) {
      outcome.fell_through = true;
      outcome.hung = outcome.could_hang = !std::isnan(outcome.speed_lost);
      outcome.energy_error = std::numeric_limits<double>::infinity();
      return outcome;
    }
    const double change = total_energy(model, start) - energy_at_start;
    worst_energy =
        std::max(worst_energy, scene.conservative ? std::abs(change) : change);
    if (is_checkpoint(k, steps, scene.looks))
      outcome.fell_through |=
          passes_through(scene, frame.scale, model.blocks, shared_at_start);
  }
  judge_end(scene, frame, model, start, steps, outcome);
  // Masses are those of the scene, so energies grow with the square of the lengths.
  outcome.energy_error =
      keeps_books(model)
          ? worst_energy / (energy_scale(scene) * frame.scale * frame.scale)
          : not_asked;
  return outcome;
}

std::string set_expectation(Scene& scene, const Variant& variant, long steps) {
  Model model = place(scene.model, Frame{}, variant.corners);
  dynamics::Workspace work;
  const std::unique_ptr<VariantRun> run = variant.start();
  dynamics::prepare(model);
  const Eigen::Matrix2Xd start = model.blocks.centroid;
  const SharedByPair shared_at_start = shared_by_pair(model.blocks);
  const double energy_at_start = total_energy(model, start);
  // An unstable run suddenly gains much energy; a run at rest gains only round-off.
  const double max_gained = keeps_books(model)
                                ? energy_scale(scene)
                                : std::numeric_limits<double>::infinity();
  std::string doubt;
  for (long k = 0; k < steps && doubt.empty(); ++k) {
    run->find(model, work);
    if (!run->step(model, work).finite)
      doubt = fmt::format("is unsound: numbers are not finite after step {}", k + 1);
    else if (total_energy(model, start) - energy_at_start > max_gained &&
             max_gained > 0.0)
      doubt = fmt::format("is unsound: by step {} it has gained more energy than its "
                          "blocks had",
                          k + 1);
    else if (is_checkpoint(k, steps, 50) &&
             passes_through(scene, 1.0, model.blocks, shared_at_start))
      doubt =
          fmt::format("lets two blocks overlap by more than {:g} % of the smaller one "
                      "by step {}",
                      100.0 * scene.max_shared, k + 1);
  }
  const Eigen::Matrix2Xd moved = model.blocks.centroid - start;
  scene.expected = [moved](long, double) { return moved; };
  return doubt;
}

}  // namespace blocks::study
