#include "post/read/results_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "files/file_access_guard.hpp"
#include "files/hdf5_errors.hpp"
#include "files/hdf5_handle.hpp"
#include "output/results/results_mark.hpp"
#include "output/results/results_names.hpp"
#include "post/read/frame_units.hpp"
#include "post/read/results_file.hpp"
#include "post/read/results_nearby.hpp"

namespace blocks::post {

int Frame::count_present() const {
  return size() - static_cast<int>(std::count(fixed.begin(), fixed.end(), 3));
}

Eigen::Matrix2Xd FrameContacts::force() const {
  if (normal.cols() == 0)  // row(0) of an empty matrix has no address
    return Eigen::Matrix2Xd(2, 0);
  Eigen::Matrix2Xd along(2, normal.cols());  // edges; normals are on their left
  along.row(0) = normal.row(1);
  along.row(1) = -normal.row(0);
  return normal * normal_force.asDiagonal() - along * shear_force.asDiagonal();
}

ResultsReader::ResultsReader(const std::string& path)
    : file_(std::make_unique<File>(path)) {
  const files::FileAccessGuard in_hand("read",
                                       path);  // covers closing it after a failure
  File& from = *file_;
  const auto read = [&] {
    const auto frames = hdf5::read_attribute(from.steps.get(), "NSteps");
    return std::tuple(Column::open(from.steps.get(), "Values")
                          .read<double>(0, static_cast<hsize_t>(frames)),
                      hdf5::read_text(from.own.get(), "title"),
                      output::read_names(from.own.get()));
  };
  try {
    std::tie(from.times, from.title, from.names) =
        files::with_file_errors("read", path, [&] { return from.soundly(read); });
    if (!std::all_of(from.times.begin(), from.times.end(),
                     [](double time) { return std::isfinite(time); }))
      throw files::FileError(
          fmt::format("cannot read {}: Values are not finite", path));
    if (from.names.units.known())
      from.units = from.names.units;
  } catch (const files::FileError& error) {
    file_.reset();
    const std::string words = error.what();
    throw files::FileError(words.ends_with(File::busy) ? words
                                                       : words + results_nearby(path));
  }
}

ResultsReader::~ResultsReader() {
  const files::FileAccessGuard in_hand("read", file_->path);
  file_.reset();
}

long ResultsReader::frames() const { return static_cast<long>(file_->times.size()); }

const std::vector<double>& ResultsReader::times() const { return file_->times; }

std::string ResultsReader::title() const { return file_->title; }

const std::string& ResultsReader::path() const { return file_->path; }

const std::map<int, std::string>& ResultsReader::material_names() const {
  return file_->names.materials;
}

std::vector<PlaneLine> ResultsReader::planes() const {
  std::vector<PlaneLine> planes;
  for (const auto& [a, b] : file_->names.planes)
    planes.push_back({file_->scale.length * a, file_->scale.length * b});
  return planes;
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

void ResultsReader::make_compression_positive() { file_->compression_positive = true; }

bool ResultsReader::is_compression_positive() const {
  return file_->compression_positive;
}

Frame ResultsReader::frame(long i) const {
  file_->require(i);
  Frame frame = files::with_file_errors("read", file_->path, [&] {
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
  FrameContacts contacts = files::with_file_errors("read", file_->path, [&] {
    return file_->soundly(
        [&] { return file_->read_contacts(static_cast<hsize_t>(i)); });
  });
  convert(contacts, file_->scale);
  return contacts;
}

bool ResultsReader::has_laws() const {
  return files::with_file_errors("read", file_->path, [&] {
    return file_->soundly(
        [&] { return hdf5::exists(file_->own.get(), last_state_column); });
  });
}

bool ResultsReader::has_unbalanced() const {
  return files::with_file_errors("read", file_->path, [&] {
    return file_->soundly(
        [&] { return hdf5::exists(file_->vtk.get(), unbalanced_column); });
  });
}

std::vector<Crack> ResultsReader::cracks() const {
  std::vector<Crack> cracks = files::with_file_errors("read", file_->path, [&] {
    return file_->soundly([&] { return file_->read_cracks(); });
  });
  convert(cracks, file_->scale);
  return cracks;
}

std::vector<RecordedHistory> ResultsReader::recorded() const {
  std::vector<RecordedHistory> sections =
      files::with_file_errors("read", file_->path, [&] {
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
  const auto found = std::min_element(times.begin(), times.end(), closer);
  // Cards may have changed the model after a frame of the same time.
  return std::upper_bound(found, times.end(), *found) - 1 - times.begin();
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
