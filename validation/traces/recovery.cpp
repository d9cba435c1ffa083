#include "validation/traces/recovery.hpp"

#include "joints/set_fit.hpp"

namespace blocks::validation {
namespace {

using geometry::SpacingLaw;
using joints::Estimate;
using joints::SetFit;
using joints::testing::SetNumbers;

struct Field {
  const char* name;
  Estimate SetFit::*fitted;
  double SetNumbers::*given;
};
constexpr Field fields[] = {{"dip", &SetFit::dip, &SetNumbers::dip},
                            {"ddev", &SetFit::ddev, &SetNumbers::ddev},
                            {"space", &SetFit::space, &SetNumbers::space},
                            {"sdev", &SetFit::sdev, &SetNumbers::sdev},
                            {"trace", &SetFit::trace, &SetNumbers::trace},
                            {"tdev", &SetFit::tdev, &SetNumbers::tdev},
                            {"gap", &SetFit::gap, &SetNumbers::gap},
                            {"gdev", &SetFit::gdev, &SetNumbers::gdev}};

}  // namespace

// The starts are outside of the window, except for joints that turn about them.
std::vector<RecoveryCase> recovery_cases() {
  return {{"run through, UNIFORM",
           {{30, 0, 2, .5, 0, 0, 0, 0, -25, 10}, {110, 0, 3, 1, 0, 0, 0, 0, 60, -10}}},
          {"run through, NEGEXP",
           {{30, 0, 2, 0, 0, 0, 0, 0, -25, 10, SpacingLaw::negexp},
            {110, 0, 3, 0, 0, 0, 0, 0, 60, -10, SpacingLaw::negexp}}},
          {"run through, turned",
           {{30, 3, 2, .5, 0, 0, 0, 0, 20, 15}, {110, 3, 3, 1, 0, 0, 0, 0, 20, 15}}},
          {"traces",
           {{30, 0, 2, .5, 8, 2, 2, 1, -25, 10}, {110, 0, 3, 1, 6, 3, 3, 2, 60, -10}}},
          {"traces, turned",
           {{30, 4, 2, .5, 8, 2, 2, 1, -25, 10}, {110, 4, 3, 1, 6, 3, 3, 2, 60, -10}}}};
}

Recovery recover(const RecoveryCase& one, int maps) {
  Recovery found;
  found.maps = maps;
  for (std::size_t k = 0; k < one.sets.size(); ++k)
    for (const Field& field : fields)
      found.fields.push_back(
          {field.name, static_cast<int>(k) + 1, one.sets[k].*field.given, 0.0, 0});
  for (int seed = 1; seed <= maps; ++seed) {
    std::vector<geometry::JointSet> sets;
    for (const SetNumbers& numbers : one.sets)
      sets.push_back(joints::testing::joint_set(numbers));
    const joints::NetworkFit fit = joints::fit_sets(joints::network_of(
        joints::testing::generated(joints::testing::rectangle(40.0, 30.0), sets,
                                   static_cast<unsigned>(seed))));
    if (fit.sets.size() != one.sets.size())
      continue;
    ++found.right;
    std::size_t row = 0;
    for (std::size_t k = 0; k < one.sets.size(); ++k) {
      found.laws += fit.sets[k].law == one.sets[k].law ? 1 : 0;
      for (const Field& field : fields) {
        const Estimate& estimate = fit.sets[k].*field.fitted;
        RecoveredField& sum = found.fields[row++];
        sum.mean += estimate.value;
        sum.covered += estimate.low <= sum.given && sum.given <= estimate.high ? 1 : 0;
      }
    }
  }
  for (RecoveredField& field : found.fields)
    field.mean /= found.right;
  return found;
}

}  // namespace blocks::validation
