// The layout follows VTKHDF 2.0. /VTKHDF holds the flattened arrays of all frames.
// /VTKHDF/Steps holds where each frame begins in them, and its attribute NSteps the
// number of complete frames. Free-form data are under /BLOCKS.
#include "output/results/results.hpp"

#include <fmt/format.h>
#include <random>

#include "files/file_access_guard.hpp"
#include "files/file_tools.hpp"
#include "files/hdf5_errors.hpp"
#include "output/results/results_frames.hpp"
#include "output/results/results_history.hpp"
#include "output/results/results_mark.hpp"
#include "output/results/results_names.hpp"

namespace blocks::output {
namespace {

constexpr int format = 1;

}  // namespace

struct ResultsWriter::File {
  std::string path;
  std::optional<files::TemporaryFile> temporary;  ///< until the first frame
  std::string aside;  ///< ending for an older file of this name
  ChangeMark mark;    ///< destroyed after the HDF5 handles
  hdf5::Handle file;
  ResultsGroups groups;
  long frames = 0;
  bool unbalanced = false;  ///< the frames have unbalanced forces
  std::int64_t last_step = -1;

  std::unique_ptr<ResultsFrames> data;  ///< null until the first frame
  std::optional<HistorySections> history;

  File() = default;
  ~File();
  void keep(long count);
  void append(const Model& model);
  void appear();
  void flush_history();
  void publish(long count) {
    hdf5::check(H5Fflush(file.get(), H5F_SCOPE_GLOBAL));
    hdf5::write_attribute(groups.steps.get(), "NSteps", count);
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

void ResultsWriter::File::keep(long count) {
  const auto stored = hdf5::read_attribute(groups.steps.get(), "NSteps");
  if (count < 0 || count > stored)
    throw hdf5::Failure("it has " + std::to_string(stored) + " frames, but " +
                        std::to_string(count) + " were written before the checkpoint");
  if (!hdf5::exists(groups.own.get(), "steps"))
    return;  // no frame was ever written
  data = ResultsFrames::open(groups);
  publish(count);  // readers no longer see later frames

  data->truncate(count);
  if (count > 0)
    last_step = data->step(count - 1);
  frames = count;
  hdf5::check(H5Fflush(file.get(), H5F_SCOPE_GLOBAL));
}

/// Gives the file its final name after the first frame and renames an older file.
void ResultsWriter::File::appear() {
  if (temporary)
    temporary->take_name_keeping_older(aside);
  temporary.reset();
}

void ResultsWriter::File::flush_history() {
  if (history->flushed())
    return;
  mark.begin();
  history->flush();
  publish(frames);
  mark.end();
}

void ResultsWriter::File::append(const Model& model) {
  mark.begin();
  if (!data) {
    data = ResultsFrames::create(groups, model, unbalanced);
    write_names(groups.own.get(), model.settings);
  }
  write_planes(groups.own.get(), model.settings.planes);
  data->put(frames, model);
  history->flush();
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
  File& to = *file_;
  to.path = path;
  to.temporary.emplace(path);
  to.aside = std::move(aside);
  const auto create = [&] {
    to.file = hdf5::create_file(to.temporary->path(), mark_size);
    to.mark = ChangeMark::make(to.temporary->path());
    to.mark.begin();
    to.groups.vtk = hdf5::create_group(to.file.get(), "VTKHDF");
    const hdf5::Handle version_space = [] {
      const hsize_t two = 2;
      return hdf5::Handle(H5Screate_simple(1, &two, nullptr), H5Sclose);
    }();
    const std::int64_t version[2] = {2, 0};
    const hdf5::Handle attribute(H5Acreate2(to.groups.vtk.get(), "Version",
                                            H5T_NATIVE_INT64, version_space.get(),
                                            H5P_DEFAULT, H5P_DEFAULT),
                                 H5Aclose);
    hdf5::check(H5Awrite(attribute.get(), H5T_NATIVE_INT64, version));
    hdf5::write_text_attribute(to.groups.vtk.get(), "Type", "UnstructuredGrid");
    for (const char* group : {"CellData", "FieldData", "PointData"})
      hdf5::create_group(to.groups.vtk.get(), group);
    to.groups.steps = hdf5::create_group(to.groups.vtk.get(), "Steps");
    to.groups.own = hdf5::create_group(to.file.get(), "BLOCKS");
    hdf5::write_attribute(to.groups.own.get(), "format", format);
    hdf5::write_attribute(to.groups.own.get(), "seed",
                          static_cast<std::int64_t>(identity.seed));
    hdf5::write_text(to.groups.own.get(), "run_id", new_run_id());
    hdf5::write_text(to.groups.own.get(), "title", identity.title);
    hdf5::write_text(to.groups.own.get(), "version", identity.version);
    hdf5::write_text(to.groups.own.get(), "deck_file", identity.deck_file);
    hdf5::write_text(to.groups.own.get(), "deck_text", identity.deck_text);
    hdf5::write_text(to.groups.own.get(), "overrides", identity.overrides);
    if (!identity.continues_run.empty())
      hdf5::write_text(to.groups.own.get(), "continues_run", identity.continues_run);
    to.history.emplace(to.groups.own.get(), 0);
    to.publish(0);
    to.mark.end();
  };
  files::with_file_errors("write", path, create);
}

ResultsWriter::ResultsWriter(std::unique_ptr<File> file) : file_(std::move(file)) {}

ResultsWriter ResultsWriter::reopen(const std::string& path, long frames,
                                    long samples) {
  files::FileAccessGuard in_hand("continue",
                                 path);  // also covers closing after a failure
  auto file = std::make_unique<File>();
  file->path = path;
  try {
    files::with_file_errors("continue", path, [&] {
      file->mark = ChangeMark::find(path);
      file->mark.begin();
      file->file = hdf5::open_file(path, true);
      if (!hdf5::exists(file->file.get(), "VTKHDF") ||
          !hdf5::exists(file->file.get(), "BLOCKS"))
        throw hdf5::Failure("it is not a results file of BLOCKS");
      file->groups.vtk = hdf5::open_group(file->file.get(), "VTKHDF");
      file->groups.own = hdf5::open_group(file->file.get(), "BLOCKS");
      file->groups.steps = hdf5::open_group(file->groups.vtk.get(), "Steps");
      if (hdf5::read_attribute(file->groups.own.get(), "format") > format)
        throw hdf5::Failure("a newer version of BLOCKS wrote it");
      file->keep(frames);
      file->history.emplace(file->groups.own.get(), samples);
      file->mark.end();
    });
  } catch (const files::FileError&) {
    in_hand.must_end_within(2);
    throw;
  }
  return ResultsWriter(std::move(file));
}

ResultsWriter::~ResultsWriter() {
  if (file_ == nullptr)
    return;
  file_->temporary.reset();  // a file without a frame is removed
  const files::FileAccessGuard in_hand("close", file_->path);
  file_.reset();
}
ResultsWriter::ResultsWriter(ResultsWriter&&) noexcept = default;
ResultsWriter& ResultsWriter::operator=(ResultsWriter&&) noexcept = default;

void ResultsWriter::include_unbalanced() { file_->unbalanced = true; }

void ResultsWriter::write(const Model& model, bool changed) {
  if (!changed && file_->frames > 0 && file_->last_step == model.steps)
    return;
  files::with_file_errors("write", file_->path, [&] { file_->append(model); });
}

long ResultsWriter::frames() const { return file_->frames; }

std::optional<double> ResultsWriter::begin_history(const HistoryRequest& request) {
  return files::with_file_errors("write", file_->path, [&] {
    file_->flush_history();  // samples of the request before
    return file_->history->begin(request);
  });
}

void ResultsWriter::add_sample(double time, std::span<const double> values) {
  if (file_->history->add(time, values))
    flush_history();
}

void ResultsWriter::flush_history() {
  files::with_file_errors("write", file_->path, [&] { file_->flush_history(); });
}

long ResultsWriter::samples() const { return file_->history->rows(); }

FirstPositions ResultsWriter::first_positions() const {
  return files::with_file_errors(
      "read", file_->path, [&] { return file_->data->first_positions(file_->groups); });
}

std::string ResultsWriter::run_id() const {
  return files::with_file_errors("read", file_->path, [&] {
    return hdf5::read_text(file_->groups.own.get(), "run_id");
  });
}

}  // namespace blocks::output
