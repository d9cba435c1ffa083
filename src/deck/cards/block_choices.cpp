#include "deck/cards/block_choices.hpp"

#include <fmt/format.h>

namespace blocks::deck {

bool has_no_range(const Value& nb1, const Value& nb2, const char* card,
                  Diagnostics& diagnostics) {
  if (!nb1.selector || !nb2.given || nb2.integer == 0) {
    return true;
  }
  diagnostics.error(nb2.where, card, "nb2 has no meaning after a selector",
                    "leave it blank; in(x1, y1, x2, y2) selects several blocks");
  return false;
}

bool has_sides(const std::vector<Value>& f, std::string_view block, const char* card,
               Diagnostics& diagnostics) {
  if (f[0].given || f[1].selector) {
    return true;
  }
  diagnostics.error(
      f[1].where, card, fmt::format("a side without a block: {} is missing", block),
      fmt::format("only a selector of sides, {}, needs no block", side_selectors));
  return false;
}

std::optional<Selection> build_selection(const std::vector<Value>& f, const char* card,
                                         Diagnostics& diagnostics) {
  const Selection out{f[0].as_choice(),
                      f[1].as_int(),
                      f[2].as_int(),
                      f[3].as_int(),
                      f[4].as_word(),
                      {},
                      {}};
  const int ways = int{out.nb1.given()} + int{out.mat.given} + int{out.nc.given};
  const auto fault = [&](SourceLocation where, const std::string& message,
                         const char* hint) {
    diagnostics.error(where, card, message, hint);
    return std::nullopt;
  };
  if (out.nb2.given && !out.nb1.given()) {
    return fault(out.nb2.where, "nb2 without nb1",
                 "nb1 is the first block of the range, nb2 the last");
  }
  if (out.rule.given && !out.nc.given) {
    return fault(
        out.rule.where, "a rule without an outline",
        "INSIDE and CENTROID tell which blocks an outline of nc corners means");
  }
  if (ways != 1) {
    const SourceLocation where = out.nc.given ? out.nc.where : out.mat.where;
    return fault(where, ways == 0 ? "no blocks are named" : "blocks are named twice",
                 "give nb1 and nb2, or mat, or nc and an outline");
  }
  if (!has_no_range(f[0], f[1], card, diagnostics)) {
    return std::nullopt;
  }
  if (!out.nb1.selector && out.nb2.value > 0 && out.nb2.value < out.nb1.number.value) {
    return fault(out.nb2.where,
                 fmt::format("nb2 must not be less than nb1, found {} and {}",
                             out.nb1.number.value, out.nb2.value),
                 "0 means nb1 alone, a negative number means all from nb1 on");
  }
  return out;
}

}  // namespace blocks::deck
