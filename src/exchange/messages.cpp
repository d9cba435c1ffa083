#include "exchange/messages.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "text/counted.hpp"

namespace blocks::exchange {
namespace {

constexpr std::size_t max_shown = 40;
constexpr std::size_t before = 50,
                      after = 30;  // characters shown around the caret in a long line

bool begins_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), begins_character));
}

/// Returns the text without control characters, for a terminal.
std::string shown(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (static_cast<unsigned char>(c) < 32 || c == 127)
      c = ' ';
  return result;
}

/// Returns the part of the line around the message's offset, with a caret under it.
std::string picture(std::string_view text, std::size_t begin, const Message& message) {
  const std::size_t end = std::min(text.find('\n', message.at), text.size());
  std::size_t from = begin, to = end;
  if (message.at - from > before)
    from = message.at - before;
  while (from > begin && !begins_character(text[from]))
    --from;
  if (to - message.at > after)
    to = message.at + after;
  while (to < end && !begins_character(text[to]))
    ++to;
  const std::string left =
      (from > begin ? "..." : "") + shown(text.substr(from, message.at - from));
  std::string right = shown(text.substr(message.at, to - message.at));
  right += to < end ? "..." : "";
  right.erase(right.find_last_not_of(' ') + 1);
  const std::size_t length = std::clamp<std::size_t>(
      message.length, 1, std::max<std::size_t>(to - message.at, 1));
  return fmt::format("  {}{}\n  {:>{}}{}\n", left, right, "^", characters(left) + 1,
                     std::string(length - 1, '~'));
}

}  // namespace

bool has_errors(const std::vector<Message>& messages) {
  return std::any_of(messages.begin(), messages.end(),
                     [](const Message& message) { return message.error; });
}

std::string format(std::vector<Message> messages, const std::string& file,
                   const std::string& form, std::string_view text) {
  if (messages.empty())
    return {};
  std::stable_sort(messages.begin(), messages.end(),
                   [](const Message& a, const Message& b) { return a.at < b.at; });
  std::string out;
  std::size_t line = 1, begin = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  std::size_t column = 1, counted_to = begin;  // both within the line
  for (std::size_t i = 0; i < std::min(messages.size(), max_shown); ++i) {
    Message& message = messages[i];
    std::string where = file;
    std::string shown_line;
    if (message.at != nowhere) {
      message.at = std::clamp(message.at, begin, std::max(begin, text.size()));
      for (auto end = text.find('\n', begin); end < message.at;
           end = text.find('\n', begin)) {
        begin = counted_to = end + 1;
        column = 1;
        ++line;
      }
      column += characters(text.substr(counted_to, message.at - counted_to));
      counted_to = message.at;
      where += fmt::format(":{}:{}", line, column);
      if (message.length > 0)
        shown_line = picture(text, begin, message);
    }
    out += fmt::format("{}: {}: {}: {}\n{}", where, message.error ? "error" : "warning",
                       form, shown(message.text), shown_line);
    const bool last = i + 1 == std::min(messages.size(), max_shown);
    if (!message.hint.empty() && (last || messages[i + 1].hint != message.hint))
      out += "  hint: " + message.hint + "\n";
  }
  if (messages.size() > max_shown)
    out += fmt::format("... and {} more not shown\n", messages.size() - max_shown);
  const auto errors = static_cast<std::size_t>(std::count_if(
      messages.begin(), messages.end(), [](const Message& m) { return m.error; }));
  const auto if_any = [](std::size_t n, const char* noun) {
    return n == 0 ? "" : counted(n, noun);
  };
  const std::string warnings = if_any(messages.size() - errors, "warning");
  out += if_any(errors, "error") + (errors > 0 && !warnings.empty() ? ", " : "") +
         warnings + "\n";
  return out;
}

}  // namespace blocks::exchange
