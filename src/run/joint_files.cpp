#include "run/joint_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "output/file_tools.hpp"
#include "run/deck_file.hpp"

namespace blocks::run {
namespace {

constexpr std::uintmax_t most_bytes = 2'000'000'000;  // more would not fit into memory

/// Returns the line and column of an offset as ":12:5", or an empty text if there is
/// none. Columns count characters.
std::string place(const std::string& text, std::size_t at) {
  if (at == exchange::nowhere)
    return {};
  at = std::min(at, text.size());
  const std::size_t before = at == 0 ? text.npos : text.rfind('\n', at - 1);
  const std::size_t begin = before == text.npos ? 0 : before + 1;
  const auto count = [&](std::size_t from, auto&& counts) {
    return 1 + std::count_if(text.begin() + static_cast<long>(from),
                             text.begin() + static_cast<long>(at), counts);
  };
  return fmt::format(":{}:{}", count(0, [](char c) { return c == '\n'; }),
                     count(begin, [](char c) {
                       return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
                     }));
}

/// Returns the text of the file, or nothing after an error.
std::optional<std::string> read(const FileOnCard& named,
                                deck::Diagnostics& diagnostics) {
  namespace fs = std::filesystem;
  const std::string path = beside(named.folder, named.file.value);
  std::error_code ignored;
  if (fs::exists(path, ignored) && !fs::is_directory(path, ignored) &&
      (!fs::is_regular_file(path, ignored) ||
       fs::file_size(path, ignored) > most_bytes)) {
    diagnostics.error(
        named.file.where, named.card,
        fmt::format("cannot read {}: it is no file, or larger than 2 GB", path),
        "write the traces or points to a file");
    return {};
  }
  try {
    return read_deck(path);
  } catch (const output::FileError& fault) {
    diagnostics.error(named.file.where, named.card, fault.what(),
                      "a name is relative to the folder of the deck");
    return {};
  }
}

/// Reports the first messages of each kind.
void tell(const std::vector<exchange::Message>& messages, const std::string& text,
          const FileOnCard& named, deck::Diagnostics& diagnostics) {
  constexpr std::size_t most_shown = 5;
  for (const bool errors : {true, false}) {
    const auto say = [&](const std::string& message, const std::string& hint) {
      if (errors)
        diagnostics.error(named.file.where, named.card, message, hint);
      else
        diagnostics.warning(named.file.where, named.card, message, hint);
    };
    std::size_t count = 0;
    for (const exchange::Message& one : messages)
      if (one.error == errors && ++count <= most_shown)
        say(fmt::format("{}{}: {}", named.file.value, place(text, one.at), one.text),
            one.hint);
    if (count > most_shown)
      say(fmt::format("{}: {} more like these", named.file.value, count - most_shown),
          "correct the first ones and check again");
  }
}

/// Reads a file with one of the readers.
template <class File>
std::optional<File> read_with(File (*reader)(std::string_view), const FileOnCard& named,
                              deck::Diagnostics& diagnostics) {
  const std::optional<std::string> text = read(named, diagnostics);
  if (!text)
    return {};
  File file = reader(*text);
  tell(file.messages, *text, named, diagnostics);
  return exchange::has_errors(file.messages) ? std::nullopt
                                             : std::optional(std::move(file));
}

}  // namespace

std::optional<exchange::TraceFile> traces_of(const FileOnCard& named,
                                             deck::Diagnostics& diagnostics) {
  return read_with(exchange::read_traces, named, diagnostics);
}

std::optional<exchange::PointFile> points_of(const FileOnCard& named,
                                             deck::Diagnostics& diagnostics) {
  return read_with(exchange::read_points, named, diagnostics);
}

}  // namespace blocks::run
