#include "report/measure.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "report/factor_of_safety.hpp"
#include "text/number.hpp"

namespace blocks::report {
namespace {

using When = Measure::When;

/// Takes "<LIMIT" or ">LIMIT" from the end of the text. The name of a material may have
/// these characters.
std::optional<Measure::Limit> take_limit(std::string& text) {
  const auto at = text.find_last_of("<>");
  if (at == std::string::npos)
    return std::nullopt;
  const auto value = text::number_of<double>(text.substr(at + 1));
  if (!value && text.find(":material=") < at)
    return std::nullopt;
  if (!value)
    throw std::runtime_error(fmt::format(
        "'{}' needs a number after {}\n  hint: dy:min<-1 asks for the share "
        "of the runs in which dy:min is below -1",
        text, text[at]));
  const Measure::Limit limit{text[at] == '>', *value};
  text.erase(at);
  return limit;
}

/// Takes "@TIME", "@max", "@min" or "@end" from the end of the text.
void take_moment(std::string& text, Measure& measure) {
  const auto at = text.rfind('@');
  if (at == std::string::npos)
    return;
  const std::string moment = text.substr(at + 1);
  if (moment == "max")
    measure.when = When::largest;
  else if (moment == "min")
    measure.when = When::smallest;
  else if (const auto time = text::number_of<double>(moment))
    measure.when = When::time, measure.time = *time;
  else if (moment != "end")
    throw std::runtime_error(
        fmt::format("cannot read the time in '{}'\n  hint: {}@0.5 is the value at that "
                    "time, {}@max and {}@min are its extremes over time",
                    text, text.substr(0, at), text.substr(0, at), text.substr(0, at)));
  text.erase(at);
}

std::string moment_of(const Measure& measure) {
  switch (measure.when) {
  case When::largest:
    return "@max";
  case When::smallest:
    return "@min";
  case When::time:
    return fmt::format("@{}", measure.time);
  case When::end:
    break;
  }
  return {};
}

std::string indented(std::string hint) {
  for (auto end = hint.find('\n'); end != hint.npos; end = hint.find('\n', end + 1))
    hint.insert(end + 1, "        ");
  return hint;
}

/// Returns "p21, t_vertices; with :max, :min: aspect, width" for these and aspect:max,
/// aspect:min, width:max and width:min.
std::string short_list(const std::set<std::string>& names) {
  std::set<std::string> alone, whole, parts;
  for (const std::string& name : names)
    if (const auto colon = name.rfind(':'); colon == std::string::npos) {
      alone.insert(name);
    } else {
      whole.insert(name.substr(0, colon));
      parts.insert(name.substr(colon));
    }
  std::string list = fmt::format("{}", fmt::join(alone, ", "));
  if (!parts.empty())
    list += fmt::format("{}with {}: {}", list.empty() ? "" : "; ",
                        fmt::join(parts, ", "), fmt::join(whole, ", "));
  return list;
}

[[noreturn]] void tell_unknown(const quantities::CurveFault& fault,
                               const std::set<std::string>& outcome_names) {
  std::string hint = fault.hint;
  std::set<std::string> of_blocks, of_safety;
  for (const std::string& name : outcome_names)
    (safety_names().contains(name) ? of_safety : of_blocks).insert(name);
  if (!of_blocks.empty())
    hint += "\nof the blocks at the first motion: " + short_list(of_blocks);
  if (!of_safety.empty())
    hint += "\nof the FOS card: " + short_list(of_safety);
  throw std::runtime_error(std::string(fault.what()) + "\n  hint: " + indented(hint));
}

/// Reads what remains without limit and moment.
void read_name(const std::string& text, const std::set<std::string>& outcome_names,
               bool outcomes_first, Measure& measure) {
  const std::string prefix = "outcome.", profile = "profile:";
  const bool at_end = measure.when == When::end;
  const std::string own = text.starts_with(prefix) ? text.substr(prefix.size()) : text;
  const bool known = at_end && outcome_names.contains(own);
  if (known && (outcomes_first || own.size() < text.size())) {
    measure.from = Measure::From::outcome;
    measure.key = own;
    return;
  }
  if (at_end && (text == "profile:min" || text == "profile:max")) {
    measure.from = Measure::From::profile;
    measure.key = text.substr(profile.size());
    return;
  }
  try {
    measure.curve = quantities::parse_curve(text);
  } catch (const quantities::CurveFault& fault) {
    if (!known)
      tell_unknown(fault, outcome_names);
    measure.from = Measure::From::outcome;
    measure.key = own;
  }
}

}  // namespace

double Measure::with_limit(double value) const {
  if (!limit || std::isnan(value))
    return value;
  return (limit->above ? value > limit->value : value < limit->value) ? 1.0 : 0.0;
}

Measure parse_measure(const std::string& text,
                      const std::set<std::string>& outcome_names, bool outcomes_first) {
  Measure measure;
  std::string rest = text;
  measure.limit = take_limit(rest);
  take_moment(rest, measure);
  read_name(rest, outcome_names, outcomes_first, measure);
  measure.name = measure.from == Measure::From::curve
                     ? measure.curve.name() + moment_of(measure)
                     : rest;
  if (measure.limit)
    measure.name +=
        fmt::format("{}{}", measure.limit->above ? '>' : '<', measure.limit->value);
  return measure;
}

}  // namespace blocks::report
