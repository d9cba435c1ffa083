#include "post/results_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <sstream>
#include <tuple>

#include "output/file_tools.hpp"
#include "output/hdf5_handle.hpp"
#include "output/results.hpp"
#include "output/results_mark.hpp"
#include "output/results_names.hpp"
#include "post/frame_units.hpp"
#include "post/results_nearby.hpp"

namespace blocks::post {

using output::hdf5::Column;
using output::hdf5::Failure;
using output::hdf5::Handle;

namespace {

/// How long to wait for a run that is writing a frame, [s]. It needs milliseconds, but
/// a disk may delay it.
constexpr std::chrono::seconds patience(10);
/// The column of the states of laws that a run makes last.
const std::string last_law_column = "contacts/Length";
const std::string busy = "a run is writing to it now; try again";

}  // namespace

struct ResultsReader::File {
  std::string path;
  output::ChangeWatch watch;
  std::optional<std::uint64_t> opened_at;  ///< number of changes when it was opened
  Handle file, vtk, steps, own;
  std::vector<double> times;
  std::string title;
  output::ResultsNames names;
  std::optional<Units> units;
  UnitScale scale;  ///< from the units of the deck to `units`
  bool compression_positive = false;

  explicit File(const std::string& name) : path(name), watch(name) {}

  /// Throws Failure.
  void open();
  /// Returns the result of `action`, which reads the file. If the file has changed
  /// meanwhile, opens it again and repeats, for at most `patience`. Throws Failure.
  template <class Action> auto soundly(Action&& action) -> decltype(action());

  hsize_t step_value(const std::string& name, hsize_t row) const {
    const auto value = Column::open(steps.get(), name).at<std::int64_t>(row);
    if (value < 0)
      throw Failure("Steps/" + name + " is negative");
    return static_cast<hsize_t>(value);
  }
  hsize_t count(const std::string& name, hsize_t row) const {
    const auto value = Column::open(vtk.get(), name).at<std::int64_t>(row);
    if (value < 0)
      throw Failure(name + " is negative");
    return static_cast<hsize_t>(value);
  }
  template <class T>
  std::vector<T> rows(const char* name, hsize_t row, hsize_t n) const {
    return Column::open(vtk.get(), name).read<T>(row, n);
  }
  /// Returns cell data of a frame, `width` values for each block.
  template <class T>
  std::vector<T> cells(const std::string& name, hsize_t frame, hsize_t n,
                       hsize_t width) const {
    Column column = Column::open(vtk.get(), "CellData/" + name);
    if (column.width() != width)
      throw Failure(name + " has the wrong shape");
    return column.read<T>(step_value("CellDataOffsets/" + name, frame), n);
  }
  template <class T> T field(const std::string& name, hsize_t frame) const {
    return Column::open(vtk.get(), "FieldData/" + name)
        .at<T>(step_value("FieldDataOffsets/" + name, frame));
  }
  template <class T>
  std::vector<T> contact(const char* name, hsize_t from, hsize_t n,
                         hsize_t width) const {
    Column column = Column::open(own.get(), std::string("contacts/") + name);
    if (column.width() != width)
      throw Failure(std::string("contacts/") + name + " has the wrong shape");
    return column.read<T>(from, n);
  }
  /// Returns a column of the states of laws. Rows that it lacks belong to frames
  /// before the first JOINT card and are 0.
  template <class T>
  std::vector<T> law(const char* name, hsize_t from, hsize_t n) const {
    Column column = Column::open(own.get(), std::string("contacts/") + name);
    if (column.width() != 1)
      throw Failure(std::string("contacts/") + name + " has the wrong shape");
    const hsize_t rows = column.rows(), there = rows > from ? rows - from : 0;
    std::vector<T> values = column.read<T>(std::min(from, rows), std::min(n, there));
    values.resize(n, T(0));
    return values;
  }
  /// Throws FileError, with the range of frames, unless frame i exists.
  void require(long i) const;
  Frame read(hsize_t i) const;
  FrameContacts read_contacts(hsize_t i) const;
  FrameContacts::Laws read_laws(hsize_t from, hsize_t m) const;
  std::vector<RecordedHistory> read_recorded() const;
  /// Returns the joint ids of all points of a frame; empty if the file has none.
  std::vector<int> read_joints(hsize_t i, hsize_t points) const;
  void read_outlines(hsize_t i, hsize_t part, hsize_t n, Frame& frame) const;
};

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
    for (auto* tensor : {&frame.stress, &frame.applied, &frame.strain_rate})
      tensor->col(b).setConstant(std::nan(""));
  }
}

}  // namespace

