// Displacements of blocks that have split, as the figures show them
// (docs/cracks.md#pictures).
#include <pybind11/numpy.h>

#include <limits>
#include <string>

#include "bindings.hpp"
#include "post/crack_tracker.hpp"
#include "post/quantity.hpp"
#include "post/results_reader.hpp"

namespace blocks::python {
namespace {

/// Returns the displacements of frame i since the first frame, (n, 2) [L]; NaN for
/// removed blocks.
py::array displacements(const std::string& path, long i) {
  const post::ResultsReader results(path);
  const post::Frame frame = results.frame(i);
  post::ResultsTracker tracker(results);
  const post::Frame& first = tracker.at(i, frame).first;
  py::array_t<double> moved({static_cast<py::ssize_t>(frame.size()), py::ssize_t{2}});
  auto rows = moved.mutable_unchecked<2>();
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::VectorXd values =
        post::quantity(axis == 0 ? "dx" : "dy", frame, first).values;
    for (int b = 0; b < frame.size(); ++b)
      rows(b, axis) =
          frame.is_removed(b) ? std::numeric_limits<double>::quiet_NaN() : values[b];
  }
  return moved;
}

}  // namespace

void bind_displacements(py::module_& module) {
  module.def("_displacements", &displacements, py::arg("path"), py::arg("frame"));
}

}  // namespace blocks::python
