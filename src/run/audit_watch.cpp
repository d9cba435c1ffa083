#include "run/audit_watch.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "audit/audit.hpp"
#include "audit/words.hpp"

namespace blocks::run {
namespace {

/// More say no more.
constexpr std::size_t most_faults = 10;

}  // namespace

void AuditWatch::before(const Model& model) {
  blocks_ = model.blocks;
  // a list that is not current is made anew where the blocks now stand
  left_ = model.search.current ? model.search.left : model.settings.contact_tolerance;
}

AuditWatch::Verdict AuditWatch::after(const Model& model) {
  const audit::Findings found =
      audit::audit({blocks_, model.contacts, model.settings, left_});
  const long step = model.steps;
  const double time = model.time - model.time_step.dt;  // when it was decided
  ++totals_.moments;
  totals_.pairs += found.pairs, totals_.records += found.records;
  totals_.acting += found.acting, totals_.hanging += found.hanging;
  totals_.missed += static_cast<long>(found.missed.size());
  totals_.wrong += static_cast<long>(found.wrong.size());

  Verdict verdict;
  const auto fault = [&](const std::string& text, int corner, int block) {
    if (verdict.faults.size() == most_faults)
      return;
    verdict.faults.push_back(
        fmt::format("at time {:g} (step {}) audit: {}", time, step, text));
    const audit::ExactRules rules(blocks_, 2.0 * model.settings.contact_tolerance);
    for (const std::string& line : audit::story(rules, rules.decide(corner, block)))
      verdict.stories.push_back("  " + line);
  };
  for (const auto& missed : found.missed)
    fault(audit::tell(blocks_, missed), missed.corner,
          blocks_.corner_block[missed.edge]);
  for (const auto& wrong : found.wrong)
    fault(audit::tell(blocks_, wrong), wrong.corner, wrong.block);
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
        told_.try_emplace({excess.first, excess.second}, totals_.excess.size());
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
        told_deep_.try_emplace({deep.corner, deep.edge}, totals_.deep.size());
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
      "audit every {} steps: {} moments, {} pairs of a corner and a block, {} records "
      "due "
      "in the list, {} acting contacts; pairs missed: {}; wrong decisions: {}; decided "
      "by "
      "rounding at a closed joint: {}; pairs of blocks that overlap more than their "
      "contacts explain: {} (worst {:.3g}); contacts deeper than the overlap of their "
      "blocks: {} (worst {:.3g})",
      totals_.every, totals_.moments, totals_.pairs, totals_.records, totals_.acting,
      totals_.missed, totals_.wrong, totals_.hanging, totals_.excess.size(),
      totals_.worst.excess(), totals_.deep.size(), totals_.deepest.excess());
}

}  // namespace blocks::run
