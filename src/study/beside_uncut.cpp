#include "study/beside_uncut.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "study/block_run.hpp"
#include "study/free_shift.hpp"

namespace blocks::study {
namespace {

/// Overlaps and motions are compared after so many steps each.
constexpr long steps_between_looks = 10;
/// Motions may differ by the overlap that energy and load explain, and by this part of
/// the way. Bounces on one spring and on two differ by a few per cent of their speed.
constexpr double free_part_of_way = 0.04;
/// They may also differ by this multiple of the difference between runs in one piece.
/// A smaller value finds no more failures in 2,000 frames than one.
constexpr double spread_factor = 2.0;
/// The slack of the depth of a contact, as a part of the overlap that energy and load
/// explain.
constexpr double slack_of_depth = 0.1;

/// A run in one piece that differs from the first one as another number of springs
/// might make it differ.
struct Member {
  bool marked = false;   ///< the joints have left straight corners on the surface
  double springs = 1.0;  ///< so many springs and dashpots instead of one
  Vec2 shift = {0, 0};   ///< of the block at the start, in overlaps
  double turn = 0.0;     ///< of the block at the start: its farthest corner moves so
                         ///< many overlaps
};
const std::array members = {
    Member{true, 1, {0, 0}, 0},     Member{true, 2, {0, 0}, 0},
    Member{false, 0.5, {0, 0}, 0},  Member{false, 2, {0, 0}, 0},
    Member{false, 3, {0, 0}, 0},    Member{false, 1, {0.3, 0}, 0},
    Member{false, 1, {-0.3, 0}, 0}, Member{false, 1, {0, 0.3}, 0},
    Member{false, 1, {0, -0.3}, 0}, Member{false, 1, {0, 0}, 0.3},
    Member{false, 1, {0, 0}, -0.3}};

/// The worst violation of a limit so far.
class Worst {
 public:
  /// Returns whether this value exceeds its limit by a larger factor than before.
  bool is_worse(double value, double limit) {
    if (!(value > factor_ * limit))
      return false;
    factor_ = value / limit;
    return true;
  }
  bool has_failed() const { return !text.empty(); }

  std::string text;  ///< describes it; empty: no limit was exceeded

 private:
  double factor_ = 1.0;
};

/// A run and what is wrong with it by itself.
struct Observed {
  Observed(const Model& start, const Variant& variant, const char* name)
      : run(start, variant), domain(name) {}
  bool has_failed() const { return fall.has_failed() || too_deep.has_failed(); }

  BlockRun run;
  const char* domain;            ///< "cut" or "whole", for messages
  std::vector<BlockPlace> path;  ///< the places of the block at the looks
  Worst fall, too_deep;
};

class Comparison {
 public:
  Comparison(const Scene& scene, const Frame& frame, const Variant& variant)
      : scene_(scene), frame_(frame), variant_(variant),
        cut_(place(scene.model, frame, variant.corners), variant, "cut"),
        whole_(place(scene.uncut->model, frame, variant.corners), variant, "whole"),
        domain_(make_domain(whole_.run.model.blocks.outline(0))),
        arm_(whole_.run.arm()) {
    // Two springs carry a wedge in a notch. They act on the faces of the notch or on
    // those of the wedge. Let a be half the angle between these faces. Each spring has
    // the overlap d sin(a), so the wedge sinks in by d = F / (2 K sin(a)^2) at rest. A
    // fall with the energy E takes it to sqrt(E / K) / sin(a).
    const double sine = std::sin(scene.uncut->sharpest);
    energy_lever_ = std::max(1.0, 0.5 / sine);
    load_lever_ = std::max(1.0, 0.5 / (sine * sine));
    at_start_ = min_shift(whole_.run.outline(), domain_) + gaps();
    // Both runs have the same time step, although the pieces have other masses.
    cut_.run.model.time_step.dt = whole_.run.model.time_step.dt;
    last_ = whole_.run.place();
  }

