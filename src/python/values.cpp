// Values of many blocks at once, for quantities and exports.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>
#include <optional>
#include <string>
#include <tuple>

#include "bindings.hpp"
#include "geometry/polygon.hpp"
#include "post/read/frame_quantity.hpp"
#include "post/read/units.hpp"
#include "quantities/model_quantity.hpp"
#include "quantities/quantity.hpp"

namespace blocks::python {
namespace {

template <class Number>
using Array = py::array_t<Number, py::array::c_style | py::array::forcecast>;

/// Returns the largest (sign 1) or smallest (-1) principal value of each tensor, (n).
/// tensors: (n, 2, 2).
py::array principal(const Array<double>& tensors, double sign) {
  const auto all = tensors.unchecked<3>();
  py::array_t<double> values(all.shape(0));
  for (py::ssize_t i = 0; i < all.shape(0); ++i)
    values.mutable_data()[i] = quantities::principal(
        {all(i, 0, 0), all(i, 0, 1), all(i, 1, 0), all(i, 1, 1)}, sign);
  return values;
}

/// Returns the area of each outline, (n) [L^2]; 0 without corners. corners: (m, 2)
/// [L], clockwise. first: (n + 1) the first corner of each outline.
py::array areas(const Array<double>& corners, const Array<long>& first) {
  const auto at = corners.unchecked<2>();
  const auto from = first.unchecked<1>();
  py::array_t<double> values(from.shape(0) - 1);
  for (py::ssize_t b = 0; b + 1 < from.shape(0); ++b) {
    geometry::Polygon outline;
    for (long c = from(b); c < from(b + 1); ++c)
      outline.push_back({at(c, 0), at(c, 1)});
    values.mutable_data()[b] =
        outline.empty() ? 0.0 : geometry::section_properties(outline).area;
  }
  return values;
}

py::tuple tuple_of(const quantities::Dimension& dimension) {
  return py::make_tuple(dimension.length, dimension.mass, dimension.time, dimension.si,
                        dimension.angle);
}

/// Returns the label, the dimension and whether there is a sign, by name, of the
/// quantities of blocks, contacts and the model.
py::dict quantity_kinds() {
  py::dict kinds;
  for (const quantities::QuantityKind& kind : quantities::quantity_kinds())
    kinds[py::str(kind.name)] =
        py::make_tuple(kind.label + post::sign_convention(kind, false),
                       tuple_of(kind.dimension), kind.is_signed);
  for (const auto& [name, kind] : quantities::other_kinds())
    kinds[py::str(name)] = py::make_tuple(kind.label, tuple_of(kind.dimension), false);
  return kinds;
}

/// Returns the unit of a dimension as tuple_of() makes it.
std::string
unit_text(const std::tuple<int, int, int, std::string, std::string>& dimension,
          const std::optional<std::array<std::string, 3>>& units) {
  const auto& [length, mass, time, si, angle] = dimension;
  std::optional<Units> names;
  if (units)
    names = {(*units)[0], (*units)[1], (*units)[2]};
  return post::unit_text({length, mass, time, si.c_str(), angle.c_str()}, names);
}

}  // namespace

void bind_values(py::module_& module) {
  module.def("_quantity_kinds", &quantity_kinds);
  module.def("_unit_text", &unit_text, py::arg("dimension"), py::arg("units"));
  module.def("_principal", &principal, py::arg("tensors"), py::arg("sign"));
  module.def("_areas", &areas, py::arg("corners"), py::arg("first_corner"));
}

}  // namespace blocks::python
