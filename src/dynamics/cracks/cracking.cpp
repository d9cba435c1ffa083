#include "dynamics/cracks/cracking.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numeric>
#include <utility>

#include "dynamics/cracks/contact_loads.hpp"
#include "dynamics/cracks/crack_rules.hpp"
#include "dynamics/cracks/pieces.hpp"
#include "dynamics/energy/block_energy.hpp"
#include "dynamics/energy/energy.hpp"
#include "dynamics/preparation/time_step.hpp"
#include "dynamics/step.hpp"
#include "model/numbering.hpp"
#include "model/splitting.hpp"

namespace blocks::dynamics {
namespace {

/// A crossing moves to a corner that is nearer than this part of the square root of
/// amin; shorter chords between point loads do not count.
constexpr double near_part = 0.05;

double near_distance(const CrackRule& rule) {
  return near_part * std::sqrt(rule.min_area);
}

/// The rules by block, looked up only when the material changes.
class RulesOfBlocks {
 public:
  explicit RulesOfBlocks(const Settings& settings) : rules_(settings.crack_rules) {}
  const CrackRule* of(const Blocks& blocks, int b) {
    if (blocks.material[b] != material_) {
      material_ = blocks.material[b];
      const auto found = rules_.find(material_);
      rule_ = found == rules_.end() ? nullptr : &found->second;
    }
    return blocks.is_free(b) ? rule_ : nullptr;
  }

 private:
  const std::map<int, CrackRule>& rules_;
  int material_ = 0;
  const CrackRule* rule_ = nullptr;
};

/// Returns whether a piece would certainly be too small, so that blocks that cannot
/// split cost no exact cut in every step. A piece on one side of the line is at most as
/// large as all of the block there; corners that crossings move to change that area by
/// at most the length of the chord times `near`.
bool is_certainly_small(const Blocks& blocks, int b, const geometry::SplitLine& line,
                        double min_area) {
  if (!blocks.convex[b])
    return false;  // a piece may lie on both sides of the line
  const Vec2 along = line.along.normalized();
  double left = 0.0, right = 0.0, size = 0.0;
  for (int c = blocks.first_corner[b]; c < blocks.first_corner[b + 1]; ++c) {
    const Vec2 p = Vec2(blocks.corner.col(c)) - line.point;
    const Vec2 q = Vec2(blocks.corner.col(blocks.next[c])) - line.point;
    const double u = geometry::cross(along, p), v = geometry::cross(along, q);
    // Areas under the side, from the line; clockwise outlines have them positive on the
    // left.
    const double s = along.dot(p), t = along.dot(q);
    size = std::max(size, p.norm());
    const double cut = (u < 0.0) != (v < 0.0) ? s + (t - s) * (u / (u - v)) : t;
    const double first = 0.5 * (cut - s) * ((u < 0.0) == (v < 0.0) ? u + v : u);
    const double second = 0.5 * (t - cut) * v;
    (u < 0.0 ? right : left) += first;
    (v < 0.0 ? right : left) += second;
  }
  const double allowance = 2.0 * line.near * 2.0 * size + 1e-9 * size * size;
  return std::min(std::abs(left), std::abs(right)) + allowance < min_area;
}

/// Returns whether both ends of a chord have moved to one side of an outline with n
/// corners, so that there is nothing left to split.
bool lies_on_side(const std::array<geometry::ChordEnd, 2>& ends, int n) {
  const auto [first, second] = ends;
  if (first.corner < 0 && second.corner < 0)
    return false;
  if (first.corner >= 0 && second.corner >= 0) {
    const int apart = std::abs(first.corner - second.corner);
    return apart <= 1 || apart == n - 1;
  }
  const int corner = std::max(first.corner, second.corner);
  const int side = std::max(first.side, second.side);
  return side == corner || (side + 1) % n == corner;
}

/// Returns whether the chord that was cut runs from one point load to the other. In a
/// block that is not convex, the line between them may leave the block.
bool joins_loads(const std::array<geometry::ChordEnd, 2>& ends,
                 const CrackDemand& demand, double tolerance) {
  const double length = (ends[1].place - ends[0].place).norm();
  return std::abs(length - demand.line.along.norm()) <= 2.0 * tolerance;
}

/// Collects the splits of one call.
class Cracking {
 public:
  Cracking(Model& model, const std::vector<int>& numbers)
      : model_(model), numbers_(numbers), rules_(model.settings) {}

