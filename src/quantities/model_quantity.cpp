#include "quantities/model_quantity.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "quantities/energy.hpp"
#include "quantities/quantity.hpp"
#include "text/suggest.hpp"

namespace blocks::quantities {

void OtherKind::of_contacts(std::span<const ContactState> contacts,
                            std::span<double> of_blocks) const {
  std::fill(of_blocks.begin(), of_blocks.end(), 0.0);
  const int blocks = static_cast<int>(of_blocks.size());
  for (const ContactState& one : contacts)
    for (const int number : {one.corner_block, one.edge_block})
      if (number >= 1 && number <= blocks) {
        double& of_block = of_blocks[static_cast<std::size_t>(number) - 1];
        of_block = natural == Statistic::How::largest ? std::max(of_block, contact(one))
                                                      : of_block + contact(one);
      }
}

namespace {

/// Returns the largest local ratio of a block; NaN if they are not known.
double largest_local_ratio(const State& now) {
  if (now.blocks.local_ratio == nullptr)
    return std::numeric_limits<double>::quiet_NaN();
  double largest = 0.0;
  for (const double ratio : *now.blocks.local_ratio)
    largest = std::max(largest, ratio);  // a removed block of a frame has NaN
  return largest;
}

std::map<std::string, OtherKind> all_other_kinds() {
  using How = Statistic::How;
  constexpr Dimension force{0, 1, -2, "N/m", ""}, length{1, 0, 0, "m", ""},
      duration{0, 0, 1, "s", ""}, stress{-1, 1, -2, "Pa", ""}, pure{};
  constexpr bool per_length = true, with_laws = true;
  std::map<std::string, OtherKind> kinds = {
      {"contacts",
       {"contacts", pure, How::sum, [](const ContactState&) { return 1.0; }, {}}},
      {"normal_force",
       {"normal contact force",
        force,
        How::sum,
        [](const ContactState& c) { return c.normal_force; },
        {}}},
      {"shear_force",
       {"shear contact force",
        force,
        How::sum,
        [](const ContactState& c) { return std::abs(c.shear_force); },
        {},
        [](const ContactState& c) { return c.shear_force; }}},
      {"overlap",
       {"overlap",
        length,
        How::largest,
        [](const ContactState& c) { return c.overlap; },
        {},
        {},
        How::largest}},
      {"bonded",
       {"bonded contacts",
        pure,
        How::sum,
        [](const ContactState& c) { return c.state.bonded ? 1.0 : 0.0; },
        {},
        {},
        How::sum,
        false,
        with_laws}},
      {"failed",
       {"failed contacts",
        pure,
        How::sum,
        [](const ContactState& c) { return c.state.failed ? 1.0 : 0.0; },
        {},
        {},
        How::sum,
        false,
        with_laws}},
      {"slip",
       {"slip",
        length,
        How::largest,
        [](const ContactState& c) { return std::abs(c.state.slip); },
        {},
        [](const ContactState& c) { return c.state.slip; },
        How::mean,
        false,
        with_laws}},
      {"dilation",
       {"dilation",
        length,
        How::largest,
        [](const ContactState& c) { return c.state.offset; },
        {},
        {},
        How::mean,
        false,
        with_laws}},
      {"joint_length",
       {"length in contact",
        length,
        How::sum,
        [](const ContactState& c) { return c.state.length; },
        {},
        {},
        How::sum,
        false,
        with_laws}},
      {"normal_stress",
       {"normal stress",
        stress,
        How::sum,
        {},
        {},
        [](const ContactState& c) { return c.state.law != 0 ? c.normal_force : 0.0; },
        How::sum,
        per_length,
        with_laws}},
      {"shear_stress",
       {"shear stress",
        stress,
        How::sum,
        {},
        {},
        [](const ContactState& c) { return c.state.law != 0 ? c.shear_force : 0.0; },
        How::sum,
        per_length,
        with_laws}},
      {"step",
       {"step",
        pure,
        How::sum,
        {},
        [](const State& now) { return static_cast<double>(now.step); }}},
      {"blocks",
       {"blocks",
        pure,
        How::sum,
        {},
        [](const State& now) { return static_cast<double>(now.blocks.present()); }}},
      {"cracks",
       {"cracks",
        pure,
        How::sum,
        {},
        [](const State& now) { return static_cast<double>(now.cracks); }}},
      {ratio_name,
       {"ratio of the unbalanced forces",
        pure,
        How::sum,
        {},
        [](const State& now) { return now.unbalanced_ratio; }}},
      {largest_local_name,
       {"largest local ratio", pure, How::sum, {}, largest_local_ratio}},
      {"time",
       {"time", duration, How::sum, {}, [](const State& now) { return now.time; }}}};
  // The account is on request only; see energy.hpp.
  const Dimension energy{1, 1, -2, "J/m", ""};
  for (const EnergyQuantity& one : energy_quantities())
    kinds[energy_prefix + one.name] = {
        one.label, energy, How::sum, {}, [value = one.value](const State& now) {
          return now.energy == nullptr ? std::numeric_limits<double>::quiet_NaN()
                                       : value(*now.energy);
        }};
  return kinds;
}

}  // namespace

const std::map<std::string, OtherKind>& other_kinds() {
  static const std::map<std::string, OtherKind> kinds = all_other_kinds();
  return kinds;
}

const OtherKind* find_other(const std::string& name) {
  std::string lower = name;
  for (char& c : lower)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const auto found = other_kinds().find(lower);
  return found == other_kinds().end() ? nullptr : &found->second;
}

std::string block_quantity_names() {
  std::string names = quantity_names();
  for (const auto& [name, kind] : other_kinds())
    if (kind.contact)
      names += ", " + name;
  return names;
}

std::string nearest_quantity(std::string_view word,
                             std::vector<std::string_view> others) {
  for (const QuantityKind& kind : quantity_kinds())
    others.push_back(kind.name);
  for (const auto& [name, kind] : other_kinds())
    others.push_back(name);
  return text::suggest(word, others);
}

}  // namespace blocks::quantities
