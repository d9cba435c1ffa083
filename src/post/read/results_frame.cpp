#include "post/read/results_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "quantities/state.hpp"

namespace blocks::post {

namespace {

Eigen::Matrix2Xd in_plane(const std::vector<double>& rows) {
  using Rows = Eigen::Map<const Eigen::Matrix3Xd>;
  return Rows(rows.data(), 3, static_cast<Eigen::Index>(rows.size() / 3)).topRows(2);
}

Eigen::VectorXd vector(const std::vector<double>& rows) {
  return Eigen::Map<const Eigen::VectorXd>(rows.data(),
                                           static_cast<Eigen::Index>(rows.size()));
}

Eigen::Matrix4Xd tensors(const std::vector<double>& rows) {
  return Eigen::Map<const Eigen::Matrix4Xd>(rows.data(), 4,
                                            static_cast<Eigen::Index>(rows.size() / 4));
}

/// A removed block has no values, so that figures, histories and ranges skip it.
void hide_removed(Frame& frame) {
  for (int b = 0; b < frame.size(); ++b) {
    if (!frame.is_removed(b))
      continue;
    for (auto* plane : {&frame.centroid, &frame.velocity, &frame.force})
      plane->col(b).setConstant(std::nan(""));
    for (auto* values : {&frame.angle, &frame.spin, &frame.moment, &frame.area,
                         &frame.mass, &frame.inertia})
      (*values)[b] = std::nan("");
    for (auto* values : {&frame.unbalanced, &frame.local_ratio})
      if (values->size() > 0)
        (*values)[b] = std::nan("");
    if (frame.water_force.cols() > 0)
      frame.water_force.col(b).setConstant(std::nan(""));
    for (auto* tensor : {&frame.stress, &frame.applied, &frame.strain_rate})
      tensor->col(b).setConstant(std::nan(""));
  }
}

/// Throws Failure unless every contact is that of a corner and an edge that exist.
/// `corners` has the number of corners of each block. The edges of block 0 are planes.
void expect_in_range(const FrameContacts& contacts,
                     const std::vector<std::int64_t>& corners, std::int64_t planes) {
  const auto expect = [&](const char* name, std::int64_t value, std::int64_t from,
                          std::int64_t to) {
    if (value < from || value > to)
      throw Failure(fmt::format("contacts/{} is out of range: {} is not in {} to {}",
                                name, value, from, to));
  };
  const auto blocks = static_cast<std::int64_t>(corners.size());
  const auto corners_of = [&](int block) {
    return corners[static_cast<std::size_t>(block) - 1];
  };
  for (std::size_t i = 0; i < contacts.corner.size(); ++i) {
    const int block = contacts.corner_block[i], other = contacts.edge_block[i];
    expect("CornerBlock", block, 1, blocks);
    expect("Corner", contacts.corner[i], 1, corners_of(block));
    expect("EdgeBlock", other, 0, blocks);
    if (other == block)
      throw Failure(fmt::format("contacts: block {} touches itself", block));
    expect("Edge", contacts.edge[i], 1, other == 0 ? planes : corners_of(other));
  }
}

}  // namespace

template <class T>
std::vector<T> ResultsReader::File::read_late(const std::string& group,
                                              const std::string& name, hsize_t i,
                                              hsize_t rows, hsize_t width) const {
  const std::string data = group + "/" + name, places = group + "Offsets",
                    offsets = places + "/" + name;
  if (!hdf5::exists(vtk.get(), group) || !hdf5::exists(vtk.get(), data))
    return {};
  Column stored = Column::open(vtk.get(), data);
  if (stored.width() != width)
    throw Failure(name + " has the wrong shape");
  // A run that was interrupted while it added the data left frames without an offset.
  if (!hdf5::exists(steps.get(), places) || !hdf5::exists(steps.get(), offsets) ||
      Column::open(steps.get(), offsets).rows() <= i)
    return {};
  return stored.read<T>(step_value(offsets, i), rows);
}

std::pair<hsize_t, hsize_t> ResultsReader::File::water_rows(const char* name,
                                                            hsize_t i) const {
  if (!hdf5::exists(own.get(), "water") ||
      !hdf5::exists(own.get(), "water/points_of_frame"))
    return {0, 0};
  Column stored = Column::open(own.get(), name);
  if (stored.width() != 2)
    throw Failure(std::string(name) + " has the wrong shape");
  if (stored.rows() <= i)
    return {0, 0};
  const auto rows = stored.read<std::int64_t>(i, 1);
  if (rows[0] < 0 || rows[1] < 0)
    throw Failure(std::string(name) + " is negative");
  return {static_cast<hsize_t>(rows[0]), static_cast<hsize_t>(rows[1])};
}

std::vector<Eigen::Vector2d> ResultsReader::File::read_water_line(hsize_t i) const {
  const auto [first, count] = water_rows("water/points_of_frame", i);
  std::vector<Eigen::Vector2d> line;
  if (count == 0)
    return line;
  Column points = Column::open(own.get(), "water/point");
  if (points.width() != 2)
    throw Failure("water/point has the wrong shape");
  const std::vector<double> rows = points.read<double>(first, count);
  for (std::size_t k = 0; k + 1 < rows.size(); k += 2) {
    line.emplace_back(rows[k], rows[k + 1]);
    if (!line.back().allFinite())
      throw Failure("water/point has values that are not finite");
  }
  return line;
}

void ResultsReader::File::read_wet_sides(hsize_t i,
                                         const std::vector<std::pair<int, int>>& places,
                                         Frame& frame) const {
  const auto [first, count] = water_rows("water/parts_of_frame", i);
  if (count == 0)
    return;
  Column corner = Column::open(own.get(), "water/corner"),
         part = Column::open(own.get(), "water/part");
  if (corner.width() != 1 || part.width() != 4)
    throw Failure("water/part has the wrong shape");
  const auto corners = corner.read<std::int64_t>(first, count);
  const auto parts = part.read<double>(first, count);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    if (corners[k] < 0 || corners[k] >= static_cast<std::int64_t>(places.size()))
      throw Failure("water/corner is out of range");
    const auto [block, side] = places[static_cast<std::size_t>(corners[k])];
    const Eigen::Vector2d share(parts[4 * k], parts[4 * k + 1]),
        pressure(parts[4 * k + 2], parts[4 * k + 3]);
    if (block < 0 || !(share.minCoeff() >= 0.0 && share.maxCoeff() <= 1.0) ||
        !(pressure.minCoeff() >= 0.0) || !pressure.allFinite())
      throw Failure("water/part is out of range");
    const auto& outline = frame.outlines[static_cast<std::size_t>(block)];
    const auto at = static_cast<std::size_t>(side);
    const Eigen::Vector2d a = outline[at], b = outline[(at + 1) % outline.size()];
    frame.wet_sides.push_back({block,
                               side,
                               {a + share[0] * (b - a), a + share[1] * (b - a)},
                               share,
                               pressure});
  }
}

