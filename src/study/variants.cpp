#include "study/variants.hpp"

#include <algorithm>

#include "dynamics/decisions/contact_rule.hpp"
#include "dynamics/update_pairs.hpp"
#include "study/near_corners.hpp"
#include "study/signs.hpp"

namespace blocks::study {
namespace {

using dynamics::BlockParts;
using dynamics::PairIndex;
using dynamics::PairScratch;
using dynamics::RuleParts;
using dynamics::Workspace;

constexpr RuleParts without_third_parts{.third_parts = false};

/// The contact rule with some of its parts. Every pair is decided in every step.
template <RuleParts with, bool transfers = true>
struct PairRules : dynamics::PairwiseRule {
  PairRules() : PairwiseRule({false, transfers}, with) {}
};

/// The rules of the report (3.2, 3.3): each listed corner is decided with each of its
/// listed edges independently.
class ReportRules : public dynamics::ContactRule {
 public:
  ReportRules() : ContactRule({false, false}) {}

  void find(Model& model, Workspace& work) {
    const double tolerance = model.settings.contact_tolerance;
    update_pairs(model, work);
    if (model.search.updates == listed_)
      return;
    near_.find(model, work.index, 2.0 * tolerance);
    model.search.left = std::min(model.search.left, tolerance);
    listed_ = model.search.updates;
  }
  void decide(const Blocks& blocks, const BlockParts&, const PairIndex& index, int p,
              PairScratch& scratch) const override {
    scratch.found.clear();
    for (const dynamics::CornerOnEdge& one :
         near_.of(index.pairs[p].low, index.pairs[p].high))
      if (acts(blocks, one.corner, one.edge))
        scratch.found.push_back(one);
  }

 private:
  static bool acts(const Blocks& blocks, int corner, int edge) {
    using Signs = PrintedSigns;
    const auto at = [&](int k) { return Vec2(blocks.corner.col(k)); };
    const Vec2 c = at(corner), p1 = at(edge), p2 = at(blocks.next[edge]);
    return Signs::overlap_sign(c, p1, p2) > 0 && Signs::between(c, p1, p2) &&
           Signs::faces_edge(c, at(blocks.previous[corner]), p1, p2) &&
           Signs::faces_edge(c, at(blocks.next[corner]), p1, p2);
  }

  NearCorners near_;
  long listed_ = -1;  ///< search (NUPDAT) of the present list
};

/// Runs a variant by its rules, which may have a find() of their own.
template <class Rules> class RunBy : public VariantRun {
 public:
  void find(Model& model, Workspace& work) override {
    if constexpr (requires { rules_.find(model, work); })
      rules_.find(model, work);
    else
      update_pairs(model, work);
  }
  dynamics::StepResult step(Model& model, Workspace& work) override {
    work.rule = &rules_;
    return dynamics::step(model, work);
  }

 private:
  Rules rules_;
};

template <class Signs>
void judge_signs(const Blocks& blocks, const PairIndex& index, SignTally& tally) {
  const auto judge = [&](int k, int e) {
    const Vec2 c = blocks.corner.col(k), p1 = blocks.corner.col(e);
    const Vec2 p2 = blocks.corner.col(blocks.next[e]);
    ++tally.areas;
    tally.wrong_areas +=
        Signs::overlap_sign(c, p1, p2) != geometry::exact::overlap_sign(c, p1, p2);
    for (const int n : {blocks.previous[k], blocks.next[k]}) {
      const Vec2 neighbour = blocks.corner.col(n);
      ++tally.tangents;
      // The reference uses the proved filter, because exact arithmetic alone is slow
      // for (20).
      tally.wrong_tangents += Signs::faces_edge(c, neighbour, p1, p2) !=
                              geometry::faces_edge(c, neighbour, p1, p2);
    }
  };
  const auto judge_all = [&](int own, int other) {
    for (int c = blocks.first_corner[own]; c < blocks.first_corner[own + 1]; ++c)
      for (int e = blocks.first_corner[other]; e < blocks.first_corner[other + 1]; ++e)
        judge(c, e);
  };
  for (const dynamics::NearPair& pair : index.pairs)
    judge_all(pair.low, pair.high), judge_all(pair.high, pair.low);
}

template <class Rules, class Signs = ExactSigns>
constexpr Variant variant(std::string_view name, std::string_view what,
                          Corners corners = Corners::sharp) {
  return {
      name, what, corners,
      []() -> std::unique_ptr<VariantRun> { return std::make_unique<RunBy<Rules>>(); },
      judge_signs<Signs>};
}

}  // namespace

const std::vector<Variant>& all_variants() {
  static const std::vector<Variant> all = {
      variant<dynamics::PairwiseRule>(
          "default", "the contact rule of every run: the least axis of a pair of "
                     "blocks whose side is surface of all blocks together"),
      // the contact rule without one of its parts
      variant<PairRules<RuleParts{.far_axes = false}>>(
          "no-far", "default, whether an axis is far or not"),
      variant<PairRules<without_third_parts>>(
          "no-joints", "default without third parts, as if pairs were alone"),
      variant<PairRules<RuleParts{.faces = false}>>(
          "no-faces", "default, but of two faces one corner acts, the deepest"),
      variant<PairRules<RuleParts{}, false>>(
          "no-hand-over", "default, but springs do not pass to other contacts"),
      // the rules of 1982
      variant<ReportRules, PrintedSigns>(
          "report", "the report's rules in doubles, (19) as printed"),
      // other corners, as in other codes
      variant<PairRules<without_third_parts>>(
          "chamfer", "no-joints; corners cut by 1 % of a side", Corners::chamfered),
      variant<PairRules<without_third_parts>>(
          "rounded", "no-joints; corners rounded over 1 % of a side", Corners::rounded),
      variant<PairRules<without_third_parts>>(
          "skin", "no-joints; outlines moved inwards by 0.1 % of the size",
          Corners::skinned),
  };
  return all;
}

const Variant* find_variant(std::string_view name) {
  for (const Variant& variant : all_variants())
    if (variant.name == name)
      return &variant;
  return nullptr;
}

}  // namespace blocks::study
