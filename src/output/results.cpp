// The layout follows VTKHDF 2.0. /VTKHDF holds the flattened arrays of all frames.
// /VTKHDF/Steps holds where each frame begins in them, and its attribute NSteps the
// number of complete frames. Free-form data are under /BLOCKS.
#include "output/results.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <map>
#include <random>

#include "output/file_tools.hpp"
#include "output/results_columns.hpp"
#include "output/results_contacts.hpp"
#include "output/results_history.hpp"
#include "output/results_mark.hpp"
#include "output/results_names.hpp"

namespace blocks::output {
namespace {

using hdf5::Column;

constexpr int format = 1;
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

/// The cells of all blocks in VTK's form. The cell of a removed block has no corners,
/// so other programs do not draw it.
struct Cells {
  std::vector<int> starts = {0};  ///< (n + 1) where the corners of each cell begin
  std::vector<int> corners;       ///< corners of all cells

  explicit Cells(const Blocks& blocks) {
    for (int b = 0; b < blocks.size(); ++b) {
      if (!blocks.is_removed(b))
        for (int c = blocks.first_corner[b]; c < blocks.first_corner[b + 1]; ++c)
          corners.push_back(c);
      starts.push_back(static_cast<int>(corners.size()));
    }
  }
};

/// A source of the same values as 64-bit numbers.
auto long_values(const std::vector<int>& values) {
  return made_of<std::int64_t>([&](hsize_t row) { return values[row]; });
}

}  // namespace

struct ResultsWriter::File {
  std::string path;
  std::string written_as;  ///< temporary name until the first frame
  std::string aside;       ///< ending for an older file of this name
  ChangeMark mark;         ///< destroyed after the HDF5 handles
  hdf5::Handle file, vtk, steps, own;
  long frames = 0;
  std::int64_t last_step = -1;

  // Created with the first frame, when the number of blocks is known.
  bool laid_out = false;
  Column points, connectivity, offsets, types;
  Column number_of_points, number_of_cells, number_of_ids;
  Column values, number_of_parts, part_offsets, point_offsets, cell_offsets, id_offsets;
  std::map<std::string, FrameColumn> cells;
  std::map<std::string, Column> frame_data, frame_offsets, frame_sizes;
  std::unique_ptr<ContactColumns> contacts;
  std::optional<HistorySections> history;

  /// Position of the topology written last; part is -1 if there is none.
  std::int64_t part = -1, first_cell = 0, first_id = 0;

