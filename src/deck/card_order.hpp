// Checks the order of the cards: START or RESTART first, the preliminary cards once and
// before END, and all required cards present (report A.1.0, A.2.0).
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "deck/cards/card_table.hpp"
#include "deck/diagnostics.hpp"

namespace blocks::deck {

/// Receives the cards in order and reports those out of place, each fault once.
class CardOrder {
 public:
  /// names: the names of all cards of the deck in order, misspelt ones as their
  /// intended names. A card that comes too late is therefore not also reported as
  /// missing.
  CardOrder(std::vector<std::string_view> names, Diagnostics& diagnostics)
      : names_(names.begin(), names.end()), diagnostics_(diagnostics) {}

  /// Declares that the cards follow a deck that was read before, so no preliminary card
  /// is allowed.
  void begin_after_deck() { started_ = ended_ = after_deck_ = true; }

  /// Registers the next card. Returns false if it is out of place, which has then been
  /// reported. misspelt: the name is a guess and is not reported again.
  bool pass(const CardSpec& spec, SourceLocation where, bool misspelt);

  /// Registers the end of the deck, or STOP. where: just after the last line.
  void finish(SourceLocation where);

 private:
  bool pass_first(const CardSpec& spec, SourceLocation where);
  bool pass_preliminary(const CardSpec& spec, SourceLocation where);
  bool pass_problem(const CardSpec& spec, SourceLocation where);
  bool unique(const CardSpec& spec, SourceLocation where);
  void report_missing(SourceLocation where);
  bool is_in_deck(std::string_view name) const { return names_.contains(name); }

  std::set<std::string_view> names_;
  Diagnostics& diagnostics_;
  std::map<std::string_view, int> first_line_;  ///< first line of each card read so far
  bool started_ = false;
  bool restart_ = false;
  bool ended_ = false;       ///< the preliminary data have ended
  bool after_deck_ = false;  ///< these cards follow a deck
};

}  // namespace blocks::deck
