#include "model/numbering.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

namespace blocks {
namespace {

double median_area(const Blocks& blocks) {
  std::vector<double> areas(blocks.area.begin(), blocks.area.end());
  const auto middle = areas.begin() + static_cast<std::ptrdiff_t>(areas.size() / 2);
  std::nth_element(areas.begin(), middle, areas.end());
  return *middle;
}

/// Returns the length of the path from centroid to centroid in this order, [L].
double way(const Blocks& blocks, const std::vector<int>& order) {
  double sum = 0.0;
  for (std::size_t i = 1; i < order.size(); ++i)
    sum += (blocks.centroid.col(order[i]) - blocks.centroid.col(order[i - 1])).norm();
  return sum;
}

/// Returns the drives or servos of the new blocks, in their order.
template <class Drive>
std::vector<Drive> sorted(std::vector<Drive> all, const std::vector<int>& new_of) {
  for (Drive& one : all)
    one.block = new_of[one.block];
  std::sort(all.begin(), all.end(),
            [](const Drive& l, const Drive& r) { return l.block < r.block; });
  return all;
}

}  // namespace

std::vector<int> strip_order(const Blocks& blocks) {
  if (blocks.size() == 0)
    return {};
  const Vec2 size =
      blocks.centroid.rowwise().maxCoeff() - blocks.centroid.rowwise().minCoeff();
  const int across = size.x() >= size.y() ? 0 : 1;
  const double width = 1.5 * std::sqrt(median_area(blocks));
  // strip, position along it, block
  std::vector<std::tuple<double, double, int>> places;
  places.reserve(blocks.size());
  for (int b = 0; b < blocks.size(); ++b)
    places.emplace_back(std::floor(blocks.centroid(across, b) / width),
                        blocks.centroid(1 - across, b), b);
  std::sort(places.begin(), places.end());
  std::vector<int> order;
  order.reserve(blocks.size());
  for (const auto& [strip, along, b] : places)
    order.push_back(b);
  return order;
}

std::vector<int> order_if_worthwhile(const Blocks& blocks, int min) {
  if (blocks.size() < min)
    return {};
  // If k blocks side by side are numbered at random, the path is 0.5 sqrt(k) times as
  // long.
  constexpr double much_longer = 16.0;
  std::vector<int> own(blocks.size()), strips = strip_order(blocks);
  std::iota(own.begin(), own.end(), 0);
  if (!(way(blocks, own) > much_longer * way(blocks, strips)))
    strips.clear();
  return strips;
}

namespace {

/// Copies the items of `from` into the new order.
template <class T>
void take(const std::vector<T>& from, const NewNumbers& numbers, std::vector<T>& to) {
  to.resize(numbers.old_of.size());
  for (std::size_t i = 0; i < to.size(); ++i)
    to[i] = from[numbers.old_of[i]];
}
template <class Matrix>
void take(const Matrix& from, const NewNumbers& numbers, Matrix& to) {
  if constexpr (Matrix::ColsAtCompileTime == 1)
    to = from(numbers.old_of);
  else
    to = from(Eigen::all, numbers.old_of);
}

void find_new(NewNumbers& numbers) {
  numbers.new_of.resize(numbers.old_of.size());
  for (int i = 0; i < numbers.size(); ++i)
    numbers.new_of[numbers.old_of[i]] = i;
}

}  // namespace

Numbering::Numbering(const Blocks& old, const std::vector<int>& order) {
  blocks_.old_of = order;
  corners_.old_of.reserve(old.corners());
  for (const int b : order)
    for (int c = old.first_corner[b]; c < old.first_corner[b + 1]; ++c)
      corners_.old_of.push_back(c);
  find_new(blocks_);
  find_new(corners_);
}

Numbering Numbering::reverse() const {
  Numbering back = *this;
  for (NewNumbers* numbers : {&back.blocks_, &back.corners_})
    std::swap(numbers->old_of, numbers->new_of);
  return back;
}

Loads Numbering::renumbered(Loads loads) const {
  for (Pressure& pressure : loads.pressures)
    pressure.block = blocks_.new_of[pressure.block];
  for (CentroidForce& force : loads.forces)
    force.block = blocks_.new_of[force.block];
  for (QuietSide& quiet : loads.quiet_sides)
    quiet.block = blocks_.new_of[quiet.block];
  return loads;
}

std::vector<Drive> Numbering::renumbered(std::vector<Drive> drives) const {
  return sorted(std::move(drives), blocks_.new_of);
}

std::vector<Servo> Numbering::renumbered(std::vector<Servo> servos) const {
  return sorted(std::move(servos), blocks_.new_of);
}

void Numbering::renumber(const Blocks& from, Blocks& to) const {
  const auto of_corners = [&](auto... columns) {
    (take(from.*columns, corners_, to.*columns), ...);
  };
  const auto of_blocks = [&](auto... columns) {
    (take(from.*columns, blocks_, to.*columns), ...);
  };
  of_corners(&Blocks::corner_block, &Blocks::next, &Blocks::previous, &Blocks::joint,
             &Blocks::arm, &Blocks::corner);
  of_blocks(&Blocks::material, &Blocks::fixity, &Blocks::convex, &Blocks::layer,
            &Blocks::area, &Blocks::mass, &Blocks::inertia, &Blocks::second_moment,
            &Blocks::centroid, &Blocks::gradient, &Blocks::velocity, &Blocks::angle,
            &Blocks::spin, &Blocks::force, &Blocks::moment, &Blocks::applied,
            &Blocks::stress, &Blocks::strain_rate);
  if (from.has_scaled_masses())
    of_blocks(&Blocks::scale);
  else
    to.scale.resize(0);
  for (int& block : to.corner_block)
    block = blocks_.new_of[block];
  to.cuts = from.cuts;
  for (std::size_t k = 0; k < to.cuts.size();
       k += 2 + static_cast<std::size_t>(to.cuts[k + 1]))
    to.cuts[k] = blocks_.new_of[to.cuts[k]];
  for (std::vector<int>* beside : {&to.next, &to.previous})
    for (int& corner : *beside)
      corner = corners_.new_of[corner];
  to.first_corner.assign(1, 0);
  for (const int b : blocks_.old_of)
    to.first_corner.push_back(to.first_corner.back() + from.corners_of(b));
}

void Numbering::renumber(const std::vector<Contact>& from,
                         const std::vector<LawState>& states, const Blocks& blocks,
                         std::vector<Contact>& to,
                         std::vector<LawState>& states_to) const {
  NewNumbers records;
  records.old_of.resize(from.size());
  std::iota(records.old_of.begin(), records.old_of.end(), 0);
  std::vector<Contact> renumbered = from;
  for (Contact& contact : renumbered) {
    contact.corner = corners_.new_of[contact.corner];
    contact.edge = corners_.new_of[contact.edge];
  }
  std::sort(records.old_of.begin(), records.old_of.end(), [&](int l, int r) {
    return sort_key(blocks, renumbered[l]) < sort_key(blocks, renumbered[r]);
  });
  take(renumbered, records, to);
  if (states.empty())
    states_to.clear();
  else
    take(states, records, states_to);
}

std::vector<PlaneContact> Numbering::renumbered(std::vector<PlaneContact> list) const {
  for (PlaneContact& contact : list)
    contact.corner = corners_.new_of[contact.corner];
  std::sort(list.begin(), list.end(), [](const PlaneContact& l, const PlaneContact& r) {
    return std::pair(l.plane, l.corner) < std::pair(r.plane, r.corner);
  });
  return list;
}

}  // namespace blocks
