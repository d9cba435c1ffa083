#include "deck/diagnostics.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "deck/free_field.hpp"

namespace blocks::deck {
namespace {

constexpr std::size_t max_printed = 100;
constexpr std::size_t widest_line = 120;
constexpr std::size_t tab_stop = 8;

/// A source line as displayed, with one cell per column of the terminal.
struct Picture {
  std::string line;
  std::size_t caret = 0;   ///< cells before the caret
  std::size_t length = 1;  ///< cells underlined
};

Picture picture(const std::string& line, SourceLocation where) {
  std::vector<std::string> cells;
  std::size_t first = 0;
  std::size_t last = 0;
  const auto from = static_cast<std::size_t>(std::max(where.column, 1)) - 1;
  const auto to = from + static_cast<std::size_t>(std::max(where.length, 1));
  // Only the part of a possibly long line up to a little after the location is needed.
  const std::vector<std::string> chars =
      characters(std::string_view(line).substr(0, 4 * (to + widest_line)));
  for (std::size_t i = 0; i < chars.size(); ++i) {
    if (i == from) {
      first = cells.size();
    }
    if (chars[i] == "\t") {
      do {
        cells.emplace_back(" ");
      } while (cells.size() % tab_stop != 0);
    } else {
      const auto byte = static_cast<unsigned char>(chars[i][0]);
      cells.push_back(byte < 0x20 || byte == 0x7f ? " " : chars[i]);
    }
    if (i + 1 == to) {
      last = cells.size();
    }
  }
  if (from >= chars.size()) {
    first = cells.size() + (from - chars.size());
  }
  last = std::max(last, first + 1);

  // Show a window around the caret; dots mark where the line is cut.
  std::size_t begin = 0;
  std::size_t end = cells.size();
  if (end > widest_line) {
    constexpr std::size_t before = 60;
    constexpr std::size_t dots = 3;
    begin = first > before ? first - before : 0;
    end = std::min(end, begin + widest_line - 2 * dots);
    last = std::min(last, std::max(end, first + 1));
  }
  Picture out;
  if (begin > 0) {
    out.line = "...";
    out.caret = 3;
  }
  for (std::size_t i = begin; i < end; ++i) {
    out.line += cells[i];
  }
  if (end < cells.size()) {
    out.line += "...";
  }
  out.caret += first - begin;
  out.length = last - first;
  out.line.erase(out.line.find_last_not_of(' ') + 1);
  return out;
}

std::string count(std::size_t number, std::string_view noun) {
  return fmt::format("{} {}{}", number, noun, number == 1 ? "" : "s");
}

}  // namespace

Diagnostics::Diagnostics(std::string file, std::string text)
    : file_(std::move(file)), lines_(source_lines(text)) {}

void Diagnostics::add(Diagnostic diagnostic) {
  // A fault in an option occurs at every card that the option changes; it is reported
  // once.
  if (diagnostic.where.line == 0) {
    for (const Diagnostic& other : all_) {
      if (other.where.line == 0 && other.where.column == diagnostic.where.column &&
          other.message == diagnostic.message) {
        return;
      }
    }
  }
  all_.push_back(std::move(diagnostic));
}

void Diagnostics::error(SourceLocation where, std::string card, std::string message,
                        std::string hint) {
  add({Severity::error, where, std::move(card), std::move(message), std::move(hint)});
}

void Diagnostics::warning(SourceLocation where, std::string card, std::string message,
                          std::string hint) {
  add({Severity::warning, where, std::move(card), std::move(message), std::move(hint)});
}

SourceLocation Diagnostics::from_command_line(std::string option) {
  options_.push_back(std::move(option));
  return {0, static_cast<int>(options_.size()), 0};
}

bool Diagnostics::has_errors() const {
  return std::any_of(all_.begin(), all_.end(),
                     [](const Diagnostic& d) { return d.severity == Severity::error; });
}

std::string Diagnostics::format(const Diagnostic& diagnostic) const {
  const SourceLocation where = diagnostic.where;
  std::string out;
  if (where.line > 0) {
    out = fmt::format("{}:{}:{}", file_, where.line, where.column);
  } else if (where.column > 0 &&
             static_cast<std::size_t>(where.column) <= options_.size()) {
    out = options_[static_cast<std::size_t>(where.column) - 1];
  } else {
    out = file_;
  }
  out += diagnostic.severity == Severity::error ? ": error: " : ": warning: ";
  if (!diagnostic.card.empty()) {
    out += diagnostic.card + ": ";
  }
  out += diagnostic.message + "\n";
  if (where.line > 0 && static_cast<std::size_t>(where.line) <= lines_.size()) {
    const Picture shown =
        picture(lines_[static_cast<std::size_t>(where.line) - 1], where);
    out += fmt::format("  {}\n  {}^{}\n", shown.line, std::string(shown.caret, ' '),
                       std::string(shown.length - 1, '~'));
  }
  if (!diagnostic.hint.empty()) {
    out += "  hint: " + diagnostic.hint + "\n";
  }
  return out;
}

std::string Diagnostics::format_all() const {
  if (all_.empty()) {
    return {};
  }
  std::vector<const Diagnostic*> sorted;
  std::size_t errors = 0;
  for (const Diagnostic& diagnostic : all_) {
    sorted.push_back(&diagnostic);
    errors += diagnostic.severity == Severity::error ? 1 : 0;
  }
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto* a, const auto* b) {
    return std::pair(a->where.line, a->where.column) <
           std::pair(b->where.line, b->where.column);
  });
  std::string out;
  for (std::size_t i = 0; i < std::min(sorted.size(), max_printed); ++i) {
    out += format(*sorted[i]);
  }
  if (sorted.size() > max_printed) {
    out += fmt::format("... and {} more not shown\n", sorted.size() - max_printed);
  }
  const std::size_t warnings = all_.size() - errors;
  if (errors > 0) {
    out += count(errors, "error") + (warnings > 0 ? ", " : "");
  }
  if (warnings > 0) {
    out += count(warnings, "warning");
  }
  return out + "\n";
}

}  // namespace blocks::deck
