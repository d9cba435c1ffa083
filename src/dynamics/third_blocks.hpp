// Blocks beside the two of a pair that a certainty counts on: as long as they stay away
// no joint hides anything (ClosedJoint).
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace blocks::dynamics {

/// What a certainty counts on. Each third block that is listed for one of the corners
/// may move by the margin, together with the two blocks of the pair (Swing::way).
struct ThirdsAway {
  static constexpr int most_corners = 3;
  double margin = std::numeric_limits<double>::max();  ///< [L]
  int count = 0;
  int corner[most_corners] = {};

  /// That of one more corner.
  void add(int of, double travel) {
    margin = travel < margin ? travel : margin;
    for (int k = 0; k < count; ++k)
      if (corner[k] == of)
        return;
    corner[count++] = of;
  }
  /// Corners of this and the other: whether they find room.
  bool add(const ThirdsAway& other);
};

/// The third blocks of one group.
struct ThirdBlock {
  int group, pair, block;
  float limit;  ///< [L] ways of the three blocks are less together
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
  template <class Visit> void each(int round, const Visit& visit) const {
    for (int k = 0; k < count_[round]; ++k)
      visit(thirds_[place(round) + k]);
  }
  template <class Visit> void each(const Visit& visit) const {
    for (int round = 0; round < static_cast<int>(count_.size()); ++round)
      each(round, visit);
  }

 private:
  static constexpr int most = 32;  ///< of a round
  static std::ptrdiff_t place(int round) { return std::ptrdiff_t{most} * round; }

  std::unique_ptr<ThirdBlock[]> thirds_;
  std::ptrdiff_t room_ = 0;
  std::vector<std::uint8_t> count_;  ///< (rounds)
};

}  // namespace blocks::dynamics
