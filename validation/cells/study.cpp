#include "validation/cells/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace blocks::validation {
namespace {

const char* const head =
    R"(# Cells against exact answers

Written by `./go validate cells`; do not edit. [README](README.md) derives the exact values and
explains the sampling. Each row compares a mean with its exact value.

- Cells are sampled if their lowest point is in a window, which is well inside the outline (minus
  sampling). So the outline cuts hardly any sampled cell, and large cells are not missed.
- The standard error is from independent networks, by the jackknife. Cells of one network depend on
  each other, so the network is the unit.
- Inside: the exact value is in the 95 % confidence interval. About one row in twenty is outside by
  chance.
- z is the deviation in standard errors. A run fails if one |z| exceeds the limit. If every exact
  value is true, this happens in one run of a hundred or less (Bonferroni over all rows and both sets
  of seeds).

![deviations](intervals.svg)

)";

/// The figures of a group, which follow its table.
struct GroupFigures {
  const char* group;
  const char* text;
};
constexpr std::array figures = {
    GroupFigures{
        "Poisson lines",
        "![Poisson lines](poisson_lines.png)\n\n"
        "The number of sides of a cell. Exact are the parts with three and four "
        "sides.\n\n![sides](sides.svg)\n"},
    GroupFigures{"Poisson lines in a convex window",
                 "The number of cells varies much from network to network.\n\n"
                 "![number of cells](faces.svg)\n"},
    GroupFigures{"Two NEGEXP sets",
                 "![NEGEXP](negexp.png)\n\n"
                 "The areas of two sets follow the law of a product of two "
                 "spacings.\n\n![areas](areas.svg)\n"},
    GroupFigures{"Two UNIFORM sets", "![UNIFORM](uniform.png)\n"},
    GroupFigures{
        "Persistence: trace 3, gap 2, space 0.5",
        "The picture has a second, through-going set, because one set alone makes "
        "no blocks.\n\n![persistence](persistence.png)\n\n![P21](p21.svg)\n"},
    GroupFigures{"Poisson Voronoi cells", "![Voronoi](voronoi.png)\n"}};

/// Returns the number with the digits that its error justifies.
std::string with_error(double value, double error) {
  const int digits =
      error > 0.0
          ? std::clamp(1 - static_cast<int>(std::floor(std::log10(error))), 0, 9)
          : 6;
  return fmt::format("{:.{}f}", value, digits);
}

std::string overview(const Study& study) {
  std::string text = "| | first seeds | second seeds |\n|---|---|---|\n";
  const auto line = [&](const std::string& name, const auto& cell) {
    text += fmt::format("| {} | {} | {} |\n", name, cell(0), cell(1));
  };
  const auto count = [&](int index) {
    return [&study, index](std::size_t set) {
      return fmt::format("{:.0f}", study.total(set, index));
    };
  };
  line("networks", count(sum::networks));
  line("sampled cells", count(sum::cells));
  line("of these, cells that touch the outline", count(sum::clipped));
  line("networks with an identity that holds in every realisation",
       count(sum::identities));
  line("of these, networks where it does not hold", count(sum::broken));
  line("rows", [&](std::size_t) { return study.rows.size(); });
  line("rows outside of their 95 % interval", [&](std::size_t set) {
    return std::count_if(study.rows.begin(), study.rows.end(),
                         [&](const Row& row) { return !row.is_inside(set); });
  });
  line("expected outside by chance", [&](std::size_t) {
    return fmt::format("{:.1f}",
                       (1.0 - interval_level) * static_cast<double>(study.rows.size()));
  });
  line("largest z, without sign", [&](std::size_t set) {
    double max = 0.0;
    for (const Row& row : study.rows)
      max = std::max(max, std::abs(row.estimates[set].z(row.quantity.exact)));
    return fmt::format("{:.2f}", max);
  });
  line("limit", [&](std::size_t set) {
    double min = HUGE_VAL;
    for (const Row& row : study.rows)
      min = std::min(min, study.limit(row, set));
    return fmt::format("{:.2f}", min);
  });
  return text + "\n";
}

std::string table_row(const Study& study, const Row& row) {
  const Estimate &one = row.estimates[0], &two = row.estimates[1];
  const double exact = row.quantity.exact, half = one.half_width(interval_level);
  const auto show = [&](double value) { return with_error(value, one.error); };
  return fmt::format(
      "| {} | {} | {} | {} | {} | {} | {} | {} to {} | {} | {:.2f} | {} | {:.2f} |\n",
      study.cases[row.index].name, row.quantity.name, row.quantity.formula, show(exact),
      one.count, show(one.value), show(one.error), show(one.value - half),
      show(one.value + half), row.is_inside(0) ? "yes" : "no", one.z(exact),
      show(two.value), two.z(exact));
}

}  // namespace

double Study::total(std::size_t set, int index) const {
  double result = 0.0;
  for (const auto& sets : samples)
    for (const Sums& one : sets[set])
      result += one[index];
  return result;
}

double Study::limit(const Row& row, std::size_t set) const {
  return family_limit(family_level, static_cast<int>(seed_sets * rows.size()),
                      row.estimates[set].count);
}

bool Study::passed() const {
  for (std::size_t set = 0; set < seed_sets; ++set) {
    if (total(set, sum::broken) > 0.0 ||
        total(set, sum::clipped) > max_clipped * total(set, sum::cells))
      return false;
    for (const Row& row : rows)
      if (!(std::abs(row.estimates[set].z(row.quantity.exact)) <= limit(row, set)))
        return false;
  }
  return true;
}

Study run_study(double part, int threads) {
  constexpr std::uint64_t seeds_of_a_case = 1'000'000, seeds_of_a_set = 1'000'000'000;
  Study study;
  study.cases = cases();
  study.samples.resize(study.cases.size());
  for (std::size_t i = 0; i < study.cases.size(); ++i) {
    const Case& one = study.cases[i];
    const int count = std::max(20, static_cast<int>(std::lround(part * one.networks)));
    for (std::size_t set = 0; set < seed_sets; ++set)
      study.samples[i][set] =
          samples(one, 1 + set * seeds_of_a_set + i * seeds_of_a_case, count, threads);
    for (const Quantity& quantity : one.quantities) {
      Row row{i, quantity, {}};
      for (std::size_t set = 0; set < seed_sets; ++set)
        row.estimates[set] = jackknife(study.samples[i][set], quantity.statistic);
      study.rows.push_back(row);
    }
  }
  return study;
}

std::string markdown(const Study& study) {
  std::string text = head + overview(study), group;
  for (const Row& row : study.rows) {
    const Case& one = study.cases[row.index];
    if (one.group != group) {
      group = one.group;
      text += fmt::format(
          "## {}\n\n| case | quantity | exact | value | networks | mean | standard "
          "error | "
          "95 % interval | inside | z | mean, second seeds | z, second seeds |\n"
          "|---|---|---|---|---|---|---|---|---|---|---|---|\n",
          group);
    }
    text += table_row(study, row);
    const std::size_t next = static_cast<std::size_t>(&row - study.rows.data()) + 1;
    if (next < study.rows.size() && study.cases[study.rows[next].index].group == group)
      continue;
    text += "\n";
    for (const GroupFigures& shown : figures)
      if (group == shown.group)
        text += std::string(shown.text) + "\n";
  }
  return text;
}

}  // namespace blocks::validation
