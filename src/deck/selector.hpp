// Selectors: fields that name blocks, sides or corners by position, material or joint
// id, because numbers of blocks exist only after a cut. Independent of the model.
#pragma once

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/decimal.hpp"

namespace blocks::deck {

/// A selector as written, such as "at(3, 4)".
struct Selector {
  enum class By {
    at,        ///< at(x, y): the block that contains the point
    in,        ///< in(x1, y1, x2, y2): blocks whose centroid is in the box
    material,  ///< material(name or number): blocks of a material
    nearest,   ///< nearest(x, y): a corner
    joint,     ///< joint(id): sides with this joint id
    edge,      ///< edge(k): sides on edge k of the last OUTLINE
    on         ///< on(x1, y1, x2, y2): sides on a line
  };
  By by = By::at;
  std::vector<geometry::Decimal> numbers = {};  ///< coordinates [L], joint id or edge
  std::string material = {};                    ///< number or name
  std::string text = {};                        ///< as written

  bool is_of_blocks() const {
    return by == By::at || by == By::in || by == By::material;
  }
  bool is_of_sides() const { return by == By::joint || by == By::edge || by == By::on; }
  /// Whether the choice depends on where the blocks are.
  bool is_by_position() const { return by != By::material && by != By::joint; }
};

/// Thrown if a selector cannot be read. `at` and `length` are the part of the text that
/// is wrong.
struct SelectorFault : std::runtime_error {
  SelectorFault(const std::string& message, std::string what_to_do, std::size_t begin,
                std::size_t count)
      : std::runtime_error(message), hint(std::move(what_to_do)), at(begin),
        length(count) {}
  std::string hint;
  std::size_t at = 0, length = 0;
};

/// Whether the text ends in the name of a selector, alone or after a colon: "at",
/// "y:nearest". A bracket after it begins the values of a selector.
bool ends_in_selector_name(std::string_view text);

/// Whether the text has the form of a selector: a word and a bracket.
bool looks_like_selector(std::string_view text);

/// Reads a selector. Throws SelectorFault.
Selector read_selector(std::string_view text);

/// The selectors of blocks or of sides and their values, for messages.
inline constexpr std::string_view block_selectors =
    "at(x, y), in(x1, y1, x2, y2) or material(name)";
inline constexpr std::string_view side_selectors =
    "joint(id), edge(k) or on(x1, y1, x2, y2)";

}  // namespace blocks::deck
