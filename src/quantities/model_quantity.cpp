#include "quantities/model_quantity.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "quantities/quantity.hpp"

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

const std::map<std::string, OtherKind>& other_kinds() {
  using How = Statistic::How;
  constexpr Dimension force{0, 1, -2, "N/m", ""}, length{1, 0, 0, "m", ""},
      duration{0, 0, 1, "s", ""}, pure{};
  static const std::map<std::string, OtherKind> kinds = {
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
        {}}},
      {"overlap",
       {"overlap",
        length,
        How::largest,
        [](const ContactState& c) { return c.overlap; },
        {}}},
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
      {"time",
       {"time", duration, How::sum, {}, [](const State& now) { return now.time; }}}};
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

}  // namespace blocks::quantities
