// Signals, such as Ctrl-C, during work without the lock of Python.
#pragma once

#include <functional>

namespace blocks::python {

/// Returns a function to be called often, without the lock of Python. About every 10 ms
/// it lets Python handle signals; Python does so in the main thread only. Throws
/// error_already_set if a handler raises an exception, such as KeyboardInterrupt.
std::function<void()> signal_watch();

}  // namespace blocks::python
