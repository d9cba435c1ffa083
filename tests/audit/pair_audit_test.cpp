// Scenes that are stepped with the contact rule of pairs, judged while they move.
#include "audit/pair_audit.hpp"

#include <gtest/gtest.h>

#include "audit/moments.hpp"
#include "audit/pair_words.hpp"
#include "study/variants.hpp"

namespace blocks {
namespace {

using audit::PairFindings;
using scenes::Scene;

/// Steps a scene by pairs and audits every so many steps.
PairFindings audited(Model& model, int steps, int every) {
  const study::Variant& by_pairs = *study::find_variant("pairs");
  dynamics::SearchBuffers buffers(1);
  dynamics::prepare(model);
  PairFindings sum;
  for (int i = 0; i < steps && sum.sound(); ++i) {
    by_pairs.find(model, buffers);
    const Blocks before = model.blocks;
    const double left = model.search.left;
    by_pairs.step(model, buffers);
    if (i % every != 0)
      continue;
    const PairFindings found = audit::audit_pairs(
        {before, model.contacts, model.settings, left}, audit::cut_into_parts(before));
    sum.pairs += found.pairs, sum.records += found.records, sum.acting += found.acting;
    sum.missed = found.missed, sum.wrong = found.wrong;
    if (!found.wrong.empty()) {
      const audit::WrongPair& wrong = found.wrong.front();
      ADD_FAILURE() << "step " << i << ": "
                    << audit::tell_wrong_pair(before, wrong.first, wrong.second,
                                              wrong.acting, wrong.exact);
    }
    if (!found.missed.empty()) {
      const audit::MissedPair& missed = found.missed.front();
      ADD_FAILURE() << "step " << i << ": the list misses corner " << missed.corner
                    << " on edge " << missed.edge << ", overlap " << missed.overlap
                    << (missed.acts ? ", which acts" : "");
    }
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

}  // namespace
}  // namespace blocks
