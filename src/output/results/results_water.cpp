#include "output/results/results_water.hpp"

#include <limits>
#include <string>

namespace blocks::output {
namespace {

using hdf5::Column;

constexpr const char* group = "water";
constexpr hsize_t rows_per_chunk = 256;

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
  const WaterNow water(model.loads.water, model.time);
  std::vector<Vec2> line;
  if (!water.has_table())
    return line;
  const Vec2 across = table.across();
  double left = std::numeric_limits<double>::infinity(), right = -left;
  for (int c = 0; c < model.blocks.corners(); ++c) {
    const double s = across.dot(Vec2(model.blocks.corner.col(c)));
    left = std::min(left, s), right = std::max(right, s);
  }
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

template <class Make> WaterColumns::Lists WaterColumns::visit(const Make& make) {
  const std::string path = std::string(group) + "/";
  // The last one tells whether all were made, or a frame was interrupted.
  return {make(path + "corner", H5T_NATIVE_INT64, 0),
          make(path + "part", H5T_NATIVE_DOUBLE, 4),
          make(path + "point", H5T_NATIVE_DOUBLE, 2),
          make(path + "parts_of_frame", H5T_NATIVE_INT64, 2),
          make(path + "points_of_frame", H5T_NATIVE_INT64, 2)};
}

void WaterColumns::remove_lists() {
  lists_.reset();
  if (hdf5::exists(own_, group))
    hdf5::check(H5Ldelete(own_, group, H5P_DEFAULT));
}

void WaterColumns::open() {
  forces_.open();
  if (!hdf5::exists(own_, group) || !hdf5::exists(own_, "water/points_of_frame")) {
    remove_lists();
    return;
  }
  lists_.emplace(visit([&](const std::string& name, hid_t, hsize_t width) {
    Column column = Column::open(own_, name);
    if (column.width() != (width == 0 ? 1 : width))
      throw hdf5::Failure(name + " has the wrong shape");
    return column;
  }));
}

void WaterColumns::put_lists(long frame, const Model& model) {
  const Blocks& blocks = model.blocks;
  const auto at = static_cast<hsize_t>(frame);
  if (!lists_) {
    lists_.emplace(visit([&](const std::string& name, hid_t type, hsize_t width) {
      return Column(own_, name, type, width, rows_per_chunk);
    }));
    const std::int64_t none[2] = {0, 0};
    for (hsize_t i = 0; i < at; ++i)
      for (Column* column : {&lists_->parts_of_frame, &lists_->points_of_frame})
        column->put(i, none, 1);
  }
  std::vector<std::int64_t> corners;
  std::vector<WetPart> parts;
  const WaterNow water(model.loads.water, model.time);
  for (int c = 0; c < blocks.corners(); ++c) {
    if (blocks.is_removed(blocks.corner_block[c]))
      continue;
    water.add_parts(blocks.corner.col(c), blocks.corner.col(blocks.next[c]),
                    blocks.joint[c], parts);
    corners.resize(parts.size(), c);
  }
  std::vector<double> rows;
  for (const WetPart& part : parts)
    rows.insert(rows.end(), {part.t0, part.t1, part.p0, part.p1});
  const auto place = [&](Column& column, Column& of_frame, std::size_t count) {
    const std::int64_t found[2] = {static_cast<std::int64_t>(column.rows()),
                                   static_cast<std::int64_t>(count)};
    of_frame.put(at, found, 1);
  };
  place(lists_->part, lists_->parts_of_frame, parts.size());
  lists_->corner.put(lists_->corner.rows(), corners.data(), corners.size());
  lists_->part.put(lists_->part.rows(), rows.data(), parts.size());
  std::vector<double> line;
  for (const Vec2& point : water_line(model))
    line.insert(line.end(), {point.x(), point.y()});
  place(lists_->point, lists_->points_of_frame, line.size() / 2);
  lists_->point.put(lists_->point.rows(), line.data(), line.size() / 2);
}

void WaterColumns::put(long frame, const Model& model) {
  if (!lists_ && model.loads.water.none())
    return;
  forces_.put(frame, forces_of(model));
  put_lists(frame, model);
}

void WaterColumns::truncate(long frames, hsize_t blocks) {
  forces_.truncate(frames, blocks);
  if (!lists_)
    return;
  const auto kept = static_cast<hsize_t>(frames);
  if (kept == 0 || lists_->points_of_frame.rows() < kept) {
    remove_lists();
    return;
  }
  const auto end = [&](Column& of_frame) {
    const auto last = of_frame.read<std::int64_t>(kept - 1, 1);
    of_frame.truncate(kept);
    return static_cast<hsize_t>(last[0] + last[1]);
  };
  const hsize_t parts = end(lists_->parts_of_frame);
  lists_->corner.truncate(parts);
  lists_->part.truncate(parts);
  lists_->point.truncate(end(lists_->points_of_frame));
}

}  // namespace blocks::output
