// The cards CRACK and MDAMP (docs/cracks.md).
#include "run/builder/builder.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "text/counted.hpp"

namespace blocks::run {

using deck::Command;

void Builder::let_crack(const Command& command, const deck::Crack& card) {
  if (!has_material(command, card.mat))
    return;
  model_.settings.crack_rules[static_cast<int>(card.mat.value)] = {
      card.ten.value, card.amin.value, card.tenp.given ? card.tenp.value : 0.0,
      static_cast<int>(card.id.value)};
  crack_cards_.emplace_back(card.mat.where, static_cast<int>(card.mat.value));
  model_.time_step.blocks = 0;  // it has to allow for the pieces
  // Blocks that were too small for the old card may not be for this one.
  std::erase_if(model_.crack_refusals, [&](const RefusedCrack& refused) {
    return model_.blocks.material[refused.block] == card.mat.value;
  });
}

void Builder::damp_material(const Command& command, const deck::Mdamp& card) {
  if (!has_material(command, card.mat))
    return;
  model_.settings.materials.at(static_cast<int>(card.mat.value)).damping = card.z.value;
  model_.time_step.blocks = 0;  // strong damping needs a shorter one
}

void Builder::take_in_pieces() {
  const int now = model_.blocks.size();
  if (now == known_blocks_)
    return;
  if (motion_)
    makers_.record(*motion_, now);
  if (certificate_) {
    AssemblyCertificate with_pieces = *certificate_;
    with_pieces.blocks = with_pieces.moved = now;
    certificate_ = std::make_shared<const AssemblyCertificate>(std::move(with_pieces));
  }
  known_blocks_ = checked_blocks_ = moved_blocks_ = domain_blocks_ = now;
}

void Builder::error_unsure(const Command& command, const deck::Int& number) {
  diagnostics_.error(
      number.where, command.name,
      fmt::format(
          "the block that gets the number {} is not known before the run: blocks "
          "may split in the motion above",
          number.value),
      "make blocks before the motions in which others split, or name them by material "
      "or outline");
}

void Builder::check_cracks() {
  const Blocks& blocks = model_.blocks;
  for (const auto& [where, material] : std::exchange(crack_cards_, {})) {
    const double min = model_.settings.crack_rules.at(material).min_area;
    double largest = 0.0;
    for (int b = 0; b < blocks.size(); ++b)
      if (blocks.is_free(b) && blocks.material[b] == material)
        largest = std::max(largest, blocks.area[b]);
    if (largest < 2.0 * min)
      diagnostics_.warning(
          where, "CRACK",
          largest == 0.0
              ? fmt::format("no free block has material {}", material)
              : fmt::format("no block of material {} is large enough to split: amin is "
                            "{:g}, the largest area {:g}",
                            material, min, largest),
          "only free blocks with an area of at least two times amin split");
    else if (blocks.size() >= model_.settings.max_blocks)
      diagnostics_.warning(where, "CRACK",
                           fmt::format("START allows {}, so none can split",
                                       counted(model_.settings.max_blocks, "block")),
                           "raise nblokm of START by the number of pieces you expect");
  }
}

}  // namespace blocks::run