std::vector<int> ResultsReader::File::read_joints(hsize_t i, hsize_t points) const {
  if (!output::hdf5::exists(vtk.get(), "PointData") ||
      !output::hdf5::exists(vtk.get(), "PointData/Joint"))
    return {};
  Column stored = Column::open(vtk.get(), "PointData/Joint");
  if (stored.width() != 1)
    throw Failure("Joint has the wrong shape");
  // A run that was interrupted while it added the data left frames without an offset.
  if (!output::hdf5::exists(steps.get(), "PointDataOffsets") ||
      !output::hdf5::exists(steps.get(), "PointDataOffsets/Joint") ||
      Column::open(steps.get(), "PointDataOffsets/Joint").rows() <= i)
    return {};
  std::vector<int> joints =
      stored.read<int>(step_value("PointDataOffsets/Joint", i), points);
  if (std::any_of(joints.begin(), joints.end(), [](int joint) { return joint < 0; }))
    throw Failure("Joint is negative");
  return joints;
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

  const std::vector<int> joints = read_joints(i, points);
  if (!joints.empty())
    frame.joints.resize(n);
  frame.outlines.resize(n);
  for (std::size_t b = 0; b < n; ++b) {
    const std::int64_t from = starts[b], to = starts[b + 1];
    if (from < 0 || to < from || to > static_cast<std::int64_t>(ids))
      throw Failure("Offsets are out of range");
    for (std::int64_t k = from; k < to; ++k) {
      const std::int64_t point = connectivity[static_cast<std::size_t>(k)];
      if (point < 0 || point >= corners.cols())
        throw Failure("Connectivity is out of range");
      frame.outlines[b].emplace_back(corners.col(point));
      if (!joints.empty())
        frame.joints[b].push_back(joints[static_cast<std::size_t>(point)]);
    }
  }
}

Frame ResultsReader::File::read(hsize_t i) const {
  const hsize_t part = step_value("PartOffsets", i);
  const hsize_t n = count("NumberOfCells", part);
  Frame frame;
  frame.time = times[i];
  frame.step = field<std::int64_t>("Step", i);
  frame.kinetic_energy = field<double>("KineticEnergy", i);
  frame.number = cells<int>("BlockNumber", i, n, 1);
  frame.material = cells<int>("Material", i, n, 1);
  frame.fixed = cells<int>("Fixed", i, n, 1);
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
  read_outlines(i, part, n, frame);
  hide_removed(frame);
  return frame;
}

int Frame::count_present() const {
  return size() - static_cast<int>(std::count(fixed.begin(), fixed.end(), 3));
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
  if (output::hdf5::exists(own.get(), last_law_column))
    rows.laws = read_laws(from, m);
  return rows;
}

FrameContacts::Laws ResultsReader::File::read_laws(hsize_t from, hsize_t m) const {
  FrameContacts::Laws laws;
  laws.law = law<int>("Law", from, m);
  laws.bonded = law<int>("Bonded", from, m);
  laws.failed = law<int>("Failed", from, m);
  laws.slip = vector(law<double>("Slip", from, m));
  laws.dilation = vector(law<double>("Dilation", from, m));
  laws.plastic_closure = vector(law<double>("PlasticClosure", from, m));
  laws.length = vector(law<double>("Length", from, m));
  return laws;
}

