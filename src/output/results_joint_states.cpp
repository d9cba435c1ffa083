#include "output/results_joint_states.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace blocks::output {
namespace {

using hdf5::Column;

constexpr hsize_t states_per_chunk = 1024;
/// The number of states assembled before they are written.
constexpr hsize_t states_at_once = 65536;

std::string path_of(const char* name) { return std::string("contacts/") + name; }

/// Writes value(state) of contacts first_contact, first_contact + 1, ... in rows `row`
/// to `row + count`; contacts without a law have 0, unless INSITU has acted.
template <class T, class Value>
void put_values(Column& column, hsize_t row, hsize_t count, const Model& model,
                std::size_t first_contact, Value&& value) {
  std::vector<T> values(count, T(0));
  const std::vector<JointState>& states = model.joint_states;
  for (hsize_t i = 0; i < count && first_contact + i < states.size(); ++i)
    if (const JointState& state = states[first_contact + i];
        state.law != 0 || model.settings.in_situ)
      values[i] = static_cast<T>(value(state));
  column.put(row, values.data(), count);
}

}  // namespace

template <class Act> void JointStateColumns::visit(Columns& columns, Act&& act) {
  act(columns.law, "Law", true);
  act(columns.bonded, "Bonded", true);
  act(columns.failed, "Failed", true);
  act(columns.slip, "Slip", false);
  act(columns.path, "SlipPath", false);
  act(columns.dilation, "Dilation", false);
  act(columns.closure, "Closure", false);
  act(columns.plastic, "PlasticClosure", false);
  act(columns.stiffness, "NormalStiffness", false);
  act(columns.shear_stiffness, "ShearStiffness", false);
  act(columns.length, "Length", false);
}

void JointStateColumns::create() {
  columns_.emplace();
  visit(*columns_, [&](Column& column, const char* name, bool whole) {
    column = Column(own_, path_of(name), whole ? H5T_NATIVE_INT : H5T_NATIVE_DOUBLE, 0,
                    states_per_chunk);
  });
}

void JointStateColumns::open() {
  // The last column is made last. A run that was interrupted while it made them has
  // left columns without frames, which are made again.
  Columns found;
  bool complete = true;
  visit(found, [&](Column& column, const char* name, bool) {
    if (!hdf5::exists(own_, path_of(name))) {
      complete = false;
      return;
    }
    column = Column::open(own_, path_of(name));
    if (column.width() != 1)
      throw hdf5::Failure(path_of(name) + " has the wrong shape");
  });
  if (complete) {
    columns_.emplace(std::move(found));
    return;
  }
  found = {};
  visit(found, [&](Column&, const char* name, bool) {
    if (hdf5::exists(own_, path_of(name)))
      hdf5::check(H5Ldelete(own_, path_of(name).c_str(), H5P_DEFAULT));
  });
}

void JointStateColumns::put(hsize_t first, hsize_t end, const Model& model) {
  if (!columns_) {
    if (model.settings.joint_laws.empty() && model.joint_states.empty())
      return;
    create();
  }
  // Rows of frames without laws, which were never written, are 0 in HDF5.
  for (hsize_t row = first, count; row < end; row += count) {
    count = std::min(states_at_once, end - row);
    const auto from = static_cast<std::size_t>(row - first);
    const auto whole = [&](Column& column, auto value) {
      put_values<int>(column, row, count, model, from, value);
    };
    const auto real = [&](Column& column, auto value) {
      put_values<double>(column, row, count, model, from, value);
    };
    whole(columns_->law, [](const JointState& s) { return s.law; });
    whole(columns_->bonded, [](const JointState& s) { return s.bonded; });
    whole(columns_->failed, [](const JointState& s) { return s.failed; });
    real(columns_->slip, [](const JointState& s) { return s.slip; });
    real(columns_->path, [](const JointState& s) { return s.path; });
    real(columns_->dilation, [](const JointState& s) { return s.offset; });
    real(columns_->closure, [](const JointState& s) { return s.closure; });
    real(columns_->plastic, [](const JointState& s) { return s.plastic; });
    real(columns_->stiffness, [](const JointState& s) { return s.stiffness; });
    real(columns_->shear_stiffness,
         [](const JointState& s) { return s.shear_stiffness; });
    real(columns_->length, [](const JointState& s) { return s.length; });
  }
}

void JointStateColumns::truncate(hsize_t rows) {
  if (columns_)
    visit(*columns_, [&](Column& column, const char*, bool) {
      if (column.rows() > rows)  // fewer: the frames kept have no contacts after it
        column.truncate(rows);
    });
}

}  // namespace blocks::output
