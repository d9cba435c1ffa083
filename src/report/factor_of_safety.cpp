#include "report/factor_of_safety.hpp"

#include <fmt/format.h>

#include <cmath>

namespace blocks::report {
namespace {

double number_of(const nlohmann::ordered_json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_number() ? found->get<double>() : no_number;
}

constexpr Measure::Limit below_one{false, 1.0};

}  // namespace

const std::set<std::string>& safety_names() {
  static const std::set<std::string> names = {"fos", "fos_lower", "fos_upper"};
  return names;
}

double SafetyBracket::middle() const { return 0.5 * (lower + upper); }

double SafetyBracket::decide(const Measure::Limit& limit) const {
  if (upper <= limit.value)
    return limit.above ? 0.0 : 1.0;
  if (lower >= limit.value)
    return limit.above ? 1.0 : 0.0;
  return no_number;
}

std::optional<SafetyBracket> safety_bracket(const sweep::Outcome& outcome) {
  const auto found = outcome.measured.find("factor_of_safety");
  if (found == outcome.measured.end() || !found->is_object())
    return std::nullopt;
  return SafetyBracket{number_of(*found, "lower"), number_of(*found, "upper")};
}

double safety_value(const SafetyBracket& bracket, const Measure& measure) {
  if (measure.key == "fos")
    return measure.limit ? bracket.decide(*measure.limit) : bracket.middle();
  return measure.with_limit(measure.key == "fos_lower" ? bracket.lower : bracket.upper);
}

void FailureCount::add(const SafetyBracket& bracket) {
  const double fails = bracket.decide(below_one);
  ++(std::isnan(fails) ? undecided : fails == 1.0 ? failing : stable);
}

double FailureCount::share() const {
  return decided() == 0 ? no_number
                        : static_cast<double>(failing) / static_cast<double>(decided());
}

std::string failure_words(const FailureCount& count) {
  std::string words = "F < 1 is not decided in any run";
  if (count.decided() > 0) {
    const Interval interval = count.interval();
    words = fmt::format("F < 1 in {} of {} runs: {:.3g} % (95 % interval {:.3g} to "
                        "{:.3g} %)",
                        count.failing, count.decided(), 100.0 * count.share(),
                        100.0 * interval.low, 100.0 * interval.high);
  }
  if (count.undecided > 0)
    words += fmt::format("; {} {} undecided", count.undecided,
                         count.undecided == 1 ? "run is" : "runs are");
  return words;
}

}  // namespace blocks::report
