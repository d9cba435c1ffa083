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

/// Puts the items of a column into the new order. The column keeps its memory.
template <class T> void take(std::vector<T>& column, const NewNumbers& numbers) {
  const std::vector<T> from = column;
  for (std::size_t i = 0; i < from.size(); ++i)
    column[i] = from[numbers.old_of[i]];
}
template <class Matrix> void take(Matrix& column, const NewNumbers& numbers) {
  const Matrix from = column;
  if constexpr (Matrix::ColsAtCompileTime == 1)
    column = from(numbers.old_of);
  else
    column = from(Eigen::all, numbers.old_of);
}

/// Gives loads or drives the new numbers of their blocks.
template <class Item>
void give_numbers(std::vector<Item>& items, const NewNumbers& blocks) {
  for (Item& item : items)
    item.block = blocks.new_of[item.block];
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

Numbering Numbering::of_renumbered(const Blocks& now, const std::vector<int>& order) {
  NewNumbers numbers{order, {}};
  find_new(numbers);
  return Numbering(now, numbers.new_of).reverse();
}

Numbering Numbering::reverse() const {
  Numbering back = *this;
  for (NewNumbers* numbers : {&back.blocks_, &back.corners_})
    std::swap(numbers->old_of, numbers->new_of);
  return back;
}

void Numbering::renumber(Blocks& blocks) const {
  const auto of_corners = [&](auto&... columns) { (take(columns, corners_), ...); };
  const auto of_blocks = [&](auto&... columns) { (take(columns, blocks_), ...); };
  of_corners(blocks.corner_block, blocks.next, blocks.previous, blocks.joint,
             blocks.arm, blocks.corner);
  of_blocks(blocks.material, blocks.fixity, blocks.convex, blocks.layer, blocks.area,
            blocks.mass, blocks.inertia, blocks.second_moment, blocks.centroid,
            blocks.gradient, blocks.velocity, blocks.angle, blocks.spin, blocks.force,
            blocks.moment, blocks.applied, blocks.stress, blocks.strain_rate);
  if (blocks.has_scaled_masses())
    of_blocks(blocks.scale);
  for (int& block : blocks.corner_block)
    block = blocks_.new_of[block];
  for (std::size_t k = 0; k < blocks.cuts.size();
       k += 2 + static_cast<std::size_t>(blocks.cuts[k + 1]))
    blocks.cuts[k] = blocks_.new_of[blocks.cuts[k]];
  for (std::vector<int>* beside : {&blocks.next, &blocks.previous})
    for (int& corner : *beside)
      corner = corners_.new_of[corner];
  const std::vector<int> first(blocks.first_corner.begin(), blocks.first_corner.end());
  for (int b = 0; b < blocks_.size(); ++b) {
    const int old = blocks_.old_of[b];
    blocks.first_corner[b + 1] = blocks.first_corner[b] + first[old + 1] - first[old];
  }
}

/// blocks: already renumbered.
void Numbering::renumber_contacts(Model& model) const {
  struct Place {
    std::tuple<int, int, int, int> key;
    int old;
  };
  std::vector<Place> places;
  places.reserve(model.contacts.size());
  for (Contact& contact : model.contacts) {
    contact.corner = corners_.new_of[contact.corner];
    contact.edge = corners_.new_of[contact.edge];
    places.push_back(
        {sort_key(model.blocks, contact), static_cast<int>(places.size())});
  }
  std::ranges::sort(places, {}, &Place::key);
  NewNumbers records;
  for (const Place& place : places)
    records.old_of.push_back(place.old);
  take(model.contacts, records);
  take(model.law_states, records);
}

void Numbering::renumber(Model& model) const {
  renumber(model.blocks);
  renumber_contacts(model);
  for (PlaneContact& contact : model.plane_contacts)
    contact.corner = corners_.new_of[contact.corner];
  std::ranges::sort(model.plane_contacts, {}, [](const PlaneContact& contact) {
    return std::pair(contact.plane, contact.corner);
  });
  const auto give = [&](auto&... lists) { (give_numbers(lists, blocks_), ...); };
  give(model.loads.pressures, model.loads.forces, model.loads.quiet_sides);
  give(model.drives, model.servos);
  std::ranges::sort(model.drives, {}, &Drive::block);
  std::ranges::sort(model.servos, {}, &Servo::block);
}

}  // namespace blocks
