#include "dynamics/decide_contacts.hpp"

#include <algorithm>
#include <utility>

#include "dynamics/workspace.hpp"
#include "geometry/contact_predicates.hpp"

namespace blocks::dynamics {
namespace {

/// Two blocks nearer than this part of the shorter longest arm get slots before they
/// touch. In a pile that falls, the arrays are then rebuilt five times less often.
constexpr double near_share = 0.1;

/// Decisions are made for so many pairs at once. Their memory is then small even in the
/// first step, which decides all pairs.
constexpr std::size_t due_at_once = 4096;

/// Finds the first pairs of the half-open range [begin, end) whose decisions have
/// expired. Returns the first pair that has not been examined.
int find_due(const Blocks& blocks, Workspace& work, int begin, int end,
             std::vector<int>& due) {
  Decisions& decisions = work.decisions;
  const bool keeps = work.rule->options.keeps_decisions;
  const double longest_path = decisions.bounds.longest_path;
  due.clear();
  int p = begin;
  for (; p < end && due.size() < due_at_once; ++p)
    if (!keeps || !(longest_path < decisions.next_check[p] ||
                    decisions.holds(blocks, work.parts, work.index.pairs[p], p)))
      due.push_back(p);
  return p;
}

/// Decides the due pairs of a thread. A decision is kept while it certainly holds, or
/// until its renewal, or for this step alone.
void decide_due(const Blocks& blocks, Workspace& work, DecisionThread& thread) {
  const PairIndex& index = work.index;
  Decisions& decisions = work.decisions;
  const bool keeps = work.rule->options.keeps_decisions;
  if (keeps)
    thread.certain.find(blocks, work.parts, index, decisions, thread.due);
  for (std::size_t k = 0; k < thread.due.size(); ++k) {
    const int p = thread.due[k];
    if (keeps && thread.certain[k].validity > 0.0) {
      const CertainDecision& decision = thread.certain[k];
      decisions.keep_certain(blocks, index.pairs[p], p, decision.validity,
                             decision.growth);
      work.contacts.assign(blocks, index, p, decision.contacts, true, thread.changes);
      continue;
    }
    work.rule->decide(blocks, work.parts, index, p, thread.scratch);
    const PairScratch& scratch = thread.scratch;
    const bool is_kept = keeps && scratch.may_be_kept;
    work.contacts.assign(blocks, index, p, is_kept ? scratch.candidates : scratch.found,
                         is_kept, thread.changes);
    if (is_kept)
      decisions.keep_exact(blocks, work.parts, index, p, scratch.depths,
                           scratch.asked_of_third);
    else
      decisions.expire(p);
  }
}

/// Takes the springs that the threads have released, and counts exact questions.
/// Returns whether pairs have outgrown their slots.
bool join_threads(Workspace& work) {
  bool has_grown = false;
  for (DecisionThread& thread : work.deciding) {
    std::vector<ReleasedSpring>& released = thread.changes.released;
    work.forces.transfer.released.insert(work.forces.transfer.released.end(),
                                         released.begin(), released.end());
    released.clear();
    has_grown = has_grown || !thread.changes.grown.pair.empty();
    if (const auto calls = std::exchange(thread.exact_calls, 0);
        work.profile != nullptr)
      work.profile->exact_calls += calls;
  }
  return has_grown;
}

/// Takes the contacts of pairs that have outgrown their slots from the threads.
ContactsOfPairs take_grown(Workspace& work) {
  ContactsOfPairs all;
  for (DecisionThread& thread : work.deciding)
    all.append(std::exchange(thread.changes.grown, {}));
  return all;
}

/// Gives slots to pairs that have none and may touch soon.
void expect_contacts(Workspace& work) {
  const std::vector<double>& longest = work.decisions.bounds.longest;
  for (int p = 0; p < work.index.size(); ++p) {
    const auto [low, high] = work.index.pairs[p];
    const double apart = work.decisions.pairs[p].validity.distance;
    if (work.contacts.slots_of_pair[p] == 0 && apart > 0.0 &&
        apart < near_share * std::min(longest[low], longest[high]))
      work.contacts.slots_of_pair[p] = ContactArrays::contacts_of_two_faces;
  }
}

}  // namespace

void decide_contacts(const Model& model, Workspace& work) {
  const Blocks& blocks = model.blocks;
  const auto pairs_until = [&](int window) {
    return std::min(work.index.size(), window * pairs_of_window);
  };
  // A window is decided by one thread, so no other thread writes to its batches.
  work.workers->each(work.split.windows, [&](int k, int begin, int end) {
    DecisionThread& thread = work.deciding[k];
    const unsigned long long before = geometry::exact::calls();
    for (int next = pairs_until(begin); next < pairs_until(end);) {
      next = find_due(blocks, work, next, pairs_until(end), thread.due);
      decide_due(blocks, work, thread);
    }
    thread.exact_calls += geometry::exact::calls() - before;
  });
  if (!join_threads(work))
    return;
  expect_contacts(work);
  const ContactsOfPairs grown = take_grown(work);
  ContactsOfPairs kept;
  work.contacts.copy_contacts(kept);
  work.contacts.make(blocks, model.settings, work.index, kept, grown);
  work.split.split_batches(work.contacts.first_batch);
}

}  // namespace blocks::dynamics
