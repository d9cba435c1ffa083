#include "model/piece_map.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>

namespace blocks {

PieceMap::PieceMap(const Blocks& blocks, const std::vector<BlockSplit>& splits)
    : old_(blocks), splits_(splits),
      split_of_(static_cast<std::size_t>(blocks.size()), -1), first_corner_(1, 0) {
  const auto add = [&](std::size_t corners) {
    first_corner_.push_back(first_corner_.back() + static_cast<int>(corners));
  };
  for (std::size_t i = 0; i < splits.size(); ++i)
    split_of_[static_cast<std::size_t>(splits[i].block)] = static_cast<int>(i);
  for (int b = 0; b < blocks.size(); ++b) {
    const Piece* const own = piece(b);
    add(own == nullptr ? static_cast<std::size_t>(blocks.corners_of(b))
                       : own->shape.outline.size());
  }
  for (const BlockSplit& split : splits)
    add(split.pieces[1].shape.outline.size());
}

const BlockSplit* PieceMap::split(int block) const {
  const int split = split_of_[static_cast<std::size_t>(block)];
  return split < 0 ? nullptr : &splits_[static_cast<std::size_t>(split)];
}

const Piece* PieceMap::piece(int block) const {
  const int olds = static_cast<int>(split_of_.size());
  if (block >= olds)
    return &splits_[static_cast<std::size_t>(block - olds)].pieces[1];
  const BlockSplit* const its = split(block);
  return its == nullptr ? nullptr : &its->pieces[0];
}

int PieceMap::parent(int block) const {
  const int olds = static_cast<int>(split_of_.size());
  return block < olds ? block : splits_[static_cast<std::size_t>(block - olds)].block;
}

int PieceMap::joint_of_chord(int block) const { return split(parent(block))->joint; }

int PieceMap::number(int block, int piece) const {
  return piece == 0 ? block
                    : static_cast<int>(split_of_.size()) +
                          split_of_[static_cast<std::size_t>(block)];
}

int PieceMap::corner(int old) const {
  const int b = old_.corner_block[static_cast<std::size_t>(old)];
  const int local = old - old_.first_corner[static_cast<std::size_t>(b)];
  const BlockSplit* const its = split(b);
  if (its == nullptr)
    return first_corner(b) + local;
  for (int p = 0; p < 2; ++p) {
    const std::vector<int>& corners =
        its->pieces[static_cast<std::size_t>(p)].shape.corner;
    const auto at = std::find(corners.begin(), corners.end(), local);
    if (at != corners.end())
      return first_corner(number(b, p)) + static_cast<int>(at - corners.begin());
  }
  return -1;  // every corner is one of a piece
}

int PieceMap::edge(int old, const Vec2& point) const {
  const int b = old_.corner_block[static_cast<std::size_t>(old)];
  const std::vector<SidePart> parts =
      parts_of_side(b, old - old_.first_corner[static_cast<std::size_t>(b)]);
  const auto number_of = [&](const SidePart& part) {
    return first_corner(part.block) + part.side;
  };
  if (parts.size() == 1)
    return number_of(parts.front());
  const Vec2 from = old_.corner.col(old);
  const Vec2 along = old_.corner.col(old_.next[static_cast<std::size_t>(old)]) - from;
  const double share = (point - from).dot(along) / along.squaredNorm();
  return number_of(share < parts.front().end ? parts.front() : parts.back());
}

std::vector<PieceMap::SidePart> PieceMap::parts_of_side(int block, int side) const {
  const BlockSplit* const its = split(block);
  if (its == nullptr)
    return {{block, side, 0.0, 1.0}};
  double cut = 1.0;
  for (const geometry::ChordEnd& end : its->ends)
    if (end.side == side)
      cut = end.part;
  std::vector<SidePart> parts;
  for (int p = 0; p < 2; ++p) {
    const geometry::SplitPiece& shape = its->pieces[static_cast<std::size_t>(p)].shape;
    for (std::size_t i = 0; i < shape.side.size(); ++i)
      if (shape.side[i] == side) {
        const bool begins = shape.corner[i] == side;
        parts.push_back({number(block, p), static_cast<int>(i), begins ? 0.0 : cut,
                         begins ? cut : 1.0});
      }
  }
  std::sort(parts.begin(), parts.end(),
            [](const SidePart& l, const SidePart& r) { return l.begin < r.begin; });
  return parts;
}

namespace {

/// Puts the items into a new order. order: old index of each item.
template <class Items> void reorder(Items& items, const std::vector<int>& order) {
  if (items.size() == 0)
    return;
  Items moved = items;
  for (std::size_t i = 0; i < order.size(); ++i)
    moved[i] = items[static_cast<std::size_t>(order[i])];
  std::swap(items, moved);
}

std::vector<int> numbers_to(std::size_t count) {
  std::vector<int> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

/// The block of each corner after the splits.
std::vector<int> blocks_of_corners(const PieceMap& map) {
  std::vector<int> block;
  block.reserve(static_cast<std::size_t>(map.corners()));
  for (int b = 0; b < map.blocks(); ++b)
    block.resize(static_cast<std::size_t>(map.first_corner(b + 1)), b);
  return block;
}

void move_plane_contacts(std::vector<PlaneContact>& list, const PieceMap& map) {
  for (PlaneContact& contact : list)
    contact.corner = map.corner(contact.corner);
  std::sort(list.begin(), list.end(), [](const PlaneContact& l, const PlaneContact& r) {
    return std::pair(l.plane, l.corner) < std::pair(r.plane, r.corner);
  });
}

}  // namespace

void move_contacts(Model& model, const PieceMap& map) {
  for (Contact& contact : model.contacts) {
    // The edge first: its foot is that of the old corner.
    contact.edge = map.edge(contact.edge, model.blocks.corner.col(contact.corner));
    contact.corner = map.corner(contact.corner);
  }
  const std::vector<int> block = blocks_of_corners(map);
  const auto key = [&](int i) {
    const Contact& contact = model.contacts[static_cast<std::size_t>(i)];
    const auto [low, high] =
        std::minmax(block[static_cast<std::size_t>(contact.corner)],
                    block[static_cast<std::size_t>(contact.edge)]);
    return std::tuple(low, high, contact.corner, contact.edge);
  };
  std::vector<int> order = numbers_to(model.contacts.size());
  std::sort(order.begin(), order.end(), [&](int l, int r) { return key(l) < key(r); });
  reorder(model.contacts, order);
  reorder(model.law_states, order);
  move_plane_contacts(model.plane_contacts, map);
}

namespace {

/// The parts of a traction that changes linearly along a side. The forces of the whole
/// side at its two corners are f1 and f2; the result are those of the part from share
/// `begin` to share `end`.
std::array<Vec2, 2> part_of_traction(const Vec2& f1, const Vec2& f2, double begin,
                                     double end) {
  const Vec2 first = 4.0 * f1 - 2.0 * f2, last = 4.0 * f2 - 2.0 * f1;
  const Vec2 q1 = first + begin * (last - first), q2 = first + end * (last - first);
  const double length = end - begin;
  return {(length / 6.0) * (2.0 * q1 + q2), (length / 6.0) * (q1 + 2.0 * q2)};
}

}  // namespace

void move_loads(Loads& loads, const Blocks& blocks, const PieceMap& map) {
  std::vector<Pressure> pressures;
  for (const Pressure& whole : loads.pressures)
    for (const auto& part : map.parts_of_side(whole.block, whole.side)) {
      const double change = whole.p2 - whole.p1;
      pressures.push_back({part.block, part.side,
                           part.begin > 0.0 ? whole.p1 + part.begin * change : whole.p1,
                           part.end < 1.0 ? whole.p1 + part.end * change : whole.p2,
                           whole.arrival});
    }
  loads.pressures.swap(pressures);

  std::vector<CentroidForce> forces;
  for (const CentroidForce& whole : loads.forces) {
    const BlockSplit* const split = map.split(whole.block);
    forces.push_back(whole);
    if (split == nullptr)
      continue;
    Vec2& stays = forces.back().force;
    stays = split->pieces[0].mass / blocks.mass[whole.block] * whole.force;
    forces.push_back(
        {map.number(whole.block, 1), Vec2(whole.force - stays), whole.arrival});
  }
  loads.forces.swap(forces);

  std::vector<QuietSide> quiet_sides;
  for (const QuietSide& whole : loads.quiet_sides)
    for (const auto& part : map.parts_of_side(whole.block, whole.side)) {
      quiet_sides.push_back(
          {part.block, part.side, whole.cp, whole.cs, whole.first, whole.second});
      if (part.begin == 0.0 && part.end == 1.0)
        continue;
      const auto [first, second] =
          part_of_traction(whole.first, whole.second, part.begin, part.end);
      quiet_sides.back().first = first, quiet_sides.back().second = second;
    }
  loads.quiet_sides.swap(quiet_sides);
}

}  // namespace blocks
