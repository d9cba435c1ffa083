#include "deck/card_order.hpp"

#include <fmt/format.h>

namespace blocks::deck {

bool CardOrder::pass(const CardSpec& spec, SourceLocation where, bool misspelt) {
  const bool first = !started_;
  started_ = true;
  if (misspelt) {
    restart_ = restart_ || (first && spec.name == "RESTART");
    ended_ = ended_ || restart_ || spec.name == "END";
    first_line_.emplace(spec.name, where.line);
    return true;
  }
  if (first && !pass_first(spec, where)) {
    return false;
  }
  return spec.group == CardGroup::preliminary ? pass_preliminary(spec, where)
                                              : pass_problem(spec, where);
}

bool CardOrder::pass_first(const CardSpec& spec, SourceLocation where) {
  if (spec.name == "RESTART") {
    restart_ = true;
    ended_ = true;
  } else if (spec.name != "START") {
    // The deck is then read as a new run. A START further down is not reported again.
    diagnostics_.error(where, std::string(spec.name),
                       "the first card must be START or RESTART",
                       "a new run begins with START, nblok, ncmx and a title line");
    if (!is_in_deck("START")) {
      first_line_.emplace("START", where.line);
    }
  }
  return true;
}

bool CardOrder::unique(const CardSpec& spec, SourceLocation where) {
  const auto [met, is_new] = first_line_.emplace(spec.name, where.line);
  if (is_new || !spec.once) {
    return true;
  }
  diagnostics_.error(where, std::string(spec.name), "this card may be given only once",
                     fmt::format("the first one is on line {}", met->second));
  return false;
}

bool CardOrder::pass_preliminary(const CardSpec& spec, SourceLocation where) {
  const std::string card(spec.name);
  if (after_deck_) {
    diagnostics_.error(where, card,
                       "a preliminary card cannot follow once the model is built",
                       "use problem cards only; 'blocks cards' lists them");
    return false;
  }
  if (spec.name == "RESTART") {
    if (restart_ && first_line_.empty()) {
      first_line_.emplace(spec.name, where.line);
      return true;
    }
    diagnostics_.error(where, card,
                       restart_ ? "this card may be given only once"
                                : "must be the first card",
                       "a restart has no START and no other preliminary card");
    return false;
  }
  if (restart_) {
    if (spec.name == "END") {
      diagnostics_.warning(where, card, "a restart needs no END card");
      return true;
    }
    diagnostics_.error(where, card, "a restart has no other preliminary card",
                       "these data come from the checkpoint");
    return false;
  }
  if (!unique(spec, where)) {
    return false;
  }
  if (spec.name == "END") {
    report_missing(where);
    ended_ = true;
    return true;
  }
  if (ended_) {
    diagnostics_.error(where, card, "a preliminary card must come before END",
                       first_line_.contains("END")
                           ? fmt::format("move it above line {}", first_line_["END"])
                           : "move it above the first problem card");
    return false;
  }
  return true;
}

bool CardOrder::pass_problem(const CardSpec& spec, SourceLocation where) {
  if (ended_) {
    return true;
  }
  const std::string card(spec.name);
  if (is_in_deck("END")) {
    diagnostics_.error(where, card, "a problem card must come after END",
                       "END closes the preliminary data; move this card below it");
    return false;
  }
  diagnostics_.error(where, "END", fmt::format("missing before {}", card),
                     "close the preliminary data with a line END");
  ended_ = true;
  report_missing(where);
  return true;
}

void CardOrder::report_missing(SourceLocation where) {
  for (const CardSpec& spec : card_table()) {
    if (!spec.required || spec.name == "END" || first_line_.contains(spec.name) ||
        is_in_deck(spec.name)) {
      continue;
    }
    const std::string example(spec.example.substr(0, spec.example.find('\n')));
    diagnostics_.error(
        where, std::string(spec.name), "required card missing",
        fmt::format("{}: {}; for example {}", spec.syntax(), spec.summary, example));
  }
}

void CardOrder::finish(SourceLocation where) {
  if (restart_ || ended_ || !started_) {
    return;
  }
  if (!first_line_.contains("END")) {
    diagnostics_.error(where, "END", "required card missing",
                       "close the preliminary data with a line END");
  }
  report_missing(where);
}

}  // namespace blocks::deck
