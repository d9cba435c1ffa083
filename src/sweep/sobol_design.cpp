#include "sweep/sobol_design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <random>

#include "text/number.hpp"

namespace blocks::sweep {
namespace {

constexpr const char* sobol_hint =
    "for example --sobol FRICTN.fric=0.3..0.6,STIFF.stifn=1e8..1e9; 'blocks cards "
    "--set DECK' lists the fields of a deck";

/// Returns the end of a range; nothing if the text is no number.
std::optional<double> end_of(const std::string& text) {
  const std::string word = trimmed(text);
  return text::number_of<double>(word.substr(word.starts_with('+') ? 1 : 0));
}

/// Reads "low..high" in every way in which both ends are numbers: 1...5 has two.
std::vector<SobolRange> readings(const std::string& text) {
  std::vector<SobolRange> found;
  for (auto at = text.find(".."); at != text.npos; at = text.find("..", at + 1)) {
    const auto low = end_of(text.substr(0, at)), high = end_of(text.substr(at + 2));
    if (low && high)
      found.push_back({{}, *low, *high});
  }
  return found;
}

SobolRange parse_range(const std::string& text) {
  const auto equals = text.find('=');
  const std::string field = trimmed(text.substr(0, equals));
  if (equals == std::string::npos || !is_field(field))
    throw AxisFault(
        fmt::format("--sobol: expected CARD.field=low..high, found '{}'", text),
        sobol_hint);
  const auto found = readings(text.substr(equals + 1));
  if (found.empty())
    throw AxisFault(
        fmt::format("--sobol {}: expected two numbers, low..high", trimmed(text)),
        sobol_hint);
  if (found.size() > 1)
    throw AxisFault(
        fmt::format("--sobol {}: three points can be read in two ways", trimmed(text)),
        "write 0.5 instead of .5, and 1 instead of 1.");
  SobolRange range = found.front();
  range.field = field;
  if (!(range.low < range.high))
    throw AxisFault(
        fmt::format("--sobol {}: the low end {} is not below the high end "
                    "{}",
                    trimmed(text), range.low, range.high),
        range.low > range.high
            ? fmt::format("write {}={}..{}", field, range.high, range.low)
            : fmt::format("--set {}={} is for a fixed value", field, range.low));
  return range;
}

/// Returns a variation with these values of the parameters, in their order.
Variation with_values(const SobolDesign& design, const Variation& common,
                      const std::vector<double>& values) {
  Variation run = common;
  for (std::size_t i = 0; i < values.size(); ++i)
    run.sets.push_back(fmt::format("{}={}", design.ranges[i].field, values[i]));
  return run;
}

double between(const SobolRange& range, double share) {
  return std::lerp(range.low, range.high, share);
}

}  // namespace

bool SobolDesign::has(const std::string& field) const {
  return std::any_of(ranges.begin(), ranges.end(),
                     [&](const SobolRange& one) { return one.field == field; });
}

std::vector<SobolRange> parse_sobol(const std::string& text) {
  std::vector<SobolRange> ranges;
  for (std::size_t from = 0; from <= text.size();) {
    const auto comma = std::min(text.find(',', from), text.size());
    const SobolRange range = parse_range(text.substr(from, comma - from));
    if (std::any_of(ranges.begin(), ranges.end(),
                    [&](const SobolRange& one) { return one.field == range.field; }))
      throw AxisFault(fmt::format("--sobol: the field {} is given twice", range.field),
                      "give each field once");
    ranges.push_back(range);
    from = comma + 1;
  }
  if (ranges.size() > max_sobol_parameters)
    throw AxisFault(fmt::format("--sobol has {} parameters, but at most {} are "
                                "possible",
                                ranges.size(), max_sobol_parameters),
                    "leave out those with little effect");
  return ranges;
}

std::vector<std::vector<double>> sobol_points(std::size_t count, std::size_t dimension,
                                              std::uint64_t seed) {
  // The standard defines all numbers of this generator.
  std::mt19937_64 random(seed);
  std::vector<std::uint64_t> shift(dimension);
  for (std::uint64_t& bits : shift)
    bits = random();
  boost::random::sobol sequence(dimension);
  std::vector<std::vector<double>> points(count, std::vector<double>(dimension));
  for (std::size_t j = 0; j < count; ++j)
    for (std::size_t d = 0; d < dimension; ++d) {
      // Boost leaves out the first point, 0, without which 2^m points are less even.
      const std::uint64_t bits = (j == 0 ? 0 : sequence()) ^ shift[d];
      constexpr double half = 0.5, all = 0x1p-52;  // 52 bits and a half are exact
      points[j][d] = (static_cast<double>(bits >> 12) + half) * all;
    }
  return points;
}

std::vector<Variation> sobol_runs(const SobolDesign& design, const Variation& common) {
  for (const std::string& set : common.sets)
    if (design.has(field_of(set)))
      throw AxisFault(fmt::format("the field {} is given twice", field_of(set)),
                      "give it by --sobol or by --set");
  const std::size_t k = design.ranges.size();
  if (design.rows > max_runs / design.runs_per_row())
    throw AxisFault(fmt::format("a sweep has at most {} runs, and --sobol with {} "
                                "parameters makes {} for each row",
                                max_runs, k, design.runs_per_row()),
                    fmt::format("give -n {} or less", max_runs / (k + 2)));
  std::vector<Variation> runs;
  runs.reserve(design.runs());
  for (const std::vector<double>& point :
       sobol_points(design.rows, 2 * k, design.seed)) {
    std::vector<double> a, b;
    for (std::size_t i = 0; i < k; ++i) {
      a.push_back(between(design.ranges[i], point[i]));
      b.push_back(between(design.ranges[i], point[k + i]));
    }
    runs.push_back(with_values(design, common, a));
    runs.push_back(with_values(design, common, b));
    for (std::size_t i = 0; i < k; ++i) {
      std::vector<double> mixed = a;
      mixed[i] = b[i];
      runs.push_back(with_values(design, common, mixed));
    }
  }
  return runs;
}

std::vector<Variation> sobol_corners(const SobolDesign& design,
                                     const Variation& common) {
  std::vector<Variation> corners;
  for (std::size_t corner = 0; corner < std::size_t{1} << design.ranges.size();
       ++corner) {
    std::vector<double> values;
    for (std::size_t i = 0; i < design.ranges.size(); ++i)
      values.push_back((corner >> i & 1) != 0 ? design.ranges[i].high
                                              : design.ranges[i].low);
    corners.push_back(with_values(design, common, values));
  }
  return corners;
}

std::string words_of(const SobolDesign& design) {
  std::string words;
  for (const SobolRange& one : design.ranges)
    words += fmt::format("{}{} = {} to {}", words.empty() ? "" : ", ", one.field,
                         one.low, one.high);
  return words;
}

}  // namespace blocks::sweep
