#include "convert/joint_maps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "exchange/forms.hpp"
#include "exchange/trace_reader.hpp"
#include "geometry/joint_sources.hpp"
#include "geometry/polygon.hpp"
#include "model/settings.hpp"
#include "run/cutting/cut_joints.hpp"
#include "run/cutting/joint_files.hpp"
#include "run/run.hpp"
#include "run/support/deck_file.hpp"

namespace blocks::convert {
namespace {

namespace fs = std::filesystem;
using geometry::Decimal;
using geometry::DecimalPoint;
using joints::TraceMap;

void warn(const std::string& message, const std::string& hint) {
  fmt::print(stderr, "blocks: warning: {}\n  hint: {}\n", message, hint);
}

int refuse(const std::string& message, const std::string& hint) {
  fmt::print(stderr, "blocks: error: {}\n  hint: {}\n", message, hint);
  return run::deck_error;
}

std::string shown_name(const std::string& file) {
  return file == "-" ? "<standard input>" : file;
}

/// Whether the text is a deck: some line begins with OUTLINE or START.
bool is_deck(const std::string& file, const std::string& text) {
  if (fs::path(file).extension() == ".deck")
    return true;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::string_view line(text.data() + begin,
                                std::min(text.find('\n', begin), text.size()) - begin);
    for (const std::string_view card : {"OUTLINE,", "START,"})
      if (line.size() >= card.size() &&
          std::equal(card.begin(), card.end(), line.begin(),
                     [](char wanted, char given) {
                       return wanted == std::toupper(static_cast<unsigned char>(given));
                     }))
        return true;
    begin += line.size() + 1;
  }
  return false;
}

geometry::Polygon nearest(const std::vector<DecimalPoint>& corners) {
  geometry::Polygon found;
  for (const DecimalPoint& corner : corners)
    found.emplace_back(corner.x.value(), corner.y.value());
  return found;
}

/// Makes the corners clockwise. Returns what is wrong with them, or an empty text.
std::string orient(std::vector<DecimalPoint>& corners) {
  const geometry::OutlineCheck check = geometry::check_outline(nearest(corners));
  if (check.fault != geometry::OutlineFault::none)
    return geometry::describe(check);
  if (check.anticlockwise)
    std::reverse(corners.begin() + 1, corners.end());
  return {};
}

/// Reads a window, or reports why there is none.
std::optional<std::vector<DecimalPoint>> window_of(const std::string& file) {
  const std::string text = run::read_deck(file);
  const exchange::Form form =
      exchange::recognise(text).value_or(exchange::Form::geojson);
  const exchange::OutlineFile outlines = exchange::read_outlines(form, text);
  fmt::print(stderr, "{}",
             exchange::format(outlines.messages, shown_name(file),
                              exchange::name_of(form), text));
  if (exchange::has_errors(outlines.messages))
    return {};
  if (outlines.outlines.size() != 1) {
    refuse(fmt::format("{}: {} polygons, and a window is one", shown_name(file),
                       outlines.outlines.size()),
           "give a file with one polygon, or the deck that blocks import --map writes");
    return {};
  }
  std::vector<DecimalPoint> corners;
  for (const exchange::WrittenCorner& corner : outlines.outlines[0].written)
    corners.push_back({*Decimal::parse(corner[0]), *Decimal::parse(corner[1])});
  if (const std::string fault = orient(corners); !fault.empty()) {
    refuse(shown_name(file) + ": " + fault,
           "give the corners in order around the window, each one once");
    return {};
  }
  return corners;
}

class Reader {
 public:
  explicit Reader(const MapInput& input) : input_(input) {}

  ReadMaps read() {
    for (const std::string& file : input_.files) {
      const std::string text = run::read_deck(file);
      const int code =
          is_deck(file, text) ? read_deck(file, text) : read_traces(file, text);
      if (code != run::done)
        return {code, {}};
    }
    return {run::done, std::move(maps_)};
  }

