#include "deck/selector.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "deck/free_field.hpp"
#include "text/capitals.hpp"
#include "text/suggest.hpp"

namespace blocks::deck {
namespace {

using By = Selector::By;

struct Form {
  std::string_view name, values;  ///< values as in a message: "x, y"
  By by;
  std::size_t count;
  bool whole;  ///< the value is a whole number from 1
};

constexpr std::array<Form, 7> forms = {
    {{"AT", "x, y", By::at, 2, false},
     {"IN", "x1, y1, x2, y2", By::in, 4, false},
     {"MATERIAL", "name or number", By::material, 1, false},
     {"NEAREST", "x, y", By::nearest, 2, false},
     {"JOINT", "id", By::joint, 1, true},
     {"EDGE", "k", By::edge, 1, true},
     {"ON", "x1, y1, x2, y2", By::on, 4, false}}};

std::string lower(std::string_view capital_letters) {
  std::string out(capital_letters);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
  return out;
}

const Form* find_form(std::string_view name) {
  const std::string word = text::capitals(name);
  const auto* const found = std::find_if(
      forms.begin(), forms.end(), [&](const Form& form) { return form.name == word; });
  return found == forms.end() ? nullptr : found;
}

std::string syntax(const Form& form) {
  return fmt::format("{}({})", lower(form.name), form.values);
}

/// A part of the text between two commas, without blanks around it.
struct Part {
  std::size_t at = 0;
  std::string_view text;
};

constexpr std::string_view blanks = " \t";

Part trimmed(std::string_view text, std::size_t begin, std::size_t end) {
  while (begin < end && blanks.find(text[begin]) != std::string_view::npos)
    ++begin;
  while (begin < end && blanks.find(text[end - 1]) != std::string_view::npos)
    --end;
  return {begin, text.substr(begin, end - begin)};
}

/// Splits the values between brackets at commas or, as in a card, at blanks.
std::vector<Part> split(std::string_view text, std::size_t begin, std::size_t end) {
  std::vector<Part> parts;
  while (begin < end) {
    const std::size_t comma = std::min(text.find(',', begin), end);
    std::size_t at = begin;
    bool is_empty = true;
    while (at < comma) {
      const std::size_t word = std::min(text.find_first_not_of(blanks, at), comma);
      const std::size_t stop = std::min(text.find_first_of(blanks, word), comma);
      if (word < comma)
        parts.push_back({word, text.substr(word, stop - word)}), is_empty = false;
      at = stop;
    }
    if (is_empty)
      parts.push_back({begin, {}});
    begin = comma + 1;
  }
  return parts;
}

geometry::Decimal number_of(const Part& part, const Form& form) {
  const Number number = read_number(part.text);
  const double x = number.value.value();
  constexpr double max = 1e9;
  const bool fits = !form.whole || (x >= 1.0 && x <= max && x == std::floor(x));
  if (number.fault == NumberFault::none && fits)
    return number.value;
  throw SelectorFault(fmt::format("expected a {} in {}, found '{}'",
                                  form.whole ? "whole number from 1" : "number",
                                  lower(form.name), part.text),
                      "write " + syntax(form), part.at,
                      std::max<std::size_t>(part.text.size(), 1));
}

std::pair<double, double> point(const Selector& selector, std::size_t first) {
  return {selector.numbers[first].value(), selector.numbers[first + 1].value()};
}

}  // namespace

bool ends_in_selector_name(std::string_view text) {
  const std::size_t colon = text.rfind(':');
  return find_form(colon == std::string_view::npos ? text : text.substr(colon + 1)) !=
         nullptr;
}

bool looks_like_selector(std::string_view text) {
  const std::size_t bracket = text.find('(');
  const auto is_letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  };
  return bracket != std::string_view::npos && bracket > 0 &&
         std::all_of(text.begin(), text.begin() + static_cast<long>(bracket),
                     is_letter);
}

Selector read_selector(std::string_view text) {
  const std::size_t open = text.find('('), close = text.find(')');
  const std::string_view name = text.substr(0, open);
  const Form* form = find_form(name);
  if (form == nullptr) {
    std::vector<std::string_view> names;
    for (const Form& one : forms)
      names.push_back(one.name);
    const std::string near = lower(text::suggest(std::string(name), names));
    throw SelectorFault(fmt::format("there is no selector '{}'", name),
                        near.empty() ? fmt::format("blocks: {}; sides: {}",
                                                   block_selectors, side_selectors)
                                     : fmt::format("did you mean {}?", near),
                        0, name.size());
  }
  if (open == std::string_view::npos)
    throw SelectorFault(
        fmt::format("the values of '{}' are missing", name),
        fmt::format("write {}, the bracket directly behind the name", syntax(*form)), 0,
        name.size());
  if (close == std::string_view::npos)
    throw SelectorFault("the bracket is not closed",
                        fmt::format("write {} on one line", syntax(*form)), open, 1);
  if (close + 1 != text.size())
    throw SelectorFault("there is text after the closing bracket",
                        "a comma or a blank ends the field", close + 1,
                        text.size() - close - 1);
  Selector out{
      .by = form->by, .numbers = {}, .material = {}, .text = std::string(text)};
  const Part whole = trimmed(text, open + 1, close);
  if (form->by == By::material && !whole.text.empty()) {
    const char first = whole.text.front();
    const bool quoted = whole.text.size() > 2 && whole.text.back() == first &&
                        (first == '\'' || first == '"');
    out.material = quoted ? whole.text.substr(1, whole.text.size() - 2) : whole.text;
    return out;
  }
  const std::vector<Part> parts = split(text, open + 1, close);
  if (parts.size() != form->count)
    throw SelectorFault(fmt::format("{} takes {} value{}, found {}", lower(form->name),
                                    form->count, form->count == 1 ? "" : "s",
                                    parts.size()),
                        "write " + syntax(*form), open, close - open + 1);
  for (const Part& part : parts)
    out.numbers.push_back(number_of(part, *form));
  if (form->by == By::on && point(out, 0) == point(out, 2))
    throw SelectorFault("both points of the line are the same",
                        "write two points on the line, such as on(0, 0, 1, 0)", open,
                        close - open + 1);
  return out;
}

}  // namespace blocks::deck
