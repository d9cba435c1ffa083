#include "study/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "text/table.hpp"

namespace blocks::study {
namespace {

/// An estimate of the tables, and how many frames it counts, if it counts any.
struct Measured {
  const char *csv, *json;  ///< its names
  Estimate Row::*estimate;
  long Row::*count = nullptr;
};
constexpr Measured measures[] = {
    {"wrong_signs", "wrong_signs", &Row::wrong_signs},
    {"wrong_tangents", "wrong_tangents", &Row::wrong_tangents},
    {"phantom", "phantom", &Row::phantom},
    {"missed", "missed", &Row::missed},
    {"hang_ups", "hang_ups", &Row::hang_ups, &Row::hung},
    {"fall_throughs", "fall_throughs", &Row::fall_throughs, &Row::fell},
    {"speed_lost", "speed_lost", &Row::speed_lost},
    {"energy_error", "energy_error", &Row::energy},
    {"diverged", "divergences", &Row::divergences, &Row::diverged},
    {"median_step", "median_step", &Row::divergence_step},
    {"deep", "deep_contacts", &Row::deep_frames, &Row::deep}};

/// A share with half its interval, in per cent: "66 ±2", "0", "-".
std::string percent(const Estimate& e) {
  if (std::isnan(e.value))
    return "-";
  if (e.value == 0.0)
    return "0";
  const double half = 50.0 * (e.high - e.low), value = 100.0 * e.value;
  const int digits = value < 0.095 ? -1 : value < 9.95 ? 1 : 0;
  if (digits < 0)
    return fmt::format("{:.1g}", value);
  if (std::isnan(half))
    return fmt::format("{:.{}f}", value, digits);
  return fmt::format("{:.{}f} ±{:.{}f}", value, digits, half, digits);
}

/// "3/20 5-36": count, frames, interval in per cent; "-" if it could not happen.
std::string counted(long k, int n, const Estimate& e) {
  if (std::isnan(e.value))
    return "-";
  return fmt::format("{}/{} {:.{}f}-{:.{}f}", k, n, 100 * e.low,
                     100 * e.low < 9.95 && k ? 1 : 0, 100 * e.high,
                     100 * e.high < 9.95 ? 1 : 0);
}

/// "4e-10 (8e-11..2e-09)": a mean over several magnitudes has an asymmetric interval.
std::string small(const Estimate& e) {
  if (std::isnan(e.value))
    return "-";
  return std::isnan(e.low)
             ? fmt::format("{:.0e}", e.value)
             : fmt::format("{:.0e} ({:.0e}..{:.0e})", e.value, e.low, e.high);
}

/// "12/20 at 53 (20-71)": frames, and the median of the first step with its interval.
std::string divergence(const Row& row) {
  if (row.variant->corners != Corners::sharp)
    return "-";
  if (row.diverged == 0)
    return "never";
  const Estimate& step = row.divergence_step;
  return fmt::format("{}/{} at {:.0f}", row.diverged, row.frames, step.value) +
         (std::isnan(step.low) ? std::string()
                               : fmt::format(" ({:.0f}-{:.0f})", step.low, step.high));
}

/// Lists the frames in which the default rules failed, so that they can be run again.
std::string frames_line(const char* what, const std::vector<int>& frames,
                        const std::string& again) {
  if (frames.empty())
    return {};
  std::string line = fmt::format("default {} in frame", what);
  for (std::size_t i = 0; i < frames.size() && i < 10; ++i)
    line += fmt::format(" {}", frames[i]);
  return line + fmt::format("{}; to repeat one: --frames 1 --first {}{}\n",
                            frames.size() > 10 ? " ..." : "", frames.front(), again);
}

std::string text_of(const Reason& reason) {
  return fmt::format("frame {} ({}), {}", reason.frame, reason.kind, reason.why);
}

/// What failed in the first frames that failed, and the counts of each kind of frame.
std::string reasons_and_kinds(const Row& row) {
  constexpr std::size_t max = 10;
  std::string out;
  for (std::size_t i = 0; i < std::min(max, row.reasons.size()); ++i)
    out += text_of(row.reasons[i]) + '\n';
  if (row.reasons.size() > max)
    out += fmt::format("... and {} more\n", row.reasons.size() - max);
  if (row.kinds.size() < 2)
    return out;
  std::vector<std::vector<std::string>> table = {
      {"kind of frame", "frames", "failed", "hung", "fell through", "too deep"}};
  for (const KindCount& kind : row.kinds)
    table.push_back({kind.kind, fmt::format("{}", kind.frames),
                     fmt::format("{}", kind.failed), fmt::format("{}", kind.hung),
                     fmt::format("{}", kind.fell), fmt::format("{}", kind.deep)});
  return out + '\n' + text::aligned(table, table[0].size());
}

std::string number(double x) {
  return std::isfinite(x) ? fmt::format("{:.6g}", x) : "";
}

std::string cell(const Estimate& e) {
  if (std::isnan(e.value))
    return ",,,";
  return "," + number(e.value) + "," + number(e.low) + "," + number(e.high);
}

nlohmann::json value_or_null(double x) {
  return std::isfinite(x) ? nlohmann::json(x) : nlohmann::json();
}

nlohmann::json as_json(const Estimate& e) {
  return {{"value", value_or_null(e.value)},
          {"low", value_or_null(e.low)},
          {"high", value_or_null(e.high)}};
}

/// Adds what is measured only beside an uncut domain.
void add_kinds(nlohmann::json& json, const Row& row) {
  json["deep_in"] = row.deep_in;
  json["reasons"] = nlohmann::json::array();
  for (const Reason& reason : row.reasons)
    json["reasons"].push_back(text_of(reason));
  for (const KindCount& kind : row.kinds)
    json["kinds"].push_back({{"kind", kind.kind},
                             {"frames", kind.frames},
                             {"failed", kind.failed},
                             {"hung", kind.hung},
                             {"fell", kind.fell},
                             {"deep", kind.deep}});
}

nlohmann::json as_json(const Row& row) {
  if (!row.refused.empty())
    return {{"variant", row.variant->name}, {"refused", row.refused}};
  nlohmann::json json = {{"variant", row.variant->name},
                         {"hung_in", row.hung_in},
                         {"fell_in", row.fell_in},
                         {"energy_error_worst", value_or_null(row.worst_energy)},
                         {"diverged", row.diverged}};
  for (const Measured& one : measures)
    if (one.estimate != &Row::deep_frames || !row.kinds.empty())
      json[one.json] = as_json(row.*one.estimate);
  if (!row.kinds.empty())
    add_kinds(json, row);
  return json;
}

}  // namespace

std::string text(const Study& study) {
  std::string out = fmt::format("{}: {}\n", study.scene, study.what);
  if (!study.refused.empty())
    return out + "not run: " + study.refused + "\n";
  const bool has_deep =
      std::any_of(study.rows.begin(), study.rows.end(),
                  [](const Row& row) { return !std::isnan(row.deep_frames.value); });
  std::vector<std::vector<std::string>> table = {
      {"variant", "wrong", "phantom", "missed", "hang-ups", "speed", "fell through",
       "energy", "differs from"},
      {"", "signs %", "%", "%", "%", "lost %", "%", "error", "default at step"}};
  if (has_deep)
    table[0].push_back("too deep"), table[1].push_back("%");
  std::string notes;
  int frames = 0;
  for (const Row& row : study.rows) {
    if (!row.refused.empty()) {
      notes += fmt::format("{} not run: {}\n", row.variant->name, row.refused);
      continue;
    }
    frames = row.frames;
    table.push_back(
        {std::string(row.variant->name), percent(row.wrong_signs), percent(row.phantom),
         percent(row.missed), counted(row.hung, row.frames, row.hang_ups),
         percent(row.speed_lost), counted(row.fell, row.frames, row.fall_throughs),
         small(row.energy), divergence(row)});
    if (has_deep)
      table.back().push_back(counted(row.deep, row.frames, row.deep_frames));
    if (row.variant == &all_variants().front()) {
      if (!study.not_counted.empty())
        notes += fmt::format("hang-ups and fall-throughs: not counted, because\n  {}\n",
                             study.not_counted);
      else if (std::isnan(row.hang_ups.value))
        notes += study.expected.empty()
                     ? "hang-ups: not possible here, because nothing should move\n"
                     : "hang-ups: not counted, because the expected motion ends near "
                       "its start; another number of --steps may end elsewhere\n";
      if (!study.expected.empty())
        notes += fmt::format("the deck's own MOTION, CYCLE and SOLVE are replaced by "
                             "{} steps\n",
                             study.steps);
      if (!study.must_pass)
        notes += "default is known to fail here in some frames\n";
      notes += frames_line("hung", row.hung_in, study.again);
      notes += frames_line("fell through", row.fell_in, study.again);
      notes += frames_line("had a contact that is too deep", row.deep_in, study.again);
      notes += reasons_and_kinds(row);
    }
  }
  if (frames > 0)
    out += fmt::format("{} frame{} of {} steps; 95 % confidence{}\n\n", frames,
                       frames == 1 ? "" : "s", study.steps,
                       study.expected.empty()
                           ? std::string()
                           : "; expected motion: the run of " + study.expected) +
           text::aligned(table, table[0].size());
  return out + notes;
}

std::string csv(const std::vector<Study>& studies) {
  std::string out = "scene,variant,frames,steps";
  for (const Measured& one : measures) {
    if (one.count != nullptr)
      out += fmt::format(",{}_count", one.csv);
    out += fmt::format(",{0},{0}_low,{0}_high", one.csv);
    if (one.estimate == &Row::energy)
      out += ",energy_error_worst";
  }
  for (const Study& study : studies)
    for (const Row& row : study.rows) {
      out += fmt::format("\n{},{},{},{}", text::csv_cell(study.scene),
                         row.variant->name, row.frames, study.steps);
      for (const Measured& one : measures) {
        const Estimate& estimate = row.*one.estimate;
        if (one.count != nullptr)  // empty if it could not happen
          out += std::isnan(estimate.value) ? "," : fmt::format(",{}", row.*one.count);
        out += cell(estimate);
        if (one.estimate == &Row::energy)
          out += "," + number(row.worst_energy);
      }
    }
  return out + "\n";
}

std::string json(const std::vector<Study>& studies, const ReportHead& head) {
  nlohmann::json result = {{"frames", head.frames}, {"seed", head.seed}};
  result["studies"] = nlohmann::json::array();
  for (const Study& study : studies) {
    nlohmann::json one = {
        {"scene", study.scene}, {"what", study.what}, {"steps", study.steps}};
    if (!study.expected.empty())
      one["expected"] = study.expected;
    if (!study.refused.empty())
      one["refused"] = study.refused;
    one["variants"] = nlohmann::json::array();
    for (const Row& row : study.rows)
      one["variants"].push_back(as_json(row));
    result["studies"].push_back(one);
  }
  return result.dump(2) + "\n";
}

std::string list_of_variants() {
  std::string out = "variants:\n";
  for (const Variant& v : all_variants())
    out += fmt::format("  {:<14}{}\n", v.name, v.what);
  return out;
}

std::string list_of_scenes() {
  std::string out = "scenes (all: all of them), or a deck:\n";
  for (const std::string_view name : scene_names())
    out += fmt::format("  {:<14}{}\n", name, make_scene(name).what);
  return out;
}

}  // namespace blocks::study
