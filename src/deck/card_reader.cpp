#include "deck/card_reader.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "text/capitals.hpp"
#include "text/suggest.hpp"

namespace blocks::deck {
namespace {

std::string did_you_mean(const std::string& word) {
  return word.empty() ? "" : "did you mean " + word + "?";
}

std::string not_a_number_hint(const std::string& text) {
  if (text.starts_with('*')) {
    return comment_hint;
  }
  for (const char c : text) {
    if (static_cast<unsigned char>(c) >= 0x80) {
      return "a number has only digits, point, sign and exponent; retype it, because "
             "copied text often has other kinds of minus or blank";
    }
  }
  if (text.find_first_not_of("0123456789.+-Oo") == std::string::npos &&
      text.find_first_of("Oo") != std::string::npos) {
    return "the letter O is not a zero";
  }
  return "write numbers like 12, -0.5, 1.E-3 or 1.D-3";
}

/// Reports faulty quotes of a field.
void report_quotes(const Field& field, std::string_view card,
                   Diagnostics& diagnostics) {
  const char quote = field.text.front();
  const char other = quote == '"' ? '\'' : '"';
  const bool open = field.fault == QuoteFault::not_closed;
  diagnostics.error(field.where, std::string(card),
                    open ? "the quote is not closed"
                         : "there is text after the closing quote",
                    open ? fmt::format("end the value with {}", quote)
                         : fmt::format("a value that contains {0} is written {1}...{1}",
                                       quote, other));
}

Value read_word(const Field& field, const FieldSpec& spec, std::string_view card,
                Diagnostics& diagnostics) {
  Value value{.where = field.where, .given = true, .ok = true};
  value.word = spec.choices.empty() ? field.text : text::capitals(field.text);
  if (!spec.choices.empty()) {
    for (const std::string_view choice : spec.choices) {
      if (value.word == choice) {
        return value;
      }
    }
    std::string allowed;
    for (const std::string_view choice : spec.choices) {
      allowed += (allowed.empty() ? "" : ", ") + std::string(choice);
    }
    value.ok = false;
    diagnostics.error(field.where, std::string(card),
                      fmt::format("{} must be {} or blank, found {}", spec.name,
                                  allowed, shown(field.text)),
                      did_you_mean(text::suggest(field.text, spec.choices)));
  }
  return value;
}

/// Reads a block or a side that is not given by its number.
Value read_choice(const Field& field, const FieldSpec& spec, std::string_view card,
                  Diagnostics& diagnostics) {
  Value value{.where = field.where, .given = true};
  try {
    value.selector = read_selector(field.text);
  } catch (const SelectorFault& fault) {
    SourceLocation part = field.where;
    part.column += static_cast<int>(fault.at) + int{field.quoted};
    part.length = static_cast<int>(fault.length);
    diagnostics.error(field.where.column == 0 ? field.where : part, std::string(card),
                      fault.what(), fault.hint);
    return value;
  }
  const bool of_side = spec.kind == Kind::side;
  value.ok = of_side ? value.selector->is_of_sides() : value.selector->is_of_blocks();
  if (!value.ok)
    diagnostics.error(field.where, std::string(card),
                      fmt::format("{} does not name {} for {}", value.selector->text,
                                  of_side ? "sides" : "blocks", spec.name),
                      fmt::format("{}s have {}", of_side ? "side" : "block",
                                  of_side ? side_selectors : block_selectors));
  return value;
}

Value default_value(const FieldSpec& spec, SourceLocation keyword) {
  Value value{.where = keyword, .ok = true};
  if (spec.kind == Kind::word) {
    value.word = *spec.fallback;
  } else {
    value.number = read_number(*spec.fallback).value;
    value.integer = std::lround(value.number.value());
  }
  return value;
}

/// Replaces values of the deck by those of --set.
std::vector<Field> overridden(const CardSpec& spec, const Line& line, long nth,
                              const std::vector<OverrideFields>& overrides) {
  std::vector<Field> fields(line.fields.begin() + 1, line.fields.end());
  for (const OverrideFields& set : overrides) {
    if (!set.changes(spec.name, nth)) {
      continue;
    }
    const std::size_t at = *spec.find_field(set.field);
    if (fields.size() <= at) {
      fields.resize(at + 1, Field{"", line.end, true, false});
    }
    if (spec.fields[at].repeats) {
      fields.resize(at);
      fields.insert(fields.end(), set.fields.begin(), set.fields.end());
    } else {
      fields[at] = set.fields.front();
    }
  }
  return fields;
}

/// Splits the value of --set like a card. It has no comments; a word without quotes is
/// the whole value, so that it may have blanks, commas, $ and !.
std::vector<Field> set_fields(const std::string& value, const FieldSpec& spec) {
  const std::size_t begin = std::min(value.find_first_not_of(" \t"), value.size());
  const std::string text =
      value.substr(begin, value.find_last_not_of(" \t") + 1 - begin);
  if (text.empty()) {
    return {Field{"", {}, true, false}};
  }
  const bool quoted = text.front() == '\'' || text.front() == '"';
  const bool whole = spec.kind == Kind::word && !spec.repeats;
  if (!quoted && (whole || text.find_first_of("$!") != std::string::npos)) {
    return {Field{text, {}, false, whole}};
  }
  return split_fields(text, 0).fields;
}

/// Returns n of MATERIAL[n]; 0 without brackets; nothing unless n is 1, 2, ...
std::optional<long> number_in_brackets(std::string_view card) {
  const std::size_t open = card.find('[');
  if (open == std::string_view::npos) {
    return 0;
  }
  const std::string_view digits = card.substr(open + 1, card.size() - open - 2);
  if (!card.ends_with(']') || digits.empty() || digits.size() > 9 ||
      digits.find_first_not_of("0123456789") != std::string_view::npos) {
    return std::nullopt;
  }
  const long number = std::stol(std::string(digits));
  return number > 0 ? std::optional(number) : std::nullopt;
}

}  // namespace

std::string shown(const std::string& text) {
  constexpr std::size_t longest = 40;
  const std::vector<std::string> chars = characters(text);
  std::string out;
  for (std::size_t i = 0; i < chars.size() && i < longest; ++i) {
    out += chars[i];
  }
  return "'" + out + (chars.size() > longest ? "...'" : "'");
}

std::optional<Override> parse_override(const std::string& text) {
  const auto dot = text.find('.'), equals = text.find('=');
  if (dot == std::string::npos || equals == std::string::npos || dot > equals)
    return std::nullopt;
  return Override{text.substr(0, dot), text.substr(dot + 1, equals - dot - 1),
                  text.substr(equals + 1)};
}

std::vector<OverrideFields> prepare_overrides(const std::vector<Override>& overrides,
                                              Diagnostics& diagnostics) {
  std::vector<OverrideFields> out;
  for (const Override& set : overrides) {
    const SourceLocation where = diagnostics.from_command_line(
        fmt::format("--set {}.{}={}", set.card, set.field, set.value));
    const std::string name = set.card.substr(0, set.card.find('['));
    const CardSpec* spec = find_card(name);
    if (spec == nullptr) {
      diagnostics.error(where, "", fmt::format("unknown card {}", shown(name)),
                        did_you_mean(text::suggest(name, card_names())));
      continue;
    }
    const std::optional<long> number = number_in_brackets(set.card);
    if (!number) {
      diagnostics.error(where, std::string(spec->name),
                        fmt::format("there is no card {}", shown(set.card)),
                        fmt::format("{0}[1] is the first {0} of the deck", spec->name));
      continue;
    }
    const auto at = spec->find_field(set.field);
    if (!at) {
      std::vector<std::string_view> names;
      std::string list;
      for (const FieldSpec& field : spec->fields) {
        names.push_back(field.name);
        list += (list.empty() ? "" : ", ") + std::string(field.name);
      }
      std::string hint = did_you_mean(text::suggest(set.field, names));
      if (hint.empty()) {
        hint = list.empty()        ? "this card has no fields"
               : names.size() == 1 ? "its only field is " + list
                                   : "its fields are " + list;
      }
      diagnostics.error(where, std::string(spec->name),
                        fmt::format("unknown field {}", shown(set.field)), hint);
      continue;
    }
    if (!is_utf8(set.value)) {
      diagnostics.error(where, std::string(spec->name), "the value is not in UTF-8",
                        "convert it, for example with iconv");
      continue;
    }
    if (first_binary_byte(set.value) ||
        set.value.find_first_of("\r\n") != std::string::npos) {
      diagnostics.error(where, std::string(spec->name),
                        "the value has a control character, such as a line end",
                        "give one line of text");
      continue;
    }
    std::vector<Field> fields = set_fields(set.value, spec->fields[*at]);
    if (fields.size() > 1 && !spec->fields[*at].repeats) {
      diagnostics.error(where, std::string(spec->name),
                        fmt::format("{} takes one value, found {}",
                                    spec->fields[*at].name, fields.size()));
      continue;
    }
    for (Field& field : fields) {
      field.where = where;
    }
    out.push_back({std::string(spec->name), text::capitals(set.field), *number,
                   std::move(fields)});
  }
  return out;
}

Line take_card(const CardSpec& spec, const std::vector<Line>& lines,
               std::size_t& next) {
  Line line = lines[next++];
  while (next < lines.size() && lines[next].is_data() &&
         line.fields.size() - 1 < spec.continue_below) {
    const Line& more_fields = lines[next++];
    line.fields.insert(line.fields.end(), more_fields.fields.begin(),
                       more_fields.fields.end());
    line.end = more_fields.end;
  }
  return line;
}

Value read_value(const Field& field, const FieldSpec& spec, std::string_view card,
                 Diagnostics& diagnostics) {
  if (field.fault != QuoteFault::none) {
    report_quotes(field, card, diagnostics);
    return {.where = field.where, .given = true};
  }
  if (spec.kind == Kind::word) {
    return read_word(field, spec, card, diagnostics);
  }
  const bool names = spec.kind == Kind::block || spec.kind == Kind::side;
  if (names && (looks_like_selector(field.text) || ends_in_selector_name(field.text))) {
    return read_choice(field, spec, card, diagnostics);
  }
  Value value{.where = field.where, .given = true};
  const auto fault = [&](const std::string& message, std::string hint) {
    diagnostics.error(field.where, std::string(card), message, std::move(hint));
    return value;
  };
  const bool whole = spec.kind == Kind::integer || names;
  const Number number = read_number(field.text);
  if (number.fault == NumberFault::not_a_number) {
    return fault(fmt::format("expected a {}number for {}, found {}",
                             whole ? "whole " : "", spec.name, shown(field.text)),
                 not_a_number_hint(field.text));
  }
  if (number.fault == NumberFault::not_finite) {
    return fault(fmt::format("{} must be a finite number, found {}", spec.name,
                             shown(field.text)),
                 "numbers may be from about 1e-308 to 1e308");
  }
  if (number.fault == NumberFault::too_small) {
    return fault(fmt::format("{} is too small a number for a double, found {}",
                             spec.name, shown(field.text)),
                 "numbers may be from about 1e-308 to 1e308; write 0 for zero");
  }
  value.number = number.value;
  const double x = value.number.value();
  if (whole) {
    if (x != std::floor(x)) {
      return fault(fmt::format("{} must be a whole number, found {}", spec.name,
                               shown(field.text)),
                   fmt::format("{}: {}", spec.name, spec.help));
    }
    // 2^53: all integers below it are doubles.
    constexpr double largest = 9007199254740992.0;
    if (std::abs(x) >= largest) {
      return fault(
          fmt::format("{} is too large, found {}", spec.name, shown(field.text)),
          "the largest whole number is 9007199254740991");
    }
    value.integer = static_cast<long>(x);
  }
  if (!spec.range.contains(x)) {
    return fault(fmt::format("{} must be {}, found {}", spec.name, spec.range.text(),
                             shown(field.text)),
                 fmt::format("{}: {}", spec.name, spec.help));
  }
  value.ok = true;
  return value;
}

Values read_card(const CardSpec& spec, const Line& line, long nth,
                 const std::vector<OverrideFields>& overrides,
                 Diagnostics& diagnostics) {
  const std::string card(spec.name);
  const SourceLocation keyword = line.fields.front().where;
  const std::vector<Field> fields = overridden(spec, line, nth, overrides);
  Values out;
  std::string missing;
  SourceLocation missing_at = line.end;
  // A field with faulty quotes contains those after it.
  const bool complete = fields.empty() || fields.back().fault == QuoteFault::none;
  const auto report_missing = [&] {
    if (!missing.empty() && complete) {
      diagnostics.error(missing_at, card, "missing " + missing,
                        "syntax: " + spec.syntax());
      missing.clear();
    }
  };
  for (std::size_t i = 0; i < spec.fields.size(); ++i) {
    const FieldSpec& field = spec.fields[i];
    if (field.repeats) {
      for (std::size_t k = i; k < fields.size(); ++k) {
        if (!fields[k].blank) {
          out.repeated.push_back(read_value(fields[k], field, card, diagnostics));
          out.ok = out.ok && out.repeated.back().ok;
        }
      }
      break;
    }
    if (i < fields.size() && !fields[i].blank) {
      report_missing();
      out.fields.push_back(read_value(fields[i], field, card, diagnostics));
    } else if (field.fallback) {
      out.fields.push_back(default_value(field, keyword));
    } else {
      // Adjacent missing fields are reported in one message.
      if (missing.empty()) {
        missing_at = i < fields.size() ? fields[i].where : line.end;
      }
      missing += (missing.empty() ? "" : ", ") + std::string(field.name);
      out.fields.push_back({.where = keyword});
    }
    out.ok = out.ok && out.fields.back().ok;
  }
  report_missing();
  const bool repeats = !spec.fields.empty() && spec.fields.back().repeats;
  for (std::size_t i = spec.fields.size(); i < fields.size() && !repeats; ++i) {
    if (!fields[i].blank) {
      out.ok = false;
      if (fields[i].fault != QuoteFault::none) {
        report_quotes(fields[i], card, diagnostics);
        break;
      }
      diagnostics.error(fields[i].where, card,
                        fmt::format("one value too many: {}", shown(fields[i].text)),
                        spec.fields.empty() ? "this card has no values"
                                            : "syntax: " + spec.syntax());
      break;
    }
  }
  return out;
}

}  // namespace blocks::deck
