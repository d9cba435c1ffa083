#include "output/results/results_law_states.hpp"

#include <algorithm>
#include <string>
#include <type_traits>
#include <vector>

namespace blocks::output {
namespace {

using hdf5::Column;

constexpr hsize_t states_per_chunk = 1024;
/// The number of states assembled before they are written.
constexpr hsize_t states_at_once = 65536;

std::string path_of(const char* name) { return std::string("contacts/") + name; }

/// Writes a member of the states of contacts first_contact, first_contact + 1, ... in
/// rows `row` to `row + count`; contacts without a law have 0, unless INSITU has acted.
template <class Member>
void put_values(Column& column, hsize_t row, hsize_t count, const Model& model,
                std::size_t first_contact, Member LawState::*member) {
  std::vector<ResultsType<Member>> values(count, 0);
  const std::vector<LawState>& states = model.law_states;
  for (hsize_t i = 0; i < count && first_contact + i < states.size(); ++i)
    if (const LawState& state = states[first_contact + i];
        state.law != 0 || model.settings.in_situ)
      values[i] = state.*member;
  column.put(row, values.data(), count);
}

template <class Member> hid_t type_of(Member LawState::*) {
  return std::is_same_v<Member, double> ? H5T_NATIVE_DOUBLE : H5T_NATIVE_INT;
}

}  // namespace

void LawStateColumns::create() {
  each_law_field([&](const LawField& field, auto member) {
    columns_.emplace_back(own_, path_of(field.column), type_of(member), 0,
                          states_per_chunk);
  });
}

void LawStateColumns::open() {
  // The last column is made last. A run that was interrupted while it made them has
  // left columns without frames, which are made again.
  std::vector<std::string> found;
  std::size_t fields = 0;
  each_law_field([&](const LawField& field, auto) {
    ++fields;
    if (hdf5::exists(own_, path_of(field.column)))
      found.push_back(path_of(field.column));
  });
  for (const std::string& path : found)
    if (fields > found.size()) {
      hdf5::check(H5Ldelete(own_, path.c_str(), H5P_DEFAULT));
    } else {
      columns_.push_back(Column::open(own_, path));
      if (columns_.back().width() != 1)
        throw hdf5::Failure(path + " has the wrong shape");
    }
}

void LawStateColumns::put(hsize_t first, hsize_t end, const Model& model) {
  if (columns_.empty()) {
    if (model.settings.joint_laws.empty() && model.law_states.empty())
      return;
    create();
  }
  // Rows of frames without laws, which were never written, are 0 in HDF5.
  for (hsize_t row = first, count; row < end; row += count) {
    count = std::min(states_at_once, end - row);
    auto column = columns_.begin();
    each_law_field([&](const LawField&, auto member) {
      put_values(*column++, row, count, model, row - first, member);
    });
  }
}

void LawStateColumns::truncate(hsize_t rows) {
  for (Column& column : columns_)
    if (column.rows() > rows)  // fewer: the frames kept have no contacts after it
      column.truncate(rows);
}

}  // namespace blocks::output
