#include "run/watch/crack_watch.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "text/counted.hpp"

namespace blocks::run {
namespace {

/// What the user can do about a refusal.
const char* advice(CrackRefusal why) {
  switch (why) {
  case CrackRefusal::small:
  case CrackRefusal::thin:
    return "a smaller amin of CRACK gives smaller pieces and shorter time steps";
  case CrackRefusal::corners:
    return "raise ncmax of START";
  case CrackRefusal::full:
    return "raise nblokm of START";
  case CrackRefusal::unsound:
    return "the block stays whole in this step";
  }
  return "";
}

/// Returns three lines on one crack, of at most 132 columns: "at time 0.00057 (step 60)
/// block 4 split into 4 and 9 (stress 1e+06)", the cut with its areas, and the
/// energies.
std::string crack_lines(const CrackRecord& crack) {
  return fmt::format(
      "at time {:g} (step {}) block {} split into {} and {} ({} {:g})\n"
      "  cut from ({:g}, {:g}) to ({:g}, {:g}), angle {:g} degrees; areas {:g} and "
      "{:g}\n"
      "  energy released {:g}: kinetic {:g} to {:g}, strain {:g} to {:g}",
      crack.time, crack.step, crack.parent + 1, crack.parent + 1, crack.child + 1,
      crack.cause == CrackCause::stress ? "stress" : "point loads, stress",
      crack.stress, crack.from.x(), crack.from.y(), crack.to.x(), crack.to.y(),
      crack.angle(), crack.parent_area, crack.child_area, crack.released(),
      crack.kinetic_before, crack.kinetic_after, crack.strain_before,
      crack.strain_after);
}

}  // namespace

CrackNews CrackWatch::take_news(const Model& model) {
  CrackNews news;
  for (; reported_cracks_ < model.cracks.size(); ++reported_cracks_)
    news.cracks.push_back(crack_lines(model.cracks[reported_cracks_]));
  if (model.crack_refusals.size() == reported_refusals_.size())
    return news;
  for (int i = 0; i < crack_refusals; ++i) {
    const auto why = static_cast<CrackRefusal>(i);
    if (count_refused(reported_refusals_, why) > 0 ||
        count_refused(model.crack_refusals, why) == 0)
      continue;
    const auto first =
        std::find_if(model.crack_refusals.begin(), model.crack_refusals.end(),
                     [&](const RefusedCrack& refused) { return refused.why == why; });
    news.warnings.push_back(fmt::format("at time {:g} (step {}) block {} reached its "
                                        "strength but did not split: {}; {} "
                                        "(told once; the summary counts such blocks)",
                                        model.time, model.steps, first->block + 1,
                                        describe(why), advice(why)));
  }
  reported_refusals_ = model.crack_refusals;
  return news;
}

std::string cracks_line(const Model& model) {
  const auto by_stress = static_cast<std::size_t>(std::count_if(
      model.cracks.begin(), model.cracks.end(),
      [](const CrackRecord& crack) { return crack.cause == CrackCause::stress; }));
  std::string text = fmt::format("{} ({} by stress, {} by point loads)",
                                 counted(model.cracks.size(), "crack"), by_stress,
                                 model.cracks.size() - by_stress);
  for (int i = 0; i < crack_refusals; ++i) {
    const auto why = static_cast<CrackRefusal>(i);
    if (const std::size_t refused = count_refused(model.crack_refusals, why))
      text += fmt::format("; {} did not split at first: {}", counted(refused, "block"),
                          describe(why));
  }
  return text;
}

}  // namespace blocks::run
