#include "import_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>

#include "convert/import_map.hpp"
#include "deck/mesh/mesh_readers.hpp"
#include "exchange/deck_skeleton.hpp"
#include "exchange/foreign_form.hpp"
#include "exchange/forms.hpp"
#include "exchange/mesh_writer.hpp"
#include "exchange/soundness_text.hpp"
#include "files/check_outputs.hpp"
#include "files/file_tools.hpp"
#include "run/run.hpp"
#include "run/support/deck_file.hpp"

namespace blocks::apps {
namespace {

namespace fs = std::filesystem;
using exchange::Outline;
using exchange::OutlineFile;

/// The form that --format names, or that the content has; nothing: a mesh.
std::optional<exchange::Form> form_of(const std::string& format,
                                      std::string_view text) {
  using exchange::Form;
  return format == "auto"      ? exchange::recognise(text)
         : format == "geojson" ? std::optional(Form::geojson)
         : format == "wkt"     ? std::optional(Form::wkt)
         : format == "dxf"     ? std::optional(Form::dxf)
                               : std::nullopt;
}

/// Reads a mesh in one of the forms of READ9.
OutlineFile read_mesh(const std::string& name, const std::string& text) {
  deck::MeshFile mesh = deck::parse_mesh(name, text);
  OutlineFile file;
  file.found = mesh.found;
  file.material_names = std::move(mesh.names);
  std::size_t at = 0;
  int line = 1;
  for (deck::MeshBlock& block : mesh.blocks) {
    Outline outline;
    outline.corners = std::move(block.outline);
    outline.material = block.material;
    outline.fixed = block.fixed;
    outline.joints = std::move(block.joints);
    for (; line < block.line; ++line)  // blocks are sorted by line
      at = text.find('\n', at) + 1;
    if (block.line > 0)
      outline.at = at;
    file.outlines.push_back(std::move(outline));
  }
  return file;
}

void give_material(OutlineFile& file, int material) {
  std::size_t without = 0;
  const Outline* first = nullptr;
  for (Outline& outline : file.outlines) {
    if (outline.material == 0 && material > 0)
      outline.material = material;
    if (outline.material == 0 && without++ == 0)
      first = &outline;
  }
  if (without > 0)
    file.messages.push_back(
        {true, first->at,
         fmt::format("{} of {} blocks without a material", without,
                     file.outlines.size()),
         "give --material N, or in GeoJSON the property \"material\""});
}

/// "here/roof.geojson" -> "roof"
std::string stem_of(const std::string& path) {
  return path == "-" ? "blocks" : fs::path(path).stem().string();
}

/// "roof.mesh.txt" -> "roof.deck"
std::string deck_beside(const std::string& mesh) {
  fs::path path = fs::path(mesh).replace_extension();
  if (path.extension() == ".mesh")
    path.replace_extension();
  path += ".deck";
  return path.string();
}

/// Replaces names of materials that a deck cannot have, and omits those that an earlier
/// material has, with a warning for each.
void take_names_of_deck(OutlineFile& file) {
  std::map<long, std::string> names;
  std::set<std::string> used;
  const auto warn = [&](const std::string& text, const std::string& hint) {
    file.messages.push_back({false, exchange::nowhere, text, hint, 0});
  };
  for (const auto& [material, name] : file.material_names) {
    const std::string in_deck = exchange::name_in_deck(name);
    if (!used.insert(in_deck).second) {
      warn(fmt::format("material {} has no name in the deck, because another one is "
                       "named '{}'",
                       material, in_deck),
           "two materials of a deck have different names");
      continue;
    }
    if (in_deck != name)
      warn(
          fmt::format("the name of material {} is '{}' in the deck", material, in_deck),
          "a name in a deck has no colon, no line break and one kind of quotes, and is "
          "not a number");
    names[material] = in_deck;
  }
  file.material_names = std::move(names);
}

int usage(const std::string& message) {
  fmt::print(stderr, "blocks: error: {}\n", message);
  return run::usage_error;
}

}  // namespace

void add_import_options(CLI::App& command, ImportOptions& options) {
  command
      .add_option("FILE", options.file,
                  "GeoJSON, WKT, DXF, Gmsh .msh, or another form of READ9; - for "
                  "standard input")
      ->required();
  command.add_option(
      "-o,--output", options.output,
      "the mesh to write (default: FILE's name with .mesh.txt, in this folder)");
  command
      .add_option("--format", options.format,
                  "auto (by content), geojson, wkt, dxf, or mesh for READ9's forms")
      ->check(CLI::IsMember({"auto", "geojson", "wkt", "dxf", "mesh"}));
  command
      .add_option("--material", options.material,
                  "material of blocks for which the file gives none")
      ->check(CLI::PositiveNumber);
  CLI::Option* deck = command.add_flag(
      "--deck", options.deck, "also write a deck that uses the mesh, NAME.deck");
  CLI::Option* map = command.add_flag(
      "--map", options.map,
      "the lines are joints: write a deck that cuts blocks along them, NAME.deck");
  map->excludes(deck);
  command
      .add_option("--outline", options.outline,
                  "with --map: a file with the polygon to be cut (default: the only "
                  "closed line of a DXF map, or the box around the lines)")
      ->needs(map);
  command
      .add_option(
          "--snap", options.snap,
          "with --map: loose ends are prolonged to the next joint if that is at "
          "most this far")
      ->needs(map)
      ->check(CLI::NonNegativeNumber);
  command
      .add_option("--layer", options.layers,
                  "with --map: the joint id of a layer, NAME=ID, or NAME=outline or "
                  "NAME=skip; may be repeated")
      ->needs(map)
      ->allow_extra_args(false);
  command
      .add_flag("--keep-overlaps", options.keep_overlaps,
                "accept blocks that overlap, with a warning")
      ->excludes(map);
  command.add_flag(
      "--report-only", options.report_only,
      "report what is found and write nothing; exit 0 even if blocks are unsound");
  command.add_flag("-q,--quiet", options.quiet, "print errors and warnings only");
}

int import_blocks(ImportOptions options) {
  if (options.map)
    return convert::import_map({options.file, options.output, options.outline,
                                options.snap, options.layers, options.report_only,
                                options.quiet});
  const std::string text = run::read_deck(options.file);
  const std::string name = options.file == "-" ? "<standard input>" : options.file;
  const std::optional<exchange::Form> form = form_of(options.format, text);
  if (options.output.empty())
    options.output = stem_of(options.file) + ".mesh.txt";
  const std::string deck = deck_beside(options.output);
  const std::string mesh_name = fs::path(options.output).filename().string();
  if (files::same_file(options.file, options.output) ||
      files::same_file(options.file, deck))
    return usage(options.file + " would be overwritten: choose another -o NAME");
  if (options.deck && options.output == deck)
    return usage("-o names the mesh, and --deck writes " + deck +
                 " beside it: choose a name for the mesh, such as -o " +
                 fs::path(deck).replace_extension(".mesh.txt").string());
  if (options.deck && mesh_name.find_first_of("'\"\n\r$!") != mesh_name.npos)
    return usage("the name " + mesh_name +
                 " cannot be written in a deck: choose another -o NAME");
  if (!options.report_only)
    files::check_outputs({options.output, options.deck ? deck : ""});

  if (const auto foreign = exchange::foreign_form(text);
      !form && foreign && foreign->is_known) {
    fmt::print(stderr, "blocks: error: {} is {}\n  hint: {}\n", name, foreign->name,
               foreign->hint);
    return run::deck_error;
  }
  OutlineFile file;
  const std::string card = form ? exchange::name_of(*form) : "mesh";
  try {
    file = form ? exchange::read_outlines(*form, text) : read_mesh(name, text);
  } catch (const deck::UnknownMesh& fault) {
    fmt::print(stderr,
               "blocks: error: {}\n  hint: import reads GeoJSON, WKT, DXF and READ9's "
               "forms (docs/exchange.md)\n",
               fault.what());
    return run::deck_error;
  } catch (const deck::MeshError& fault) {
    fmt::print(stderr, "blocks: error: {}\n{}", fault.what(),
               fault.hint().empty() ? "" : "  hint: " + fault.hint() + "\n");
    return run::deck_error;
  }
  if (file.open.n > 0)
    file.messages.push_back(
        {false, file.open.first,
         fmt::format("{} that {} not closed: no block",
                     file.open.n == 1 ? "1 line" : fmt::format("{} lines", file.open.n),
                     file.open.n == 1 ? "is" : "are"),
         "blocks import --map takes lines as joints"});
  const bool readable = !exchange::has_errors(file.messages);
  std::string report;
  if (readable) {
    if (!options.report_only)
      give_material(file, options.material);
    std::vector<geometry::Polygon> corners;
    for (const Outline& outline : file.outlines)
      corners.push_back(outline.corners);
    const exchange::Soundness soundness = exchange::examine(corners);
    for (const int b : soundness.turned)
      exchange::reverse(file.outlines[b]);
    for (exchange::Message& fault :
         exchange::faults(soundness, file.outlines, options.keep_overlaps))
      file.messages.push_back(std::move(fault));
    if (options.deck)
      take_names_of_deck(file);
    report = exchange::describe(soundness, file.outlines);
    if (!file.material_names.empty() && !options.deck)
      report += "names of materials are written only to a deck (--deck)\n";
  }
  fmt::print(stderr, "{}", exchange::format(file.messages, name, card, text));
  if (!readable)
    return run::deck_error;
  if (!options.quiet)
    fmt::print("{}: {}\n{}", name, file.found, report);
  if (options.report_only)
    return run::done;
  if (exchange::has_errors(file.messages)) {
    fmt::print(stderr, "blocks: error: nothing written\n");
    return run::deck_error;
  }

  std::string skeleton;
  try {
    if (options.deck)
      skeleton = exchange::write_deck_skeleton(
          file.outlines, file.material_names,
          {mesh_name, fmt::format("READ9, '{}'\n", mesh_name), file.unit});
  } catch (const std::range_error& fault) {
    fmt::print(stderr,
               "blocks: error: {}: {}; nothing written\n  hint: choose another unit of "
               "length\n",
               name, fault.what());
    return run::deck_error;
  }
  const std::string wrote = fmt::format("From {}: {}.", name, file.found);
  files::replace_file_keeping_older(options.output,
                                    exchange::write_mesh(file.outlines, wrote));
  if (options.deck)
    files::replace_file_keeping_older(deck, skeleton);
  if (!options.quiet)
    fmt::print("written: {}{}\n", options.output, options.deck ? ", " + deck : "");
  return run::done;
}

}  // namespace blocks::apps
