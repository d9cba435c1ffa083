#include "quoted_list.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace blocks::apps {
namespace {

void split_list(const std::string& text, std::vector<std::string>& values) {
  values.emplace_back();
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string& value = values.back();
    const bool may_open = value.empty() || value.back() == '=';
    if (text[i] == ',') {
      values.emplace_back();
    } else if (may_open && (text[i] == '"' || text[i] == '\'')) {
      const std::size_t close = text.find(text[i], i + 1);
      if (close == text.npos)
        throw std::runtime_error(
            fmt::format("the quote is not closed in {}", text.substr(i)));
      value += text.substr(i + 1, close - i - 1);
      i = close;
    } else if (const std::size_t close = text.find(')', i);
               text[i] == '(' && close != text.npos) {
      value += text.substr(i, close + 1 - i);
      i = close;
    } else {
      value += text[i];
    }
  }
}

}  // namespace

std::vector<std::string> split_lists(const std::vector<std::string>& texts) {
  std::vector<std::string> values;
  for (const std::string& text : texts)
    split_list(text, values);
  return values;
}

}  // namespace blocks::apps
