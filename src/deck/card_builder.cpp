#include "deck/card_builder.hpp"

#include <cmath>
#include <fmt/format.h>
#include <map>

#include "deck/cards/block_choices.hpp"
#include "deck/cards/law_cards.hpp"
#include "deck/cards/water_cards.hpp"

namespace blocks::deck {
namespace {

using Fields = std::vector<Value>;

/// Checks that the second of two values is greater than the first, or equal if
/// `may_be_equal`.
bool in_order(const Value& low, const Value& high, bool may_be_equal, const char* card,
              const std::string& message, const std::string& hint,
              Diagnostics& diagnostics) {
  const double a = low.number.value();
  const double b = high.number.value();
  if (a < b || (may_be_equal && a == b)) {
    return true;
  }
  diagnostics.error(high.given ? high.where : low.where, card,
                    fmt::format("{}, found {:g} and {:g}", message, a, b), hint);
  return false;
}

using Builder = std::optional<Card> (*)(const Fields&, const Values&, Diagnostics&);
using Maybe = std::optional<Card>;

Maybe limits(const Fields& f, bool x, Diagnostics& diagnostics) {
  if (!in_order(f[0], f[1], false, x ? "XLIMITS" : "YLIMITS",
                x ? "xmin must be less than xmax" : "ymin must be less than ymax",
                "the lower limit comes first", diagnostics)) {
    return {};
  }
  if (x) {
    return XLimits{f[0].as_real(), f[1].as_real()};
  }
  return YLimits{f[0].as_real(), f[1].as_real()};
}

/// Returns the joint ids of faces, which begin at this field.
FaceIds face_ids(const Fields& f, std::size_t at) {
  return {f[at].as_int(), f[at + 1].as_int(), f[at + 2].as_int()};
}

Maybe layer(const Fields& f, Diagnostics& diagnostics) {
  Layer card{f[0].as_int(),  f[1].as_int(), {}, f[10].as_word(), {}, {},
             face_ids(f, 11)};
  for (std::size_t i = 0; i < 8; ++i) {
    card.corners[i] = f[i + 2].as_exact();
  }
  if (card.rcommand.value == "RANDOM" && card.ns.value > 0) {
    diagnostics.warning(card.rcommand.where, "LAYER",
                        "RANDOM is ignored where ns > 0: the widths are listed",
                        fmt::format("write ns = {} for random widths", -card.ns.value));
  }
  return card;
}

Maybe splane(const Fields& f, Diagnostics& diagnostics) {
  if (f[0].number.value() == f[2].number.value() &&
      f[1].number.value() == f[3].number.value()) {
    diagnostics.error(f[2].where, "SPLANE", "the two points are the same",
                      "the plane runs through two different points");
    return {};
  }
  const double dx = f[2].as_real().value - f[0].as_real().value;
  const double dy = f[3].as_real().value - f[1].as_real().value;
  const double square = dx * dx + dy * dy;
  if (!std::isnormal(square)) {
    diagnostics.error(f[2].where, "SPLANE",
                      square > 1.0 ? "the two points are too far apart"
                                   : "the two points are too close to each other",
                      "their distance may be from 1.5e-154 to 1.3e154");
    return {};
  }
  return Splane{f[0].as_real(), f[1].as_real(), f[2].as_real(), f[3].as_real()};
}

Maybe setvel(const Fields& f, Diagnostics& diagnostics) {
  const long nb1 = f[0].integer;
  const long nb2 = f[1].integer;
  if (!f[0].selector && nb2 > 0 && nb2 < nb1) {
    diagnostics.error(
        f[1].where, "SETVEL",
        fmt::format("nb2 must not be less than nb1, found {} and {}", nb1, nb2),
        "0 means nb1 alone, a negative number means all from nb1 on");
    return {};
  }
  if (!has_no_range(f[0], f[1], "SETVEL", diagnostics)) {
    return {};
  }
  return SetVel{f[0].as_choice(), f[1].as_int(), f[2].as_real(), f[3].as_real(),
                f[4].as_real()};
}

Maybe fos(const Fields& f, Diagnostics& diagnostics) {
  if (f[3].given && f[4].given &&
      !in_order(f[3], f[4], false, "FOS", "lower must be less than upper",
                "the model should be stable with its strength / lower, and fail with "
                "its strength / upper",
                diagnostics))
    return {};
  return Fos{f[0].as_real(), f[1].as_real(), f[2].as_int(), f[3].as_real(),
             f[4].as_real()};
}

/// Reads PLOTS, , n: a frame every n steps.
Maybe plots_in_steps(const Fields& f, const Values& values, Diagnostics& diagnostics) {
  const char* hint = "PLOTS, dtplot sets an interval of time; PLOTS, , n a number of "
                     "steps";
  if (values.repeated.size() != 1) {
    const bool none = values.repeated.empty();
    diagnostics.error(none ? f[0].where : values.repeated[1].where, "PLOTS",
                      none ? "missing dtplot" : "without dtplot, one value too many",
                      hint);
    return {};
  }
  const Value& value = values.repeated.front();
  const double n = value.number.value();
  constexpr double max = 9007199254740991.0;  // as for other whole numbers
  if (n != std::floor(n) || n > max) {
    diagnostics.error(value.where, "PLOTS",
                      fmt::format("without dtplot, the number of steps must be whole, "
                                  "found {:g}",
                                  n),
                      hint);
    return {};
  }
  return Plots{f[0].as_real(), {}, {static_cast<long>(n), value.where, true}};
}

Maybe plots(const Fields& f, const Values& values, Diagnostics& diagnostics) {
  if (!f[0].given)
    return plots_in_steps(f, values, diagnostics);
  Plots card{f[0].as_real(), {}};
  for (const Value& value : values.repeated) {
    card.times.push_back(value.as_real());
  }
  return card;
}

History history(const Fields& f, const Values& values) {
  History card{f[0].as_real(), {}};
  for (const Value& value : values.repeated) {
    card.quantities.push_back(value.as_word());
  }
  return card;
}

Maybe output(const Fields& f, const Values& values) {
  Output card{f[0].as_real(), {}};
  for (const Value& value : values.repeated) {
    card.blocks.push_back(value.as_choice());
  }
  return card;
}

/// Returns the builders, one line per card, in the order of the report. The parser adds
/// lists and titles.
const std::map<std::string_view, Builder>& builders() {
  using F = const Fields&;
  using V = const Values&;
  using D = Diagnostics&;
  static const std::map<std::string_view, Builder> table = {
      {"START",
       [](F f, V, D) -> Maybe {
         return Start{f[0].as_int(), f[1].as_int(), {}};
       }},
      {"XLIMITS", [](F f, V, D d) -> Maybe { return limits(f, true, d); }},
      {"YLIMITS", [](F f, V, D d) -> Maybe { return limits(f, false, d); }},
      {"BOXES",
       [](F f, V, D) -> Maybe {
         return Boxes{f[0].as_int(), f[1].as_int(), f[2].as_real()};
       }},
      {"STIFF",
       [](F f, V, D) -> Maybe {
         return Stiff{f[0].as_real(), f[1].as_real()};
       }},
      {"FRACTION", [](F f, V, D) -> Maybe { return Fraction{f[0].as_real()}; }},
      {"MATERIAL",
       [](F f, V, D) -> Maybe {
         return Material{f[0].as_int(), f[1].as_real(), f[2].as_real(), f[3].as_real(),
                         f[4].as_word()};
       }},
      {"FUNCTION",
       [](F f, V, D) -> Maybe {
         return Function{f[0].as_int(), {}, {}};
       }},
      {"RIGID", [](F, V, D) -> Maybe { return Rigid{}; }},
      {"SEED", [](F f, V, D) -> Maybe { return Seed{f[0].as_int()}; }},
      {"UNITS",
       [](F f, V, D) -> Maybe {
         return Units{f[0].as_word(), f[1].as_word(), f[2].as_word()};
       }},
      {"END", [](F, V, D) -> Maybe { return End{}; }},
      {"RESTART", [](F f, V, D) -> Maybe { return Restart{f[0].as_word()}; }},
      {"CREATE",
       [](F f, V, D) -> Maybe {
         return Create{f[0].as_int(), f[1].as_int(), f[2].as_int(), {}, {}, {}};
       }},
      {"READ9",
       [](F f, V, D) -> Maybe {
         return Read9{f[0].as_word(), face_ids(f, 1)};
       }},
      {"LAYER", [](F f, V, D d) -> Maybe { return layer(f, d); }},
      {"ORIENT",
       [](F f, V, D d) -> Maybe {
         if (!in_order(f[0], f[1], true, "ORIENT", "angmin must not exceed angplus",
                       "the lesser angle comes first; a blank angle is 0", d)) {
           return {};
         }
         return Orient{f[0].as_exact(), f[1].as_exact()};
       }},
      {"MERGE", [](F f, V, D) -> Maybe { return Merge{f[0].as_exact()}; }},
      {"SPLANE", [](F f, V, D d) -> Maybe { return splane(f, d); }},
      {"GRAVITY",
       [](F f, V, D) -> Maybe {
         return Gravity{f[0].as_real(), f[1].as_real(), f[2].as_real()};
       }},
      {"FIX", [](F f, V, D) -> Maybe { return Fix{f[0].as_choice()}; }},
      {"REMOVE",
       [](F f, V, D d) -> Maybe {
         if (auto blocks = build_selection(f, "REMOVE", d)) {
           return Remove{*std::move(blocks)};
         }
         return {};
       }},
      {"FREE",
       [](F f, V, D d) -> Maybe {
         if (auto blocks = build_selection(f, "FREE", d)) {
           return Free{*std::move(blocks)};
         }
         return {};
       }},
      {"PRESSBC",
       [](F f, V, D d) -> Maybe {
         if (!has_sides(f, "nblok", "PRESSBC", d)) {
           return {};
         }
         return PressBc{f[0].as_choice(), f[1].as_choice(), f[2].as_real(),
                        f[3].as_real(), f[4].as_real()};
       }},
      {"FORCE",
       [](F f, V, D) -> Maybe {
         return Force{f[0].as_choice(), f[1].as_real(), f[2].as_real(), f[3].as_real()};
       }},
      {"WATER", [](F f, V, D d) -> Maybe { return build_water(f, d); }},
      {"JWATER", [](F f, V, D d) -> Maybe { return build_joint_water(f, d); }},
      {"FRICTN", [](F f, V, D) -> Maybe { return Frictn{f[0].as_real()}; }},
      {"SETVEL", [](F f, V, D d) -> Maybe { return setvel(f, d); }},
      {"SETVELM",
       [](F f, V, D) -> Maybe {
         return SetVelM{f[0].as_int(), f[1].as_real(), f[2].as_real(), f[3].as_real()};
       }},
      {"DAMPING", [](F f, V, D) -> Maybe { return Damping{f[0].as_real()}; }},
      {"JOINT", [](F f, V, D d) -> Maybe { return build_joint(f, d); }},
      {"WALTON",
       [](F f, V, D) -> Maybe {
         return Walton{f[0].as_int(), f[1].as_real()};
       }},
      {"BARTON", [](F f, V, D d) -> Maybe { return build_barton(f, d); }},
      {"JPAIR",
       [](F f, V, D) -> Maybe {
         return Jpair{f[0].as_int(), f[1].as_int(), f[2].as_int()};
       }},
      {"BOND",
       [](F f, V, D) -> Maybe {
         return Bond{f[0].as_int(), f[1].as_real()};
       }},
      {"DRIVE",
       [](F f, V, D) -> Maybe {
         return Drive{f[0].as_choice(), f[1].as_real(), f[2].as_real(), f[3].as_real()};
       }},
      {"LOCDAMP", [](F f, V, D) -> Maybe { return Locdamp{f[0].as_real()}; }},
      {"KINDAMP", [](F f, V, D) -> Maybe { return Kindamp{f[0].as_int()}; }},
      {"MSCALE", [](F f, V, D) -> Maybe { return Mscale{f[0].as_int()}; }},
      {"INSITU",
       [](F f, V, D) -> Maybe {
         return Insitu{f[0].as_real(), f[1].as_real(), f[2].as_real(),
                       f[3].as_real(), f[4].as_real(), f[5].as_real()};
       }},
      {"SERVO",
       [](F f, V, D d) -> Maybe {
         if (!has_sides(f, "nb", "SERVO", d)) {
           return {};
         }
         return Servo{f[0].as_choice(), f[1].as_choice(), f[2].as_real(),
                      f[3].as_real()};
       }},
      {"QUIET",
       [](F f, V, D d) -> Maybe {
         if (!has_sides(f, "nb", "QUIET", d)) {
           return {};
         }
         return Quiet{f[0].as_choice(), f[1].as_choice(), f[2].as_real(),
                      f[3].as_real()};
       }},
      {"CRACK",
       [](F f, V, D) -> Maybe {
         return Crack{f[0].as_int(), f[1].as_real(), f[2].as_real(), f[3].as_real(),
                      f[4].as_int()};
       }},
      {"MDAMP",
       [](F f, V, D) -> Maybe {
         return Mdamp{f[0].as_int(), f[1].as_real()};
       }},
      {"DUMP", [](F, V, D) -> Maybe { return Dump{}; }},
      {"OUTPUT", [](F f, V v, D) -> Maybe { return output(f, v); }},
      {"PLOTS", [](F f, V v, D d) -> Maybe { return plots(f, v, d); }},
      {"HISTORY", [](F f, V v, D) -> Maybe { return history(f, v); }},
      {"MOTION", [](F f, V, D) -> Maybe { return Motion{f[0].as_real()}; }},
      {"CYCLE", [](F f, V, D) -> Maybe { return Cycle{f[0].as_int()}; }},
      {"SOLVE",
       [](F f, V, D) -> Maybe {
         return Solve{f[0].as_real(), f[1].as_int(), f[2].as_real()};
       }},
      {"FOS", [](F f, V, D d) { return fos(f, d); }},
      {"SAVE", [](F f, V, D) -> Maybe { return Save{f[0].as_word()}; }},
      {"STOP", [](F, V, D) -> Maybe { return Stop{}; }},
  };
  return table;
}

}  // namespace

std::optional<Card> build_card(std::string_view name, const Values& values,
                               Diagnostics& diagnostics) {
  const auto builder = builders().find(name);
  if (!values.ok || builder == builders().end()) {
    return std::nullopt;
  }
  return builder->second(values.fields, values, diagnostics);
}

}  // namespace blocks::deck
