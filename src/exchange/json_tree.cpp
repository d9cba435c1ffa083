#include "exchange/json_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

namespace blocks::exchange {
namespace {

/// Iterates over the text and counts the characters that the parser has consumed,
/// because nlohmann's events have no position.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, std::size_t* taken) : at_(at), taken_(taken) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    ++at_;
    ++*taken_;
    return *this;
  }
  CountingIterator operator++(int) {
    const CountingIterator before = *this;
    ++*this;
    return before;
  }
  friend bool operator==(const CountingIterator& a, const CountingIterator& b) {
    return a.at_ == b.at_;
  }
  friend bool operator!=(const CountingIterator& a, const CountingIterator& b) {
    return a.at_ != b.at_;
  }

 private:
  const char* at_;
  std::size_t* taken_;
};

constexpr std::size_t deepest = 32;  // levels of nesting; GeoJSON needs about ten

/// Builds the tree from nlohmann's events.
class TreeBuilder {
 public:
  TreeBuilder(std::string_view text, const std::size_t& taken)
      : text_(text), taken_(taken) {}

  bool null() { return put(leaf(Json::Kind::null, 4)); }
  bool boolean(bool value) {
    Json node = leaf(Json::Kind::boolean, value ? 4 : 5);
    node.text = value ? "true" : "false";
    return put(std::move(node));
  }
  bool number_integer(std::int64_t) { return number(); }
  bool number_unsigned(std::uint64_t) { return number(); }
  bool number_float(double, const std::string&) { return number(); }
  bool string(std::string& value) {
    Json node = leaf(Json::Kind::string,
                     1);  // positioned at the closing quote, which is close enough
    node.text = std::move(value);
    return put(std::move(node));
  }
  bool binary(std::vector<std::uint8_t>&) { return false; }
  bool key(std::string& value) {
    open_.back()->keys.push_back(std::move(value));
    return true;
  }
  bool start_object(std::size_t) { return open(Json::Kind::object); }
  bool start_array(std::size_t) { return open(Json::Kind::array); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  template <class Exception>
  bool parse_error(std::size_t position, const std::string&, const Exception& error) {
    std::string message = error.what();  // "[json...] ... column 7: what is wrong"
    if (const auto column = message.find("column "); column != message.npos)
      if (const auto colon = message.find(": ", column); colon != message.npos)
        message.erase(0, colon + 2);
    if (message.starts_with('['))  // an out-of-range number has no column
      message.erase(0, message.find("] ") + 2);
    throw JsonFault(position > 0 ? position - 1 : 0, message.substr(0, 200));
  }

  Json root;

 private:
  std::string_view text_;
  const std::size_t& taken_;
  std::vector<Json*> open_;

  Json leaf(Json::Kind kind, std::size_t length) const {
    Json node;
    node.kind = kind;
    node.at = taken_ >= length ? taken_ - length : 0;
    return node;
  }

  // The parser reads one character beyond a number, unless the text ends there.
  bool number() {
    constexpr std::string_view of_numbers = "+-.eE0123456789";
    std::size_t end = taken_;
    while (end > 0 && of_numbers.find(text_[end - 1]) == of_numbers.npos)
      --end;
    const std::size_t before = text_.find_last_not_of(of_numbers, end - 1);
    Json node;
    node.kind = Json::Kind::number;
    node.at = before == text_.npos ? 0 : before + 1;
    node.number = text_.substr(node.at, end - node.at);
    return put(std::move(node));
  }

  bool put(Json node) {
    if (open_.empty())
      root = std::move(node);
    else
      open_.back()->items.push_back(std::move(node));
    return true;
  }

  bool open(Json::Kind kind) {
    Json node = leaf(kind, 1);
    if (open_.size() == deepest)
      throw JsonFault(node.at, fmt::format("nested deeper than {}", deepest));
    put(std::move(node));
    open_.push_back(open_.empty() ? &root : &open_.back()->items.back());
    return true;
  }

  bool close() {
    open_.back()->items.shrink_to_fit();
    open_.pop_back();
    return true;
  }
};

}  // namespace

const Json* Json::find(std::string_view key) const {
  const Json* found = nullptr;
  for (std::size_t i = 0; i < keys.size(); ++i)
    if (keys[i] == key) {
      if (found)
        throw JsonFault(items[i].at, fmt::format("\"{}\" is given twice here", key));
      found = &items[i];
    }
  return found;
}

std::string name_of(Json::Kind kind) {
  switch (kind) {
  case Json::Kind::null:
    return "null";
  case Json::Kind::boolean:
    return "true or false";
  case Json::Kind::number:
    return "a number";
  case Json::Kind::string:
    return "a text";
  case Json::Kind::array:
    return "an array";
  case Json::Kind::object:
    return "an object";
  }
  return {};
}

Json parse_json(std::string_view text) {
  std::size_t taken = 0;
  TreeBuilder builder(text, taken);
  const char* begin = text.data();
  nlohmann::json::sax_parse(CountingIterator(begin, &taken),
                            CountingIterator(begin + text.size(), &taken), &builder);
  return std::move(builder.root);
}

}  // namespace blocks::exchange
