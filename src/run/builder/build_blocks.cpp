#include "run/builder/build_blocks.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "deck/mesh/mesh_readers.hpp"
#include "geometry/contact_predicates.hpp"
#include "geometry/layer.hpp"
#include "run/builder/face_joints.hpp"
#include "run/support/contact_room.hpp"
#include "text/counted.hpp"

namespace blocks::run {

using geometry::QuadShape;

namespace {

/// Returns the width or height of the corners, whichever is the larger one, [L].
double extent(const geometry::Polygon& corners) {
  Eigen::AlignedBox2d box;
  for (const Vec2& corner : corners)
    box.extend(corner);
  return box.sizes().maxCoeff();
}

}  // namespace

double BlockBuilder::density(long material, deck::SourceLocation where) {
  const auto& materials = model_.settings.materials;
  const bool in_range = material <= std::numeric_limits<int>::max();
  if (const auto found = materials.find(static_cast<int>(material));
      in_range && found != materials.end())
    return found->second.density;
  if (unread_.may_define(material, model_.settings))
    return 1.0;
  std::string known;
  for (const auto& [number, unused] : materials)
    known += (known.empty() ? "" : ", ") + std::to_string(number);
  error(where, fmt::format("there is no material {}", material),
        "materials defined: " + (known.empty() ? std::string("none") : known));
  return 0.0;
}

bool BlockBuilder::fits(long more, deck::SourceLocation where) {
  constexpr long max = 20'000'000;          // about 12 GB of state
  constexpr double bytes_of_block = 600.0;  // a block without contacts
  const auto fit_in_memory = static_cast<long>(physical_memory() / bytes_of_block);
  if (more > max) {
    error(where, fmt::format("{} blocks at once", more),
          fmt::format("one card may make {} blocks at most", max));
    return false;
  }
  if (more > fit_in_memory) {
    error(where, fmt::format("{} blocks at once", more),
          fmt::format("this machine has memory for about {}", fit_in_memory));
    return false;
  }
  const long left = model_.settings.max_blocks - model_.blocks.size();
  if (more <= left || !has_start())
    return true;
  error(where,
        fmt::format("{} exceed{} START's maximum of {}", counted(more, "more block"),
                    more == 1 ? "s" : "", model_.settings.max_blocks),
        fmt::format(
            "{} exist so far: {} more are possible, or raise nblok on the START card",
            model_.blocks.size(), left));
  return false;
}

bool BlockBuilder::has_weight(const geometry::Polygon& clockwise,
                              deck::SourceLocation where, const std::string& what,
                              const std::string& hint_if_thin) {
  const geometry::SectionProperties section = geometry::section_properties(clockwise);
  if (section.area > 0.0 && std::isfinite(section.area) && section.polar_moment > 0.0 &&
      std::isfinite(section.polar_moment))
    return true;
  const double length = extent(clockwise);
  if (const double square = length * length; std::isnormal(square * square)) {
    error(where,
          fmt::format("{} is too thin to calculate with, at ({:.6g}, {:.6g})", what,
                      clockwise[0].x(), clockwise[0].y()),
          hint_if_thin);
    return false;
  }
  const bool vanishing = section.area == 0.0 || section.polar_moment == 0.0;
  error(where,
        fmt::format("{}: its area or second moment is too {} to calculate with", what,
                    vanishing ? "small" : "large"),
        "choose another unit of length");
  return false;
}

bool BlockBuilder::accept(geometry::Polygon& outline, deck::SourceLocation where,
                          const std::string& what, bool& warned,
                          std::vector<int>* joints) {
  if (static_cast<long>(outline.size()) > model_.settings.max_corners && has_start()) {
    error(where,
          fmt::format("{} has {} corners, more than START's maximum of {}", what,
                      outline.size(), model_.settings.max_corners),
          "raise ncmx on the START card");
    return false;
  }
  const geometry::OutlineCheck check = geometry::check_outline(outline);
  if (check.fault != geometry::OutlineFault::none) {
    error(where, fmt::format("{}: {}", what, geometry::describe(check)),
          "give the corners in order around the block, clockwise, each one once");
    return false;
  }
  if (!has_weight(check.anticlockwise ? geometry::reversed(outline) : outline, where,
                  what))
    return false;
  if (check.anticlockwise) {
    if (!warned)
      warning(where, fmt::format("{}: the corners run anticlockwise", what),
              "corner 1 is kept and the others are taken in the reverse order");
    outline = geometry::reversed(outline);
    if (joints)
      std::reverse(joints->begin(), joints->end());
  }
  if (!check.convex && !warned)
    warning(where, fmt::format("{} is not convex", what),
            "contacts are decided faster between convex blocks: consider cutting it in "
            "two");
  warned = warned || check.anticlockwise || !check.convex;
  return true;
}

void BlockBuilder::append(const std::vector<NewBlock>& blocks) {
  model_.blocks.append(blocks);
  model_.search.invalidate();
}

void BlockBuilder::create(const deck::Create& card) {
  const double rho = density(card.mat.value, card.mat.where);
  const long copies = card.loop ? card.loop->nloop.value : 1;
  if (!fits(copies, card.loop ? card.loop->nloop.where : command_.where) ||
      !(rho > 0.0))
    return;
  std::vector<geometry::DecimalPoint> corners;
  for (std::size_t i = 0; i < card.x.size(); ++i)
    corners.push_back({card.x[i].value, card.y[i].value});
  const geometry::DecimalPoint shift =
      card.loop ? geometry::DecimalPoint{card.loop->radd.value, card.loop->zadd.value}
                : geometry::DecimalPoint{};

  std::vector<NewBlock> made;
  bool warned = false;  // one warning for all copies, which have the same shape
  for (int copy = 0; copy < copies; ++copy) {
    geometry::Polygon outline = geometry::place_outline(corners, shift, copy);
    for (Vec2& corner : outline)
      corner = corners_.place(corner);
    const auto what = copies == 1
                          ? fmt::format("block {}", model_.blocks.size() + missing_ + 1)
                          : fmt::format("copy {} of the block", copy + 1);
    if (!accept(outline, command_.where, what, warned))
      return;
    made.push_back({std::move(outline), static_cast<int>(card.mat.value), rho,
                    card.ifix.value != 0 ? Fixity::by_user : Fixity::free});
  }
  append(made);
}

void BlockBuilder::layer(const deck::Layer& card) {
  const Settings& settings = model_.settings;
  const double rho = density(card.mat.value, card.mat.where);
  const long count = std::abs(card.ns.value);
  const bool random = card.rcommand.given;
  // MERGE may leave fewer than |ns| blocks, so the blocks of a random layer are counted
  // after it is cut.
  if (model_.settings.max_corners < 4 && has_start()) {
    error(card.ns.where, "blocks of a layer have 4 corners",
          fmt::format("START allows {}: raise ncmx, its second value, to 4 or more",
                      model_.settings.max_corners));
    return;
  }
  if (!(rho > 0.0) || (!random && !fits(count, card.ns.where)))
    return;

  geometry::LayerRequest request;
  for (std::size_t i = 0; i < 4; ++i)
    request.corners[i] = {card.corners[2 * i].value, card.corners[2 * i + 1].value};
  if (!orient_corners(card, request))
    return;
  request.rounded.emplace();
  for (std::size_t i = 0; i < 4; ++i)
    (*request.rounded)[i] =
        corners_.place({request.corners[i].x.value(), request.corners[i].y.value()});
  request.count = static_cast<int>(count);
  request.spacing = card.ns.value > 0 ? geometry::Spacing::listed
                    : random          ? geometry::Spacing::random
                                      : geometry::Spacing::even;
  for (const deck::Exact& width : card.bottom)
    request.bottom.push_back(width.value);
  for (const deck::Exact& width : card.top)
    request.top.push_back(width.value);
  if (random) {
    request.angle_min = settings.angle_min;
    request.angle_max = settings.angle_max;
    request.merge_ratio = settings.merge_ratio;
  }
  const int number = settings.layers_made + 1;
  request.stream = {settings.seed, geometry::stream_of(request)};

  geometry::Layer cut;
  try {
    cut = geometry::cut_layer(request);
  } catch (const geometry::LayerError& fault) {
    error(command_.where, fault.what(), fault.hint);
    return;
  }
  if (random && !fits(static_cast<long>(cut.mesh.cells.size()), card.ns.where))
    return;
  if (cut.bottom_scaled || cut.top_scaled)
    warning(command_.where,
            fmt::format("the widths on the {} line do not add up to its length",
                        !cut.top_scaled      ? "bottom"
                        : !cut.bottom_scaled ? "top"
                                             : "bottom and on the top"),
            "they are scaled to fit");
  std::vector<NewBlock> made;
  for (const std::vector<int>& cell : cut.mesh.cells) {
    NewBlock block{{}, static_cast<int>(card.mat.value), rho, Fixity::free, number};
    for (const int vertex : cell)
      block.outline.push_back(cut.mesh.vertices[vertex]);
    if (!has_weight(block.outline, command_.where,
                    fmt::format("block {} of the layer", made.size() + 1)))
      return;
    give_layer_joints(card.joints, block);
    made.push_back(std::move(block));
  }
  record(cut, number);
  append(made);
}

bool BlockBuilder::orient_corners(const deck::Layer& card,
                                  geometry::LayerRequest& request) {
  auto& corners = request.corners;
  const deck::SourceLocation where = card.corners[0].where;
  const char* order =
      "the corners are 1 bottom left, 2 top left, 3 top right, 4 bottom right";
  switch (geometry::classify_quad(corners)) {
  case QuadShape::convex_clockwise:
    return true;
  case QuadShape::bow_tie:
    error(where, "the corners form a bow-tie: two sides of the layer cross", order);
    return false;
  case QuadShape::dart:
    error(where, "the corners form a dart: one corner lies inside the others", order);
    return false;
  case QuadShape::degenerate:
    error(where, "the layer is degenerate: corners coincide or three lie on one line",
          order);
    return false;
  case QuadShape::convex_anticlockwise:
    break;
  }
  // Anticlockwise from the bottom left means BL, BR, TR, TL (docs/cards.md#layer). Any
  // other anticlockwise order would move the bottom line, so it is an error.
  if (!(corners[0].x.value() < corners[1].x.value() &&
        corners[0].y.value() < corners[3].y.value())) {
    error(where,
          "the corners run anticlockwise, and corner 1 is not at the bottom left",
          order);
    return false;
  }
  warning(where, "the corners run anticlockwise",
          "read as 1 bottom left, 2 bottom right, 3 top right, 4 top left");
  std::swap(corners[1], corners[3]);
  return true;
}

void BlockBuilder::record(const geometry::Layer& cut, int number) {
  model_.settings.layers_made = number;
  model_.layers.push_back(
      {number, model_.blocks.size(), static_cast<int>(cut.mesh.cells.size()),
       cut.certificate.cells, cut.certificate.interior_edges,
       cut.certificate.outline_edges, cut.redrawn, cut.ruled, cut.redrawn_sides});
  const double limit =
      model_.settings.merge_ratio ? model_.settings.merge_ratio->value() : 0.0;
  for (const geometry::Absorption& absorption : cut.absorptions)
    model_.merges.push_back({number, absorption.absorbed, absorption.into,
                             absorption.width_to_height, limit});
}

std::vector<std::string> BlockBuilder::cut(const deck::Cut& card,
                                           const CutOptions& options) {
  const deck::Outline& outline = card.outline;
  const double rho = density(outline.mat.value, outline.mat.where);
  if (!(rho > 0.0))
    return {};
  std::optional<CutOutcome> made =
      cut_domain(card, command_.where, corners_, options, diagnostics_);
  if (!made || !fits(static_cast<long>(made->blocks.size()), command_.where))
    return {};
  std::size_t corners = 0;
  for (NewBlock& block : made->blocks) {
    block.density = rho;
    corners = std::max(corners, block.outline.size());
    if (!has_weight(
            block.outline, command_.where,
            fmt::format("block {} of the cut domain{}",
                        &block - made->blocks.data() + 1, between_joints(block.joints)),
            "give emin and amin, such as 1e-6 of the size of a block, or remove "
            "one of two joints that nearly coincide there"))
      return {};
  }
  if (static_cast<long>(corners) > model_.settings.max_corners && has_start()) {
    error(command_.where,
          fmt::format("a block has {} corners, more than START's maximum of {}",
                      corners, model_.settings.max_corners),
          "raise ncmx on the START card");
    return {};
  }
  warn_of(card, made->record);
  record(*made);
  append(made->blocks);
  return std::move(made->notes);
}

void BlockBuilder::warn_of(const deck::Cut& card, const CutRecord& record) {
  if (record.blocks == 1)
    warning(
        command_.where, "the joints cut off no block",
        record.merges > 0
            ? "amin merges all cells into one: reduce it"
            : "only joints that connect two points of the outline, or of joints that "
              "do, separate blocks; see snap of TRACES");
  if (record.kept_short > 0)
    warning(card.emin.where,
            fmt::format("edges shorter than emin remain: {}", record.kept_short),
            card.protect.empty()
                ? "contracting them would fold a block or change the outline"
                : "contracting them would fold a block, change the outline or move a "
                  "corner of a protected joint");
  if (record.kept_small > 0)
    warning(card.amin.where,
            fmt::format("cells smaller than amin remain: {}", record.kept_small),
            "they have no neighbour into which they can be merged");
}

void BlockBuilder::record(const CutOutcome& outcome) {
  const int number = model_.cuts.empty() ? 1 : model_.cuts.back().number + 1;
  CutRecord& record = model_.cuts.emplace_back(outcome.record);
  record.number = number;
  record.first_block = model_.blocks.size();
  for (JointLengthRecord length : outcome.lengths) {
    length.cut = number;
    model_.joint_lengths.push_back(length);
  }
}

std::string BlockBuilder::read_mesh(const deck::Read9& card, const std::string& path) {
  deck::MeshFile mesh;
  try {
    mesh = deck::read_mesh(path);
  } catch (const deck::MeshError& fault) {
    error(command_.where, fault.what(),
          !fault.hint().empty()
              ? fault.hint()
              : "READ9 reads the text form, Gmsh .msh, GENESIS and region records "
                "(docs/mesh-formats.md)");
    return {};
  }
  if (!fits(static_cast<long>(mesh.blocks.size()), command_.where))
    return {};
  std::vector<NewBlock> made;
  bool warned = false;
  for (deck::MeshBlock& block : mesh.blocks) {
    const auto what = block.line > 0
                          ? fmt::format("block {} of the mesh (its line {})",
                                        made.size() + 1, block.line)
                          : fmt::format("block {} of the mesh", made.size() + 1);
    const double rho = density(block.material, command_.where);
    if (!(rho > 0.0) ||
        !accept(block.outline, command_.where, what, warned, &block.joints))
      return {};
    made.push_back({std::move(block.outline), static_cast<int>(block.material), rho,
                    block.fixed ? Fixity::by_user : Fixity::free, 0,
                    std::move(block.joints)});
    give_face_joints(card.joints, made.back());
  }
  const int first = model_.blocks.size() + 1;
  append(made);
  return fmt::format("READ9: {}: {} (blocks {} to {})", path, mesh.found, first,
                     model_.blocks.size());
}

}  // namespace blocks::run
