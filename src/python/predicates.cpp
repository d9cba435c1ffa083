// blocks.predicates: the exact predicates of contact detection on arrays of points.
#include <pybind11/numpy.h>

#include <array>
#include <cmath>
#include <string>

#include "bindings.hpp"
#include "geometry/contact_predicates.hpp"

namespace blocks::python {
namespace {

using geometry::Vec2;
/// (rows, 2) or (2), in the order of C.
using Points = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// One argument of a predicate: a point for each row, or the same point for all rows.
struct Argument {
  const double* data;
  py::ssize_t step;
  Vec2 at(py::ssize_t row) const { return {data[step * row], data[step * row + 1]}; }
};

[[noreturn]] void refuse(const std::string& what) { throw py::value_error(what); }

template <std::size_t count>
py::ssize_t rows_of(const std::array<Points, count>& given,
                    const std::array<const char*, count>& names,
                    std::array<Argument, count>& arguments) {
  py::ssize_t rows = -1;
  for (std::size_t i = 0; i < count; ++i) {
    const Points& points = given[i];
    const bool is_point = points.ndim() == 1 && points.shape(0) == 2;
    if (!is_point && !(points.ndim() == 2 && points.shape(1) == 2))
      refuse(std::string(names[i]) + " must have the shape (2,) or (n, 2)");
    arguments[i] = {points.data(), is_point ? 0 : 2};
    if (is_point)
      continue;
    if (rows >= 0 && rows != points.shape(0))
      refuse(std::string(names[i]) + " has " + std::to_string(points.shape(0)) +
             " rows, and other points have " + std::to_string(rows));
    rows = points.shape(0);
  }
  for (std::size_t i = 0; i < count; ++i)
    for (py::ssize_t k = 0; k < given[i].size(); ++k)
      if (!std::isfinite(given[i].data()[k]))
        refuse(std::string(names[i]) + " has a coordinate that is not a finite number");
  return rows;
}

/// Calls a predicate for each row. Returns an array, or a scalar if all arguments are
/// single points.
template <class Answer, std::size_t count, class Predicate>
py::object each_row(const std::array<Points, count>& given,
                    const std::array<const char*, count>& names,
                    const Predicate& predicate) {
  std::array<Argument, count> arguments;
  const py::ssize_t rows = rows_of(given, names, arguments);
  const auto ask = [&](py::ssize_t row) {
    return [&]<std::size_t... i>(std::index_sequence<i...>) {
      return static_cast<Answer>(predicate(arguments[i].at(row)...));
    }
    (std::make_index_sequence<count>());
  };
  if (rows < 0)
    return py::cast(
        static_cast<std::conditional_t<std::is_same_v<Answer, bool>, bool, int>>(
            ask(0)));
  py::array_t<Answer> answers(rows);
  Answer* const out = answers.mutable_data();
  {
    const py::gil_scoped_release released;
    for (py::ssize_t row = 0; row < rows; ++row)
      out[row] = ask(row);
  }
  return answers;
}

constexpr const char* shapes = R"(

Each point is (2,), or (n, 2) for n rows, [L]. Returns an array (n,), or a scalar if all
arguments are single points. The answer is exact for the doubles as they are stored.
Raises ValueError for other shapes and for coordinates that are not finite.)";

}  // namespace

void bind_predicates(py::module_& parent) {
  py::module_ module =
      parent.def_submodule("predicates", R"(Exact predicates of contact detection.

An edge runs from p1 to p2 on a clockwise block, so its outward normal is on its left.
Answers are exact for the doubles as they are stored (docs/predicates.md).)");
  // The first line is the signature that help() and inspect show.
  const auto text = [](const std::string& signature, const char* what) {
    return signature + "\n--\n" + what + shapes;
  };

  using Three = std::array<const char*, 3>;
  using Four = std::array<const char*, 4>;
  const auto three = [&](const char* name, auto answer, auto predicate,
                         const char* what) {
    using Answer = decltype(answer);
    static constexpr Three names = {"c", "p1", "p2"};
    module.def(
        name,
        [predicate](const Points& c, const Points& p1, const Points& p2) {
          return each_row<Answer, 3>({c, p1, p2}, names, predicate);
        },
        py::arg(names[0]), py::arg(names[1]), py::arg(names[2]),
        text(name + std::string("(c, p1, p2)"), what).c_str());
  };
  const auto four = [&](const char* name, const Four& names, auto answer,
                        auto predicate, const char* what) {
    using Answer = decltype(answer);
    std::string signature = std::string(name) + '(' + names[0];
    for (std::size_t i = 1; i < names.size(); ++i)
      signature += std::string(", ") + names[i];
    module.def(
        name,
        [predicate, names](const Points& a, const Points& b, const Points& c,
                           const Points& d) {
          return each_row<Answer, 4>({a, b, c, d}, names, predicate);
        },
        py::arg(names[0]), py::arg(names[1]), py::arg(names[2]), py::arg(names[3]),
        text(signature + ')', what).c_str());
  };
  three("overlap_sign", std::int8_t{}, geometry::overlap_sign, R"(
Returns the sign of the overlap of corner c with the edge: 1 behind the edge, 0 exactly
on its line, -1 outside (19).)");
  three("near_or_inside", bool{}, geometry::near_or_inside, R"(
Tests whether corner c is behind the edge, or in front of it by at most `contact_slack`
times its length.)");
  three("between", bool{}, geometry::between, R"(
Tests whether the foot of corner c is between the ends of the edge, or beyond one of
them by at most `contact_slack` times its length.)");
  three("well_between", bool{}, geometry::well_between, R"(
Tests whether the foot of corner c is between the ends of the edge, and at least
`contact_slack` times its length away from both.)");
  four("faces_edge", {"c", "neighbour", "p1", "p2"}, bool{}, geometry::faces_edge, R"(
Tests equation (20) for one side of corner c, which leads to its neighbour: the side does
not point below the edge by more than ten degrees.)");
  constexpr Four edges = {"p1", "p2", "q1", "q2"};
  four("turn_sign", edges, std::int8_t{}, geometry::turn_sign, R"(
Returns the sign of the angle from edge p to edge q: 1 anticlockwise, 0 parallel or
antiparallel, -1 clockwise.)");
  four("edges_face", edges, bool{}, geometry::edges_face, R"(
Tests whether two edges are antiparallel within ten degrees (20).)");
  module.def(
      "compare_depths",
      [](const Points& c, const Points& p1, const Points& p2, const Points& d,
         const Points& q1, const Points& q2) {
        return each_row<std::int8_t, 6>({c, p1, p2, d, q1, q2},
                                        {"c", "p1", "p2", "d", "q1", "q2"},
                                        geometry::compare_depths);
      },
      py::arg("c"), py::arg("p1"), py::arg("p2"), py::arg("d"), py::arg("q1"),
      py::arg("q2"),
      text("compare_depths(c, p1, p2, d, q1, q2)", R"(
Returns the sign of the overlap of c with edge p less that of d with edge q: -1 if the
first is smaller, 0 if they are exactly equal.)")
          .c_str());
  module.attr("contact_slack") = geometry::contact_slack;
}

}  // namespace blocks::python