  Outcome run(long steps, Trace& trace) {
    steps_ = steps;
    const bool leads = trace.empty();
    for (long k = 0; k < steps; ++k) {
      const bool looks = is_look(k);
      if (!step(cut_, k, looks) || !step(whole_, k, looks))
        break;
      note_contacts(k, leads, trace);
      yielded_ = std::max(yielded_, cut_.run.yielding());
      if (looks)
        look();
    }
    // A reference that has failed by itself says nothing about the motion.
    if (must_explain_ && !whole_.has_failed())
      judge_motion();
    return outcome();
  }

 private:
  bool is_look(long k) const {
    return (k + 1) % steps_between_looks == 0 || k + 1 == steps_;
  }
  /// [L] two pieces are shifted against each other by no more than half of this.
  double gaps() const { return 2.0 * scene_.uncut->gap * frame_.scale; }
  /// The overlap that energy and load of a run explain, [L].
  double explained(const BlockRun& run) const {
    return energy_lever_ * run.energy_overlap() + load_lever_ * run.load_overlap() +
           at_start_;
  }
  double in_sizes(double length) const { return length / frame_.scale; }

  /// Makes one step of a run and tests its overlaps. Returns whether all numbers are
  /// finite.
  bool step(Observed& observed, long k, bool looks) {
    const Polygon before = looks ? observed.run.outline() : Polygon();
    if (!observed.run.step()) {
      observed.fall.text = fmt::format("P2: numbers of the {} domain are not finite "
                                       "after step {}",
                                       observed.domain, k + 1);
      return false;
    }
    if (looks) {
      test_fall(observed, k);
      test_contacts(observed, k, before);
    }
    return true;
  }
  /// P2: the block is in the domain by no more than its energy and load explain.
  void test_fall(Observed& observed, long k) const {
    const double depth = min_shift(observed.run.outline(), domain_);
    const double max = explained(observed.run) + yielded_;
    if (observed.fall.is_worse(depth, max))
      observed.fall.text =
          fmt::format("P2: at step {} in the {} domain by {:.3g}, explained {:.3g}",
                      k + 1, observed.domain, in_sizes(depth), in_sizes(max));
  }
  /// P3: no contact is deeper than twice the shift that frees the block. `before` is
  /// the outline of the block at which the contacts were decided.
  void test_contacts(Observed& observed, long k, const Polygon& before) const {
    const BlockRun& run = observed.run;
    const double slack = slack_of_depth * (run.load_overlap() + run.energy_overlap()) +
                         gaps() + 2.0 * yielded_;
    const double depth = run.deepest_contact();
    if (depth <= slack)
      return;
    const double shift = max_shift(before, domain_);
    if (observed.too_deep.is_worse(depth, 2.0 * shift + slack))
      observed.too_deep.text = fmt::format(
          "P3: at step {} in the {} domain a contact {:.3g} deep, but a shift of "
          "{:.3g} frees the block",
          k + 1, observed.domain, in_sizes(depth), in_sizes(shift));
  }
  void note_contacts(long k, bool leads, Trace& trace) {
    const std::uint64_t hash = hash_acting(cut_.run.model.contacts);
    if (leads)
      trace.push_back(hash);
    else if (variant_.corners == Corners::sharp && diverged_ < 0 &&
             static_cast<std::size_t>(k) < trace.size() &&
             trace[static_cast<std::size_t>(k)] != hash)
      diverged_ = k + 1;
  }
  /// Keeps the places of both blocks, and how far they may be apart at least.
  void look() {
    const BlockPlace here = whole_.run.place();
    cut_.path.push_back(cut_.run.place());
    whole_.path.push_back(here);
    way_ += distance_apart(here, last_, arm_);
    last_ = here;
    free_.push_back(explained(whole_.run) + free_part_of_way * way_ + 2.0 * yielded_);
    must_explain_ |= distance_apart(cut_.path.back(), here, arm_) > free_.back();
  }
  /// The path of a run in one piece over the looks of the first one, without the shift
  /// and the turn of its start.
  std::vector<BlockPlace> path_of(const Member& member) const {
    const UncutScene& uncut = *scene_.uncut;
    const double overlap = whole_.run.energy_overlap() + whole_.run.load_overlap();
    const Vec2 shift = overlap * member.shift;
    const double turn = overlap * member.turn / arm_;
    Model start =
        place(member.marked ? uncut.marked : uncut.model, frame_, variant_.corners);
    disturb_last_block(start.blocks, shift, turn);
    start.settings.normal_stiffness *= member.springs;
    start.settings.shear_stiffness *= member.springs;
    // The dashpots grow with the root of the stiffness.
    start.settings.damping *= std::sqrt(member.springs);
    BlockRun run(start, variant_);
    run.model.time_step.dt = whole_.run.model.time_step.dt;
    std::vector<BlockPlace> path;
    for (long k = 0; path.size() < cut_.path.size() && run.step(); ++k)
      if (is_look(k)) {
        const BlockPlace here = run.place();
        path.push_back({here.centroid - shift, here.angle});
      }
    return path;
  }
  /// P1: the motions agree. They differ by more than the overlap and a part of the way,
  /// so runs in one piece show how much another number of springs explains.
  void judge_motion() {
    std::vector<double> spread(cut_.path.size(), 0.0), nearest;
    for (std::size_t i = 0; i < cut_.path.size(); ++i)
      nearest.push_back(distance_apart(cut_.path[i], whole_.path[i], arm_));
    for (const Member& member : members) {
      const std::vector<BlockPlace> path = path_of(member);
      for (std::size_t i = 0; i < path.size(); ++i) {
        spread[i] = std::max(spread[i], distance_apart(path[i], whole_.path[i], arm_));
        nearest[i] = std::min(nearest[i], distance_apart(path[i], cut_.path[i], arm_));
      }
    }
    double widest = 0.0;
    for (std::size_t i = 0; i < cut_.path.size(); ++i) {
      widest = std::max(widest, spread[i]);
      const double max = free_[i] + spread_factor * widest;
      if (difference_.is_worse(nearest[i], max))
        difference_.text = fmt::format(
            "P1: at step {} {:.3g} apart, explained {:.3g}",
            std::min(steps_, static_cast<long>(i + 1) * steps_between_looks),
            in_sizes(nearest[i]), in_sizes(max));
    }
  }
  Outcome outcome() const {
    Outcome outcome;
    outcome.could_hang = true;
    outcome.hung = difference_.has_failed();
    outcome.fell_through = cut_.fall.has_failed() || whole_.fall.has_failed();
    outcome.deep = cut_.too_deep.has_failed() || whole_.too_deep.has_failed();
    outcome.diverged = diverged_;
    outcome.energy_error = not_asked;
    for (const Worst* worst :
         {&difference_, &cut_.fall, &whole_.fall, &cut_.too_deep, &whole_.too_deep})
      if (worst->has_failed())
        outcome.why += (outcome.why.empty() ? "" : "; ") + worst->text;
    return outcome;
  }

  const Scene& scene_;
  const Frame& frame_;
  const Variant& variant_;
  Observed cut_, whole_;
  Domain domain_;
  double arm_ = 0.0, energy_lever_ = 1.0, load_lever_ = 1.0;
  double at_start_ = 0.0;  ///< [L] overlap at the start and gaps of the pieces
  long steps_ = 0, diverged_ = -1;
  BlockPlace last_;            ///< of the block in one piece, at the last look
  double way_ = 0.0;           ///< [L] of the block in one piece
  double yielded_ = 0.0;       ///< [L] how far bonded pieces have moved at most
  std::vector<double> free_;   ///< [L] how far both may be apart at least, at each look
  bool must_explain_ = false;  ///< they are farther apart at one of the looks
  Worst difference_;
};

}  // namespace

Outcome measure_beside_uncut(const Scene& scene, const Frame& frame,
                             const Variant& variant, long steps, Trace& trace) {
  return Comparison(scene, frame, variant).run(steps, trace);
}

}  // namespace blocks::study