std::vector<std::int64_t> ResultsReader::File::read_corner_counts(hsize_t i) const {
  const hsize_t part = step_value("PartOffsets", i);
  const hsize_t n = count("NumberOfCells", part);
  const auto starts =
      rows<std::int64_t>("Offsets", step_value("CellOffsets", i) + part, n + 1);
  std::vector<std::int64_t> counts(n);
  for (std::size_t b = 0; b < n; ++b) {
    if (starts[b] < 0 || starts[b + 1] < starts[b])
      throw Failure("Offsets are out of range");
    counts[b] = starts[b + 1] - starts[b];
  }
  return counts;
}

void ResultsReader::File::read_outlines(hsize_t i, hsize_t part, hsize_t n,
                                        Frame& frame) const {
  const hsize_t points = count("NumberOfPoints", part);
  const hsize_t ids = count("NumberOfConnectivityIds", part);
  Column stored = Column::open(vtk.get(), "Points");
  if (stored.width() != 3)
    throw Failure("Points has the wrong shape");
  const Eigen::Matrix2Xd corners =
      in_plane(stored.read<double>(step_value("PointOffsets", i), points));
  const auto starts =
      rows<std::int64_t>("Offsets", step_value("CellOffsets", i) + part, n + 1);
  const auto connectivity =
      rows<std::int64_t>("Connectivity", step_value("ConnectivityIdOffsets", i), ids);

  const auto joints = read_late<int>("PointData", "Joint", i, points, 1);
  if (std::any_of(joints.begin(), joints.end(), [](int joint) { return joint < 0; }))
    throw Failure("Joint is negative");
  std::vector<std::pair<int, int>> places(points, {-1, -1});
  if (!joints.empty())
    frame.joints.resize(n);
  frame.outlines.resize(n);
  for (std::size_t b = 0; b < n; ++b) {
    const std::int64_t from = starts[b], to = starts[b + 1];
    if (from < 0 || to < from || to > static_cast<std::int64_t>(ids))
      throw Failure("Offsets are out of range");
    if (constexpr std::int64_t min = 3;
        to - from < min && !frame.is_removed(static_cast<int>(b)))
      throw Failure(fmt::format("Offsets: block {} has {} corners", b + 1, to - from));
    for (std::int64_t k = from; k < to; ++k) {
      const std::int64_t point = connectivity[static_cast<std::size_t>(k)];
      if (point < 0 || point >= corners.cols())
        throw Failure("Connectivity is out of range");
      frame.outlines[b].emplace_back(corners.col(point));
      if (!joints.empty())
        frame.joints[b].push_back(joints[static_cast<std::size_t>(point)]);
      places[static_cast<std::size_t>(point)] = {static_cast<int>(b),
                                                 static_cast<int>(k - from)};
    }
  }
  read_wet_sides(i, places, frame);
}

