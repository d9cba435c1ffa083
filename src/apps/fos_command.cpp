#include "fos_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <limits>

#include "apps/options/option_checks.hpp"

namespace blocks::apps {
namespace {

/// Adds a field to the text of the card, and the option that gives it to those of the
/// command. A field that is not given stays blank.
template <class T>
void add_field(const char* name, const std::optional<T>& value,
               run::RunOptions& options) {
  options.last_card += value ? fmt::format(", {}", *value) : ", ";
  if (value)
    options.last_card_options += fmt::format(" --{} {}", name, *value);
}

}  // namespace

void add_fos_options(CLI::App& command, FosOptions& options) {
  command
      .add_option("--width", options.width,
                  "wanted width of the bracket (default: .01)")
      ->check(positive_number());
  command
      .add_option("--ratio", options.ratio,
                  "ratio of the unbalanced forces in a stable trial (default: 1e-5)")
      ->check(positive_number());
  command
      .add_option("--ncycle", options.ncycle,
                  "largest number of steps of a trial (default: 500 times the response "
                  "of the model)")
      ->check(CLI::Range(deck::Solve::fewest_steps, std::numeric_limits<long>::max()));
  command
      .add_option("--lower", options.lower,
                  "factor at which the model is stable (default: is looked for)")
      ->check(positive_number());
  command
      .add_option("--upper", options.upper,
                  "factor at which it fails (default: is looked for)")
      ->check(positive_number());
}

int find_factor_of_safety(run::RunOptions options, const FosOptions& fos) {
  std::string& card = options.last_card = "FOS";
  add_field("width", fos.width, options);
  add_field("ratio", fos.ratio, options);
  add_field("ncycle", fos.ncycle, options);
  add_field("lower", fos.lower, options);
  add_field("upper", fos.upper, options);
  card.erase(card.find_last_not_of(", ") + 1);
  options.ends_process = true;
  return run::run_deck(options);
}

}  // namespace blocks::apps