 private:
  int read_traces(const std::string& file, const std::string& text) {
    const exchange::TraceFile found = exchange::read_traces(text);
    fmt::print(stderr, "{}",
               exchange::format(found.messages, shown_name(file), found.form, text));
    if (exchange::has_errors(found.messages))
      return run::deck_error;
    TraceMap map;
    map.name = shown_name(file);
    for (const exchange::Trace& trace : found.traces) {
      ++map.traces;
      for (std::size_t i = 1; i < trace.points.size(); ++i)
        map.segments.push_back({trace.points[i - 1], trace.points[i], map.traces});
    }
    if (input_.outlines.empty()) {
      map.window = joints::box_window(map.segments);
      warn(map.name +
               ": the window is the box of the traces, so traces that end at its "
               "sides look cut off",
           "give the mapped window with --outline FILE");
    } else {
      const std::size_t last = input_.outlines.size() - 1;
      auto window = window_of(input_.outlines[std::min(trace_files_++, last)]);
      if (!window)
        return run::deck_error;
      map.window = std::move(*window);
    }
    if (input_.snap > 0.0)
      joints::close_gaps(map, *Decimal::parse(fmt::format("{}", input_.snap)));
    maps_.push_back(std::move(map));
    return run::done;
  }

  int read_deck(const std::string& file, const std::string& text) {
    deck::Diagnostics diagnostics(shown_name(file), text);
    deck::Deck deck =
        deck::parse(shown_name(file), text, diagnostics, input_.overrides);
    run::read_outline_files(deck, run::deck_folder(file), diagnostics);
    const std::size_t before = maps_.size();
    if (!diagnostics.has_errors())
      add_groups(file, deck, diagnostics);
    fmt::print(stderr, "{}", diagnostics.format_all());
    if (diagnostics.has_errors())
      return run::deck_error;
    if (maps_.size() == before)
      return refuse(shown_name(file) + " has no joints",
                    "joints are made by a group of cards from OUTLINE to CUT");
    return run::done;
  }

  void add_groups(const std::string& file, const deck::Deck& deck,
                  deck::Diagnostics& diagnostics) {
    std::uint64_t seed = Settings().seed;
    const auto groups = std::count_if(
        deck.commands.begin(), deck.commands.end(), [](const deck::Command& one) {
          return std::holds_alternative<deck::Cut>(one.card);
        });
    int group = 0;
    for (const deck::Command& command : deck.commands) {
      if (const auto* card = std::get_if<deck::Seed>(&command.card))
        seed = static_cast<std::uint64_t>(card->seed.value);
      const auto* card = std::get_if<deck::Cut>(&command.card);
      if (card == nullptr)
        continue;
      ++group;
      TraceMap map;
      map.name =
          shown_name(file) + (groups > 1 ? fmt::format(", group {}", group) : "");
      for (std::size_t i = 0; i < card->outline.x.size(); ++i)
        map.window.push_back({card->outline.x[i].value, card->outline.y[i].value});
      if (const std::string fault = orient(map.window); !fault.empty()) {
        diagnostics.error(card->outline.where, "OUTLINE", fault,
                          "give the corners in order around the domain, each one once");
        continue;
      }
      const std::optional<run::CutJoints> made =
          run::cut_joints(*card,
                          {.seed = input_.seed.value_or(seed),
                           .folder = run::deck_folder(file),
                           .unit = {},
                           .outline = map.window,
                           .max_new_blocks = geometry::max_joint_pieces},
                          diagnostics);
      if (!made)
        continue;
      number_traces(*card, made->segments, map);
      maps_.push_back(std::move(map));
    }
  }

  /// Gives the segments of one polyline one number. Segments that follow each other and
  /// have a common end are a polyline, but not the sides of Voronoi cells.
  static void number_traces(const deck::Cut& card,
                            const std::vector<geometry::JointSegment>& segments,
                            TraceMap& map) {
    std::set<long> cells;
    for (const auto& source : card.joints)
      if (const auto* voronoi = std::get_if<deck::Voronoi>(&source))
        cells.insert(voronoi->id.value);
    const geometry::JointSegment* last = nullptr;
    for (const geometry::JointSegment& one : segments) {
      const bool goes_on = last != nullptr && last->id == one.id &&
                           !cells.contains(one.id) &&
                           last->to.packed() == one.from.packed() &&
                           last->to.nearest() == one.from.nearest();
      map.traces += goes_on ? 0 : 1;
      map.segments.push_back({one.from, one.to, map.traces});
      last = &one;
    }
  }

  const MapInput& input_;
  std::vector<TraceMap> maps_;
  std::size_t trace_files_ = 0;
};

}  // namespace

ReadMaps read_maps(const MapInput& input) { return Reader(input).read(); }

}  // namespace blocks::convert
