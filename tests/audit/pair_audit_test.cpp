// Scenes that are stepped with the contact rule of pairs, judged while they move.
#include "audit/pair_audit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "audit/clusters.hpp"
#include "audit/moments.hpp"
#include "audit/pair_words.hpp"
#include "dynamics/pair_step.hpp"
#include "model/contact_blocks.hpp"
#include "study/draft.hpp"

namespace blocks {
namespace {

using audit::PairFindings;
using scenes::Scene;

/// Steps a scene by pairs and audits every so many steps.
PairFindings audited(Model& model, int steps, int every) {
  dynamics::SearchBuffers buffers(1);
  dynamics::prepare(model);
  PairFindings sum;
  for (int i = 0; i < steps && sum.sound(); ++i) {
    dynamics::update_pairs(model, buffers);
    const Blocks before = model.blocks;
    const double left = model.search.left;
    dynamics::step_by_pairs<dynamics::ContactRules>(model, buffers);
    if (i % every != 0)
      continue;
    std::vector<std::pair<int, int>> listed;
    for (const dynamics::NearPair& pair : buffers.pairs.pairs)
      listed.emplace_back(pair.low, pair.high);
    const PairFindings found =
        audit::audit_pairs({before, model.contacts, model.settings, left},
                           audit::cut_into_parts(before), listed);
    sum.pairs += found.pairs, sum.acting += found.acting;
    sum.missed = found.missed, sum.wrong = found.wrong;
    if (!found.wrong.empty()) {
      const audit::WrongPair& wrong = found.wrong.front();
      ADD_FAILURE() << "step " << i << ": "
                    << audit::tell_wrong_pair(before, wrong.first, wrong.second,
                                              wrong.acting, wrong.exact);
    }
    if (!found.missed.empty())
      ADD_FAILURE() << "step " << i << ": the list misses blocks "
                    << found.missed.front().first + 1 << " and "
                    << found.missed.front().second + 1;
  }
  return sum;
}

// The list, the decisions and what acts agree with the judge in rubble of any frame.
TEST(PairAudit, RubbleIsClean) {
  long acting = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE(seed);
    Scene scene = testing::rubble(seed);
    acting += audited(scene.model, 1500, 50).acting;
  }
  EXPECT_GT(acting, 1000);
}

/// Contacts that act deeper than 5 % of the size of the smaller block.
long deep_contacts(const Model& model) {
  const Blocks& blocks = model.blocks;
  long deep = 0;
  for (const ActingContact& contact : model.contacts.acting) {
    const auto [a, b] = pair_of(blocks, model.contacts, contact.record);
    deep +=
        contact.overlap > 0.05 * std::sqrt(std::min(blocks.area[a], blocks.area[b]));
  }
  return deep;
}

// Blocks that overlap deeply from the start have exactly the contacts that the judge
// decides.
TEST(PairAudit, DeepOverlapsAreClean) {
  PairFindings sum;
  long deep = 0;
  for (int k = 0; k < 2000; ++k) {
    SCOPED_TRACE(k);
    Model model = study::scenes::Draft("cluster", "", 0).model();
    model.settings.lower = {-200, -200}, model.settings.upper = {200, 200};
    testing::Clusters clusters(static_cast<std::uint64_t>(k));
    model.blocks.append(clusters.make(k % testing::Clusters::kinds));
    if (model.blocks.size() < 2)
      continue;
    const PairFindings found = audited(model, 1, 1);
    sum.pairs += found.pairs, sum.acting += found.acting;
    deep += deep_contacts(model);
  }
  EXPECT_GT(sum.pairs, 5000);
  EXPECT_GT(sum.acting, 5000);
  EXPECT_GT(deep, 2000);
  RecordProperty("pairs", std::to_string(sum.pairs));
  RecordProperty("acting", std::to_string(sum.acting));
  RecordProperty("deep", std::to_string(deep));
}

}  // namespace
}  // namespace blocks
