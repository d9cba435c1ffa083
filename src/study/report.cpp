#include "study/report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace blocks::study {
namespace {

/// A share with half its interval, in per cent: "66 +-2", "0", "-".
std::string percent(const Estimate& e) {
  if (std::isnan(e.value))
    return "-";
  if (e.value == 0.0)
    return "0";
  const double half = 50.0 * (e.high - e.low), value = 100.0 * e.value;
  const int digits = value < 0.095 ? -1 : value < 9.95 ? 1 : 0;
  if (digits < 0)
    return fmt::format("{:.1g}", value);
  return fmt::format("{:.{}f} ±{:.{}f}", value, digits, half, digits);
}

/// "3/20  5-36": count, frames, interval in per cent.
std::string counted(long k, int n, const Estimate& e) {
  return fmt::format("{}/{} {:.{}f}-{:.{}f}", k, n, 100 * e.low,
                     100 * e.low < 9.95 && k ? 1 : 0, 100 * e.high,
                     100 * e.high < 9.95 ? 1 : 0);
}

std::string small(double x) { return std::isnan(x) ? "-" : fmt::format("{:.0e}", x); }

std::string divergence(const Row& row) {
  if (row.variant->corners != Corners::sharp)
    return "-";
  return row.diverged == 0 ? "never"
                           : fmt::format("{}/{} at {:.0f}", row.diverged, row.frames,
                                         row.median_step);
}

/// Where the default rules failed: whoever mends them needs the frames.
std::string frames_line(const char* what, const std::vector<int>& frames) {
  if (frames.empty())
    return {};
  std::string line = fmt::format("default {} in frame", what);
  for (std::size_t i = 0; i < frames.size() && i < 10; ++i)
    line += fmt::format(" {}", frames[i]);
  return line + fmt::format("{}; one again: --frames 1 --first {}\n",
                            frames.size() > 10 ? " ..." : "", frames.front());
}

/// {:<18} counts bytes, and ± has two.
std::string left(const std::string& s, std::size_t width) {
  std::size_t shown = 0;
  for (const char c : s)
    shown += (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  return s + std::string(shown < width ? width - shown : 1, ' ');
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

}  // namespace

std::string text(const Study& study) {
  std::string out = fmt::format("{}: {}\n", study.scene, study.what);
  out += fmt::format("{} frames of {} steps; 95 % confidence\n\n",
                     study.rows.empty() ? 0 : study.rows.front().frames, study.steps);
  const auto line = [&](const std::vector<std::string>& cells) {
    constexpr std::size_t widths[] = {14, 11, 11, 11, 15, 15, 8, 1};
    std::string row;
    for (std::size_t i = 0; i < cells.size(); ++i)
      row += left(cells[i], widths[i]);
    row.erase(row.find_last_not_of(' ') + 1);
    out += row + "\n";
  };
  line({"variant", "wrong", "phantom", "missed", "hang-ups", "fell through", "energy",
        "differs from"});
  line({"", "signs %", "%", "%", "%", "%", "error", "default at step"});
  for (const Row& row : study.rows)
    line({std::string(row.variant->name), percent(row.wrong_signs),
          percent(row.phantom), percent(row.missed),
          counted(row.hung, row.frames, row.hang_ups),
          counted(row.fell, row.frames, row.fall_throughs), small(row.energy.value),
          divergence(row)});
  for (const Row& row : study.rows)
    if (row.variant == &all_variants().front()) {
      out += frames_line("hung", row.hung_in);
      out += frames_line("fell through", row.fell_in);
    }
  return out;
}

namespace {

/// A field of a CSV file: in quotes where it has to be (RFC 4180).
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos)
    return text;
  std::string quoted = "\"";
  for (const char c : text)
    quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

}  // namespace

std::string csv(const std::vector<Study>& studies) {
  std::string out = "scene,variant,frames,steps";
  for (const char* name : {"wrong_signs", "wrong_tangents", "phantom", "missed"})
    out += fmt::format(",{0},{0}_low,{0}_high", name);
  for (const char* name : {"hang_ups", "fall_throughs"})
    out += fmt::format(",{0}_count,{0},{0}_low,{0}_high", name);
  out += ",energy_error,energy_error_low,energy_error_high,energy_error_worst,diverged,"
         "median_step\n";
  for (const Study& study : studies)
    for (const Row& row : study.rows) {
      out += fmt::format("{},{},{},{}", field(study.scene), row.variant->name,
                         row.frames, study.steps);
      for (const Estimate* e :
           {&row.wrong_signs, &row.wrong_tangents, &row.phantom, &row.missed})
        out += cell(*e);
      out += fmt::format(",{}", row.hung) + cell(row.hang_ups);
      out += fmt::format(",{}", row.fell) + cell(row.fall_throughs);
      out += cell(row.energy) + "," + number(row.worst_energy);
      out += fmt::format(",{},{}\n", row.diverged, number(row.median_step));
    }
  return out;
}

std::string json(const std::vector<Study>& studies, const ReportHead& head) {
  nlohmann::json result = {{"frames", head.frames}, {"seed", head.seed}};
  for (const Study& study : studies) {
    nlohmann::json one = {
        {"scene", study.scene}, {"what", study.what}, {"steps", study.steps}};
    for (const Row& row : study.rows)
      one["variants"].push_back(
          {{"variant", row.variant->name},
           {"wrong_signs", as_json(row.wrong_signs)},
           {"wrong_tangents", as_json(row.wrong_tangents)},
           {"phantom", as_json(row.phantom)},
           {"missed", as_json(row.missed)},
           {"hang_ups", as_json(row.hang_ups)},
           {"hung_in", row.hung_in},
           {"fall_throughs", as_json(row.fall_throughs)},
           {"fell_in", row.fell_in},
           {"energy_error", as_json(row.energy)},
           {"energy_error_worst", value_or_null(row.worst_energy)},
           {"diverged", row.diverged},
           {"median_step", value_or_null(row.median_step)}});
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
  std::string out = "scenes (all: every one), or a deck:\n";
  for (const std::string_view name : scene_names())
    out += fmt::format("  {:<14}{}\n", name, make_scene(name).what);
  return out;
}

}  // namespace blocks::study