std::vector<RecordedHistory> ResultsReader::File::read_recorded() const {
  std::vector<RecordedHistory> sections;
  const bool any = output::hdf5::exists(own.get(), "history");
  for (int number = 1; any; ++number) {
    const std::string place = "history/" + std::to_string(number);
    if (!output::hdf5::exists(own.get(), place))
      break;
    const Handle group = output::hdf5::open_group(own.get(), place);
    RecordedHistory section;
    section.interval = output::hdf5::read_real_attribute(group.get(), "interval");
    std::istringstream lines(output::hdf5::read_text(group.get(), "quantities"));
    for (std::string name; std::getline(lines, name);)
      section.quantities.push_back(name);
    const auto rows = output::hdf5::read_attribute(group.get(), "rows");
    Column time = Column::open(group.get(), "time"),
           values = Column::open(group.get(), "values");
    if (rows < 0 || time.width() != 1 || values.width() != section.quantities.size())
      throw Failure(place + " has the wrong shape");
    const auto count = static_cast<hsize_t>(rows);
    section.time = time.read<double>(0, count);
    const std::vector<double> stored = values.read<double>(0, count);
    section.values = Eigen::Map<const Eigen::MatrixXd>(
        stored.data(), static_cast<Eigen::Index>(values.width()), rows);
    if (count > 0)
      sections.push_back(std::move(section));
  }
  return sections;
}

Eigen::Matrix2Xd FrameContacts::force() const {
  if (normal.cols() == 0)  // row(0) of an empty matrix has no address
    return Eigen::Matrix2Xd(2, 0);
  Eigen::Matrix2Xd along(2, normal.cols());  // edges; normals are on their left
  along.row(0) = normal.row(1);
  along.row(1) = -normal.row(0);
  return normal * normal_force.asDiagonal() - along * shear_force.asDiagonal();
}

void ResultsReader::File::open() {
  if (const std::string fault = fault_of_head(path); !fault.empty())
    throw Failure(fault);
  for (Handle* handle : {&own, &steps, &vtk, &file})
    *handle = Handle();  // HDF5 caches data of an open file
  file = output::hdf5::open_file(path, false);
  if (!output::hdf5::exists(file.get(), "VTKHDF") ||
      !output::hdf5::exists(file.get(), "BLOCKS"))
    throw Failure("it is not a results file of BLOCKS");
  vtk = output::hdf5::open_group(file.get(), "VTKHDF");
  steps = output::hdf5::open_group(vtk.get(), "Steps");
  own = output::hdf5::open_group(file.get(), "BLOCKS");
  if (!watch.still_named(path))
    throw Failure("another file has replaced it; try again");
  // Frames beyond NSteps are incomplete, or were cut off.
  const auto frames = output::hdf5::read_attribute(steps.get(), "NSteps");
  if (frames <= 0)
    throw Failure("it has no frames yet");
  if (static_cast<std::size_t>(frames) < times.size())
    throw Failure("a restart has removed frames from it; try again");
}

template <class Action>
auto ResultsReader::File::soundly(Action&& action) -> decltype(action()) {
  const auto until = std::chrono::steady_clock::now() + patience;
  while (const auto number = watch.settled(until)) {
    try {
      if (opened_at != number) {
        opened_at.reset();
        open();
        opened_at = number;
      }
      auto result = action();
      if (watch.number() == *number)
        return result;
    } catch (...) {  // also std::bad_alloc, after a size read during a change
      if (watch.number() == *number)
        throw;
    }
    if (std::chrono::steady_clock::now() > until)
      break;
  }
  throw Failure(busy);
}

ResultsReader::ResultsReader(const std::string& path)
    : file_(std::make_unique<File>(path)) {
  const output::FileAccessGuard in_hand("read",
                                        path);  // covers closing it after a failure
  File& from = *file_;
  const auto read = [&] {
    const auto frames = output::hdf5::read_attribute(from.steps.get(), "NSteps");
    return std::tuple(Column::open(from.steps.get(), "Values")
                          .read<double>(0, static_cast<hsize_t>(frames)),
                      output::hdf5::read_text(from.own.get(), "title"),
                      output::read_names(from.own.get()));
  };
  try {
    std::tie(from.times, from.title, from.names) =
        output::with_file_errors("read", path, [&] { return from.soundly(read); });
    if (from.names.units.known())
      from.units = from.names.units;
  } catch (const output::FileError& error) {
    file_.reset();
    const std::string words = error.what();
    throw output::FileError(words.ends_with(busy) ? words
                                                  : words + results_nearby(path));
  }
}

ResultsReader::~ResultsReader() {
  const output::FileAccessGuard in_hand("read", file_->path);
  file_.reset();
}

