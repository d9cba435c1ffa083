#include "deck/cards/crack_cards.hpp"

#include "deck/ranges.hpp"

namespace blocks::deck {
namespace {

constexpr Range material_number{1, 2147483647, false, false, false};
constexpr Range zero_to_one{0, 1, false, false, false};

}  // namespace

std::vector<CardSpec> crack_cards() {
  using enum Kind;
  return {
      {.name = "CRACK",
       .section = "ours",
       .summary = "let the blocks of a material split in tension",
       .fields = {{"mat", integer, {}, material_number, "[-]", "material number"},
                  {"ten",
                   real,
                   {},
                   positive,
                   "[F/L^2]",
                   "tensile strength: largest principal stress"},
                  {"amin", real, {}, positive, "[L^2]", "least area of a piece"},
                  {"tenp", real, "", positive, "[F/L^2]",
                   "strength under two opposite point loads; blank: no such cracks"},
                  {"id", integer, "0", id_or_none, "[-]",
                   "joint id of the new faces, which are not bonded; 0: none"}},
       .notes =
           "After each step, free blocks whose largest principal stress is at least "
           "ten split through the centroid, at right angles to that stress. With tenp, "
           "blocks also split between two opposite contact forces F at a distance D "
           "if 2 F / (pi D) is at least tenp. A block does not split if a piece would "
           "be smaller than amin. The time step allows for pieces of that size, so a "
           "small amin makes it short. The larger piece keeps the number of the block; "
           "the other one gets the next number. START limits the number of blocks. "
           "Another CRACK card for the material replaces the values.",
       .example = "CRACK, 1, 1.D6, .01, 5.D5"},
      {.name = "MDAMP",
       .section = "ours",
       .summary = "damp the vibration of deformable blocks",
       .fields = {{"mat", integer, {}, material_number, "[-]", "material number"},
                  {"z", real, "0", zero_to_one, "[-]",
                   "fraction of critical damping; 0: none"}},
       .notes = "Damps the normal strain rates of the blocks of a material, not their "
                "motion as rigid bodies. Without effect on rigid blocks.",
       .example = "MDAMP, 1, .1"},
  };
}

}  // namespace blocks::deck
