// The selectors of blocks, sides and corners, for the classes that hold blocks.
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <utility>
#include <vector>

#include "model/selection.hpp"

namespace blocks::python {

/// Returns blocks and sides as pairs.
inline std::vector<std::pair<int, int>> pairs_of(const std::vector<BlockSide>& sides) {
  std::vector<std::pair<int, int>> pairs;
  for (const BlockSide& side : sides)
    pairs.emplace_back(side.block, side.side);
  return pairs;
}

/// Adds the functions that blocks.selectors.Selectors calls. `blocks_of` returns the
/// blocks of an object. Blocks, sides and corners count from 0; -1: there is none.
template <class Class, class BlocksOf>
void bind_selectors(Class& bound, BlocksOf blocks_of) {
  using Self = typename Class::type;
  bound
      .def("_block_at",
           [blocks_of](Self& self, double x, double y) {
             return block_at(blocks_of(self), {x, y});
           })
      .def("_blocks_in",
           [blocks_of](Self& self, double x1, double y1, double x2, double y2) {
             return blocks_in(blocks_of(self), {x1, y1}, {x2, y2});
           })
      .def("_sides_of_joint",
           [blocks_of](Self& self, int id) {
             return pairs_of(sides_of_joint(blocks_of(self), id));
           })
      .def("_sides_on",
           [blocks_of](Self& self, double x1, double y1, double x2, double y2,
                       double tolerance) {
             return pairs_of(sides_on(blocks_of(self), {x1, y1}, {x2, y2},
                                      SidesOf::both, tolerance));
           })
      .def("_nearest_corner", [blocks_of](Self& self, double x, double y) {
        const BlockCorner found = nearest_corner(blocks_of(self), {x, y});
        return std::pair(found.block, found.corner);
      });
}

}  // namespace blocks::python
