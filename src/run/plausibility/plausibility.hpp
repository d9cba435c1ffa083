// Warns of decks that are valid and probably not what is meant. The rules are one
// table, which docs/plausibility.md repeats.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "deck/commands.hpp"
#include "deck/diagnostics.hpp"
#include "model/model.hpp"
#include "run/plausibility/block_makers.hpp"

namespace blocks::run {

/// A warning. Without a place, it is at the card that has just been reached.
struct Doubt {
  std::string message, hint;
  std::optional<deck::SourceLocation> where = {};
  std::string card = {};
};

/// The places of values that the rules compare. A restart has few of these cards.
struct CardPlaces {
  std::optional<deck::SourceLocation> x_limits, y_limits;
  std::optional<deck::SourceLocation> tolerance;  ///< ctol on the BOXES card
  std::optional<deck::SourceLocation> stiffness;  ///< stifn on the STIFF card
  std::map<int, deck::SourceLocation> modulus;    ///< E of a material
  std::map<std::size_t, deck::SourceLocation>
      planes;  ///< SPLANE, by index of the plane
};

/// What the rules see.
struct Plan {
  const Model& model;
  const BlockMakers& makers;
  const CardPlaces& places;
  int first_block;  ///< the first block that no motion has checked before
  /// The card that has acted, or the whole deck at its end.
  std::span<const deck::Command> cards;
  /// The blocks on which a REMOVE or FREE card that has just acted has acted.
  std::span<const int> chosen = {};
};

/// When a rule is tested: after each card, before each motion at the positions that the
/// deck gives, or at the end of the deck.
enum class Moment { card, motion, end };

struct PlausibilityRule {
  std::string_view name;
  std::string_view condition;  ///< when it warns
  std::string_view remedy;     ///< how to change the deck so that it does not warn
  Moment moment;
  bool once;  ///< at most one warning for a deck
  std::vector<Doubt> (*doubts)(const Plan&);
};

/// Returns all rules.
std::span<const PlausibilityRule> plausibility_rules();

/// Applies the rules to a deck.
class Plausibility {
 public:
  /// Adds the warnings of the rules of this moment to the diagnostics. `at`: the card
  /// that has been reached.
  void test(Moment moment, const Plan& plan, const deck::Command& at,
            deck::Diagnostics& diagnostics);
  /// Leaves a rule out from now on.
  void leave_out(std::string_view rule) { reported_.insert(rule); }

 private:
  /// Names of rules that warn once and have done so, or are left out.
  std::set<std::string_view> reported_;
};

}  // namespace blocks::run
