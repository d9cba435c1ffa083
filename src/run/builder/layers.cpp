// LAYER, ORIENT and MERGE (report A.2.3 to A.2.5).
#include <fmt/format.h>

#include <cstdlib>

#include "geometry/layer.hpp"
#include "run/builder/cards.hpp"
#include "run/builder/new_blocks.hpp"

namespace blocks::run {
namespace {

using geometry::QuadShape;

/// Puts the corners of a layer in clockwise order. Reports an error if that is not
/// possible.
bool orient_corners(const Context& context, const deck::Layer& card,
                    geometry::LayerRequest& request) {
  auto& corners = request.corners;
  const deck::SourceLocation where = card.corners[0].where;
  const auto refuse = [&](const char* problem) {
    context.error(
        where, problem,
        "the corners are 1 bottom left, 2 top left, 3 top right, 4 bottom right");
    return false;
  };
  switch (geometry::classify_quad(corners)) {
  case QuadShape::convex_clockwise:
    return true;
  case QuadShape::bow_tie:
    return refuse("the corners form a bow-tie: two sides of the layer cross");
  case QuadShape::dart:
    return refuse("the corners form a dart: one corner lies inside the others");
  case QuadShape::degenerate:
    return refuse("the layer is degenerate: corners coincide or three lie on one line");
  case QuadShape::convex_anticlockwise:
    break;
  }
  // Anticlockwise from the bottom left means BL, BR, TR, TL (docs/cards.md#layer). Any
  // other anticlockwise order would move the bottom line, so it is an error.
  if (!(corners[0].x.value() < corners[1].x.value() &&
        corners[0].y.value() < corners[3].y.value()))
    return refuse(
        "the corners run anticlockwise, and corner 1 is not at the bottom left");
  context.warning(where, "the corners run anticlockwise",
                  "read as 1 bottom left, 2 bottom right, 3 top right, 4 top left");
  std::swap(corners[1], corners[3]);
  return true;
}

/// Returns what to cut. Returns nothing after an error.
std::optional<geometry::LayerRequest> request_of(const Context& context,
                                                 const deck::Layer& card) {
  const Settings& settings = context.settings;
  geometry::LayerRequest request;
  for (std::size_t i = 0; i < 4; ++i)
    request.corners[i] = {card.corners[2 * i].value, card.corners[2 * i + 1].value};
  if (!orient_corners(context, card, request))
    return std::nullopt;
  request.rounded.emplace();
  for (std::size_t i = 0; i < 4; ++i)
    (*request.rounded)[i] = place_corner(
        context, {request.corners[i].x.value(), request.corners[i].y.value()});
  const bool random = card.rcommand.given;
  request.count = static_cast<int>(std::abs(card.ns.value));
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
  request.stream = {settings.seed, geometry::stream_of(request)};
  return request;
}

/// The ids of the sides of a block, whose corners are bottom left, top left, top right
/// and bottom right.
std::vector<int> joints_of(const deck::FaceIds& ids) {
  if (!ids.given())
    return {};
  const int side = static_cast<int>(ids.side.value);
  return {side, static_cast<int>(ids.top.value), side,
          static_cast<int>(ids.bottom.value)};
}

void record(const Context& context, const geometry::Layer& cut) {
  Model& model = context.model;
  const int number = ++context.settings.layers_made;
  model.layers.push_back(
      {number, context.blocks.size(), static_cast<int>(cut.mesh.cells.size()),
       cut.certificate.cells, cut.certificate.interior_edges,
       cut.certificate.outline_edges, cut.redrawn, cut.ruled, cut.redrawn_sides});
  const auto& ratio = context.settings.merge_ratio;
  for (const geometry::Absorption& absorption : cut.absorptions)
    model.merges.push_back({number, absorption.absorbed, absorption.into,
                            absorption.width_to_height, ratio ? ratio->value() : 0.0});
}

}  // namespace

void act(const Context& context, const deck::Orient& card) {
  context.settings.angle_min = card.angmin.value;
  context.settings.angle_max = card.angplus.value;
}

void act(const Context& context, const deck::Merge& card) {
  context.settings.merge_ratio = card.aratio.value;
}

void act(const Context& context, const deck::Layer& card) {
  const Settings& settings = context.settings;
  const double rho = density(context, card.mat.value, card.mat.where);
  if (settings.max_corners < 4 && settings.max_blocks > 0) {
    context.error(card.ns.where, "blocks of a layer have 4 corners",
                  fmt::format("START allows {}: raise ncmx, its second value, to 4 or "
                              "more",
                              settings.max_corners));
    return;
  }
  // MERGE may leave fewer than |ns| blocks, so the blocks of a random layer are counted
  // after it is cut.
  const bool random = card.rcommand.given;
  if (!(rho > 0.0) ||
      (!random && !have_space(context, std::abs(card.ns.value), card.ns.where)))
    return;
  const std::optional<geometry::LayerRequest> request = request_of(context, card);
  if (!request)
    return;
  geometry::Layer cut;
  try {
    cut = geometry::cut_layer(*request);
  } catch (const geometry::LayerError& fault) {
    context.error(fault.what(), fault.hint);
    return;
  }
  if (random &&
      !have_space(context, static_cast<long>(cut.mesh.cells.size()), card.ns.where))
    return;
  if (cut.bottom_scaled || cut.top_scaled)
    context.warning(fmt::format("the widths on the {} line do not add up to its length",
                                !cut.top_scaled      ? "bottom"
                                : !cut.bottom_scaled ? "top"
                                                     : "bottom and on the top"),
                    "they are scaled to fit");
  std::vector<NewBlock> made;
  for (const std::vector<int>& cell : cut.mesh.cells) {
    NewBlock block{
        {},           static_cast<int>(card.mat.value), rho,
        Fixity::free, settings.layers_made + 1,         joints_of(card.joints)};
    for (const int vertex : cell)
      block.outline.push_back(cut.mesh.vertices[vertex]);
    if (!has_weight(context, block.outline,
                    fmt::format("block {} of the layer", made.size() + 1)))
      return;
    made.push_back(std::move(block));
  }
  record(context, cut);
  append(context, made);
}

}  // namespace blocks::run
