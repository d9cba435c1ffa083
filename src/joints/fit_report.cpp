#include "joints/fit_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

namespace blocks::joints {
namespace {

using geometry::SpacingLaw;
using geometry::Vec2;

struct Field {
  const char* name;
  const char* unit;
  Estimate SetFit::*value;
};
constexpr std::array<Field, 8> fields{{{"dip", "degrees", &SetFit::dip},
                                       {"ddev", "degrees", &SetFit::ddev},
                                       {"space", "L", &SetFit::space},
                                       {"sdev", "L", &SetFit::sdev},
                                       {"trace", "L", &SetFit::trace},
                                       {"tdev", "L", &SetFit::tdev},
                                       {"gap", "L", &SetFit::gap},
                                       {"gdev", "L", &SetFit::gdev}}};

const char* name_of(SpacingLaw law) {
  return law == SpacingLaw::negexp    ? "NEGEXP"
         : law == SpacingLaw::poisson ? "POISSON"
                                      : "UNIFORM";
}

/// Whether the field matters for the set; others are 0 by definition.
bool matters(const SetFit& set, const Field& field) {
  const std::string name = field.name;
  const bool plain = set.trace.value == 0.0 || set.until > 0;
  if (plain && (name == "tdev" || name == "gap" || name == "gdev"))
    return false;
  if (set.law == SpacingLaw::poisson && (name == "dip" || name == "ddev"))
    return false;
  return name != "sdev" || set.law == SpacingLaw::uniform;
}

std::string interval(const Estimate& one) {
  if (one.low == one.value && one.high == one.value)
    return "chosen";
  return std::isfinite(one.low) && std::isfinite(one.high)
             ? fmt::format("{:.4g} to {:.4g}", one.low, one.high)
             : "not known";
}

std::string values(const std::vector<double>& numbers) {
  constexpr std::size_t per_line = 6;
  std::string text;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    text += fmt::format("{}", numbers[i]);
    if (i + 1 < numbers.size())
      text += (i + 1) % per_line == 0 ? ",\n" : ", ";
  }
  return text + "\n";
}

/// Six digits, and 0 for what is beyond them.
std::string digits(double value) { return fmt::format("{:.6g}", value); }

/// Returns about how many blocks the sets make.
double expected_blocks(const NetworkFit& fit, const Network& network) {
  double crossings = 0.0, lines = 0.0;
  for (const SetFit& a : fit.sets) {
    lines += a.p21 * std::sqrt(network.area);
    for (const SetFit& b : fit.sets)
      if (a.id < b.id)
        crossings +=
            a.p21 * b.p21 * network.area *
            std::abs(std::sin((a.dip.value - b.dip.value) * std::numbers::pi / 180.0));
    // Joints of one set cross too if they deviate.
    crossings +=
        a.p21 * a.p21 * network.area / std::numbers::pi *
        (a.law == SpacingLaw::poisson ? 1.0 : std::min(a.ddev.value / 45.0, 1.0));
  }
  return crossings + lines + 1.0;
}

/// Returns the decimals with which a thousandth of the size can be written.
int decimals_of(double size) {
  return std::clamp(3 - static_cast<int>(std::floor(std::log10(size))), 0, 15);
}

std::string one_line(std::string words) {
  std::replace_if(
      words.begin(), words.end(),
      [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  return words;
}

std::string set_card(const SetFit& set, int decimals) {
  const auto value = [&](const Field& field) {
    return matters(set, field) ? digits((set.*field.value).value) : std::string("0");
  };
  std::string card = fmt::format("$ Set {}, from {} parts of traces, P21 {:.4g}:\n",
                                 set.id, set.pieces, set.p21);
  for (const Field& field : fields)
    if (matters(set, field))
      card += fmt::format("$   {:<5} {}\n", field.name, interval(set.*field.value));
  for (const std::string& note : set.notes)
    card += fmt::format("$   {}\n", note);
  card += fmt::format("JSET, {}", set.id);
  for (const Field& field : fields)
    card += ", " + value(field);
  return card + fmt::format(", {:.{}f}, {:.{}f}, {}{}\n", set.start.x(), decimals,
                            set.start.y(), decimals, name_of(set.law),
                            set.until > 0 ? fmt::format(", {}", set.until) : "");
}

}  // namespace

std::string fit_deck(const NetworkFit& fit, const TraceMap& map,
                     const Network& network) {
  Vec2 low = network.window.front(), high = low;
  std::vector<double> x, y;
  for (const Vec2& corner : network.window) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
    x.push_back(corner.x());
    y.push_back(corner.y());
  }
  const double blocks = expected_blocks(fit, network);
  const double margin = 0.1 * (high - low).maxCoeff();
  const int decimals = decimals_of(margin);
  const auto limit = [&](double at) { return fmt::format("{:.{}f}", at, decimals); };
  const double one_block = std::sqrt(network.area / blocks);
  constexpr double spare = 4.0;  // blocks for which START reserves memory
  const auto boxes = [&](double length) {
    return std::clamp(static_cast<int>((length + 2.0 * margin) / one_block), 1, 1000);
  };
  const std::string name = one_line(map.name);
  std::string deck = fmt::format(
      "$ Joint sets fitted to {} by blocks joints fit. The numbers in the\n"
      "$ comments are intervals that cover the true value in 95 % of all maps\n"
      "$ (docs/joint-statistics.md). Stiffness, material, friction and gravity are\n"
      "$ examples: replace them by your own.\n",
      name);
  deck += fmt::format("START, {}, {}\nJOINT SETS FITTED TO {}\n",
                      static_cast<long>(spare * blocks) + 100,
                      1000 + network.window.size(), name.substr(0, 50));
  deck += fmt::format(
      "XLIMITS, {}, {}\nYLIMITS, {}, {}\nBOXES, {}, {}, {}\n", limit(low.x() - margin),
      limit(high.x() + margin), limit(low.y() - margin), limit(high.y() + margin),
      boxes(high.x() - low.x()), boxes(high.y() - low.y()), digits(0.01 * one_block));
  deck += "STIFF, 1.E8, 1.E8\nFRACTION, 0.02\nMATERIAL, 1, 1.E10, 4.E9, 2500\n"
          "$ UNITS, m, kg, s       if these are the units of the map\n"
          "SEED, 1982              $ another seed makes another map of the same kind\n"
          "RIGID\nEND\n";
  deck += fmt::format("OUTLINE, {}, 1\n{}{}", x.size(), values(x), values(y));
  for (const bool ends_at_set : {false, true})  // the cards at which others end first
    for (const SetFit& set : fit.sets)
      if ((set.until > 0) == ends_at_set)
        deck += set_card(set, decimals);
  // Slivers would make the time step short.
  deck +=
      fmt::format("$ Cells below a hundredth of the area of a usual block are merged "
                  "into a\n$ neighbour.\nCUT, 0, {:.2g}\n",
                  0.01 * one_block * one_block);
  return deck + "GRAVITY, 0, -9.81\nFRICTN, 0.5\nDAMPING, 0.5\nCYCLE, 100\nSTOP\n";
}

std::string fit_text(const NetworkFit& fit) {
  std::string text;
  for (const SetFit& set : fit.sets) {
    text += fmt::format("set {}: {} parts of traces, law {}, P21 {:.4g}\n", set.id,
                        set.pieces, name_of(set.law), set.p21);
    for (const Field& field : fields)
      if (matters(set, field))
        text += fmt::format("  {:<5} {:>10.4g} [{}]  95 %: {}\n", field.name,
                            (set.*field.value).value, field.unit,
                            interval(set.*field.value));
    if (set.until > 0)
      text += fmt::format("  until {:>10}\n", set.until);
    for (const std::string& note : set.notes)
      text += "  " + note + "\n";
  }
  return text;
}

std::string fit_json(const NetworkFit& fit, const TraceMap& map) {
  using nlohmann::ordered_json;
  const auto number = [](double value) {
    return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
  };
  ordered_json all = {{"name", map.name},
                      {"components_by_bic", fit.components},
                      {"sets", ordered_json::array()}};
  for (const SetFit& set : fit.sets) {
    ordered_json one = {{"id", set.id},
                        {"parts", set.pieces},
                        {"p21", number(set.p21)},
                        {"law", name_of(set.law)}};
    for (const Field& field : fields) {
      const Estimate& estimate = set.*field.value;
      one[field.name] = {{"value", number(estimate.value)},
                         {"low", number(estimate.low)},
                         {"high", number(estimate.high)}};
    }
    one["x0"] = set.start.x();
    one["y0"] = set.start.y();
    if (set.until > 0)
      one["until"] = set.until;
    one["notes"] = set.notes;
    all["sets"].push_back(std::move(one));
  }
  return all.dump(2) + "\n";
}

}  // namespace blocks::joints
