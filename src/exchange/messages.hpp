// Errors and warnings about a text that may be one line of many megabytes: the place is
// found in one pass, and the line is shown through a window.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace blocks::exchange {

/// The offset of what stands nowhere in particular.
inline constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

struct Message {
  bool error = true;         ///< false: a warning
  std::size_t at = nowhere;  ///< offset in the text
  std::string text;          ///< lower case, no full stop
  std::string hint;          ///< may be empty
  std::size_t length = 1;    ///< what the caret underlines; 0: no line shown
};

bool has_errors(const std::vector<Message>& messages);

/// "file:line:col: error: FORM: message", the line, a caret, the hint, for each message
/// in the order of the text; the first 40 if there are more. A hint is given once where
/// it is the same for several messages in a row. Columns count characters.
std::string format(std::vector<Message> messages, const std::string& file,
                   const std::string& form, std::string_view text);

}  // namespace blocks::exchange