  /// Tries the cracks that the rules demand in block b.
  void crack(int b, const std::vector<PointLoad>& loads) {
    const CrackRule& rule = *rules_.of(model_.blocks, b);
    if (const auto demand =
            crack_by_stress(model_.blocks, b, model_.settings.rigid, rule))
      if (tries(b, rule, *demand))
        return;
    for (const CrackDemand& demand :
         cracks_by_point_loads(loads, near_distance(rule), rule))
      if (tries(b, rule, demand))
        return;
  }

  int cracks() const { return static_cast<int>(splits_.size()); }

  /// Replaces the blocks by their pieces and completes the records. Returns whether
  /// each block is a piece now.
  std::vector<char> finish() {
    const int old = model_.blocks.size();
    split_blocks(model_, splits_);
    std::vector<char> is_piece(static_cast<std::size_t>(model_.blocks.size()), 0);
    std::fill(is_piece.begin() + old, is_piece.end(), 1);
    for (std::size_t i = 0; i < splits_.size(); ++i) {
      const BlockEnergy first = energy_of(model_, splits_[i].block);
      const BlockEnergy second = energy_of(model_, old + static_cast<int>(i));
      records_[i].kinetic_after = first.kinetic + second.kinetic;
      records_[i].strain_after = first.strain + second.strain;
      is_piece[static_cast<std::size_t>(splits_[i].block)] = 1;
    }
    model_.cracks.insert(model_.cracks.end(), records_.begin(), records_.end());
    return is_piece;
  }

 private:
  int number(int b) const { return number_in_deck(numbers_, b); }

  bool refuse(int b, CrackRefusal why) {
    refuse_crack(model_.crack_refusals, {number(b), why});
    return false;
  }

  /// Cuts the block if that gives two acceptable pieces. Returns whether it does.
  bool tries(int b, const CrackRule& rule, const CrackDemand& demand) {
    const Blocks& blocks = model_.blocks;
    const Settings& settings = model_.settings;
    if (blocks.size() + static_cast<int>(splits_.size()) >= settings.max_blocks)
      return refuse(b, CrackRefusal::full);
    geometry::SplitLine line = demand.line;
    line.near = near_distance(rule);
    if (is_certainly_small(blocks, b, line, rule.min_area))
      return refuse(b, CrackRefusal::small);
    geometry::Split cut =
        geometry::split_outline(blocks.outline(b), line, rule.min_area);
    switch (cut.fault) {
    case geometry::SplitFault::none:
      break;
    case geometry::SplitFault::no_chord:
      return false;
    case geometry::SplitFault::small:
      return refuse(b, CrackRefusal::small);
    case geometry::SplitFault::unsound:
      return !lies_on_side(cut.ends, blocks.corners_of(b)) &&
             refuse(b, CrackRefusal::unsound);
    }
    if (demand.cause == CrackCause::point_loads && !blocks.convex[b] &&
        !joins_loads(cut.ends, demand, line.near + settings.contact_tolerance))
      return false;
    for (const geometry::SplitPiece& piece : cut.pieces)
      if (static_cast<int>(piece.outline.size()) > settings.max_corners)
        return refuse(b, CrackRefusal::corners);
    BlockSplit split = pieces_of(blocks, b, std::move(cut));
    if (!settings.rigid)
      for (const Piece& piece : split.pieces)
        if (thickness_of(piece) < min_thickness_of_pieces(rule.min_area))
          return refuse(b, CrackRefusal::thin);
    split.joint = rule.joint;
    record(b, demand, split);
    splits_.push_back(std::move(split));
    return true;
  }

