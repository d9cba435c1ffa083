// The states of a contact with the law of a joint (docs/laws.md), in one list. The code
// that keeps, advances, checks, writes or reads them follows from it. Kernels and
// readers of results include this header, which depends on the standard library only.
#pragma once

#include <string>
#include <type_traits>

namespace blocks {

/// The list. The entries of a state are: member, type in LawState (kernels have
/// numbers, with 1 or 0 for flags), name in results, dimension, range in checkpoints.
/// The length is last, because readers take its column as a sign that all exist.
#define BLOCKS_LAW_STATES(STATE)                                                       \
  /* Stiffnesses of the contact. They are frozen while the length does not grow. */    \
  STATE(stiffness, double, "NormalStiffness", stiffness, not_negative)                 \
  STATE(shear_stiffness, double, "ShearStiffness", stiffness, not_negative)            \
  /* up, the plastic slip with its sign */                                             \
  STATE(slip, double, "Slip", length, finite)                                          \
  /* the length of the path of the slip */                                             \
  STATE(path, double, "SlipPath", length, not_negative)                                \
  /* a, the sum of the closing (Walton, Bandis) */                                     \
  STATE(closure, double, "Closure", length, finite)                                    \
  /* a0, the part of the closure that stays (Walton); opening by dilation (Barton) */  \
  STATE(plastic, double, "PlasticClosure", length, finite)                             \
  /* r0, added to the overlap: dilation. A contact acts while bonded or while */       \
  /* overlap + offset > 0. */                                                          \
  STATE(offset, double, "Dilation", length, finite)                                    \
  /* The contact acts in tension too. */                                               \
  STATE(bonded, bool, "Bonded", none, not_negative)                                    \
  /* Residual values apply; true for contacts that BOND did not make. */               \
  STATE(failed, bool, "Failed", none, not_negative)                                    \
  /* L, the part of the faces that the contact stands for in this step */              \
  STATE(length, double, "Length", length, not_negative)

/// What the law of a joint remembers of a contact, in addition to its springs. If `law`
/// is 0, its other values have an effect only after INSITU.
struct LawState {
  int law = 0;  ///< joint id whose law acts; 0: STIFF and FRICTN
#define BLOCKS_MEMBER(member, type, ...) type member = {};
  BLOCKS_LAW_STATES(BLOCKS_MEMBER)
#undef BLOCKS_MEMBER
  bool operator==(const LawState&) const = default;
};

/// Calls act(one.member, other.member, ...) for each state. The structs have members of
/// these names.
template <class Act, class... Structs>
[[gnu::always_inline]] inline void each_state(const Act& act, Structs&&... structs) {
#define BLOCKS_ACT(member, ...) act(structs.member...);
  BLOCKS_LAW_STATES(BLOCKS_ACT)
#undef BLOCKS_ACT
}

/// The dimension of a state: none, [L], [F/L].
enum class StateDimension { none, length, stiffness };
/// The values of a state that a checkpoint may have: any finite number, or from 0.
enum class StateRange { finite, not_negative };

/// The names of a member of LawState in files, and the kind of its values.
struct LawField {
  const char* name;    ///< in checkpoints
  const char* column;  ///< in results
  StateDimension dimension;
  StateRange range;

  /// Returns the name in tables of text and of Python: "slip_path" for "SlipPath".
  std::string name_in_tables() const {
    std::string text;
    for (const char* c = column; *c != '\0'; ++c) {
      const bool is_capital = *c >= 'A' && *c <= 'Z';
      if (is_capital && !text.empty())
        text += '_';
      text += is_capital ? static_cast<char>(*c - 'A' + 'a') : *c;
    }
    return text;
  }
};

/// The type of a member of LawState in results: flags and the law are whole numbers.
template <class Member>
using ResultsType = std::conditional_t<std::is_same_v<Member, double>, double, int>;

/// Calls act(field, pointer to member) for the law and each state of LawState.
template <class Act> void each_law_field(const Act& act) {
  act(LawField{"law", "Law", StateDimension::none, StateRange::not_negative},
      &LawState::law);
#define BLOCKS_ACT(member, type, column, dimension, range)                             \
  act(LawField{#member, column, StateDimension::dimension, StateRange::range},         \
      &LawState::member);
  BLOCKS_LAW_STATES(BLOCKS_ACT)
#undef BLOCKS_ACT
}

}  // namespace blocks
