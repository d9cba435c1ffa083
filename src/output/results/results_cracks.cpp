#include "output/results/results_cracks.hpp"

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace blocks::output {
namespace {

using hdf5::Column;

constexpr const char *parent_data = "CellData/Parent",
                     *parent_offsets = "CellDataOffsets/Parent", *group = "cracks";
constexpr hsize_t rows_per_chunk = 256;

std::string path_of(const char* name) { return std::string("cracks/") + name; }

/// Returns for each block the number, from 1, of the block from which it split off; 0:
/// none.
std::vector<int> parents_of_blocks(const Model& model) {
  std::vector<int> parents(static_cast<std::size_t>(model.blocks.size()), 0);
  for (const CrackRecord& crack : model.cracks)
    parents[static_cast<std::size_t>(crack.child)] = crack.parent + 1;
  return parents;
}

}  // namespace

template <class Act> void CrackColumns::visit(Columns& columns, Act&& act) {
  const hid_t real = H5T_NATIVE_DOUBLE, whole = H5T_NATIVE_INT;
  act(columns.step, "step", H5T_NATIVE_INT64, 0);
  act(columns.time, "time", real, 0);
  act(columns.parent, "parent", whole, 0);
  act(columns.child, "child", whole, 0);
  act(columns.cause, "cause", whole, 0);
  act(columns.stress, "stress", real, 0);
  act(columns.from, "from", real, 3);
  act(columns.to, "to", real, 3);
  act(columns.moved, "moved", real, 0);
  act(columns.parent_area, "parent_area", real, 0);
  act(columns.child_area, "child_area", real, 0);
  act(columns.kinetic_before, "kinetic_before", real, 0);
  act(columns.kinetic_after, "kinetic_after", real, 0);
  act(columns.strain_before, "strain_before", real, 0);
  act(columns.strain_after, "strain_after", real, 0);
  act(columns.counts, "counts", H5T_NATIVE_INT64, 0);
}

void CrackColumns::create(long frame, hsize_t blocks) {
  parents_.emplace(Column(vtk_, parent_data, H5T_NATIVE_INT, 0, chunk_rows(blocks)),
                   Column(steps_, parent_offsets, H5T_NATIVE_INT64, 0, rows_per_chunk));
  if (frame > 0)  // blocks keep their numbers, so no earlier frame has more
    parents_->start_late<int>(frame, blocks);
  Columns made;
  visit(made, [&](Column& column, const char* name, hid_t type, hsize_t width) {
    column = Column(own_, path_of(name), type, width, rows_per_chunk);
  });
  columns_.emplace(std::move(made));
  rows_ = 0;
}

/// Removes all data, also those of a frame that was interrupted while it added them.
void CrackColumns::remove() {
  columns_.reset();
  parents_.reset();
  for (const auto& [place, name] :
       {std::pair{vtk_, parent_data}, {steps_, parent_offsets}, {own_, group}})
    if (hdf5::exists(place, name))
      hdf5::check(H5Ldelete(place, name, H5P_DEFAULT));
}

void CrackColumns::open() {
  // The counts are made last. Without them a frame was interrupted while it added the
  // data, which no complete frame has.
  if (!hdf5::exists(own_, group) || !hdf5::exists(own_, path_of("counts"))) {
    remove();
    return;
  }
  Columns found;
  visit(found, [&](Column& column, const char* name, hid_t, hsize_t width) {
    column = Column::open(own_, path_of(name));
    if (column.width() != (width == 0 ? 1 : width))
      throw hdf5::Failure(path_of(name) + " has the wrong shape");
  });
  Column data = Column::open(vtk_, parent_data),
         offsets = Column::open(steps_, parent_offsets);
  if (data.width() != 1 || offsets.width() != 1)
    throw hdf5::Failure("Parent has the wrong shape");
  columns_.emplace(std::move(found));
  parents_.emplace(std::move(data), std::move(offsets));
}

void CrackColumns::put_records(const Model& model) {
  const std::span<const CrackRecord> made =
      std::span(model.cracks).subspan(static_cast<std::size_t>(rows_));
  const auto put = [&]<class T>(Column& column, T, auto value) {
    std::vector<T> values;
    for (const CrackRecord& crack : made)
      values.push_back(static_cast<T>(value(crack)));
    column.put(rows_, values.data(), values.size());
  };
  const auto place = [&](Column& column, Vec2 CrackRecord::*end) {
    std::vector<double> values;
    for (const CrackRecord& crack : made)
      values.insert(values.end(), {(crack.*end).x(), (crack.*end).y(), 0.0});
    column.put(rows_, values.data(), made.size());
  };
  const auto real = [&](Column& column, double CrackRecord::*value) {
    put(column, double{}, [&](const CrackRecord& crack) { return crack.*value; });
  };
  Columns& to = *columns_;
  put(to.step, std::int64_t{}, [](const CrackRecord& crack) { return crack.step; });
  put(to.parent, int{}, [](const CrackRecord& crack) { return crack.parent + 1; });
  put(to.child, int{}, [](const CrackRecord& crack) { return crack.child + 1; });
  put(to.cause, int{}, [](const CrackRecord& crack) { return crack.cause; });
  place(to.from, &CrackRecord::from);
  place(to.to, &CrackRecord::to);
  real(to.time, &CrackRecord::time);
  real(to.stress, &CrackRecord::stress);
  real(to.moved, &CrackRecord::moved);
  real(to.parent_area, &CrackRecord::parent_area);
  real(to.child_area, &CrackRecord::child_area);
  real(to.kinetic_before, &CrackRecord::kinetic_before);
  real(to.kinetic_after, &CrackRecord::kinetic_after);
  real(to.strain_before, &CrackRecord::strain_before);
  real(to.strain_after, &CrackRecord::strain_after);
}

void CrackColumns::put(long frame, const Model& model) {
  const std::vector<int> parents = parents_of_blocks(model);
  const auto blocks = static_cast<hsize_t>(parents.size());
  if (!columns_) {
    if (model.settings.crack_rules.empty() && model.cracks.empty())
      return;
    create(frame, blocks);
  }
  put_records(model);
  parents_->put(frame, blocks, as_stored(parents.data()));
  // Counts of earlier frames without a CRACK card, which were never written, are 0.
  const auto count = static_cast<std::int64_t>(model.cracks.size());
  columns_->counts.put(static_cast<hsize_t>(frame), &count, 1);
  rows_ = static_cast<hsize_t>(count);
}

void CrackColumns::truncate(long frames, hsize_t blocks) {
  if (!columns_)
    return;
  const auto kept = static_cast<hsize_t>(frames);
  if (columns_->counts.rows() < kept) {  // the frame that added them was interrupted
    remove();
    return;
  }
  rows_ = frames == 0
              ? 0
              : static_cast<hsize_t>(columns_->counts.at<std::int64_t>(kept - 1));
  visit(*columns_, [&](Column& column, const char*, hid_t, hsize_t) {
    column.truncate(&column == &columns_->counts ? kept : rows_);
  });
  parents_->truncate(frames, blocks);
}

}  // namespace blocks::output
