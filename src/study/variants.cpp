#include "study/variants.hpp"

#include "dynamics/contact_loop.hpp"
#include "dynamics/contact_readings.hpp"
#include "dynamics/pair_step.hpp"
#include "dynamics/step.hpp"

namespace blocks::study {
namespace {

template <class Rules>
dynamics::Displacement step(Model& model, dynamics::SearchBuffers& buffers) {
  const dynamics::Extremes touching = dynamics::evaluate_contacts_by<Rules>(
      model.blocks, model.contacts, buffers.groups, model.settings, model.time_step.dt,
      *buffers.workers);
  dynamics::read_contacts(model.blocks, model.contacts, buffers.groups, model.settings,
                          model.time_step.dt);
  const dynamics::Displacement moved = dynamics::move(model, buffers, touching);
  dynamics::catch_up(model, buffers);
  return moved;
}

template <class Signs> void judge_signs(const Model& model, SignTally& tally) {
  const Blocks& blocks = model.blocks;
  const Contacts& contacts = model.contacts;
  for (int i = 0; i < contacts.size(); ++i) {
    const int k = contacts.corner[i], e = contacts.edge[i];
    const Vec2 c = blocks.corner.col(k), p1 = blocks.corner.col(e);
    const Vec2 p2 = blocks.corner.col(blocks.next[e]);
    ++tally.areas;
    tally.wrong_areas +=
        Signs::overlap_sign(c, p1, p2) != geometry::exact::overlap_sign(c, p1, p2);
    for (const int n : {blocks.previous[k], blocks.next[k]}) {
      const Vec2 neighbour = blocks.corner.col(n);
      ++tally.tangents;
      // judged with the filter, proved and tested: (20) is slow without
      tally.wrong_tangents += Signs::faces_edge(c, neighbour, p1, p2) !=
                              geometry::faces_edge(c, neighbour, p1, p2);
    }
  }
}

template <class Signs, Use use>
constexpr Variant variant(std::string_view name, std::string_view what,
                          Corners corners = Corners::sharp) {
  return {name,
          what,
          corners,
          [](Model& model, dynamics::SearchBuffers& buffers) {
            find_contacts(model, buffers, use.list, !use.nearest_edge);
          },
          step<VariantRules<Signs, use>>,
          judge_signs<Signs>};
}

/// Decided pair by pair.
struct NoEntry : dynamics::ExactPredicates {
  static constexpr bool entry = false;
};
struct NoCrossing : dynamics::ExactPredicates {
  static constexpr bool crossing = false;
};
struct NoJoints : dynamics::ExactPredicates {
  static constexpr bool covered_sides = false;
};
struct NoFaces : dynamics::ExactPredicates {
  static constexpr bool faces = false;
};
template <class Given> struct PairRules {
  using Predicates = Given;
  static constexpr bool keeps_decisions =
      std::is_same_v<Predicates, dynamics::ExactPredicates>;
};
template <class Predicates>
constexpr Variant by_pairs(std::string_view name, std::string_view what) {
  Variant run = variant<ExactSigns<Ends::slack>, Use{}>(name, what);
  run.find = dynamics::update_pairs;
  run.step = dynamics::step_by_pairs<PairRules<Predicates>>;
  return run;
}

/// The step of every run itself, its list already up to date.
constexpr Variant as_run(std::string_view name, std::string_view what) {
  Variant run = variant<ExactSigns<Ends::slack>, Use{}>(name, what);
  run.step = dynamics::step;
  return run;
}

using Exact = ExactSigns<Ends::slack>;
template <class Area> using Plain = PlainSigns<Area, Ends::slack>;

/// Ours, but every decision taken anew in every step.
constexpr Use ours = {};
/// Ours but for one rule.
constexpr Use no_facing = {.facing = false};
constexpr Use no_nearest = {.nearest_edge = false};
constexpr Use bare = {.far_edges_meet = false, .facing = false, .nearest_edge = false};
/// The shape of the corners, not (20), says which edge a corner can meet.
constexpr Use shaped = {.far_edges_meet = false, .facing = false, .shield = false};
constexpr Use no_meeting = {.far_edges_meet = false};
constexpr Use no_shield = {.shield = false};
constexpr Use no_hand_over = {.hands_over = false};
constexpr Use by_edge = {.whole_block = false};
constexpr Use kept_list = [] {
  Use use = report_rules;
  use.list = List::kept;
  return use;
}();

}  // namespace

const std::vector<Variant>& all_variants() {
  static const std::vector<Variant> all = {
      as_run("default", "the step of every run: exact, slack 1e-6, (20), meeting, "
                        "nearest edge, closed joints, hand-over"),
      by_pairs<dynamics::ExactPredicates>("pairs",
                                          "the first entered axis of a pair of blocks, "
                                          "or the surface of a closed joint "
                                          "that hides it"),
      by_pairs<NoEntry>("pairs-no-entry", "pairs, whether an axis is entered or not"),
      by_pairs<NoCrossing>("pairs-no-crossing",
                           "pairs, but only corners inside a block have entered it"),
      by_pairs<NoJoints>("pairs-no-joints", "pairs without what closed joints hide"),
      by_pairs<NoFaces>("pairs-no-faces",
                        "pairs, but of two faces one corner acts, the deepest"),
      // arithmetic
      variant<Plain<PrintedArea>, ours>(
          "printed",
          "default, but (19) as printed, in doubles and absolute coordinates"),
      variant<Plain<TranslatedArea<double>>, ours>(
          "double", "default, but plain doubles on differences of coordinates"),
      variant<Plain<TranslatedArea<long double>>, ours>(
          "long-double", "the same in long doubles (64 bits of mantissa)"),
      // ends of an edge
      variant<ExactSigns<Ends::strict>, ours>(
          "strict", "default, but without slack: on the limit is outside"),
      variant<ExactSigns<Ends::inclusive>, ours>(
          "inclusive", "default, but without slack: on the limit is inside"),
      variant<Exact, by_edge>(
          "edge", "default, but \"between\" asked of the edge, not of the whole block"),
      // rules left out
      variant<Exact, no_facing>("no-20", "default without (20)"),
      variant<Exact, no_nearest>("no-nearest", "default without the nearest edge"),
      variant<Exact, bare>("bare", "default without (20), nearest edge and meeting"),
      variant<Exact, no_meeting>(
          "no-meeting", "default, but far edges also act on blocks that do not "
                        "reach them"),
      variant<Exact, no_shield>("no-shield", "default without what closed joints hide"),
      variant<Exact, no_hand_over>("no-hand-over", "default without hand-over"),
      // 1982
      variant<PlainSigns<PrintedArea, Ends::inclusive>, report_rules>(
          "report", "the report's rules in doubles, (19) as printed"),
      variant<ExactSigns<Ends::inclusive>, report_rules>(
          "report-exact", "the report's rules decided exactly"),
      variant<ExactSigns<Ends::inclusive>, kept_list>(
          "keep", "report-exact, and a pair once listed stays for ever"),
      // other codes: other corners instead of (20)
      variant<Exact, shaped>("chamfer",
                             "no-20, no joints; corners cut by 1 % of a side",
                             Corners::chamfered),
      variant<Exact, shaped>("rounded", "the same; corners rounded over 1 % of a side",
                             Corners::rounded),
      variant<Exact, shaped>("skin",
                             "the same; outlines moved inwards by 0.1 % of the size",
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
