// Displacements of blocks that have split, and motions of faces, as the figures show
// them (docs/cracks.md#pictures, docs/joints.md#opening).
#include <pybind11/numpy.h>

#include <limits>
#include <string>

#include "bindings.hpp"
#include "post/read/crack_tracker.hpp"
#include "post/read/face_motion.hpp"
#include "post/read/frame_quantity.hpp"
#include "post/read/results_reader.hpp"

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

/// Returns the ends (k, 2, 2, 2) of both sides of the faces in frame i, and their
/// openings and shear displacements at both ends, (k, 2), all [L].
py::tuple face_motions(const std::string& path, long i) {
  const post::ResultsReader results(path);
  const post::Frame frame = results.frame(i);
  post::ResultsTracker tracker(results);
  const post::CrackedBlocks& cracked = tracker.at(i, frame);
  const auto motions = post::face_motions(frame, cracked.first, &cracked);
  const auto count = static_cast<py::ssize_t>(motions.size());
  constexpr py::ssize_t two = 2;
  py::array_t<double> ends({count, two, two, two}), opening({count, two}),
      shear({count, two});
  auto places = ends.mutable_unchecked<4>();
  for (py::ssize_t k = 0; k < count; ++k) {
    const post::FaceMotion& motion = motions[static_cast<std::size_t>(k)];
    for (int end = 0; end < 2; ++end) {
      opening.mutable_at(k, end) = motion.opening[end];
      shear.mutable_at(k, end) = motion.shear[end];
      const auto at = static_cast<std::size_t>(end);
      for (int axis = 0; axis < 2; ++axis) {
        places(k, 0, end, axis) = motion.own[at][axis];
        places(k, 1, end, axis) = motion.other[at][axis];
      }
    }
  }
  return py::make_tuple(ends, opening, shear);
}

}  // namespace

void bind_displacements(py::module_& module) {
  module.def("_displacements", &displacements, py::arg("path"), py::arg("frame"));
  module.def("_face_motions", &face_motions, py::arg("path"), py::arg("frame"));
}

}  // namespace blocks::python
