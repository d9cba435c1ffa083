// The colours of figures, and the faces that contacts with the law of a joint stand
// for, so that pictures of Python are those of `blocks plot`.
#include <pybind11/numpy.h>

#include <tuple>
#include <utility>
#include <vector>

#include "bindings.hpp"
#include "draw/colour_map.hpp"
#include "draw/joint_colours.hpp"
#include "post/figure/sides.hpp"
#include "post/read/joint_faces.hpp"

namespace blocks::python {
namespace {

template <class T>
using Column = py::array_t<T, py::array::c_style | py::array::forcecast>;

py::tuple tuple_of(const draw::Colour& colour) {
  return py::make_tuple(colour.r, colour.g, colour.b);
}

/// Returns a frame that has only outlines.
post::Frame frame_of(const Column<double>& corners, const Column<int>& first_corner) {
  const auto corner = corners.unchecked<2>();
  const auto first = first_corner.unchecked<1>();
  post::Frame frame;
  for (py::ssize_t b = 0; b + 1 < first.shape(0); ++b) {
    frame.number.push_back(static_cast<int>(b) + 1);
    auto& outline = frame.outlines.emplace_back();
    for (int k = first(b); k < first(b + 1); ++k)
      outline.emplace_back(corner(k, 0), corner(k, 1));
  }
  return frame;
}

/// Returns the columns of contacts that faces need. Python counts blocks from 0, and
/// corners over all blocks.
post::FrameContacts contacts_of(const py::array& table,
                                const Column<int>& first_corner) {
  const auto column = [&](const char* name) {
    const Column<int> values(table[name]);
    return std::vector<int>(values.data(), values.data() + values.size());
  };
  post::FrameContacts contacts;
  const auto place = [&](const char* block_name, const char* corner_name) {
    std::vector<int> block = column(block_name), corner = column(corner_name);
    for (std::size_t i = 0; i < block.size(); ++i) {
      const bool is_block = block[i] >= 0 && block[i] + 1 < first_corner.size();
      corner[i] = is_block ? corner[i] - first_corner.at(block[i]) + 1 : 0;
      ++block[i];
    }
    return std::pair(std::move(block), std::move(corner));
  };
  std::tie(contacts.corner_block, contacts.corner) = place("corner_block", "corner");
  std::tie(contacts.edge_block, contacts.edge) = place("edge_block", "edge");
  const Column<int> law(table["law"]), bonded(table["bonded"]), failed(table["failed"]);
  const Column<double> slip(table["slip"]);
  for (py::ssize_t i = 0; i < law.size(); ++i) {
    LawState& state = contacts.states.emplace_back();
    state.law = law.at(i), state.slip = slip.at(i);
    state.bonded = bonded.at(i) != 0, state.failed = failed.at(i) != 0;
  }
  return contacts;
}

/// Returns the ends (k, 2, 2) [L] of the parts of faces in the order in which they are
/// drawn, the words for their bonds, and their slips (k) [L].
py::tuple face_parts(const Column<double>& corners, const Column<int>& first_corner,
                     const py::array& contacts) {
  const auto parts = post::face_parts(frame_of(corners, first_corner),
                                      contacts_of(contacts, first_corner));
  const auto count = static_cast<py::ssize_t>(parts.size());
  py::array_t<double> ends({count, py::ssize_t{2}, py::ssize_t{2}}), slips(count);
  auto at = ends.mutable_unchecked<3>();
  py::list bonds;
  for (py::ssize_t i = 0; i < count; ++i) {
    const post::FacePart& part = parts[static_cast<std::size_t>(i)];
    for (int axis = 0; axis < 2; ++axis) {
      at(i, 0, axis) = part.from[axis];
      at(i, 1, axis) = part.to[axis];
    }
    bonds.append(quantities::word(part.bond));
    slips.mutable_at(i) = part.slip;
  }
  return py::make_tuple(ends, bonds, slips);
}

}  // namespace

void bind_drawing(py::module_& module) {
  module.def(
      "_material_colour",
      [](int material) { return tuple_of(draw::material_colour(material)); },
      py::arg("material"));
  module.def(
      "_joint_colour", [](int joint) { return tuple_of(draw::joint_colour(joint)); },
      py::arg("joint"));
  module.def(
      "_force_colour", [](double part) { return tuple_of(draw::intensity(part)); },
      py::arg("part"));
  module.def(
      "_slip_colour", [](double part) { return tuple_of(post::slip_colour(part)); },
      py::arg("part"));
  module.attr("_NO_JOINT_COLOUR") = tuple_of(draw::no_joint_colour);
  module.attr("_BONDED_COLOUR") = tuple_of(post::bonded_colour);
  module.def("_face_parts", &face_parts, py::arg("corners"), py::arg("first_corner"),
             py::arg("contacts"));
}

}  // namespace blocks::python
