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

AuditedOverlap overlap_of(const audit::ExcessOverlap& pair, long step, double time) {
  return {pair.first, pair.second,    step,        time,
          pair.depth, pair.explained, pair.pressed};
}

AuditedContact contact_of(const Blocks& blocks, const audit::DeepContact& deep,
                          long step, double time) {
  const int a = blocks.corner_block[deep.corner], b = blocks.corner_block[deep.edge];
  return {a,
          deep.corner - blocks.first_corner[a],
          b,
          deep.edge - blocks.first_corner[b],
          step,
          time,
          deep.overlap,
          deep.common,
          deep.pressed};
}

/// Returns whether no audit before has recorded this pair of indices. Of several
/// records of a pair, the worst is kept.
template <class Record>
bool is_new(std::pair<int, int> pair, const Record& here,
            std::map<std::pair<int, int>, std::size_t>& known,
            std::vector<Record>& records) {
  const auto [at, fresh] = known.try_emplace(pair, records.size());
  if (fresh)
    records.push_back(here);
  else if (Record& worst = records[at->second]; here.excess() > worst.excess())
    worst = here;
  return fresh;
}

}  // namespace

void AuditWatch::keep_start(const Model& model) {
  blocks_ = model.blocks;
  held_ = audit::held_contacts(model);
  // If the present list is not current, the step makes a new one first.
  left_ = model.search.current ? model.search.left : dynamics::list_tolerance(model);
}

AuditWatch::Verdict AuditWatch::audit_step(const Model& model,
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
  count(found);
  keep_worst(found, model.steps, time);
  Verdict verdict;
  add_faults(found, moment.order, verdict);
  for (const audit::ExcessOverlap& pair : found.excess)
    if (is_new({pair.first, pair.second}, overlap_of(pair, model.steps, time),
               reported_, totals_.excess))
      verdict.overlaps.push_back(audit::tell(pair));
  for (const audit::DeepContact& deep : found.deep)
    if (is_new({deep.corner, deep.edge}, contact_of(blocks_, deep, model.steps, time),
               reported_deep_, totals_.deep))
      verdict.deep.push_back(audit::tell(blocks_, deep));
  for (auto* texts : {&verdict.faults, &verdict.overlaps, &verdict.deep})
    for (std::string& text : *texts)
      text = fmt::format("at time {:g} (step {}) audit: {}", time, model.steps, text);
  totals_.faults.insert(totals_.faults.end(), verdict.faults.begin(),
                        verdict.faults.end());
  return verdict;
}

void AuditWatch::count(const audit::Findings& found) {
  ++totals_.moments;
  totals_.pairs += found.pairs, totals_.acting += found.acting;
  totals_.missed += static_cast<long>(found.missed.size());
  totals_.wrong += static_cast<long>(found.wrong.size());
  totals_.wrong_at_planes += static_cast<long>(found.wrong_at_planes.size());
  totals_.late += found.late;
}

void AuditWatch::keep_worst(const audit::Findings& found, long step, double time) {
  if (const audit::BehindPlane& now = found.behind; now.depth > totals_.behind.depth) {
    const int b = blocks_.corner_block[now.corner];
    totals_.behind = {now.plane,  b,    now.corner - blocks_.first_corner[b],
                      step,       time, now.depth,
                      now.pressed};
  }
  if (found.water.block >= 0 &&
      (!totals_.water.tested || found.water.share > totals_.water.share))
    totals_.water = {found.water.block, step, time, found.water.share, true};
  if (found.worst.excess() > totals_.worst.excess())
    totals_.worst = overlap_of(found.worst, step, time);
  if (found.deepest.excess() > totals_.deepest.excess())
    totals_.deepest = contact_of(blocks_, found.deepest, step, time);
}

void AuditWatch::add_faults(const audit::Findings& found, const std::vector<int>& order,
                            Verdict& verdict) const {
  const auto add = [&](const std::string& text) {
    if (verdict.faults.size() == max_faults)
      return false;
    verdict.faults.push_back(text);
    return true;
  };
  const auto add_pair = [&](const std::string& text, int first, int second) {
    if (!add(text))
      return;
    const audit::ExactPairRule rule = audit::make_exact_rule(blocks_, 0.0, order);
    for (const std::string& line :
         audit::story(rule, first, second, rule.decide(first, second)))
      verdict.stories.push_back("  " + line);
  };
  for (const audit::BlockPair& missed : found.missed)
    add_pair(audit::tell(missed), missed.first, missed.second);
  for (const audit::WrongPair& wrong : found.wrong)
    add_pair(audit::tell(blocks_, wrong), wrong.first, wrong.second);
  for (const audit::PlaneFault& wrong : found.wrong_at_planes)
    add(audit::tell(blocks_, wrong));
}

std::string AuditWatch::summary() const {
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
