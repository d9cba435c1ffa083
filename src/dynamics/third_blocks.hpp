// Blocks beside the two of a pair that a certainty counts on: as long as they stay away
// no joint hides anything (ClosedJoint).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace blocks::dynamics {

/// The surfaces that no third block may go on with: those of edges, below a corner of
/// the other block of the pair.
struct ThirdsAway {
  struct Place {
    int corner, surface;
    bool operator==(const Place&) const = default;
  };
  static constexpr int most = 6;
  int count = 0;
  std::array<Place, most> places = {};

  bool contains(const Place& place) const {
    for (int k = 0; k < count; ++k)
      if (places[k] == place)
        return true;
    return false;
  }
  /// Whether there was room for it.
  bool add(const Place& place) {
    if (contains(place))
      return true;
    if (count == most)
      return false;
    places[count++] = place;
    return true;
  }
};

/// One of these blocks.
struct ThirdBlock {
  int group, pair;
  ThirdsAway::Place place;
  int block;
  float
      limit;  ///< [L] away while the ways of the three blocks (Swing) are less together
};

/// Those of the groups of each window of pairs, which one thread asks and adds to. Asks
/// for no memory but for a list.
class ThirdBlocks {
 public:
  /// For so many windows: none.
  void reserve(int windows);
  void forget();
  /// Whether there was room for it.
  bool add(int window, const ThirdBlock& third);
  /// All of one group.
  void drop(int window, int group);
  /// Calls visit(third) for those of a window; of all.
  template <class Visit> void each(int window, const Visit& visit) {
    for (int k = 0; k < count_[window]; ++k)
      visit(thirds_[place(window) + k]);
  }
  template <class Visit> void each(const Visit& visit) {
    for (int window = 0; window < static_cast<int>(count_.size()); ++window)
      each(window, visit);
  }

 private:
  static constexpr int most = 128;  ///< of a window
  static std::ptrdiff_t place(int window) { return std::ptrdiff_t{most} * window; }

  std::unique_ptr<ThirdBlock[]> thirds_;
  std::ptrdiff_t room_ = 0;
  std::vector<std::uint8_t> count_;  ///< (windows)
};

}  // namespace blocks::dynamics
