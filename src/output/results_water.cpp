#include "output/results_water.hpp"

#include <limits>
#include <string>

namespace blocks::output {
namespace {

using hdf5::Column;

constexpr const char* group = "water";
constexpr hsize_t rows_per_chunk = 256;

/// Returns the pressure at both ends of each side, (2 m).
std::vector<double> pressures_of(const Model& model) {
  const Blocks& blocks = model.blocks;
  std::vector<double> pressures;
  const WaterNow water(model.loads.water, model.time);
  pressures.reserve(2 * blocks.joint.size());
  for (int c = 0; c < blocks.corners(); ++c) {
    Vec2 ends(0.0, 0.0);
    if (!blocks.is_removed(blocks.corner_block[c]))
      ends = water.at_ends(blocks.corner.col(c), blocks.corner.col(blocks.next[c]),
                           blocks.joint[c]);
    pressures.insert(pressures.end(), {ends[0], ends[1]});
  }
  return pressures;
}

/// Returns the force on each block, (3 n).
std::vector<double> forces_of(const Model& model) {
  std::vector<double> forces;
  Eigen::Matrix2Xd plane;
  WaterNow(model.loads.water, model.time).forces_on(model.blocks, plane);
  for (Eigen::Index b = 0; b < plane.cols(); ++b)
    forces.insert(forces.end(), {plane(0, b), plane(1, b), 0.0});
  return forces;
}

}  // namespace

std::vector<Vec2> water_line(const Model& model) {
  const WaterTable& table = model.loads.water.table;
  std::vector<Vec2> line;
  if (table.none())
    return line;
  const Vec2 across = table.across();
  double left = std::numeric_limits<double>::infinity(), right = -left;
  for (int c = 0; c < model.blocks.corners(); ++c) {
    const double s = across.dot(Vec2(model.blocks.corner.col(c)));
    left = std::min(left, s), right = std::max(right, s);
  }
  const WaterNow water(model.loads.water, model.time);
  const auto add = [&](double s) {
    line.emplace_back(s * across + water.level_at(s) * table.up);
  };
  const double width = right - left;
  if (left - width < table.place.front())
    add(left - width);
  for (const double s : table.place)
    add(s);
  if (right + width > table.place.back())
    add(right + width);
  return line;
}

template <class Make> WaterColumns::Table WaterColumns::visit(const Make& make) {
  const std::string path = std::string(group) + "/";
  // The counts are made last: without them a frame was interrupted.
  return {make(path + "points", H5T_NATIVE_DOUBLE, 2),
          make(path + "first", H5T_NATIVE_INT64, 0),
          make(path + "count", H5T_NATIVE_INT64, 0)};
}

void WaterColumns::remove_table() {
  table_.reset();
  if (hdf5::exists(own_, group))
    hdf5::check(H5Ldelete(own_, group, H5P_DEFAULT));
}

void WaterColumns::open() {
  pressures_.open();
  forces_.open();
  if (!hdf5::exists(own_, group) || !hdf5::exists(own_, "water/count")) {
    remove_table();
    return;
  }
  table_.emplace(visit([&](const std::string& name, hid_t, hsize_t width) {
    Column column = Column::open(own_, name);
    if (column.width() != (width == 0 ? 1 : width))
      throw hdf5::Failure(name + " has the wrong shape");
    return column;
  }));
}

void WaterColumns::put_table(long frame, const Model& model) {
  const std::vector<Vec2> line = water_line(model);
  if (!table_) {
    if (line.empty())
      return;
    table_.emplace(visit([&](const std::string& name, hid_t type, hsize_t width) {
      return Column(own_, name, type, width, rows_per_chunk);
    }));
    const std::int64_t none = 0;
    for (long i = 0; i < frame; ++i)
      for (Column* column : {&table_->first, &table_->count})
        column->put(static_cast<hsize_t>(i), &none, 1);
  }
  std::vector<double> rows;
  for (const Vec2& at : line)
    rows.insert(rows.end(), {at.x(), at.y()});
  const hsize_t end = table_->points.rows();
  table_->points.put(end, rows.data(), line.size());
  const auto first = static_cast<std::int64_t>(end),
             count = static_cast<std::int64_t>(line.size());
  table_->first.put(static_cast<hsize_t>(frame), &first, 1);
  table_->count.put(static_cast<hsize_t>(frame), &count, 1);
}

void WaterColumns::put(long frame, const Model& model) {
  if (pressures_.exists() || !model.loads.water.none()) {
    pressures_.put(frame, pressures_of(model));
    forces_.put(frame, forces_of(model));
  }
  put_table(frame, model);
}

void WaterColumns::truncate(long frames, hsize_t blocks, hsize_t corners) {
  pressures_.truncate(frames, corners);
  forces_.truncate(frames, blocks);
  if (!table_)
    return;
  const auto kept = static_cast<hsize_t>(frames);
  if (kept == 0 || table_->count.rows() < kept) {
    remove_table();
    return;
  }
  const auto last = static_cast<hsize_t>(table_->first.at<std::int64_t>(kept - 1)),
             count = static_cast<hsize_t>(table_->count.at<std::int64_t>(kept - 1));
  table_->points.truncate(last + count);
  table_->first.truncate(kept);
  table_->count.truncate(kept);
}

}  // namespace blocks::output