  static double thickness_of(const Piece& piece) {
    const Eigen::Vector4d& moment = piece.second_moment;
    return thickness({moment[0], moment[1], moment[3]}, piece.mass);
  }

  void record(int b, const CrackDemand& demand, const BlockSplit& split) {
    const BlockEnergy before = energy_of(model_, b);
    CrackRecord made;
    made.step = model_.steps;
    made.time = model_.time;
    made.parent = number(b);
    made.child = model_.blocks.size() + static_cast<int>(splits_.size());
    made.cause = demand.cause;
    made.stress = demand.stress;
    made.from = split.ends[0].place, made.to = split.ends[1].place;
    made.moved = std::max(split.ends[0].moved, split.ends[1].moved);
    made.parent_area = split.pieces[0].shape.area;
    made.child_area = split.pieces[1].shape.area;
    made.kinetic_before = before.kinetic;
    made.strain_before = before.strain;
    records_.push_back(made);
  }

  Model& model_;
  const std::vector<int>& numbers_;
  RulesOfBlocks rules_;
  std::vector<BlockSplit> splits_;
  std::vector<CrackRecord> records_;
};

/// Gives the corners in the arrays the numbers that they have after cracks. Contacts of
/// blocks that have split lose them. old: the first corner of each block before, and
/// the number of corners.
void follow_pieces(const Blocks& blocks, const std::vector<int>& old, Workspace& work) {
  const auto old_blocks = static_cast<int>(old.size()) - 1;
  std::vector<int> new_of(static_cast<std::size_t>(old.back()), -1);
  for (int b = 0; b < old_blocks; ++b)
    if (work.changed_blocks[static_cast<std::size_t>(b)] == 0)
      std::iota(new_of.begin() + old[b], new_of.begin() + old[b + 1],
                blocks.first_corner[b]);
  work.contacts.renumber_corners(new_of);
}

/// Returns the blocks whose strength is reached by stress, or that have point loads.
std::vector<int> find_candidates(const Model& model, const ContactLoads& loads) {
  const Blocks& blocks = model.blocks;
  const Eigen::Matrix4Xd& stress =
      model.settings.rigid ? blocks.applied : blocks.stress;
  RulesOfBlocks rules(model.settings);
  std::vector<int> found;
  for (int b = 0; b < blocks.size(); ++b)
    if (const CrackRule* const rule = rules.of(blocks, b))
      if (loads.may_crack(b) || largest_principal(stress.col(b)) >= rule->strength)
        found.push_back(b);
  return found;
}

}  // namespace

bool needs_contact_forces(const Settings& settings) {
  return may_crack(settings) &&
         (settings.rigid ||
          std::any_of(
              settings.crack_rules.begin(), settings.crack_rules.end(),
              [](const auto& rule) { return rule.second.point_strength > 0.0; }));
}

int crack_blocks(Model& model, Workspace& work, const std::vector<int>& numbers,
                 const std::function<void()>& before_split) {
  if (!may_crack(model.settings))
    return 0;
  const Profile::Timer timer(work.profile, Profile::motion);
  const ContactLoads loads(model, near_part);
  std::vector<int> candidates = find_candidates(model, loads);
  if (!numbers.empty())
    std::sort(candidates.begin(), candidates.end(),
              [&](int l, int r) { return numbers[l] < numbers[r]; });
  Cracking cracking(model, numbers);
  for (const int b : candidates)
    cracking.crack(b, loads.of(b));
  if (cracking.cracks() == 0)
    return 0;
  catch_up(model, work);
  if (before_split)
    before_split();
  const std::vector<int> first_corners(model.blocks.first_corner.begin(),
                                       model.blocks.first_corner.end());
  work.changed_blocks = cracking.finish();
  if (work.springs.arrays_are_current()) {
    follow_pieces(model.blocks, first_corners, work);
    work.springs.blocks_split();
  } else {
    work.springs.list_changed();
  }
  if (model.energy.kept)
    count_cracks(model, *work.workers, work.energy);
  return cracking.cracks();
}

}  // namespace blocks::dynamics
