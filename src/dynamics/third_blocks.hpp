// Blocks beside the two of a pair that a certainty counts on: as long as they stay away
// no joint hides anything (ClosedJoint).
#pragma once

#include <array>
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

/// Those of the groups of each round of pairs. A round is asked, and added to, by one
/// thread; it asks for no memory.
class ThirdBlocks {
 public:
  /// For so many rounds: none.
  void reserve(int rounds);
  void forget();
  bool any(int round) const { return count_[round] > 0; }
  /// Whether there was room for it.
  bool add(int round, const ThirdBlock& third);
  /// All of one group.
  void drop(int round, int group);
  /// Calls visit(third) for those of a round; of all.
  template <class Visit> void each(int round, const Visit& visit) {
    for (int k = 0; k < count_[round]; ++k)
      visit(thirds_[place(round) + k]);
  }
  template <class Visit> void each(const Visit& visit) {
    for (int round = 0; round < static_cast<int>(count_.size()); ++round)
      each(round, visit);
  }

 private:
  static constexpr int most = 48;  ///< of a round
  static std::ptrdiff_t place(int round) { return std::ptrdiff_t{most} * round; }

  std::unique_ptr<ThirdBlock[]> thirds_;
  std::ptrdiff_t room_ = 0;
  std::vector<std::uint8_t> count_;  ///< (rounds)
};

}  // namespace blocks::dynamics