  File() = default;
  ~File();
  template <class Make> void lay_out(Make&& make, hsize_t blocks, hsize_t corners);
  void create_columns(const Model& model);
  void open_columns();
  void keep(long count);
  void append(const Model& model);
  bool has_topology(const Cells& cells);
  void put_topology(const Blocks& blocks);
  void put_cells(const Blocks& blocks);
  void put_frame_data(const Model& model);
  void appear();
  void discard();
  void flush_history();
  void publish(long count) {
    hdf5::check(H5Fflush(file.get(), H5F_SCOPE_GLOBAL));
    hdf5::write_attribute(steps.get(), "NSteps", count);
    if (history)
      history->publish();
    hdf5::check(H5Fflush(file.get(), H5F_SCOPE_GLOBAL));
  }
};

/// HDF5 flushes while members are destroyed, so the mark must show a change.
ResultsWriter::File::~File() {
  try {
    mark.begin();
  } catch (...) {  // the file can no longer be written
  }
}

/// Visits all datasets, in order to create or to open them. make(group, name, type,
/// width, rows per chunk) returns the column.
template <class Make>
void ResultsWriter::File::lay_out(Make&& make, hsize_t blocks, hsize_t corners) {
  const hid_t whole = H5T_NATIVE_INT64, real = H5T_NATIVE_DOUBLE;
  const hsize_t per_block = chunk_rows(blocks), per_corner = chunk_rows(corners);
  points = make(vtk, "Points", real, 3, per_corner);
  connectivity = make(vtk, "Connectivity", whole, 0, per_corner);
  offsets = make(vtk, "Offsets", whole, 0, per_block);
  types = make(vtk, "Types", H5T_NATIVE_UCHAR, 0, per_block);
  for (auto& [column, name] : {std::pair{&number_of_points, "NumberOfPoints"},
                               {&number_of_cells, "NumberOfCells"},
                               {&number_of_ids, "NumberOfConnectivityIds"}})
    *column = make(vtk, name, whole, 0, frames_per_chunk);
  values = make(steps, "Values", real, 0, frames_per_chunk);
  for (auto& [column, name] : {std::pair{&number_of_parts, "NumberOfParts"},
                               {&part_offsets, "PartOffsets"},
                               {&point_offsets, "PointOffsets"},
                               {&cell_offsets, "CellOffsets"},
                               {&id_offsets, "ConnectivityIdOffsets"}})
    *column = make(steps, name, whole, 0, frames_per_chunk);
  for (const CellField& field : cell_fields) {
    const std::string name = field.name;
    const hid_t type = field.whole ? H5T_NATIVE_INT : real;
    cells.insert_or_assign(
        name, FrameColumn(
                  make(vtk, "CellData/" + name, type, field.width, per_block),
                  make(steps, "CellDataOffsets/" + name, whole, 0, frames_per_chunk)));
  }
  for (const CellField& field : frame_fields) {
    const std::string name = field.name;
    const hid_t type = field.whole ? whole : real;
    frame_data[name] = make(vtk, "FieldData/" + name, type, 0, frames_per_chunk);
    frame_offsets[name] =
        make(steps, "FieldDataOffsets/" + name, whole, 0, frames_per_chunk);
    frame_sizes[name] =
        make(steps, "FieldDataSizes/" + name, whole, 2, frames_per_chunk);
  }
  contacts = std::make_unique<ContactColumns>(
      [&](const std::string& name, hid_t type, hsize_t width, hsize_t chunk) {
        return make(own, "contacts/" + name, type, width, chunk);
      });
  laid_out = true;
}

void ResultsWriter::File::create_columns(const Model& model) {
  const auto make = [](const hdf5::Handle& group, const std::string& name, hid_t type,
                       hsize_t width, hsize_t chunk) {
    return Column(group.get(), name, type, width, chunk);
  };
  lay_out(make, static_cast<hsize_t>(model.blocks.size()),
          static_cast<hsize_t>(model.blocks.corners()));
  hdf5::check(H5Lcreate_hard(vtk.get(), "FieldData/Step", own.get(), "steps",
                             H5P_DEFAULT, H5P_DEFAULT));
  write_names(own.get(), model.settings);
}

void ResultsWriter::File::open_columns() {
  const auto open = [](const hdf5::Handle& group, const std::string& name, hid_t,
                       hsize_t width, hsize_t) {
    Column column = Column::open(group.get(), name);
    if (column.width() != (width == 0 ? 1 : width))
      throw hdf5::Failure(name + " has the wrong shape");
    return column;
  };
  lay_out(open, 0, 0);
}

void ResultsWriter::File::keep(long count) {
  const auto stored = hdf5::read_attribute(steps.get(), "NSteps");
  if (count < 0 || count > stored)
    throw hdf5::Failure("it has " + std::to_string(stored) + " frames, but " +
                        std::to_string(count) + " were written before the checkpoint");
  if (!hdf5::exists(own.get(), "steps"))
    return;  // no frame was ever written
  open_columns();
  publish(count);  // readers no longer see later frames

  hsize_t cell_count = 0, corner_end = 0, cell_end = 0, id_end = 0, parts = 0;
  const auto kept = static_cast<hsize_t>(count);
  if (count > 0) {
    const hsize_t last = kept - 1;
    const auto at = [](Column& column, hsize_t row) {
      return static_cast<hsize_t>(column.at<std::int64_t>(row));
    };
    const hsize_t own_part = at(part_offsets, last);
    cell_count = at(number_of_cells, own_part);
    corner_end = at(point_offsets, last) + at(number_of_points, own_part);
    cell_end = at(cell_offsets, last) + cell_count;
    id_end = at(id_offsets, last) + at(number_of_ids, own_part);
    parts = own_part + 1;
    part = static_cast<std::int64_t>(own_part);
    first_cell = cell_offsets.at<std::int64_t>(last);
    first_id = id_offsets.at<std::int64_t>(last);
    last_step = frame_data.at("Step").at<std::int64_t>(last);
  }
  contacts->truncate(count);
  for (auto& [name, column] : cells)
    column.truncate(count, cell_count);
  points.truncate(corner_end);
  connectivity.truncate(id_end);
  types.truncate(cell_end);
  offsets.truncate(cell_end + parts);  // each part has one more than cells
  for (Column* column : {&number_of_points, &number_of_cells, &number_of_ids})
    column->truncate(parts);
  for (Column* column : {&values, &number_of_parts, &part_offsets, &point_offsets,
                         &cell_offsets, &id_offsets})
    column->truncate(kept);
  for (auto* columns : {&frame_data, &frame_offsets, &frame_sizes})
    for (auto& [name, column] : *columns)
      column.truncate(kept);
  frames = count;
  hdf5::check(H5Fflush(file.get(), H5F_SCOPE_GLOBAL));
}

/// Whether the topology written last is that of these cells. A removed block differs
/// from others in its number of corners.
bool ResultsWriter::File::has_topology(const Cells& now) {
  if (part < 0)
    return false;
  const auto own_part = static_cast<hsize_t>(part);
  return number_of_cells.at<std::int64_t>(own_part) + 1 ==
             static_cast<std::int64_t>(now.starts.size()) &&
         has_rows(offsets, static_cast<hsize_t>(first_cell) + own_part,
                  now.starts.size(), long_values(now.starts));
}

/// The corners of the cells are the same in all frames, so they are written again only
/// if blocks were added or removed. VTK reads the n + 1 offsets of a part at
/// CellOffsets + PartOffsets.
void ResultsWriter::File::put_topology(const Blocks& blocks) {
  const Cells now(blocks);
  if (has_topology(now))
    return;
  part = -1;  // remains -1 if writing fails
  const std::int64_t points_here = blocks.corners(), cells_here = blocks.size(),
                     ids_here = static_cast<std::int64_t>(now.corners.size());

  // An interrupted write may have left columns of unequal lengths. VTK needs consistent
  // cells, parts and offsets, so all positions follow from the numbers of parts and
  // cells.
  const hsize_t next = number_of_cells.rows();
  first_cell = static_cast<std::int64_t>(types.rows());
  first_id = static_cast<std::int64_t>(connectivity.rows());
  put_rows(offsets, types.rows() + next, now.starts.size(), long_values(now.starts));
  put_rows(connectivity, connectivity.rows(), now.corners.size(),
           long_values(now.corners));
  put_rows(types, types.rows(), static_cast<hsize_t>(cells_here),
           made_of<unsigned char>([&](hsize_t b) {
             return blocks.is_removed(static_cast<int>(b)) ? empty_cell : polygon;
           }));
  number_of_points.put(next, &points_here, 1);
  number_of_ids.put(next, &ids_here, 1);
  number_of_cells.put(next, &cells_here, 1);
  part = static_cast<std::int64_t>(next);
}

void ResultsWriter::File::put_cells(const Blocks& blocks) {
  const auto n = static_cast<hsize_t>(blocks.size());
  const auto put = [&](const char* name, auto source) {
    cells.at(name).put(frames, n, source);
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

void ResultsWriter::File::put_frame_data(const Model& model) {
  const ModelTotals sums = totals(model);
  const auto frame = static_cast<hsize_t>(frames);
  const std::int64_t step = model.steps, active = sums.active_contacts;
  frame_data.at("Time").put(frame, &model.time, 1);
  frame_data.at("Step").put(frame, &step, 1);
  frame_data.at("KineticEnergy").put(frame, &sums.kinetic_energy, 1);
  frame_data.at("Contacts").put(frame, &active, 1);
  frame_data.at("WorstOverlap").put(frame, &sums.worst_overlap, 1);
  const std::int64_t offset = frames, size[2] = {1, 1};  // components, tuples
  for (auto& [name, column] : frame_offsets)
    column.put(frame, &offset, 1);
  for (auto& [name, column] : frame_sizes)
    column.put(frame, size, 1);
}

/// Gives the file its final name after the first frame and renames an older file.
void ResultsWriter::File::appear() {
  if (written_as.empty())
    return;
  std::error_code ignored;  // move_file() reports errors
  if (std::filesystem::exists(path, ignored))
    move_file(path, path + aside);
  move_file(written_as, path);
  written_as.clear();
}

void ResultsWriter::File::flush_history() {
  if (history->flushed())
    return;
  mark.begin();
  history->flush();
  publish(frames);
  mark.end();
}

/// Removes a file that has no frame.
void ResultsWriter::File::discard() {
  if (!written_as.empty())
    ::unlink(written_as.c_str());
}

void ResultsWriter::File::append(const Model& model) {
  mark.begin();
  if (!laid_out)
    create_columns(model);
  put_topology(model.blocks);
  const auto frame = static_cast<hsize_t>(frames);
  const auto first_point = static_cast<std::int64_t>(points.rows());
  const std::int64_t one = 1;
  put_rows(points, points.rows(), static_cast<hsize_t>(model.blocks.corners()),
           in_space(model.blocks.corner));
  put_cells(model.blocks);
  put_frame_data(model);
  contacts->put(frames, model);
  history->flush();
  values.put(frame, &model.time, 1);
  number_of_parts.put(frame, &one, 1);
  part_offsets.put(frame, &part, 1);
  point_offsets.put(frame, &first_point, 1);
  cell_offsets.put(frame, &first_cell, 1);
  id_offsets.put(frame, &first_id, 1);
  publish(frames + 1);
  mark.end();
  appear();
  ++frames;
  last_step = model.steps;
}

namespace {

std::string new_run_id() {
  std::random_device source;
  return fmt::format("{:08x}{:08x}", source(), source());
}

}  // namespace

ResultsWriter::ResultsWriter(const std::string& path, const RunIdentity& identity,
                             std::string aside)
    : file_(std::make_unique<File>()) {
  expect_replaceable(path);
  File& to = *file_;
  to.path = path;
  to.written_as = path + ".tmp";
  to.aside = std::move(aside);
  const auto create = [&] {
    to.file = hdf5::create_file(to.written_as, mark_size);
    to.mark = ChangeMark::make(to.written_as);
    to.mark.begin();
    to.vtk = hdf5::create_group(to.file.get(), "VTKHDF");
    const hdf5::Handle version_space = [] {
      const hsize_t two = 2;
      return hdf5::Handle(H5Screate_simple(1, &two, nullptr), H5Sclose);
    }();
    const std::int64_t version[2] = {2, 0};
    const hdf5::Handle attribute(H5Acreate2(to.vtk.get(), "Version", H5T_NATIVE_INT64,
                                            version_space.get(), H5P_DEFAULT,
                                            H5P_DEFAULT),
                                 H5Aclose);
    hdf5::check(H5Awrite(attribute.get(), H5T_NATIVE_INT64, version));
    hdf5::write_text_attribute(to.vtk.get(), "Type", "UnstructuredGrid");
    for (const char* group : {"CellData", "FieldData", "PointData"})
      hdf5::create_group(to.vtk.get(), group);
    to.steps = hdf5::create_group(to.vtk.get(), "Steps");
    to.own = hdf5::create_group(to.file.get(), "BLOCKS");
    hdf5::write_attribute(to.own.get(), "format", format);
    hdf5::write_attribute(to.own.get(), "seed",
                          static_cast<std::int64_t>(identity.seed));
    hdf5::write_text(to.own.get(), "run_id", new_run_id());
    hdf5::write_text(to.own.get(), "title", identity.title);
    hdf5::write_text(to.own.get(), "version", identity.version);
    hdf5::write_text(to.own.get(), "deck_file", identity.deck_file);
    hdf5::write_text(to.own.get(), "deck_text", identity.deck_text);
    hdf5::write_text(to.own.get(), "overrides", identity.overrides);
    if (!identity.continues_run.empty())
      hdf5::write_text(to.own.get(), "continues_run", identity.continues_run);
    to.history.emplace(to.own.get(), 0);
    to.publish(0);
    to.mark.end();
  };
  try {
    with_file_errors("write", path, create);
  } catch (...) {
    to.discard();
    throw;
  }
}

ResultsWriter::ResultsWriter(std::unique_ptr<File> file) : file_(std::move(file)) {}

ResultsWriter ResultsWriter::reopen(const std::string& path, long frames,
                                    long samples) {
  FileAccessGuard in_hand("continue", path);  // also covers closing after a failure
  auto file = std::make_unique<File>();
  file->path = path;
  try {
    with_file_errors("continue", path, [&] {
      file->mark = ChangeMark::find(path);
      file->mark.begin();
      file->file = hdf5::open_file(path, true);
      if (!hdf5::exists(file->file.get(), "VTKHDF") ||
          !hdf5::exists(file->file.get(), "BLOCKS"))
        throw hdf5::Failure("it is not a results file of BLOCKS");
      file->vtk = hdf5::open_group(file->file.get(), "VTKHDF");
      file->own = hdf5::open_group(file->file.get(), "BLOCKS");
      file->steps = hdf5::open_group(file->vtk.get(), "Steps");
      if (hdf5::read_attribute(file->own.get(), "format") > format)
        throw hdf5::Failure("a newer version of BLOCKS wrote it");
      file->keep(frames);
      file->history.emplace(file->own.get(), samples);
      file->mark.end();
    });
  } catch (const FileError&) {
    in_hand.must_end_within(2);
    throw;
  }
  return ResultsWriter(std::move(file));
}

ResultsWriter::~ResultsWriter() {
  if (file_ == nullptr)
    return;
  file_->discard();
  const FileAccessGuard in_hand("close", file_->path);
  file_.reset();
}
ResultsWriter::ResultsWriter(ResultsWriter&&) noexcept = default;
ResultsWriter& ResultsWriter::operator=(ResultsWriter&&) noexcept = default;

void ResultsWriter::write(const Model& model, bool changed) {
  if (!changed && file_->frames > 0 && file_->last_step == model.steps)
    return;
  with_file_errors("write", file_->path, [&] { file_->append(model); });
}

long ResultsWriter::frames() const { return file_->frames; }

std::optional<double> ResultsWriter::begin_history(const HistoryRequest& request) {
  return with_file_errors("write", file_->path, [&] {
    file_->flush_history();  // samples of the request before
    return file_->history->begin(request);
  });
}

void ResultsWriter::add_sample(double time, std::span<const double> values) {
  if (file_->history->add(time, values))
    flush_history();
}

void ResultsWriter::flush_history() {
  with_file_errors("write", file_->path, [&] { file_->flush_history(); });
}

long ResultsWriter::samples() const { return file_->history->rows(); }

FirstPositions ResultsWriter::first_positions() const {
  return with_file_errors("read", file_->path, [&] {
    File& from = *file_;
    const auto at = [](Column& column, hsize_t row) {
      return static_cast<hsize_t>(column.at<std::int64_t>(row));
    };
    const hsize_t part = at(from.part_offsets, 0);
    const hsize_t blocks = at(from.number_of_cells, part);
    const auto plane = [](const std::vector<double>& rows) -> Eigen::Matrix2Xd {
      const auto count = static_cast<Eigen::Index>(rows.size() / 3);
      return Eigen::Map<const Eigen::Matrix3Xd>(rows.data(), 3, count).topRows(2);
    };
    Column centroid = Column::open(from.vtk.get(), "CellData/Centroid");
    Column offset = Column::open(from.steps.get(), "CellDataOffsets/Centroid");
    FirstPositions first{plane(centroid.read<double>(at(offset, 0), blocks)), {}};
    const Eigen::Matrix2Xd corners = plane(from.points.read<double>(
        at(from.point_offsets, 0), at(from.number_of_points, part)));
    const auto starts =
        from.offsets.read<std::int64_t>(at(from.cell_offsets, 0) + part, blocks + 1);
    for (std::size_t b = 0; b < blocks; ++b) {
      first.outlines.emplace_back();
      for (std::int64_t c = starts[b]; c < starts[b + 1]; ++c)
        first.outlines.back().emplace_back(corners.col(c));
    }
    return first;
  });
}

std::string ResultsWriter::run_id() const {
  return with_file_errors("read", file_->path,
                          [&] { return hdf5::read_text(file_->own.get(), "run_id"); });
}

}  // namespace blocks::output