long ResultsReader::frames() const { return static_cast<long>(file_->times.size()); }

const std::vector<double>& ResultsReader::times() const { return file_->times; }

std::string ResultsReader::title() const { return file_->title; }

const std::string& ResultsReader::path() const { return file_->path; }

const std::map<int, std::string>& ResultsReader::material_names() const {
  return file_->names.materials;
}

const std::optional<Units>& ResultsReader::units() const { return file_->units; }

void ResultsReader::show_in(const Units& units) {
  if (const std::optional<Units>& now = file_->units) {
    UnitScale step;
    try {
      step = UnitScale::between(*now, units);
    } catch (const std::runtime_error& fault) {
      throw std::runtime_error(fmt::format("{} is in {}, not in {}: {}", file_->path,
                                           names_of(*now), names_of(units),
                                           fault.what()));
    }
    UnitScale& scale = file_->scale;
    scale = {scale.length * step.length, scale.mass * step.mass,
             scale.time * step.time};
    for (double& time : file_->times)
      time *= step.time;
  }
  file_->units = units;
}

void ResultsReader::File::require(long i) const {
  const auto frames = static_cast<long>(times.size());
  if (i < 0 || i >= frames)
    throw output::FileError(path + " has frames 0 to " + std::to_string(frames - 1) +
                            ", not " + std::to_string(i));
}

void ResultsReader::make_compression_positive() { file_->compression_positive = true; }

bool ResultsReader::is_compression_positive() const {
  return file_->compression_positive;
}

Frame ResultsReader::frame(long i) const {
  file_->require(i);
  Frame frame = output::with_file_errors("read", file_->path, [&] {
    return file_->soundly([&] { return file_->read(static_cast<hsize_t>(i)); });
  });
  convert(frame, file_->scale);
  if (file_->compression_positive) {
    frame.stress *= -1.0;
    frame.applied *= -1.0;
    frame.compression_positive = true;
  }
  return frame;
}

std::vector<std::vector<Eigen::Vector2d>> ResultsReader::last_outlines(long i) const {
  const Frame now = frame(i);
  auto outlines = now.outlines;
  int missing = now.size() - now.count_present();
  for (long k = i - 1; k >= 0 && missing > 0; --k) {
    const Frame earlier = frame(k);
    for (int b = 0; b < earlier.size(); ++b)
      if (auto& outline = outlines[static_cast<std::size_t>(b)];
          outline.empty() && !earlier.is_removed(b)) {
        outline = earlier.outlines[static_cast<std::size_t>(b)];
        --missing;
      }
  }
  return outlines;
}

FrameContacts ResultsReader::contacts(long i) const {
  file_->require(i);
  FrameContacts contacts = output::with_file_errors("read", file_->path, [&] {
    return file_->soundly(
        [&] { return file_->read_contacts(static_cast<hsize_t>(i)); });
  });
  convert(contacts, file_->scale);
  return contacts;
}

bool ResultsReader::has_laws() const {
  return output::with_file_errors("read", file_->path, [&] {
    return file_->soundly(
        [&] { return output::hdf5::exists(file_->own.get(), last_law_column); });
  });
}

std::vector<RecordedHistory> ResultsReader::recorded() const {
  std::vector<RecordedHistory> sections =
      output::with_file_errors("read", file_->path, [&] {
        return file_->soundly([&] { return file_->read_recorded(); });
      });
  for (RecordedHistory& section : sections)
    convert(section, file_->scale);
  return sections;
}

long ResultsReader::nearest(double time) const {
  const auto& times = file_->times;
  const auto closer = [time](double a, double b) {
    return std::abs(a - time) < std::abs(b - time);
  };
  return std::min_element(times.begin(), times.end(), closer) - times.begin();
}

long ResultsReader::at(double time) const {
  const double first = file_->times.front(), last = file_->times.back();
  const double slack = 1e-3 * (last - first);  // a run ends up to one step late
  if (!(time >= first - slack && time <= last + slack))
    throw std::runtime_error(fmt::format("{} has times {:g} to {:g}, not {:g}",
                                         file_->path, first, last, time));
  return nearest(time);
}

}  // namespace blocks::post
