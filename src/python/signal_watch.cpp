#include "signal_watch.hpp"

#include <pybind11/pybind11.h>

#include <chrono>

namespace blocks::python {

std::function<void()> signal_watch() {
  using Clock = std::chrono::steady_clock;
  static constexpr auto between = std::chrono::milliseconds(10);
  return [due = Clock::now() + between]() mutable {
    if (Clock::now() < due)
      return;
    const pybind11::gil_scoped_acquire locked;
    if (PyErr_CheckSignals() != 0)
      throw pybind11::error_already_set();
    due = Clock::now() + between;
  };
}

}  // namespace blocks::python
