// CREATE with CLOOP, and READ9 (report A.2.1, A.2.2 and A.2.6).
#include <fmt/format.h>

#include <cmath>

#include "deck/mesh/mesh_readers.hpp"
#include "run/builder/cards.hpp"
#include "run/builder/deck_outlines.hpp"
#include "run/builder/new_blocks.hpp"
#include "run/support/deck_file.hpp"

namespace blocks::run {
namespace {

/// Gives the ids to the sides that have none. A side whose outward normal is within 45
/// degrees of up or down is a top or a bottom.
void give_face_joints(const deck::FaceIds& ids, NewBlock& block) {
  if (!ids.given())
    return;
  const std::size_t sides = block.outline.size();
  block.joints.resize(sides, 0);
  for (std::size_t i = 0; i < sides; ++i) {
    if (block.joints[i] != 0)
      continue;
    // Corners are clockwise, so the block is on the right: a top runs to the right.
    const Vec2 along = block.outline[(i + 1) % sides] - block.outline[i];
    const deck::Int& id = along.x() > std::abs(along.y())    ? ids.top
                          : -along.x() > std::abs(along.y()) ? ids.bottom
                                                             : ids.side;
    block.joints[i] = static_cast<int>(id.value);
  }
}

}  // namespace

void act(const Context& context, const deck::Create& card) {
  const double rho = density(context, card.mat.value, card.mat.where);
  const geometry::DeckOutline given = outline_of(card);
  const long copies = card.loop ? card.loop->nloop.value : 1;
  if (!have_space(context, copies,
                  card.loop ? card.loop->nloop.where : context.command.where) ||
      !(rho > 0.0))
    return;
  std::vector<NewBlock> made;
  bool warned = false;  // one warning for all copies, which have the same shape
  for (int copy = 0; copy < copies; ++copy) {
    geometry::Polygon outline =
        geometry::place_outline(given.corners, given.shift, copy);
    for (Vec2& corner : outline)
      corner = place_corner(context, corner);
    const auto what =
        copies == 1 ? fmt::format("block {}",
                                  context.state.numbers.last(context.blocks.size()) + 1)
                    : fmt::format("copy {} of the block", copy + 1);
    if (!accept(context, outline, what, warned))
      return;
    made.push_back({std::move(outline), static_cast<int>(card.mat.value), rho,
                    card.ifix.value != 0 ? Fixity::by_user : Fixity::free});
  }
  append(context, made);
}

void act(const Context& context, const deck::Read9& card) {
  const std::string path =
      mesh_path(card, context.state.options.folder, context.state.options.tape9);
  deck::MeshFile mesh;
  try {
    mesh = deck::read_mesh(path);
  } catch (const deck::MeshError& fault) {
    context.error(fault.what(),
                  !fault.hint().empty()
                      ? fault.hint()
                      : "READ9 reads the text form, Gmsh .msh, GENESIS and region "
                        "records (docs/mesh-formats.md)");
    return;
  }
  const deck::SourceLocation where = context.command.where;
  if (!have_space(context, static_cast<long>(mesh.blocks.size()), where))
    return;
  std::vector<NewBlock> made;
  bool warned = false;
  for (deck::MeshBlock& block : mesh.blocks) {
    auto what = fmt::format("block {} of the mesh", made.size() + 1);
    if (block.line > 0)
      what += fmt::format(" (its line {})", block.line);
    const double rho = density(context, block.material, where);
    if (!(rho > 0.0) || !accept(context, block.outline, what, warned, &block.joints))
      return;
    made.push_back({std::move(block.outline), static_cast<int>(block.material), rho,
                    block.fixed ? Fixity::by_user : Fixity::free, 0,
                    std::move(block.joints)});
    give_face_joints(card.joints, made.back());
  }
  const int first = context.blocks.size() + 1;
  append(context, made);
  context.state.notes.push_back(fmt::format("READ9: {}: {} (blocks {} to {})", path,
                                            mesh.found, first, context.blocks.size()));
}

}  // namespace blocks::run
