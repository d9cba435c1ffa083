// OUTPUT, PLOTS and HISTORY.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <string_view>

#include "dynamics/preparation/time_step.hpp"
#include "quantities/curve_values.hpp"
#include "run/builder/cards.hpp"
#include "run/builder/checks.hpp"
#include "run/builder/names.hpp"
#include "run/builder/selectors.hpp"

namespace blocks::run {
namespace {

using quantities::CurveFault;

std::string hint_for(const CurveFault& fault) {
  if (fault.unknown.empty())
    return fault.hint;
  const std::string near = quantities::nearest_quantity(fault.unknown, {"ke"});
  return near.empty() ? "quantities: " + quantities::block_quantity_names()
                      : "did you mean '" + near + "'?";
}

/// A quantity of the card and its place in the deck.
struct NamedCurve {
  quantities::Curve curve;
  deck::SourceLocation where;
};

/// Returns the quantities of a HISTORY card, or the usual ones if it names none.
/// Reports quantities that cannot be read or are named twice.
std::vector<NamedCurve> named_curves(const deck::Command& command,
                                     deck::Diagnostics& diagnostics) {
  const auto& card = std::get<deck::History>(command.card);
  std::vector<NamedCurve> curves;
  if (card.quantities.empty())
    for (const char* usual : quantities::usual_curves)
      curves.push_back({quantities::parse_curve(usual), command.where});
  std::map<std::string, std::vector<deck::SourceLocation>> places;
  for (const deck::Word& word : card.quantities) {
    try {
      NamedCurve named{quantities::parse_curve(word.value), word.where};
      places[named.curve.name()].push_back(word.where);
      curves.push_back(std::move(named));
    } catch (const CurveFault& fault) {
      diagnostics.error(word.where, command.name, fault.what(), hint_for(fault));
    }
  }
  for (const auto& [name, at] : places)
    if (at.size() > 1)
      diagnostics.error(
          at[1], command.name,
          fmt::format("{} is named {}", name,
                      at.size() == 2 ? "twice" : fmt::format("{} times", at.size())),
          "name every quantity once");
  return curves;
}

using By = deck::Selector::By;

/// Returns the place of a quantity with numbers; empty after an error.
std::string place_of(const Context& context, deck::SourceLocation where,
                     const deck::Selector& selector) {
  if (selector.by == By::material)
    return "material=" + selector.material;
  if (selector.by == By::joint)
    return fmt::format("joint={:g}", selector.numbers[0].value());
  if (selector.by == By::nearest) {
    const auto found = select_corner(context, where, selector);
    return found ? fmt::format("{}.{}", context.state.numbers.number_of(found->block),
                               found->corner + 1)
                 : std::string();
  }
  if (selector.is_of_sides()) {
    context.error(where,
                  fmt::format("{} names sides, which have no history", selector.text),
                  fmt::format("blocks: {}; a corner: nearest(x, y); a joint: "
                              "joint(id)",
                              deck::block_selectors));
    return {};
  }
  const std::vector<int> chosen = select_blocks(context, where, selector);
  if (chosen.empty())
    return {};
  if (selector.by == By::at)
    return std::to_string(chosen.front() + 1);
  return quantities::place_of_blocks(chosen);
}

/// Returns the HISTORY card with numbers instead of selectors.
deck::Command with_numbers(const Context& context) {
  deck::Command out = context.command;
  auto& words = std::get<deck::History>(out.card).quantities;
  const bool any = !words.empty();
  for (deck::Word& word : words) {
    const std::size_t colon = word.value.find(':'), close = word.value.find(')');
    const std::string place =
        colon == std::string::npos ? std::string() : word.value.substr(colon + 1);
    if (!deck::looks_like_selector(place))
      continue;
    const std::size_t end = std::min(close, word.value.size() - 1) + 1;
    try {
      const deck::Selector selector =
          deck::read_selector(word.value.substr(colon + 1, end - colon - 1));
      const std::string numbers = place_of(context, word.where, selector);
      const std::string named =
          word.value.substr(0, colon + 1) + numbers + word.value.substr(end);
      if (!numbers.empty() && selector.is_by_position())
        context.note(fmt::format("{} is {}", word.value, named));
      word.value = numbers.empty() ? "" : named;
    } catch (const deck::SelectorFault& fault) {
      context.error(word.where, fault.what(), fault.hint);
      word.value.clear();
    }
  }
  std::erase_if(words, [](const deck::Word& word) { return word.value.empty(); });
  if (any && words.empty())  // The card must not seem to name no quantities.
    words.push_back({quantities::usual_curves[0], context.command.where, true});
  return out;
}

/// The number of corners of the block with this number; the largest number of all if a
/// faulty card hides it.
int corners_of(const Context& context, long number) {
  const int b = context.state.numbers.index_of(number);
  return b >= 0 ? context.blocks.corners_of(b) : std::numeric_limits<int>::max();
}

void check_curve(const Context& context, const NamedCurve& named) {
  const auto& [curve, where] = named;
  const auto& laws = context.settings.joint_laws;
  const UnreadCards& unread = context.state.unread;
  const quantities::OtherKind* kind = quantities::find_other(curve.quantity);
  const bool needs_law = (kind != nullptr && kind->of_laws) || curve.joint > 0;
  if (needs_law && laws.empty() && !unread.may_define_joint(0)) {
    context.error(where, curve.name() + " needs a joint with a law",
                  "JOINT defines a law, JPAIR gives it to materials");
    return;
  }
  if (curve.joint > 0 && !laws.contains(curve.joint) &&
      !unread.may_define_joint(curve.joint)) {
    context.error(where, fmt::format("no JOINT card above has the id {}", curve.joint),
                  "name a joint that has a law");
    return;
  }
  if (curve.last > 0 && !has_block(context, {curve.last, where, true}))
    return;
  if (const int corners = corners_of(context, curve.first); curve.corner > corners) {
    context.error(where,
                  fmt::format("block {} has no corner {}", curve.first, curve.corner),
                  fmt::format("it has corners 1 to {}", corners));
    return;
  }
  const auto& material = context.blocks.material;
  const int number = quantities::material_number(
      curve.material, quantities::material_numbers(context.settings));
  if (context.settings.materials.contains(number) &&
      std::count(material.begin(), material.end(), number) == 0 &&
      context.state.numbers.max_missing(std::numeric_limits<int>::max()) == 0)
    context.error(where, "no block is of material " + curve.material,
                  "name a material of blocks, or create blocks of this one");
}

}  // namespace

void act(const Context& context, const deck::Output& card) {
  constexpr long max = std::numeric_limits<int>::max();
  std::vector<int> chosen;
  for (const deck::NumberOrSelector& named : card.blocks) {
    if (!named.selector) {
      chosen.push_back(static_cast<int>(std::clamp(named.number.value, 1L, max)) - 1);
      continue;
    }
    for (const int b : blocks_named(context, named))
      if (std::find(chosen.begin(), chosen.end(), b) == chosen.end())
        chosen.push_back(b);
  }
  Model& model = context.model;
  model.output_blocks = chosen;
  context.state.output = context.command;  // its blocks may be made later
  model.output = {card.dtout.value, model.time + card.dtout.value};
}

void act(const Context& context, const deck::Plots& card) {
  Model& model = context.model;
  model.plots = {}, model.plot_steps = {};
  if (card.steps.given)
    model.plot_steps = {card.steps.value, model.steps};
  else
    model.plots = {card.dtplot.value, model.time + card.dtplot.value};
  std::set<double> times;
  for (const deck::Real& time : card.times)
    times.insert(time.value);
  model.plot_times.assign(times.begin(), times.end());
}

void act(const Context& context, const deck::History& card) {
  context.model.history = {card.dthist.value, {}};
  const deck::Command numbered = with_numbers(context);
  for (const NamedCurve& named : named_curves(numbered, context.diagnostics)) {
    if (!named.curve.material.empty())
      find_material(context, named.where, named.curve.material);
    context.model.history.quantities.push_back(named.curve.name());
  }
  context.state.histories.push_back(numbered);  // its blocks may be made later
}

void check_history_interval(const Context& motion) {
  const double interval = motion.model.history.interval;
  constexpr double max_per_step = 1000.0;
  if (interval == 0.0)
    return;
  const double dt = dynamics::choose_time_step(motion.model).dt;
  const std::vector<deck::Command>& histories = motion.state.histories;
  if (dt / interval > max_per_step)
    (histories.empty() ? motion : motion.of(histories.back()))
        .error(fmt::format("an interval of {:g} is less than a thousandth of the time "
                           "step, {:.4g}",
                           interval, dt),
               "values between two steps are interpolated; give about a time step or "
               "more");
}

void check_output(const Context& output) {
  for (const auto& [number, selector] :
       std::get<deck::Output>(output.command.card).blocks)
    if (!selector)
      has_block(output, number);
}

void check_history(const Context& history) {
  deck::Diagnostics card_faults("",
                                "");  // faults of the card itself are reported before
  for (const NamedCurve& curve : named_curves(history.command, card_faults))
    check_curve(history, curve);
}

}  // namespace blocks::run
