// Memory that is needed for a part of a step or of a search alone.
#pragma once

#include <cstddef>
#include <vector>

namespace blocks::dynamics {

/// Less is not worth giving back: to ask for it again takes longer. [bytes]
inline constexpr std::size_t little_memory = std::size_t{1} << 22;

/// Empties the items and gives their memory back where it is much.
template <class Item> void give_back(std::vector<Item>& items) {
  items.clear();
  if (items.capacity() * sizeof(Item) > little_memory)
    items.shrink_to_fit();
}

/// Gives the system what the program asked for and does not use any more. What was
/// asked for in small pieces, as outlines for the certificate are, or in columns that
/// are not the largest, else stays with the program, in places that others do not fit.
void give_back_what_is_free();

/// What is behind whoever goes along a column from its front: numbers that nobody wants
/// any more. Their pages are given back while the column stays, to be written anew:
/// until then anything may stand there.
class Wake {
 public:
  explicit Wake(void* front) : front_(static_cast<std::byte*>(front)) {}
  /// Nothing before this place is wanted any more.
  void passed(void* place);

 private:
  std::byte* front_;
};

}  // namespace blocks::dynamics
