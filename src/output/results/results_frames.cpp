#include "output/results/results_frames.hpp"

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "model/equilibrium.hpp"
#include "model/local_ratio.hpp"

namespace blocks::output {
namespace {

using hdf5::Column;

constexpr hsize_t frames_per_chunk = 256;
constexpr unsigned char polygon = 7, empty_cell = 0;  // VTK_POLYGON, VTK_EMPTY_CELL

struct CellField {
  const char* name;
  bool whole;  ///< int if true, otherwise double
  hsize_t width;
};
constexpr CellField cell_fields[] = {
    {"BlockNumber", true, 0}, {"Material", true, 0},       {"Fixed", true, 0},
    {"Area", false, 0},       {"Mass", false, 0},          {"Inertia", false, 0},
    {"Centroid", false, 3},   {"Velocity", false, 3},      {"Force", false, 3},
    {"Angle", false, 0},      {"Spin", false, 0},          {"Moment", false, 0},
    {"Stress", false, 4},     {"AppliedStress", false, 4}, {"StrainRate", false, 4}};
constexpr CellField frame_fields[] = {{"Time", false, 0},
                                      {"Step", true, 0},
                                      {"KineticEnergy", false, 0},
                                      {"Contacts", true, 0},
                                      {"WorstOverlap", false, 0}};
// Only in the results of decks that ask for equilibrium.
constexpr CellField unbalanced_force = {"UnbalancedForce", false, 0};
constexpr CellField local_ratio = {"LocalRatio", false, 0};
constexpr CellField unbalanced_share = {"UnbalancedRatio", false, 0};

/// VTK requires three components, so z = 0.
auto in_space(const Eigen::Matrix2Xd& plane) {
  return [&plane, rows = std::vector<double>()](hsize_t first, hsize_t count) mutable {
    rows.clear();
    for (auto i = static_cast<Eigen::Index>(first);
         i < static_cast<Eigen::Index>(first + count); ++i)
      rows.insert(rows.end(), {plane(0, i), plane(1, i), 0.0});
    return static_cast<const double*>(rows.data());
  };
}

/// A source of the same values as 64-bit numbers.
auto long_values(const std::vector<int>& values) {
  return made_of<std::int64_t>([&](hsize_t row) { return values[row]; });
}

/// A place in other columns, which a column of offsets holds.
hsize_t place(Column& column, hsize_t row) {
  return static_cast<hsize_t>(column.at<std::int64_t>(row));
}

}  // namespace

ResultsCells::ResultsCells(const Blocks& blocks) {
  for (int b = 0; b < blocks.size(); ++b) {
    if (!blocks.is_removed(b))
      for (int c = blocks.first_corner[b]; c < blocks.first_corner[b + 1]; ++c)
        corners.push_back(c);
    starts.push_back(static_cast<int>(corners.size()));
  }
}

template <class Make>
ResultsFrames::ResultsFrames(const ResultsGroups& to, Make&& make, hsize_t blocks,
                             hsize_t corners, bool unbalanced)
    : joints_(to.vtk.get(), to.steps.get(), "PointData", "Joint"),
      water_(to.vtk.get(), to.steps.get(), to.own.get()),
      cracks_(to.vtk.get(), to.steps.get(), to.own.get()) {
  const hid_t whole = H5T_NATIVE_INT64, real = H5T_NATIVE_DOUBLE;
  const hsize_t per_block = chunk_rows(blocks), per_corner = chunk_rows(corners);
  points_ = make(to.vtk, "Points", real, 3, per_corner);
  connectivity_ = make(to.vtk, "Connectivity", whole, 0, per_corner);
  offsets_ = make(to.vtk, "Offsets", whole, 0, per_block);
  types_ = make(to.vtk, "Types", H5T_NATIVE_UCHAR, 0, per_block);
  for (auto& [column, name] : {std::pair{&number_of_points_, "NumberOfPoints"},
                               {&number_of_cells_, "NumberOfCells"},
                               {&number_of_ids_, "NumberOfConnectivityIds"}})
    *column = make(to.vtk, name, whole, 0, frames_per_chunk);
  values_ = make(to.steps, "Values", real, 0, frames_per_chunk);
  for (auto& [column, name] : {std::pair{&number_of_parts_, "NumberOfParts"},
                               {&part_offsets_, "PartOffsets"},
                               {&point_offsets_, "PointOffsets"},
                               {&cell_offsets_, "CellOffsets"},
                               {&id_offsets_, "ConnectivityIdOffsets"}})
    *column = make(to.steps, name, whole, 0, frames_per_chunk);
  std::vector<CellField> of_cells(std::begin(cell_fields), std::end(cell_fields));
  std::vector<CellField> of_frames(std::begin(frame_fields), std::end(frame_fields));
  if (unbalanced) {
    of_cells.insert(of_cells.end(), {unbalanced_force, local_ratio});
    of_frames.push_back(unbalanced_share);
  }
  for (const CellField& field : of_cells) {
    const std::string name = field.name;
    const hid_t type = field.whole ? H5T_NATIVE_INT : real;
    cells_.insert_or_assign(name, FrameColumn(make(to.vtk, "CellData/" + name, type,
                                                   field.width, per_block),
                                              make(to.steps, "CellDataOffsets/" + name,
                                                   whole, 0, frames_per_chunk)));
  }
  for (const CellField& field : of_frames) {
    const std::string name = field.name;
    const hid_t type = field.whole ? whole : real;
    frame_data_[name] = make(to.vtk, "FieldData/" + name, type, 0, frames_per_chunk);
    frame_offsets_[name] =
        make(to.steps, "FieldDataOffsets/" + name, whole, 0, frames_per_chunk);
    frame_sizes_[name] =
        make(to.steps, "FieldDataSizes/" + name, whole, 2, frames_per_chunk);
  }
  contacts_ = std::make_unique<ContactColumns>(
      [&](const std::string& name, hid_t type, hsize_t width, hsize_t chunk) {
        return make(to.own, "contacts/" + name, type, width, chunk);
      },
      to.own.get());
}

std::unique_ptr<ResultsFrames> ResultsFrames::create(const ResultsGroups& groups,
                                                     const Model& model,
                                                     bool unbalanced) {
  const auto make = [](const hdf5::Handle& group, const std::string& name, hid_t type,
                       hsize_t width, hsize_t chunk) {
    return Column(group.get(), name, type, width, chunk);
  };
  std::unique_ptr<ResultsFrames> frames(
      new ResultsFrames(groups, make, static_cast<hsize_t>(model.blocks.size()),
                        static_cast<hsize_t>(model.blocks.corners()), unbalanced));
  hdf5::check(H5Lcreate_hard(groups.vtk.get(), "FieldData/Step", groups.own.get(),
                             "steps", H5P_DEFAULT, H5P_DEFAULT));
  return frames;
}

std::unique_ptr<ResultsFrames> ResultsFrames::open(const ResultsGroups& groups) {
  const auto open = [](const hdf5::Handle& group, const std::string& name, hid_t,
                       hsize_t width, hsize_t) {
    Column column = Column::open(group.get(), name);
    if (column.width() != (width == 0 ? 1 : width))
      throw hdf5::Failure(name + " has the wrong shape");
    return column;
  };
  std::unique_ptr<ResultsFrames> frames(new ResultsFrames(
      groups, open, 0, 0,
      hdf5::exists(groups.vtk.get(),
                   fmt::format("CellData/{}", unbalanced_force.name))));
  frames->joints_.open();
  frames->water_.open();
  frames->cracks_.open();
  frames->contacts_->open();
  return frames;
}

void ResultsFrames::truncate(long count) {
  hsize_t cell_count = 0, corner_count = 0, corner_end = 0, cell_end = 0, id_end = 0,
          parts = 0;
  const auto kept = static_cast<hsize_t>(count);
  if (count > 0) {
    const hsize_t last = kept - 1;
    const hsize_t own_part = place(part_offsets_, last);
    cell_count = place(number_of_cells_, own_part);
    corner_count = place(number_of_points_, own_part);
    corner_end = place(point_offsets_, last) + corner_count;
    cell_end = place(cell_offsets_, last) + cell_count;
    id_end = place(id_offsets_, last) + place(number_of_ids_, own_part);
    parts = own_part + 1;
    part_ = static_cast<std::int64_t>(own_part);
    first_cell_ = cell_offsets_.at<std::int64_t>(last);
    first_id_ = id_offsets_.at<std::int64_t>(last);
  }
  contacts_->truncate(count);
  for (auto& [name, column] : cells_)
    column.truncate(count, cell_count);
  joints_.truncate(count, corner_count);
  water_.truncate(count, cell_count);
  cracks_.truncate(count, cell_count);
  points_.truncate(corner_end);
  connectivity_.truncate(id_end);
  types_.truncate(cell_end);
  offsets_.truncate(cell_end + parts);  // each part has one more than cells
  for (Column* column : {&number_of_points_, &number_of_cells_, &number_of_ids_})
    column->truncate(parts);
  for (Column* column : {&values_, &number_of_parts_, &part_offsets_, &point_offsets_,
                         &cell_offsets_, &id_offsets_})
    column->truncate(kept);
  for (auto* columns : {&frame_data_, &frame_offsets_, &frame_sizes_})
    for (auto& [name, column] : *columns)
      column.truncate(kept);
}

std::int64_t ResultsFrames::step(long frame) {
  return frame_data_.at("Step").at<std::int64_t>(static_cast<hsize_t>(frame));
}

/// Whether the topology written last is that of these cells. A removed block differs
/// from others in its number of corners.
bool ResultsFrames::has_topology(const ResultsCells& now) {
  if (part_ < 0)
    return false;
  const auto own_part = static_cast<hsize_t>(part_);
  return number_of_cells_.at<std::int64_t>(own_part) + 1 ==
             static_cast<std::int64_t>(now.starts.size()) &&
         has_rows(offsets_, static_cast<hsize_t>(first_cell_) + own_part,
                  now.starts.size(), long_values(now.starts));
}

/// The corners of the cells are the same in all frames, so they are written again only
/// if blocks were added or removed. VTK reads the n + 1 offsets of a part at
/// CellOffsets + PartOffsets.
void ResultsFrames::put_topology(const Blocks& blocks) {
  const ResultsCells now(blocks);
  if (has_topology(now))
    return;
  part_ = -1;  // remains -1 if writing fails
  const std::int64_t points_here = blocks.corners(), cells_here = blocks.size(),
                     ids_here = static_cast<std::int64_t>(now.corners.size());

  // An interrupted write may have left columns of unequal lengths. VTK needs consistent
  // cells, parts and offsets, so all positions follow from the numbers of parts and
  // cells.
  const hsize_t next = number_of_cells_.rows();
  first_cell_ = static_cast<std::int64_t>(types_.rows());
  first_id_ = static_cast<std::int64_t>(connectivity_.rows());
  put_rows(offsets_, types_.rows() + next, now.starts.size(), long_values(now.starts));
  put_rows(connectivity_, connectivity_.rows(), now.corners.size(),
           long_values(now.corners));
  put_rows(types_, types_.rows(), static_cast<hsize_t>(cells_here),
           made_of<unsigned char>([&](hsize_t b) {
             return blocks.is_removed(static_cast<int>(b)) ? empty_cell : polygon;
           }));
  number_of_points_.put(next, &points_here, 1);
  number_of_ids_.put(next, &ids_here, 1);
  number_of_cells_.put(next, &cells_here, 1);
  part_ = static_cast<std::int64_t>(next);
}

void ResultsFrames::put_cells(long frame, const Blocks& blocks) {
  const auto n = static_cast<hsize_t>(blocks.size());
  const auto put = [&](const char* name, auto source) {
    cells_.at(name).put(frame, n, source);
  };
  put("BlockNumber", made_of<int>([](hsize_t b) { return b + 1; }));
  put("Material", as_stored(blocks.material.data()));
  put("Fixed", made_of<int>([&](hsize_t b) { return blocks.fixity[b]; }));
  put("Area", as_stored(blocks.area.data()));
  put("Mass", as_stored(blocks.mass.data()));
  put("Inertia", as_stored(blocks.inertia.data()));
  put("Centroid", in_space(blocks.centroid));
  put("Velocity", in_space(blocks.velocity));
  put("Force", in_space(blocks.force));
  put("Angle", as_stored(blocks.angle.data()));
  put("Spin", as_stored(blocks.spin.data()));
  put("Moment", as_stored(blocks.moment.data()));
  put("Stress", as_stored(blocks.stress.data(), 4));
  put("AppliedStress", as_stored(blocks.applied.data(), 4));
  put("StrainRate", as_stored(blocks.strain_rate.data(), 4));
}

void ResultsFrames::put_frame_data(long number, const Model& model) {
  const ModelTotals sums = totals(model);
  const auto frame = static_cast<hsize_t>(number);
  const std::int64_t step = model.steps, active = sums.active_contacts;
  frame_data_.at("Time").put(frame, &model.time, 1);
  frame_data_.at("Step").put(frame, &step, 1);
  frame_data_.at("KineticEnergy").put(frame, &sums.kinetic_energy, 1);
  frame_data_.at("Contacts").put(frame, &active, 1);
  frame_data_.at("WorstOverlap").put(frame, &sums.worst_overlap, 1);
  put_unbalanced(number, model);
  const std::int64_t offset = number, size[2] = {1, 1};  // components, tuples
  for (auto& [name, column] : frame_offsets_)
    column.put(frame, &offset, 1);
  for (auto& [name, column] : frame_sizes_)
    column.put(frame, size, 1);
}

void ResultsFrames::put_unbalanced(long frame, const Model& model) {
  const auto column = cells_.find(unbalanced_force.name);
  if (column == cells_.end())
    return;
  Eigen::VectorXd values;
  unbalanced_forces(model, values);
  column->second.put(frame, static_cast<hsize_t>(values.size()),
                     as_stored(values.data()));
  local_ratios(model, values);
  cells_.at(local_ratio.name)
      .put(frame, static_cast<hsize_t>(values.size()), as_stored(values.data()));
  const double ratio = unbalanced_ratio(model);
  frame_data_.at(unbalanced_share.name).put(static_cast<hsize_t>(frame), &ratio, 1);
}

void ResultsFrames::put(long number, const Model& model) {
  put_topology(model.blocks);
  const auto frame = static_cast<hsize_t>(number);
  const auto first_point = static_cast<std::int64_t>(points_.rows());
  const std::int64_t one = 1;
  put_rows(points_, points_.rows(), static_cast<hsize_t>(model.blocks.corners()),
           in_space(model.blocks.corner));
  put_cells(number, model.blocks);
  joints_.put(number, model.blocks.joint);
  water_.put(number, model);
  cracks_.put(number, model);
  put_frame_data(number, model);
  contacts_->put(number, model);
  values_.put(frame, &model.time, 1);
  number_of_parts_.put(frame, &one, 1);
  part_offsets_.put(frame, &part_, 1);
  point_offsets_.put(frame, &first_point, 1);
  cell_offsets_.put(frame, &first_cell_, 1);
  id_offsets_.put(frame, &first_id_, 1);
}

FirstPositions ResultsFrames::first_positions(const ResultsGroups& groups) {
  const hsize_t part = place(part_offsets_, 0);
  const hsize_t blocks = place(number_of_cells_, part);
  const auto plane = [](const std::vector<double>& rows) -> Eigen::Matrix2Xd {
    const auto count = static_cast<Eigen::Index>(rows.size() / 3);
    return Eigen::Map<const Eigen::Matrix3Xd>(rows.data(), 3, count).topRows(2);
  };
  Column centroid = Column::open(groups.vtk.get(), "CellData/Centroid");
  Column offset = Column::open(groups.steps.get(), "CellDataOffsets/Centroid");
  FirstPositions first{plane(centroid.read<double>(place(offset, 0), blocks)), {}};
  const Eigen::Matrix2Xd corners = plane(
      points_.read<double>(place(point_offsets_, 0), place(number_of_points_, part)));
  const auto starts =
      offsets_.read<std::int64_t>(place(cell_offsets_, 0) + part, blocks + 1);
  for (std::size_t b = 0; b < blocks; ++b) {
    first.outlines.emplace_back();
    for (std::int64_t c = starts[b]; c < starts[b + 1]; ++c)
      first.outlines.back().emplace_back(corners.col(c));
  }
  return first;
}

}  // namespace blocks::output
