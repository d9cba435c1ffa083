#include "run/cutting/joint_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <variant>

#include "exchange/forms.hpp"
#include "files/file_error.hpp"
#include "geometry/polygon.hpp"
#include "run/support/deck_file.hpp"

namespace blocks::run {
namespace {

constexpr std::uintmax_t max_bytes = 2'000'000'000;  // more would not fit into memory

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
       fs::file_size(path, ignored) > max_bytes)) {
    diagnostics.error(
        named.file.where, named.card,
        fmt::format("cannot read {}: it is no file, or larger than 2 GB", path),
        "write the traces or points to a file");
    return {};
  }
  try {
    return read_deck(path);
  } catch (const files::FileError& fault) {
    diagnostics.error(named.file.where, named.card, fault.what(),
                      "a name is relative to the folder of the deck");
    return {};
  }
}

/// Whether another card that names the same file has had this warning.
bool has_told(const std::string& message, const deck::Diagnostics& diagnostics) {
  return std::any_of(
      diagnostics.all().begin(), diagnostics.all().end(),
      [&](const deck::Diagnostic& one) { return one.message == message; });
}

/// Reports the first messages of each kind.
void tell(const std::vector<exchange::Message>& messages, const std::string& text,
          const FileOnCard& named, deck::Diagnostics& diagnostics) {
  constexpr std::size_t max_shown = 5;
  for (const bool errors : {true, false}) {
    const auto say = [&](const std::string& message, const std::string& hint) {
      if (errors)
        diagnostics.error(named.file.where, named.card, message, hint);
      else if (!has_told(message, diagnostics))
        diagnostics.warning(named.file.where, named.card, message, hint);
    };
    std::size_t count = 0;
    for (const exchange::Message& one : messages)
      if (one.error == errors && ++count <= max_shown)
        say(fmt::format("{}{}: {}", named.file.value, place(text, one.at), one.text),
            one.hint);
    if (count > max_shown)
      say(fmt::format("{}: {} more like these", named.file.value, count - max_shown),
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

/// Returns the traces of the card's layer, with the id of the card, or nothing after an
/// error.
std::optional<exchange::TraceFile> layer_of(const deck::Traces& card,
                                            const exchange::TraceFile& file,
                                            deck::Diagnostics& diagnostics) {
  const auto layer =
      std::find(file.layers.begin(), file.layers.end(), card.layer.value);
  if (layer == file.layers.end()) {
    diagnostics.error(card.layer.where, "TRACES",
                      fmt::format("{}: no trace has the layer '{}'", card.file.value,
                                  card.layer.value),
                      file.layers.empty()
                          ? std::string("the traces of this file have no layers")
                          : fmt::format("traces are on these layers: {}",
                                        fmt::join(file.layers, ", ")));
    return {};
  }
  exchange::TraceFile found;
  found.form = file.form;
  found.unit = file.unit;
  for (const exchange::Trace& trace : file.traces)
    if (trace.layer == layer - file.layers.begin()) {
      found.traces.push_back(trace);
      found.traces.back().joint.reset();
    }
  found.found = fmt::format("{}, layer {}: {} of {} polylines", file.form,
                            card.layer.value, found.traces.size(), file.traces.size());
  return found;
}

exchange::OutlineFile read_polygons(std::string_view text) {
  if (const auto form = exchange::recognise(text))
    return exchange::read_outlines(*form, text);
  exchange::OutlineFile file;
  file.messages.push_back({true, 0, "the file is not GeoJSON, WKT or DXF",
                           "give a polygon in one of these forms, or nc and the "
                           "coordinates in the deck"});
  return file;
}

/// Returns the only polygon of the layer, or of the file if no layer is given.
std::optional<exchange::Outline> only_polygon(const exchange::OutlineFile& file,
                                              const deck::Outline& card,
                                              deck::Diagnostics& diagnostics) {
  std::vector<const exchange::Outline*> found;
  std::set<std::string> layers;
  for (const exchange::Outline& one : file.outlines) {
    if (!card.layer.given || one.layer == card.layer.value)
      found.push_back(&one);
    if (!one.layer.empty())
      layers.insert(one.layer);
  }
  if (found.size() == 1)
    return *found.front();
  const std::string of_layers =
      layers.empty()
          ? "its polygons have no layers"
          : fmt::format("polygons are on these layers: {}", fmt::join(layers, ", "));
  if (found.empty())
    diagnostics.error(card.layer.where, "OUTLINE",
                      fmt::format("{}: no polygon has the layer '{}'", card.file.value,
                                  card.layer.value),
                      of_layers);
  else
    diagnostics.error(card.file.where, "OUTLINE",
                      fmt::format("{}: {} polygons, and an outline is one",
                                  card.file.value, found.size()),
                      card.layer.given ? "keep one polygon on this layer"
                                       : "give the layer; " + of_layers);
  return {};
}

bool read_outline(deck::Outline& card, const std::string& folder,
                  deck::Diagnostics& diagnostics) {
  const auto file =
      read_with(read_polygons, {"OUTLINE", card.file, folder}, diagnostics);
  if (!file)
    return false;
  auto outline = only_polygon(*file, card, diagnostics);
  if (!outline)
    return false;
  if (geometry::check_outline(outline->corners).anticlockwise)
    exchange::reverse(*outline);
  card.file_unit = file->unit;
  for (const exchange::WrittenCorner& corner : outline->written)
    for (const int axis : {0, 1}) {
      std::string_view digits = corner[static_cast<std::size_t>(axis)];
      const auto value = geometry::Decimal::parse(digits);
      if (!value) {
        diagnostics.error(card.file.where, "OUTLINE",
                          fmt::format("{}: {} is outside the range of numbers",
                                      card.file.value, digits.substr(0, 40)),
                          "choose another unit of length");
        return false;
      }
      (axis == 0 ? card.x : card.y).push_back({*value, card.file.where, true});
    }
  return true;
}

}  // namespace

void read_outline_files(deck::Deck& deck, const std::string& folder,
                        deck::Diagnostics& diagnostics) {
  std::erase_if(deck.commands, [&](deck::Command& command) {
    auto* cut = std::get_if<deck::Cut>(&command.card);
    if (cut == nullptr || !cut->outline.file.given ||
        read_outline(cut->outline, folder, diagnostics))
      return false;
    deck.unread.push_back({command.where, command.name, std::nullopt,
                           deck::UnreadCard::any_number_of_blocks});
    return true;
  });
  std::stable_sort(deck.unread.begin(), deck.unread.end(),
                   [](const deck::UnreadCard& a, const deck::UnreadCard& b) {
                     return a.where.line < b.where.line;
                   });
}

std::optional<exchange::TraceFile> TraceFiles::of(const deck::Traces& card,
                                                  deck::Diagnostics& diagnostics) {
  const FileOnCard named{"TRACES", card.file, folder_};
  if (!card.layer.given)
    return read_with(exchange::read_traces, named, diagnostics);
  auto [file, is_new] = with_layers_.try_emplace(card.file.value);
  if (is_new)
    file->second = read_with(exchange::read_traces, named, diagnostics);
  return file->second ? layer_of(card, *file->second, diagnostics) : std::nullopt;
}

std::optional<exchange::PointFile> points_of(const FileOnCard& named,
                                             deck::Diagnostics& diagnostics) {
  return read_with(exchange::read_points, named, diagnostics);
}

}  // namespace blocks::run
