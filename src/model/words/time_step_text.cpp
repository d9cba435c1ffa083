#include "model/words/time_step_text.hpp"

#include <fmt/format.h>

#include "model/safe_fraction.hpp"

namespace blocks {

std::string limit_in_words(const TimeStep& step, const std::string& elasticity) {
  if (step.pieces)
    return (step.elastic ? "the " + elasticity : "contact") + " of a piece of it";
  return step.elastic ? "its " + elasticity : "contact";
}

std::string limit_in_words(const TimeStep& step, const Settings& settings) {
  std::string text = limit_in_words(step);
  if (chooses_fraction(settings) && !step.elastic)
    text += ", largest safe step with " + damping_in_words(settings);
  return text;
}

std::string damping_in_words(const Settings& settings) {
  return fmt::format("DAMPING {:g}", settings.damping) +
         (settings.local_damping > 0.0
              ? fmt::format(" and LOCDAMP {:g}", settings.local_damping)
              : "");
}

}  // namespace blocks
