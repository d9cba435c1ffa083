// Relations between the fields of a checkpoint, and what their checks share. All
// functions throw hdf5::Failure with the reason if a value is not as expected. They
// expect that each field has the values that its Field allows.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <string>

#include "files/hdf5_handle.hpp"
#include "model/model.hpp"
#include "output/checkpoint/checkpoint_field.hpp"

namespace blocks::output {

/// Expects laws that the cards JOINT, WALTON, BARTON and JPAIR can define.
void expect_laws(const Settings& settings);

/// Expects one state for each contact, or none if there are no laws.
void expect_law_states(const Model& model);

/// Expects driven blocks in ascending order, all fixed by the user, with the velocity
/// of their drive.
void expect_drives(const Model& model);

/// Expects loads on sides that exist, and water that cards can make.
void expect_loads(const Loads& loads, const Blocks& blocks);

/// Expects pairs of different blocks in ascending order, and as many contacts, poses
/// and depths as they count.
void expect_kept(const Model& model);

[[noreturn]] inline void reject_checkpoint(const std::string& what) {
  throw hdf5::Failure("no run writes such a state: " + what);
}

inline void expect(const std::string& name, double value, const Range& range) {
  if (!range.holds(value))
    reject_checkpoint(fmt::format("{} is {}, expected {}", name, value, range.words));
}

/// Expects an index in [0, n).
inline void expect_index(const char* name, long index, long n) {
  if (index < 0 || index >= n)
    reject_checkpoint(fmt::format("{} names number {} of {}", name, index + 1, n));
}

template <class List> void expect_rows(const char* name, const List& list, long rows) {
  if (std::ssize(list) != rows)
    reject_checkpoint(
        fmt::format("{} has {} rows, expected {}", name, list.size(), rows));
}

/// Expects that key(record) ascends from each record to the next.
template <class List, class Key = std::identity>
void expect_ascending(const char* name, const List& list, const Key& key = {}) {
  for (std::size_t i = 1; i < list.size(); ++i)
    if (!(std::invoke(key, list[i - 1]) < std::invoke(key, list[i])))
      reject_checkpoint(fmt::format("{} {} is out of order", name, i + 1));
}

}  // namespace blocks::output