Frame ResultsReader::File::read(hsize_t i) const {
  const hsize_t part = step_value("PartOffsets", i);
  const hsize_t n = count("NumberOfCells", part);
  Frame frame;
  frame.time = times[i];
  frame.step = field<std::int64_t>("Step", i);
  frame.kinetic_energy = field<double>("KineticEnergy", i);
  frame.number = cells<int>("BlockNumber", i, n, 1);
  for (std::size_t b = 0; b < frame.number.size(); ++b)
    if (frame.number[b] != static_cast<int>(b) + 1)
      throw Failure("CellData/BlockNumber is out of order");
  frame.material = cells<int>("Material", i, n, 1);
  frame.fixed = cells<int>("Fixed", i, n, 1);
  if (std::any_of(frame.fixed.begin(), frame.fixed.end(), [](int fixity) {
        return fixity < 0 || fixity > static_cast<int>(Fixity::driven);
      }))
    throw Failure("CellData/Fixed is out of range");
  frame.centroid = in_plane(cells<double>("Centroid", i, n, 3));
  frame.velocity = in_plane(cells<double>("Velocity", i, n, 3));
  frame.angle = vector(cells<double>("Angle", i, n, 1));
  frame.spin = vector(cells<double>("Spin", i, n, 1));
  frame.force = in_plane(cells<double>("Force", i, n, 3));
  frame.moment = vector(cells<double>("Moment", i, n, 1));
  frame.area = vector(cells<double>("Area", i, n, 1));
  frame.mass = vector(cells<double>("Mass", i, n, 1));
  frame.inertia = vector(cells<double>("Inertia", i, n, 1));
  frame.stress = tensors(cells<double>("Stress", i, n, 4));
  frame.applied = tensors(cells<double>("AppliedStress", i, n, 4));
  frame.strain_rate = tensors(cells<double>("StrainRate", i, n, 4));
  frame.cracks = static_cast<long>(count_cracks(i));
  frame.parent = parents(i, n);
  if (hdf5::exists(vtk.get(), unbalanced_column)) {
    frame.unbalanced = vector(cells<double>("UnbalancedForce", i, n, 1));
    frame.unbalanced_ratio = field<double>("UnbalancedRatio", i);
  }
  if (hdf5::exists(vtk.get(), local_ratio_column))
    frame.local_ratio = vector(cells<double>("LocalRatio", i, n, 1));
  read_outlines(i, part, n, frame);
  frame.water_force = in_plane(read_late<double>("CellData", "WaterForce", i, n, 3));
  frame.water_line = read_water_line(i);
  hide_removed(frame);
  return frame;
}

FrameContacts ResultsReader::File::read_contacts(hsize_t i) const {
  const auto place = [&](const char* name) {
    const auto value = contact<std::int64_t>(name, i, 1, 1).front();
    if (value < 0)
      throw Failure(std::string("contacts/") + name + " is negative");
    return static_cast<hsize_t>(value);
  };
  const hsize_t from = place("Offsets"), m = place("Counts");
  FrameContacts rows;
  rows.corner_block = contact<int>("CornerBlock", from, m, 1);
  rows.corner = contact<int>("Corner", from, m, 1);
  rows.edge_block = contact<int>("EdgeBlock", from, m, 1);
  rows.edge = contact<int>("Edge", from, m, 1);
  rows.point = in_plane(contact<double>("Point", from, m, 3));
  rows.normal = in_plane(contact<double>("Normal", from, m, 3));
  rows.normal_force = vector(contact<double>("NormalForce", from, m, 1));
  rows.shear_force = vector(contact<double>("ShearForce", from, m, 1));
  rows.overlap = vector(contact<double>("Overlap", from, m, 1));
  if (hdf5::exists(own.get(), last_state_column))
    rows.states = read_states(from, m);
  // Results of older programs do not have the planes.
  const std::int64_t planes = names.planes.empty()
                                  ? std::numeric_limits<int>::max()
                                  : static_cast<std::int64_t>(names.planes.size());
  expect_in_range(rows, read_corner_counts(i), planes);
  return rows;
}

std::vector<LawState> ResultsReader::File::read_states(hsize_t from, hsize_t m) const {
  std::vector<LawState> all(m);
  each_law_field([&]<class Member>(const LawField& field, Member LawState::*member) {
    const auto values = states<ResultsType<Member>>(field.column, from, m);
    for (hsize_t i = 0; i < m; ++i)
      all[i].*member = static_cast<Member>(values[i]);
  });
  return all;
}

}  // namespace blocks::post
