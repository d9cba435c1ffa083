// The card CRACK (docs/cracks.md).
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "run/builder/cards.hpp"
#include "run/builder/checks.hpp"
#include "run/builder/names.hpp"
#include "text/counted.hpp"

namespace blocks::run {

void act(const Context& context, const deck::Crack& card) {
  if (!has_material(context, card.mat))
    return;
  const auto material = static_cast<int>(card.mat.value);
  context.settings.crack_rules[material] = {card.ten.value, card.amin.value,
                                            card.tenp.given ? card.tenp.value : 0.0,
                                            static_cast<int>(card.id.value)};
  context.state.cracks.push_back(context.command);
  context.model.time_step.blocks = 0;  // it has to allow for the pieces
  // Blocks that were too small for the old card may not be for this one.
  std::erase_if(context.model.crack_refusals, [&](const RefusedCrack& refused) {
    return context.blocks.material[refused.block] == material;
  });
}

void check_cracks(const Context& context) {
  const Blocks& blocks = context.blocks;
  for (const deck::Command& command : std::exchange(context.state.cracks, {})) {
    const deck::Int& given = std::get<deck::Crack>(command.card).mat;
    const auto material = static_cast<int>(given.value);
    const double min = context.settings.crack_rules.at(material).min_area;
    double largest = 0.0;
    for (int b = 0; b < blocks.size(); ++b)
      if (blocks.is_free(b) && blocks.material[b] == material)
        largest = std::max(largest, blocks.area[b]);
    const Context card = context.of(command);
    if (largest < 2.0 * min)
      card.warning(given.where,
                   largest == 0.0
                       ? fmt::format("no free block has material {}", material)
                       : fmt::format("no block of material {} is large enough to "
                                     "split: amin is {:g}, the largest area {:g}",
                                     material, min, largest),
                   "only free blocks with an area of at least two times amin split");
    else if (blocks.size() >= context.settings.max_blocks)
      card.warning(given.where,
                   fmt::format("START allows {}, so none can split",
                               counted(context.settings.max_blocks, "block")),
                   "raise nblokm of START by the number of pieces you expect");
  }
}

}  // namespace blocks::run
