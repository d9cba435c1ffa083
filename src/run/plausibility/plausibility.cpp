#include "run/plausibility/plausibility.hpp"

#include <iterator>

#include "run/plausibility/card_doubts.hpp"
#include "run/plausibility/domain_check.hpp"
#include "run/plausibility/physics_check.hpp"
#include "run/plausibility/plane_check.hpp"

namespace blocks::run {
namespace {

constexpr PlausibilityRule rules[] = {
    {"friction-in-degrees",
     "fric of FRICTN or JOINT is above 5, the tangent of 79 degrees",
     "give the tangent of the friction angle", Moment::card, false, doubt_friction},
    {"weight-of-water", "gamma of WATER over gravity is not near the density of water",
     "give gamma in the units of the deck, after GRAVITY", Moment::card, false,
     doubt_water},
    {"outline-crosses-blocks", "the outline of REMOVE or FREE crosses blocks",
     "draw it wider or narrower, along joints", Moment::card, false, doubt_outline},
    {"outside-domain", "a free block reaches beyond XLIMITS or YLIMITS",
     "make the domain wider, or fix the block", Moment::motion, false,
     doubt_outside_domain},
    {"edge-of-domain", "a free block reaches to XLIMITS or YLIMITS, up to rounding",
     "make the domain wider, or fix the block", Moment::motion, false,
     doubt_edge_of_domain},
    {"behind-plane", "a free block is wholly or partly behind a plane of SPLANE",
     "move the plane, or swap its points", Moment::motion, false, doubt_behind_plane},
    {"soft-contacts",
     "the heaviest column overlaps its support by over 5 % of its width",
     "raise stifn of STIFF", Moment::motion, true, doubt_stiffness},
    {"stiff-contacts",
     "the heaviest column overlaps its support by less than 2^-18 of its width",
     "lower stifn of STIFF", Moment::motion, true, doubt_overlap},
    {"soft-blocks", "the heaviest column compresses its lowest block by over 5 %",
     "raise E of MATERIAL, or make the blocks rigid", Moment::motion, true,
     doubt_modulus},
    {"large-ctol", "ctol of BOXES is more than the width of the narrowest free block",
     "give ctol as a tenth of a block", Moment::motion, true, doubt_tolerance},
    {"tiny-block", "a free block has less than a millionth of the median area",
     "remove it with emin and amin of CUT, or MERGE", Moment::motion, true,
     doubt_tiny_block},
    {"coarse-step", "FRACTION is blank, and there is no DAMPING or LOCDAMP",
     "give a FRACTION of .02 or less, or damping", Moment::motion, true, doubt_step},
    {"strength-without-bond",
     "coh or ten of JOINT exceeds its residual value, and no BOND names the id",
     "add BOND, or give equal residual values", Moment::end, false, doubt_strength},
    {"endless-ramp", "the deck ends before the ramp of GRAVITY or WATER does",
     "let the deck last longer, or shorten tramp", Moment::end, false, doubt_ramp},
    {"idle-mscale", "no SOLVE or FOS follows MSCALE", "add SOLVE, or leave MSCALE out",
     Moment::end, false, doubt_scaling},
    {"no-motion", "a new deck has no MOTION, CYCLE or SOLVE", "add one", Moment::end,
     false, doubt_motion},
};

}  // namespace

std::span<const PlausibilityRule> plausibility_rules() { return rules; }

void Plausibility::test(Moment moment, const Plan& plan, const deck::Command& at,
                        deck::Diagnostics& diagnostics) {
  for (const PlausibilityRule& rule : rules) {
    if (rule.moment != moment || reported_.contains(rule.name))
      continue;
    for (const Doubt& doubt : rule.doubts(plan)) {
      diagnostics.warning(doubt.where.value_or(at.where),
                          doubt.where ? doubt.card : at.name, doubt.message,
                          doubt.hint);
      if (rule.once)
        reported_.insert(rule.name);
    }
  }
}

}  // namespace blocks::run
