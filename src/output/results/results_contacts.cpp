#include "output/results/results_contacts.hpp"

#include <algorithm>

namespace blocks::output {
namespace {

/// The active contacts of one state, stored by column.
struct Rows {
  std::vector<int> corner_block, corner, edge_block, edge;
  std::vector<double> point, normal, normal_force, shear_force, overlap;

  void add(const Blocks& blocks, int c, const Vec2& n, double fn, double fs, double d) {
    const int b = blocks.corner_block[static_cast<std::size_t>(c)];
    corner_block.push_back(b + 1);
    corner.push_back(c - blocks.first_corner[static_cast<std::size_t>(b)] + 1);
    point.insert(point.end(), {blocks.corner(0, c), blocks.corner(1, c), 0.0});
    normal.insert(normal.end(), {n.x(), n.y(), 0.0});
    normal_force.push_back(fn);
    shear_force.push_back(fs);
    overlap.push_back(d);
  }
};

Vec2 left_of(const Vec2& from, const Vec2& to) {
  const Vec2 t = (to - from).normalized();
  return {-t.y(), t.x()};
}

Rows between_blocks(const Model& model, std::size_t begin, std::size_t end) {
  const Blocks& blocks = model.blocks;
  Rows rows;
  for (std::size_t i = begin; i < end; ++i) {
    const Contact& contact = model.contacts[i];
    const int e = contact.edge, b = blocks.corner_block[e];
    rows.add(blocks, contact.corner,
             left_of(blocks.corner.col(e), blocks.corner.col(blocks.next[e])),
             contact.normal_force, contact.shear_force, contact.overlap);
    rows.edge_block.push_back(b + 1);
    rows.edge.push_back(e - blocks.first_corner[static_cast<std::size_t>(b)] + 1);
  }
  return rows;
}

Rows against_planes(const Model& model) {
  const Blocks& blocks = model.blocks;
  Rows rows;
  for (const PlaneContact& contact : model.plane_contacts) {
    if (!contact.active)
      continue;
    const Plane& plane = model.settings.planes[static_cast<std::size_t>(contact.plane)];
    rows.add(blocks, contact.corner, left_of(plane.a, plane.b), contact.normal_force,
             0.0, contact.overlap);
    rows.edge_block.push_back(0);
    rows.edge.push_back(contact.plane + 1);
  }
  return rows;
}

constexpr hsize_t contacts_per_chunk = 1024, frames_per_chunk = 256;
/// The number of contacts assembled before they are written.
constexpr std::size_t contacts_at_once = 65536;

}  // namespace

ContactColumns::ContactColumns(const Make& make, hid_t own)
    : corner_block_(make("CornerBlock", H5T_NATIVE_INT, 0, contacts_per_chunk)),
      corner_(make("Corner", H5T_NATIVE_INT, 0, contacts_per_chunk)),
      edge_block_(make("EdgeBlock", H5T_NATIVE_INT, 0, contacts_per_chunk)),
      edge_(make("Edge", H5T_NATIVE_INT, 0, contacts_per_chunk)),
      point_(make("Point", H5T_NATIVE_DOUBLE, 3, contacts_per_chunk)),
      normal_(make("Normal", H5T_NATIVE_DOUBLE, 3, contacts_per_chunk)),
      normal_force_(make("NormalForce", H5T_NATIVE_DOUBLE, 0, contacts_per_chunk)),
      shear_force_(make("ShearForce", H5T_NATIVE_DOUBLE, 0, contacts_per_chunk)),
      overlap_(make("Overlap", H5T_NATIVE_DOUBLE, 0, contacts_per_chunk)),
      offsets_(make("Offsets", H5T_NATIVE_INT64, 0, frames_per_chunk)),
      counts_(make("Counts", H5T_NATIVE_INT64, 0, frames_per_chunk)), states_(own) {}

void ContactColumns::put(long frame, const Model& model) {
  const hsize_t first = rows_;
  hsize_t next = first;
  const auto add = [&](const Rows& rows) {
    const hsize_t added = rows.corner.size();
    corner_block_.put(next, rows.corner_block.data(), added);
    corner_.put(next, rows.corner.data(), added);
    edge_block_.put(next, rows.edge_block.data(), added);
    edge_.put(next, rows.edge.data(), added);
    point_.put(next, rows.point.data(), added);
    normal_.put(next, rows.normal.data(), added);
    normal_force_.put(next, rows.normal_force.data(), added);
    shear_force_.put(next, rows.shear_force.data(), added);
    overlap_.put(next, rows.overlap.data(), added);
    next += added;
  };
  const std::size_t acting = model.contacts.size();
  for (std::size_t done = 0; done < acting; done += contacts_at_once)
    add(between_blocks(model, done, std::min(acting, done + contacts_at_once)));
  add(against_planes(model));
  states_.put(first, next, model);
  const auto offset = static_cast<std::int64_t>(first);
  const auto size = static_cast<std::int64_t>(next - first);
  offsets_.put(static_cast<hsize_t>(frame), &offset, 1);
  counts_.put(static_cast<hsize_t>(frame), &size, 1);
  rows_ = next;
}

void ContactColumns::truncate(long frames) {
  const auto kept = static_cast<hsize_t>(frames);
  rows_ = frames == 0 ? 0
                      : static_cast<hsize_t>(offsets_.at<std::int64_t>(kept - 1) +
                                             counts_.at<std::int64_t>(kept - 1));
  for (hdf5::Column* column : {&corner_block_, &corner_, &edge_block_, &edge_, &point_,
                               &normal_, &normal_force_, &shear_force_, &overlap_})
    column->truncate(rows_);
  states_.truncate(rows_);
  offsets_.truncate(kept);
  counts_.truncate(kept);
}

}  // namespace blocks::output
