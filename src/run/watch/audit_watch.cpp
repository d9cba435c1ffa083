#include "run/watch/audit_watch.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "audit/make_exact_rule.hpp"
#include "audit/story.hpp"
#include "audit/words.hpp"
#include "dynamics/search/list_tolerance.hpp"
#include "text/counted.hpp"

namespace blocks::run {
namespace {

/// The largest number of faults reported for one step. More of them give the user no
/// further information.
constexpr std::size_t max_faults = 10;

}  // namespace

void AuditWatch::before(const Model& model) {
  blocks_ = model.blocks;
  held_ = audit::held_contacts(model);
  // If the present list is not current, the step makes a new one first.
  left_ = model.search.current ? model.search.left : dynamics::list_tolerance(model);
}

AuditWatch::Verdict AuditWatch::after(const Model& model,
                                      std::vector<audit::BlockPair> listed) {
  const double time = model.time - model.time_step.dt;  // of the decision
  const audit::Moment moment{blocks_,
                             model.contacts,
                             model.settings,
                             left_,
                             std::move(listed),
                             model.order,
                             held_,
                             model.law_states,
                             model.kept,
                             model.plane_contacts,
                             model.loads.water,
                             time};
  const audit::Findings found = audit::audit(moment);
  const long step = model.steps;
  ++totals_.moments;
  totals_.pairs += found.pairs, totals_.acting += found.acting;
  totals_.missed += static_cast<long>(found.missed.size());
  totals_.wrong += static_cast<long>(found.wrong.size());
  totals_.wrong_at_planes += static_cast<long>(found.wrong_at_planes.size());
  totals_.late += found.late;

  Verdict verdict;
  const auto report = [&](const std::string& text) {
    if (verdict.faults.size() == max_faults)
      return false;
    verdict.faults.push_back(
        fmt::format("at time {:g} (step {}) audit: {}", time, step, text));
    return true;
  };
  const auto fault = [&](const std::string& text, int first, int second) {
    if (!report(text))
      return;
    const audit::ExactPairRule rule =
        audit::make_exact_rule(blocks_, 0.0, moment.order);
    for (const std::string& line :
         audit::story(rule, first, second, rule.decide(first, second)))
      verdict.stories.push_back("  " + line);
  };
  for (const audit::BlockPair& missed : found.missed)
    fault(audit::tell(missed), missed.first, missed.second);
  for (const audit::WrongPair& wrong : found.wrong)
    fault(audit::tell(blocks_, wrong), wrong.first, wrong.second);
  for (const audit::PlaneFault& wrong : found.wrong_at_planes)
    report(audit::tell(blocks_, wrong));
  if (const audit::BehindPlane& now = found.behind; now.depth > totals_.behind.depth) {
    const int b = blocks_.corner_block[now.corner];
    totals_.behind = {now.plane,  b,    now.corner - blocks_.first_corner[b],
                      step,       time, now.depth,
                      now.pressed};
  }
  if (found.water.block >= 0 &&
      (!totals_.water.tested || found.water.share > totals_.water.share))
    totals_.water = {found.water.block, step, time, found.water.share, true};
  totals_.faults.insert(totals_.faults.end(), verdict.faults.begin(),
                        verdict.faults.end());

  const auto record = [&](const audit::ExcessOverlap& pair) {
    return AuditedOverlap{pair.first, pair.second,    step,        time,
                          pair.depth, pair.explained, pair.pressed};
  };
  if (found.worst.excess() > totals_.worst.excess())
    totals_.worst = record(found.worst);
  for (const auto& excess : found.excess) {
    const AuditedOverlap here = record(excess);
    const auto [at, fresh] =
        reported_.try_emplace({excess.first, excess.second}, totals_.excess.size());
    if (fresh) {
      totals_.excess.push_back(here);
      verdict.overlaps.push_back(fmt::format("at time {:g} (step {}) audit: {}", time,
                                             step, audit::tell(excess)));
    } else if (AuditedOverlap& worst = totals_.excess[at->second];
               excess.excess() > worst.excess()) {
      worst = here;
    }
  }
  const auto record_contact = [&](const audit::DeepContact& deep) {
    const int a = blocks_.corner_block[deep.corner],
              b = blocks_.corner_block[deep.edge];
    return AuditedContact{a,
                          deep.corner - blocks_.first_corner[a],
                          b,
                          deep.edge - blocks_.first_corner[b],
                          step,
                          time,
                          deep.overlap,
                          deep.common,
                          deep.pressed};
  };
  if (found.deepest.excess() > totals_.deepest.excess())
    totals_.deepest = record_contact(found.deepest);
  for (const auto& deep : found.deep) {
    const AuditedContact here = record_contact(deep);
    const auto [at, fresh] =
        reported_deep_.try_emplace({deep.corner, deep.edge}, totals_.deep.size());
    if (fresh) {
      totals_.deep.push_back(here);
      verdict.deep.push_back(fmt::format("at time {:g} (step {}) audit: {}", time, step,
                                         audit::tell(blocks_, deep)));
    } else if (AuditedContact& worst = totals_.deep[at->second];
               here.excess() > worst.excess()) {
      worst = here;
    }
  }
  return verdict;
}

std::string AuditWatch::closing() const {
  return fmt::format(
      "audit every {}: {}, {} of blocks near each other, {}; pairs missed: {}; wrong "
      "decisions: {}; kept decisions that would differ now: {}; pairs of blocks that "
      "overlap "
      "more than their contacts explain: {} (worst {:.3g}); contacts deeper than the "
      "overlap of their blocks: {} (worst {:.3g}){}{}",
      counted(totals_.every, "step"), counted(totals_.moments, "audit"),
      counted(totals_.pairs, "pair"), counted(totals_.acting, "acting contact"),
      totals_.missed, totals_.wrong, totals_.late, totals_.excess.size(),
      totals_.worst.excess(), totals_.deep.size(), totals_.deepest.excess(),
      totals_.behind.depth > 0.0 || totals_.wrong_at_planes > 0
          ? fmt::format(
                "; wrong contacts with symmetry planes: {}; deepest corner behind "
                "one: {:.3g}",
                totals_.wrong_at_planes, totals_.behind.depth)
          : "",
      totals_.water.tested
          ? fmt::format("; largest error of a force of water: {:.1g} of the weight of "
                        "water in place of the block",
                        totals_.water.share)
          : "");
}

}  // namespace blocks::run
