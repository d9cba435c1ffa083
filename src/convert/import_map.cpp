#include "convert/import_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <map>
#include <set>

#include "exchange/deck_skeleton.hpp"
#include "exchange/dxf_reader.hpp"
#include "exchange/trace_reader.hpp"
#include "files/check_outputs.hpp"
#include "files/file_tools.hpp"
#include "geometry/polygon.hpp"
#include "run/run.hpp"
#include "run/support/deck_file.hpp"

namespace blocks::convert {
namespace {

namespace fs = std::filesystem;
using exchange::Trace;
using exchange::TraceFile;

/// What the lines of a layer are.
enum class Role { joints, outline, skipped };
struct Layer {
  std::string name;
  std::size_t lines = 0, closed = 0;
  Role role = Role::joints;
  int joint = 0;  ///< id; 0: not chosen yet
};

struct Refusal {
  std::string message, hint;
};

bool is_closed(const Trace& trace) {
  const auto& first = trace.points.front();
  const auto& last = trace.points.back();
  return trace.points.size() > 3 && first.x.value() == last.x.value() &&
         first.y.value() == last.y.value();
}

std::vector<Layer> layers_of(const TraceFile& file) {
  std::vector<Layer> layers;
  for (const std::string& name : file.layers)
    layers.push_back({name});
  for (const Trace& trace : file.traces)
    if (trace.layer >= 0) {
      Layer& layer = layers[static_cast<std::size_t>(trace.layer)];
      ++layer.lines;
      layer.closed += is_closed(trace) ? 1 : 0;
    }
  return layers;
}

std::string list_of(const std::vector<Layer>& layers) {
  std::vector<std::string> texts;
  for (const Layer& layer : layers)
    texts.push_back(fmt::format(
        "{} ({} line{}{})", layer.name, layer.lines, layer.lines == 1 ? "" : "s",
        layer.closed > 0 ? fmt::format(", {} closed", layer.closed) : ""));
  return texts.empty() ? "the map has no layers"
                       : fmt::format("layers: {}", fmt::join(texts, ", "));
}

/// Refuses a map in which only some lines have a layer, because no card names the
/// others.
void check_layers(const TraceFile& file) {
  const auto without = std::count_if(file.traces.begin(), file.traces.end(),
                                     [](const Trace& one) { return one.layer < 0; });
  if (!file.layers.empty() && without > 0)
    throw Refusal{fmt::format("{} line{} no layer, and the others have one", without,
                              without == 1 ? " has" : "s have"),
                  "give every line the property \"layer\""};
}

/// Applies --layer NAME=ID, NAME=outline and NAME=skip.
void give_roles(const std::vector<std::string>& given, std::vector<Layer>& layers) {
  for (const std::string& text : given) {
    const std::size_t equals = text.rfind('=');
    const std::string name = text.substr(0, equals);
    const std::string role = equals == text.npos ? "" : text.substr(equals + 1);
    const auto layer =
        std::find_if(layers.begin(), layers.end(),
                     [&name](const Layer& one) { return one.name == name; });
    if (layer == layers.end())
      throw Refusal{fmt::format("--layer {}: no line has the layer '{}'", text, name),
                    list_of(layers)};
    const char* end = role.data() + role.size();
    const auto [rest, fault] = std::from_chars(role.data(), end, layer->joint);
    if (role == "outline")
      layer->role = Role::outline;
    else if (role == "skip")
      layer->role = Role::skipped;
    else if (fault != std::errc() || rest != end || layer->joint < 1)
      throw Refusal{
          fmt::format("--layer {}: expected NAME=ID, NAME=outline or NAME=skip", text),
          "a joint id is a whole number from 1"};
  }
}

/// Returns the layer of the outline: the one that --layer names, or that of the only
/// closed line of the map. Nothing: the map has no closed line.
std::optional<std::string> outline_layer(std::vector<Layer>& layers) {
  std::vector<Layer*> named, closed;
  for (Layer& layer : layers) {
    if (layer.role == Role::outline)
      named.push_back(&layer);
    if (layer.role == Role::joints && layer.closed > 0 && layer.joint == 0)
      closed.push_back(&layer);
  }
  if (named.size() > 1)
    throw Refusal{"--layer names two outlines", "a deck of one map has one outline"};
  if (named.size() == 1)
    return named.front()->name;
  if (closed.empty())
    return {};
  if (closed.size() > 1 || closed.front()->closed > 1)
    throw Refusal{"several closed lines may be the outline",
                  "give --layer NAME=outline, or --outline FILE; " + list_of(layers)};
  if (closed.front()->lines == 1)
    closed.front()->role = Role::outline;
  return closed.front()->name;
}

/// Whether a card can have this name or path.
bool can_be_quoted(const std::string& word) {
  const bool has_control = std::any_of(word.begin(), word.end(), [](char c) {
    return static_cast<unsigned char>(c) < ' ';
  });
  return !has_control && (word.find('\'') == word.npos || word.find('"') == word.npos);
}

/// Refuses layers whose names no card can have.
void check_names(const std::vector<Layer>& layers,
                 const std::optional<std::string>& outline) {
  for (const Layer& layer : layers) {
    const bool is_named = layer.role == Role::joints || layer.name == outline;
    if (is_named && !can_be_quoted(layer.name))
      throw Refusal{fmt::format("the layer {} cannot be named in a deck",
                                exchange::name_in_deck(layer.name)),
                    "rename it in the drawing, or leave it out with --layer NAME=skip"};
  }
}

/// Gives each layer of joints without an id the number in its name, or the smallest
/// that is left.
void number(std::vector<Layer>& layers) {
  std::set<int> used;
  for (Layer& layer : layers)
    if (layer.role == Role::joints) {
      if (layer.joint == 0)
        layer.joint = exchange::parse_layer(layer.name).number.value_or(0);
      used.insert(layer.joint);
    }
  int next = 1;
  for (Layer& layer : layers)
    if (layer.role == Role::joints && layer.joint == 0) {
      while (!used.insert(next).second)
        ++next;
      layer.joint = next;
    }
}

std::string quoted(const std::string& word) {
  const char quote = word.find('\'') == word.npos ? '\'' : '"';
  return quote + word + quote;
}

/// The lines of an OUTLINE card with these corners.
std::string outline_card(const std::vector<geometry::DecimalPoint>& corners,
                         const std::string& comment) {
  std::string x, y;
  for (const geometry::DecimalPoint& corner : corners) {
    const char* separator = x.empty() ? "" : ",\n";
    x += separator + fmt::format("{}", corner.x.value());
    y += separator + fmt::format("{}", corner.y.value());
  }
  return fmt::format("OUTLINE, {}, 1            $ {}\n{}\n{}\n", corners.size(),
                     comment, x, y);
}

/// The closed line of a layer, clockwise, in a form whose lines are no polygons.
std::string closed_line_card(const TraceFile& file, const std::string& layer) {
  for (const Trace& trace : file.traces) {
    if (file.layers[static_cast<std::size_t>(trace.layer)] != layer ||
        !is_closed(trace))
      continue;
    std::vector<geometry::DecimalPoint> corners(trace.points.begin(),
                                                trace.points.end() - 1);
    geometry::Polygon nearest;
    for (const geometry::DecimalPoint& corner : corners)
      nearest.emplace_back(corner.x.value(), corner.y.value());
    if (geometry::check_outline(nearest).anticlockwise)
      std::reverse(corners.begin() + 1, corners.end());
    return outline_card(corners, "the closed line of a layer");
  }
  throw Refusal{"--layer " + layer + "=outline: the layer has no closed line",
                "close the line, or give --outline FILE"};
}

/// The box around the traces as the lines of an OUTLINE card.
std::string box_card(const TraceFile& file) {
  double left = HUGE_VAL, low = HUGE_VAL, right = -HUGE_VAL, high = -HUGE_VAL;
  for (const Trace& trace : file.traces)
    for (const geometry::DecimalPoint& point : trace.points) {
      left = std::min(left, point.x.value());
      right = std::max(right, point.x.value());
      low = std::min(low, point.y.value());
      high = std::max(high, point.y.value());
    }
  if (!(left < right && low < high))
    throw Refusal{"the lines are along one line, so the box around them has no area",
                  "give --outline FILE"};
  return fmt::format("OUTLINE, 4, 1            $ the box around the traces\n"
                     "{0}, {0}, {1}, {1}\n{2}, {3}, {3}, {2}\n",
                     left, right, low, high);
}

/// The files of the cards, as the deck names them.
struct Files {
  std::string map, outline;  ///< outline: empty: none
};

/// The cards OUTLINE to CUT. snap: < 0: not given.
std::string cards_of(const TraceFile& file, const std::vector<Layer>& layers,
                     const std::optional<std::string>& outline_layer, double snap,
                     const Files& files) {
  const auto& [map, outline] = files;
  const std::string how_far = snap < 0.0 ? "" : fmt::format("{}", snap);
  std::string cards =
      !outline.empty() ? fmt::format("OUTLINE, , 1, {}\n", quoted(outline))
      : outline_layer && file.form != "DXF" ? closed_line_card(file, *outline_layer)
      : outline_layer
          ? fmt::format("OUTLINE, , 1, {}{}\n", quoted(map),
                        outline_layer->empty() ? std::string()
                                               : ", " + quoted(*outline_layer))
          : box_card(file);
  if (layers.empty())
    cards += fmt::format("TRACES, {}, 1{}{}\n", quoted(map), snap < 0.0 ? "" : ", ",
                         how_far);
  for (const Layer& layer : layers)
    if (layer.role == Role::joints)
      cards += fmt::format("TRACES, {}, {}, {}, {}\n", quoted(map), layer.joint,
                           how_far, quoted(layer.name));
  return cards + "CUT\n";
}

/// Cuts, and returns the blocks.
std::optional<std::vector<exchange::Outline>> blocks_of(const std::string& name,
                                                        const std::string& cards) {
  run::RunOptions options;
  options.deck = name;
  options.text = "START, 1000000, 32767\nMAP\nXLIMITS, -1.E30, 1.E30\nYLIMITS, -1.E30, "
                 "1.E30\nBOXES, 1, 1, 1.\nSTIFF, 1., 1.\nMATERIAL, 1, 1., 1., "
                 "1.\nRIGID\nEND\n" +
                 cards + "STOP\n";
  options.tell = [](const deck::Diagnostics& diagnostics) {
    for (const deck::Diagnostic& one : diagnostics.all())
      if (one.card != "STOP")  // the deck of the user has cards that pass time
        fmt::print(stderr, "blocks: {}: {}: {}\n{}",
                   one.severity == deck::Severity::error ? "error" : "warning",
                   one.card, one.message,
                   one.hint.empty() ? "" : "  hint: " + one.hint + "\n");
  };
  const run::CheckedDeck checked = run::build_checked(options);
  if (checked.code != run::done)
    return {};
  std::vector<exchange::Outline> outlines;
  for (int b = 0; b < checked.model.blocks.size(); ++b) {
    exchange::Outline outline;
    outline.corners = checked.model.blocks.outline(b);
    outline.material = 1;
    outlines.push_back(std::move(outline));
  }
  return outlines;
}

std::string path_from(const fs::path& folder, const std::string& file) {
  return fs::proximate(file, folder.empty() ? fs::path(".") : folder).generic_string();
}

int refuse(run::ExitCode code, const std::string& message, const std::string& hint) {
  fmt::print(stderr, "blocks: error: {}\n{}", message,
             hint.empty() ? "" : "  hint: " + hint + "\n");
  return code;
}

}  // namespace

int import_map(MapImport options) {
  if (options.file == "-")
    return refuse(run::usage_error,
                  "--map needs the name of a file, which the deck names", "");
  for (const std::string& file : {options.file, options.outline})
    if (!can_be_quoted(file))
      return refuse(run::usage_error,
                    exchange::name_in_deck(file) + " cannot be named in a deck",
                    "rename the file");
  if (options.output.empty())
    options.output = fs::path(options.file).stem().string() + ".deck";
  if (files::same_file(options.file, options.output))
    return refuse(run::usage_error, options.file + " would be overwritten",
                  "choose another -o NAME");
  if (!options.report_only)
    files::check_outputs({options.output});
  const std::string text = run::read_deck(options.file);
  const TraceFile file = exchange::read_traces(text);
  fmt::print(stderr, "{}",
             exchange::format(file.messages, options.file, file.form, text));
  if (exchange::has_errors(file.messages))
    return run::deck_error;

  std::optional<std::string> of_outline;
  // Ids of the file are kept, unless the user gives layers a meaning.
  const bool keeps_ids =
      file.form != "DXF" && options.layers.empty() &&
      std::any_of(file.traces.begin(), file.traces.end(),
                  [](const Trace& one) { return one.joint.has_value(); });
  std::vector<Layer> layers = keeps_ids ? std::vector<Layer>() : layers_of(file);
  std::string here;
  try {
    if (!keeps_ids)
      check_layers(file);
    give_roles(options.layers, layers);
    if (options.outline.empty())
      of_outline = outline_layer(layers);
    check_names(layers, of_outline);
    number(layers);
    here = cards_of(file, layers, of_outline, options.snap,
                    {options.file, options.outline});
  } catch (const Refusal& refusal) {
    return refuse(run::usage_error, refusal.message, refusal.hint);
  }
  if (!options.quiet)
    fmt::print("{}: {}\n", options.file, file.found);

  const auto blocks = blocks_of(options.file, here);
  if (!blocks)
    return run::deck_error;
  if (!options.quiet) {
    for (const Layer& layer : layers)
      fmt::print("layer {}: {}\n", layer.name,
                 layer.role == Role::outline ? "the outline"
                 : layer.role == Role::skipped
                     ? "skipped"
                     : fmt::format("joint {}, {} line{}", layer.joint, layer.lines,
                                   layer.lines == 1 ? "" : "s"));
    if (keeps_ids)
      fmt::print("joint ids are those of the file\n");
    for (const Layer& layer : layers)
      if (layer.role == Role::joints && of_outline == layer.name)
        fmt::print("the outline is the closed line of layer {}\n", layer.name);
    if (options.outline.empty() && !of_outline)
      fmt::print("no closed line: the outline is the box around the traces\n");
    fmt::print("{} block{}, certified\n", blocks->size(),
               blocks->size() == 1 ? "" : "s");
  }
  if (options.report_only)
    return run::done;
  const fs::path folder = fs::path(options.output).parent_path();
  const std::string cards =
      cards_of(file, layers, of_outline, options.snap,
               {path_from(folder, options.file),
                options.outline.empty() ? "" : path_from(folder, options.outline)});
  try {
    files::replace_file_keeping_older(
        options.output,
        exchange::write_deck_skeleton(
            *blocks, {},
            {fs::path(options.file).filename().string(), cards, file.unit}));
  } catch (const std::range_error& fault) {
    return refuse(run::deck_error,
                  fmt::format("{}: {}; nothing written", options.file, fault.what()),
                  "choose another unit of length");
  }
  if (!options.quiet)
    fmt::print("written: {}\n", options.output);
  return run::done;
}

}  // namespace blocks::convert
