// CUT with its group OUTLINE, JSET, TRACES, VORONOI (docs/joints.md).
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "deck/points.hpp"
#include "geometry/polygon.hpp"
#include "run/builder/cards.hpp"
#include "run/builder/new_blocks.hpp"
#include "run/cutting/cut_outcome.hpp"

namespace blocks::run {
namespace {

CutOptions options_of(const Context& context) {
  const BuildOptions& build = context.state.options;
  const Settings& settings = context.settings;
  CutOptions options{settings.seed, build.folder, settings.units.length};
  if (settings.max_blocks > 0)
    options.max_new_blocks = settings.max_blocks - context.blocks.size();
  if (build.cut_progress)
    options.progress = [&build, line = context.command.where.line](
                           const std::string& step, double part) {
      build.cut_progress(line, step, part);
    };
  return options;
}

/// Returns " between joints 1, 3" for the ids of the sides of a block, or an empty text
/// without joints.
std::string between_joints(const std::vector<int>& joints) {
  std::set<int> ids(joints.begin(), joints.end());
  ids.erase(0);
  return ids.empty()
             ? std::string()
             : fmt::format(" {} {}", ids.size() == 1 ? "at joint" : "between joints",
                           fmt::join(ids, ", "));
}

/// Warns of joints that do not cut, and of edges and cells that remain small.
void warn_of(const Context& context, const deck::Cut& card, const CutRecord& record) {
  if (record.blocks == 1)
    context.warning(
        "the joints cut off no block",
        record.counts.merges > 0
            ? "amin merges all cells into one: reduce it"
            : "only joints that connect two points of the outline, or of joints that "
              "do, separate blocks; see snap of TRACES");
  if (record.counts.kept_short > 0)
    context.warning(
        card.emin.where,
        fmt::format("edges shorter than emin remain: {}", record.counts.kept_short),
        card.protect.empty()
            ? "contracting them would fold a block or change the outline"
            : "contracting them would fold a block, change the outline or move a "
              "corner of a protected joint");
  if (record.counts.kept_small > 0)
    context.warning(
        card.amin.where,
        fmt::format("cells smaller than amin remain: {}", record.counts.kept_small),
        "they have no neighbour into which they can be merged");
}

void record_cut(Model& model, const CutOutcome& outcome) {
  const int number = model.cuts.empty() ? 1 : model.cuts.back().number + 1;
  CutRecord& record = model.cuts.emplace_back(outcome.record);
  record.number = number;
  record.first_block = model.blocks.size();
  for (JointLengthRecord length : outcome.lengths) {
    length.cut = number;
    model.joint_lengths.push_back(length);
  }
}

void cut(const Context& context, const deck::Cut& card, const CutOptions& options) {
  const deck::Int& material = card.outline.mat;
  const double rho = density(context, material.value, material.where);
  if (!(rho > 0.0))
    return;
  const deck::SourceLocation where = context.command.where;
  std::optional<CutOutcome> made =
      cut_domain(card, where, context.state.corners[context.state.section], options,
                 context.diagnostics);
  if (!made || !have_space(context, static_cast<long>(made->blocks.size()), where))
    return;
  std::size_t corners = 0;
  for (NewBlock& block : made->blocks) {
    block.density = rho;
    corners = std::max(corners, block.outline.size());
    if (!has_weight(
            context, block.outline,
            fmt::format("block {} of the cut domain{}",
                        &block - made->blocks.data() + 1, between_joints(block.joints)),
            "give emin and amin, such as 1e-6 of the size of a block, or remove "
            "one of two joints that nearly coincide there"))
      return;
  }
  if (!may_have_corners(context, corners, "a block"))
    return;
  warn_of(context, card, made->record);
  record_cut(context.model, *made);
  append(context, made->blocks);
  for (std::string& note : made->notes)
    context.state.notes.push_back(std::move(note));
}

}  // namespace

void act(const Context& context, const deck::Cut& card) {
  context.state.last_outline =
      geometry::place_outline(deck::points_of(card.outline.x, card.outline.y), {}, 0);
  const CutOptions options = options_of(context);
  cut(context, card, options);
  if (options.progress)
    options.progress("", 1.0);
}

}  // namespace blocks::run
