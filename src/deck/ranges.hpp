// Ranges that the values of many cards have.
#pragma once

#include <limits>

#include "deck/cards/card_table.hpp"

namespace blocks::deck {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr Range any{};
inline constexpr Range positive{0, infinity, true, false, false};
inline constexpr Range not_negative{0, infinity, false, false, false};
inline constexpr Range id_or_none{0, 1e9, false, false, false};  ///< a joint id
inline constexpr Range from_one{1, infinity, false, false, false};

}  // namespace blocks::deck
