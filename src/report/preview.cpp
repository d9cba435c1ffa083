#include "report/preview.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <utility>

#include "deck/parser.hpp"
#include "files/file_error.hpp"
#include "post/read/results_reader.hpp"
#include "report/outcome_values.hpp"
#include "run/run.hpp"
#include "run/support/deck_file.hpp"
#include "sweep/outcome.hpp"

namespace blocks::report {
namespace {

namespace fs = std::filesystem;

/// The most results files that are opened to find one that is not damaged.
constexpr std::size_t max_tried = 10;

class Scout {
 public:
  Scout(const std::vector<Member>& members, const std::optional<Units>& requested)
      : members_(members), requested_(requested) {}

  /// Finds a run that has measures, and one that has results. If no run that is done
  /// has results, takes those of another run that ended.
  Preview look_ahead() {
    found_.own_units.resize(members_.size());
    for (std::size_t m = 0; m < members_.size(); ++m) {
      const Member& one = members_[m];
      if (one.plan.kind == sweep::Kind::check)
        look_at_deck(m);
      bool has_results = one.plan.kind != sweep::Kind::run;
      std::vector<std::string> of_others;
      for (std::size_t i = 0; i < one.plan.runs.size(); ++i) {
        const std::string folder = sweep::run_folder(one.folder, i + 1);
        const auto outcome = sweep::read_outcome_or_damage(folder);
        if (!outcome)
          continue;
        const std::string results = results_path(one, i + 1);
        if (outcome->code != run::done) {
          if (!has_results && of_others.size() < max_tried && fs::exists(results))
            of_others.push_back(results);
          continue;
        }
        if (found_.outcome_names.empty()) {
          found_.outcome_names = measured_names(*outcome);
          found_.outcome_shares = measured_shares(*outcome);
        }
        if (!has_results && fs::exists(results))
          has_results = look_at_results(m, results);
        if (has_results)
          break;
      }
      for (std::size_t i = 0; i < of_others.size() && !has_results; ++i)
        has_results = look_at_results(m, of_others[i]);
    }
    return std::move(found_);
  }

 private:
  /// Returns false if the file is damaged.
  bool look_at_results(std::size_t member, const std::string& path) {
    std::optional<post::ResultsReader> results;
    try {
      results.emplace(path);
    } catch (const std::runtime_error&) {
      return false;  // the row of this run says so
    }
    if (found_.first_results.empty())
      found_.first_results = path;
    set_title_and_units(member, results->title(), results->units());
    return true;
  }

  /// A deck whose blocks are only checked has no results; its title and units are read
  /// from the deck itself, if it is still the same.
  void look_at_deck(std::size_t member) {
    const sweep::Plan& plan = members_[member].plan;
    std::string title;
    std::optional<Units> units;
    try {
      if (sweep::hash_of_deck(plan.deck) != plan.deck_hash)
        return;
      const std::string text = run::read_deck(plan.deck);
      deck::Diagnostics ignored(plan.deck, text);
      for (const deck::Command& command :
           deck::parse(plan.deck, text, ignored).commands) {
        if (const auto* start = std::get_if<deck::Start>(&command.card))
          title = start->title;
        if (const auto* card = std::get_if<deck::Units>(&command.card))
          units = Units{card->length.value, card->mass.value, card->time.value};
      }
    } catch (const files::FileError&) {
      return;  // the deck is on another computer
    }
    set_title_and_units(member, title, units);
  }

  /// The first sweep gives the title and, unless they are asked for, the units.
  void set_title_and_units(std::size_t member, const std::string& title,
                           const std::optional<Units>& units) {
    found_.own_units[member] = units;
    if (!first_known_) {
      first_known_ = member;
      found_.title = title;
      found_.units = requested_ ? requested_ : units;
    } else if (!requested_ &&
               found_.own_units[*first_known_].has_value() != units.has_value()) {
      throw std::runtime_error(
          fmt::format("only one of the decks of {} and {} names its units (UNITS "
                      "card)\n  hint: --units m,kg,s means that all of them are in "
                      "these units, or converts",
                      members_[*first_known_].folder, members_[member].folder));
    }
  }

  const std::vector<Member>& members_;
  const std::optional<Units>& requested_;
  Preview found_;
  std::optional<std::size_t> first_known_;  ///< sweep with known title and units
};

}  // namespace

Preview look_ahead(const std::vector<Member>& members,
                   const std::optional<Units>& requested) {
  return Scout(members, requested).look_ahead();
}

}  // namespace blocks::report
