#include "deck/follow_on.hpp"

#include <cstdlib>
#include <fmt/format.h>

#include <optional>
#include <span>

namespace blocks::deck {
namespace {

/// The values of several lines in one sequence, with the ends of the lines.
struct Flat {
  std::vector<const Field*> fields;
  /// Number of values up to and including each line.
  std::vector<std::size_t> line_ends;
  std::vector<SourceLocation> places;  ///< location just after each line
};

Flat flatten(const std::vector<Line>& lines) {
  Flat flat;
  for (const Line& line : lines) {
    for (const Field& field : line.fields) {
      flat.fields.push_back(&field);
    }
    flat.line_ends.push_back(flat.fields.size());
    flat.places.push_back(line.end);
  }
  return flat;
}

bool fits(const TwoListSpec& spec, long found) {
  return found == spec.count ||
         (spec.may_be_short && found < spec.count && (found == 1 || found == 2));
}

long misfit(const TwoListSpec& spec, long found) {
  return fits(spec, found) ? 0 : std::labs(spec.count - found);
}

/// Reads one of the two lists: checks its count, reads the values and completes a short
/// list.
bool read_list(const TwoListSpec& spec, std::string_view name,
               std::span<const Field* const> fields, SourceLocation end,
               std::string hint, std::vector<Exact>& out, Diagnostics& diagnostics) {
  const std::string card(spec.card);
  const auto found = static_cast<long>(fields.size());
  bool ok = fits(spec, found);
  if (!ok) {
    if (hint.empty() && spec.may_be_short && spec.count > 2) {
      hint =
          fmt::format("give all {}, or only 1 or 2; the last is repeated", spec.count);
    }
    const bool surplus = found > spec.count;
    diagnostics.error(
        surplus ? fields[static_cast<std::size_t>(spec.count)]->where : end, card,
        fmt::format("expected {} {}, found {}", spec.count, name, found), hint);
  }
  FieldSpec value_spec = spec.value;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (fields[i]->blank) {
      diagnostics.error(fields[i]->where, card,
                        fmt::format("blank value among the {}", name),
                        "the values of a list have no default");
      ok = false;
      continue;
    }
    const std::string label = fmt::format("{}{}", spec.value.name, i + 1);
    value_spec.name = label;
    const Value value = read_value(*fields[i], value_spec, card, diagnostics);
    ok = ok && value.ok;
    out.push_back(value.as_exact());
  }
  if (ok && found < spec.count) {
    Exact repeated = out.back();
    repeated.given = false;
    out.resize(static_cast<std::size_t>(spec.count), repeated);
  }
  return ok;
}

}  // namespace

TwoLists read_two_lists(const TwoListSpec& spec, const std::vector<Line>& lines,
                        SourceLocation card_end, Diagnostics& diagnostics) {
  TwoLists out;
  const std::string card(spec.card);
  if (lines.empty()) {
    diagnostics.error(card_end, card,
                      fmt::format("expected {} {} and {} {} on the lines below, found "
                                  "none",
                                  spec.count, spec.first, spec.count, spec.second));
    return out;
  }
  const Flat flat = flatten(lines);
  const auto total = static_cast<long>(flat.fields.size());
  std::size_t best = 0;  // index of the last line of the first list
  long min = -1;
  int perfect = 0;
  int perfect_comma_free = 0;
  for (std::size_t i = 0; i < flat.line_ends.size(); ++i) {
    const auto first = static_cast<long>(flat.line_ends[i]);
    const long sum = misfit(spec, first) + misfit(spec, total - first);
    // If several splits fit, a comma at the end of a line means that the list
    // continues.
    const bool comma_free = sum == 0 && !lines[i].comma;
    perfect += sum == 0 ? 1 : 0;
    perfect_comma_free += comma_free ? 1 : 0;
    if (min < 0 || sum < min || (comma_free && perfect_comma_free == 1)) {
      min = sum;
      best = i;
    }
  }
  if (perfect > 1 && perfect_comma_free != 1) {
    diagnostics.error(
        flat.fields[flat.line_ends[best]]->where, card,
        fmt::format("cannot tell where the {} start", spec.second),
        "end each continued line of a list with a comma, or give all its values");
    return out;
  }
  const std::span<const Field* const> all(flat.fields);
  const std::size_t split = flat.line_ends[best];
  const bool one_line =
      static_cast<long>(split) > spec.count && best + 1 == lines.size();
  const std::string hint =
      one_line ? fmt::format("the {} start on a new line", spec.second) : "";
  const bool first_ok = read_list(spec, spec.first, all.first(split), flat.places[best],
                                  hint, out.first, diagnostics);
  if (one_line) {
    return out;
  }
  const bool second_ok = read_list(spec, spec.second, all.subspan(split),
                                   flat.places.back(), "", out.second, diagnostics);
  out.ok = first_ok && second_ok;
  return out;
}

Points read_points(const PointSpec& spec, long count, const std::vector<Line>& lines,
                   SourceLocation card_end, Diagnostics& diagnostics) {
  const std::string card(spec.card);
  const std::string both = fmt::format("{}, {}", spec.first.name, spec.second.name);
  Points out{.first = {}, .second = {}, .ok = true};
  const auto fault = [&](SourceLocation where, const std::string& message,
                         const std::string& hint) {
    diagnostics.error(where, card, message, hint);
    out.ok = false;
  };
  const auto found = static_cast<long>(lines.size());
  if (found != count) {
    const bool surplus = found > count;
    const SourceLocation where =
        surplus ? lines[static_cast<std::size_t>(count)].fields.front().where
                : (lines.empty() ? card_end : lines.back().end);
    fault(where,
          fmt::format("expected {} line{} of {}, found {}", count,
                      count == 1 ? "" : "s", both, found),
          fmt::format("{} is the number of lines that follow, one point each",
                      spec.count));
  }
  std::optional<double> previous;
  for (const Line& line : lines) {
    const std::vector<Field>& fields = line.fields;
    if (fields.size() == 2 && (fields[0].blank || fields[1].blank)) {
      const bool is_first = fields[0].blank;
      fault(fields[is_first ? 0 : 1].where,
            fmt::format("the {} of this point is blank",
                        (is_first ? spec.first : spec.second).help),
            "points have no default");
      continue;
    }
    if (fields.size() != 2) {
      fault(fields.size() > 2 ? fields[2].where : line.end,
            fmt::format("expected {} on this line, found {} value{}", both,
                        fields.size(), fields.size() == 1 ? "" : "s"),
            "one point per line");
      continue;
    }
    const Value first = read_value(fields[0], spec.first, card, diagnostics);
    const Value second = read_value(fields[1], spec.second, card, diagnostics);
    out.ok = out.ok && first.ok && second.ok;
    if (first.ok) {
      const double now = first.number.value();
      if (!spec.ascending.empty() && previous && now < *previous)
        fault(
            first.where,
            fmt::format("{} must not decrease from line to line", spec.ascending),
            fmt::format("the previous line has {} = {:g}", spec.first.name, *previous));
      previous = now;
    }
    out.first.push_back(first.as_real());
    out.second.push_back(second.as_real());
  }
  return out;
}

}  // namespace blocks::deck
