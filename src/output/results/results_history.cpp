#include "output/results/results_history.hpp"

#include <algorithm>

namespace blocks::output {
namespace {

constexpr hsize_t rows_per_chunk = 256;
constexpr std::size_t rows_in_memory = 1024;

std::string path_of(int number) { return "history/" + std::to_string(number); }

/// The quantities as one text, one per line.
std::string lines_of(const std::vector<std::string>& quantities) {
  std::string lines;
  for (const std::string& quantity : quantities)
    lines += quantity + '\n';
  return lines;
}

}  // namespace

HistorySections::HistorySections(hid_t results, long rows) : results_(results) {
  while (hdf5::exists(results_, "history") &&
         hdf5::exists(results_, path_of(sections_ + 1)))
    ++sections_;
  for (int number = 1; number <= sections_; ++number) {
    Section section = open(number);
    const auto kept = std::min(section.rows, static_cast<hsize_t>(rows - rows_));
    section.rows = kept;
    hdf5::write_attribute(section.group.get(), "rows", static_cast<std::int64_t>(kept));
    rows_ += static_cast<long>(kept);
    if (kept > 0)
      used_ = number;
  }
  if (rows_ != rows)
    throw hdf5::Failure("it has " + std::to_string(rows_) +
                        " samples of HISTORY, but " + std::to_string(rows) +
                        " were written before the checkpoint");
  if (sections_ == 0)
    return;
  const hdf5::Handle history = hdf5::open_group(results_, "history");
  hdf5::check(H5Fflush(history.get(), H5F_SCOPE_GLOBAL));  // hidden, then removed
  for (int number = 1; number <= sections_; ++number) {
    Section section = open(number);
    section.time.truncate(section.rows);
    section.values.truncate(section.rows);
  }
}

HistorySections::Section HistorySections::open(int number) const {
  Section section;
  section.group = hdf5::open_group(results_, path_of(number));
  section.time = hdf5::Column::open(section.group.get(), "time");
  section.values = hdf5::Column::open(section.group.get(), "values");
  const auto rows = hdf5::read_attribute(section.group.get(), "rows");
  section.rows = static_cast<hsize_t>(rows);
  if (rows < 0 || section.time.width() != 1 ||
      std::min(section.time.rows(), section.values.rows()) < section.rows)
    throw hdf5::Failure(path_of(number) + " has the wrong shape");
  return section;
}

HistorySections::Section HistorySections::create(int number) const {
  Section section;
  section.group = hdf5::create_group(results_, path_of(number));
  const hid_t group = section.group.get(), real = H5T_NATIVE_DOUBLE;
  hdf5::write_attribute(group, "rows", 0);
  hdf5::write_real_attribute(group, "interval", request_.interval);
  hdf5::write_text_attribute(group, "sampling", history_sampling);
  hdf5::write_text(group, "quantities", lines_of(request_.quantities));
  section.time = hdf5::Column(group, "time", real, 0, rows_per_chunk);
  section.values =
      hdf5::Column(group, "values", real, request_.quantities.size(), rows_per_chunk);
  return section;
}

bool HistorySections::is_of(const Section& section,
                            const HistoryRequest& request) const {
  return section.values.width() == request.quantities.size() &&
         hdf5::read_real_attribute(section.group.get(), "interval") ==
             request.interval &&
         hdf5::read_text(section.group.get(), "quantities") ==
             lines_of(request.quantities);
}

std::optional<double> HistorySections::begin(const HistoryRequest& request) {
  request_ = request;
  times_.reserve(rows_in_memory);
  values_.reserve(rows_in_memory * request.quantities.size());
  current_.reset();
  if (used_ == 0)
    return {};
  Section last = open(used_);
  if (!is_of(last, request))
    return {};
  const double time = last.time.at<double>(last.rows - 1);
  current_ = std::move(last);
  return time;
}

bool HistorySections::add(double time, std::span<const double> values) {
  times_.push_back(time);
  values_.insert(values_.end(), values.begin(), values.end());
  ++rows_;
  return times_.size() >= rows_in_memory;
}

void HistorySections::flush() {
  if (times_.empty())
    return;
  if (!current_) {
    // A resumed run fills the sections that its later part had made.
    int number = used_ + 1;
    while (number <= sections_ && !is_of(open(number), request_))
      ++number;
    current_ = number <= sections_ ? open(number) : create(number);
    sections_ = std::max(sections_, number);
    used_ = number;
  }
  current_->time.put(current_->rows, times_.data(), times_.size());
  current_->values.put(current_->rows, values_.data(), times_.size());
  current_->rows += times_.size();
  times_.clear();
  values_.clear();
  published_ = false;
}

void HistorySections::publish() {
  if (published_)
    return;
  hdf5::write_attribute(current_->group.get(), "rows",
                        static_cast<std::int64_t>(current_->rows));
  published_ = true;
}

}  // namespace blocks::output
