// Which card may stand where: START or RESTART first, the preliminary cards once and
// before END, the required ones present (report A.1.0, A.2.0).
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "deck/card_table.hpp"
#include "deck/diagnostics.hpp"

namespace blocks::deck {

/// Watches the cards go by and reports those out of place, each fault once.
class CardOrder {
 public:
  /// names: the names of all cards of the deck in order, misspelt ones as what was
  /// meant, so that a card that comes too late is not also reported missing.
  CardOrder(std::vector<std::string_view> names, Diagnostics& diagnostics)
      : names_(names.begin(), names.end()), diagnostics_(diagnostics) {}

  /// The cards follow a deck that was read before: no preliminary card among them.
  void begin_behind_deck() { started_ = ended_ = behind_deck_ = true; }

  /// A card goes by; misspelt: the name is a guess, which is never faulted again.
  /// False when the card is out of place, which has then been reported.
  bool pass(const CardSpec& spec, SourceLocation where, bool misspelt);

  /// The deck is over (or STOP was met); where: just behind the last line.
  void finish(SourceLocation where);

 private:
  bool pass_first(const CardSpec& spec, SourceLocation where);
  bool pass_preliminary(const CardSpec& spec, SourceLocation where);
  bool pass_problem(const CardSpec& spec, SourceLocation where);
  bool unique(const CardSpec& spec, SourceLocation where);
  void report_missing(SourceLocation where);
  bool stands_in_deck(std::string_view name) const { return names_.contains(name); }

  std::set<std::string_view> names_;
  Diagnostics& diagnostics_;
  std::map<std::string_view, int> first_line_;  ///< of each card met
  bool started_ = false;
  bool restart_ = false;
  bool ended_ = false;        ///< the preliminary data are over
  bool behind_deck_ = false;  ///< these cards follow a deck
};

}  // namespace blocks::deck
