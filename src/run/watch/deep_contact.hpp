// Finds contacts that no overlap of the blocks explains.
#pragma once

#include <optional>

#include "model/model.hpp"

namespace blocks::run {

/// Returns the deepest contact whose depth exceeds twice the shift that separates its
/// two blocks, and twice every shift that separates one of them from another block near
/// them; empty if there is none. For blocks that are not convex, the shifts are those
/// of their parts. Contacts less deep than a thousandth of the size of the smaller
/// block, the root of its area, are not examined, and nor are contacts that the law of
/// a joint holds. The model must have been read.
std::optional<Contact> find_deep_contact(const Model& model);

}  // namespace blocks::run
