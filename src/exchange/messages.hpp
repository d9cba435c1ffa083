// Errors and warnings about a text, which may be a single line of many megabytes.
// Locations are found in one pass, and only the part of the line around the fault is
// shown.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace blocks::exchange {

/// Offset of a message that has no location.
inline constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

struct Message {
  bool error = true;         ///< false: a warning
  std::size_t at = nowhere;  ///< offset in the text
  std::string text;          ///< lower case, no full stop
  std::string hint;          ///< may be empty
  std::size_t length = 1;    ///< characters underlined; 0: no line shown
};

bool has_errors(const std::vector<Message>& messages);

/// Formats each message as "file:line:col: error: FORM: message", the line, a caret and
/// the hint, in the order of the text. Only the first 40 messages are shown. A hint
/// that several messages in a row share is shown once. Columns count characters.
std::string format(std::vector<Message> messages, const std::string& file,
                   const std::string& form, std::string_view text);

}  // namespace blocks::exchange
