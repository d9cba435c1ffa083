// The edges that prompt conditions watch (contact_loop.hpp), so laid out that eight are
// asked at once: most corners stay where they are for very long.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "dynamics/contact_lanes.hpp"

namespace blocks::dynamics {

/// Some rows of edges for each round of pairs: only a quick look. Where there are none,
/// for they were not made yet or there was no room, edges have to be asked one by one.
/// Rounds of one window share its room, and are asked and made by one thread.
class WatchRows {
 public:
  static constexpr int most = 8;  ///< rows of a round

  /// For so many rounds, of windows of so many: none made.
  void reserve(int rounds, int rounds_of_window);
  /// Those of all rounds have to be made anew; of one.
  void forget();
  void forget(int round);

  bool missing(int round) const { return count_[round] == none; }
  /// Whether all of the round's corners are certainly where they were: false also
  /// where that is not known. slack: geometry::contact_slack.
  bool all_stay(int round, const LaneArithmetic& arithmetic, const BlockRows& blocks,
                double slack) const {
    const int count = count_[round];
    return count > none && count <= most &&
           arithmetic.all_stay(rows_.get() + place(round), count, blocks, slack);
  }

  /// Makes the rows of one round.
  class Maker {
   public:
    /// outside: the corner stays outside the edge, or else inside.
    void add(int corner, int edge, int edge_end, bool outside);
    void finish(WatchRows& rows, int round);

   private:
    std::array<WatchRow, most> made_;
    int count_ = 0;
  };

 private:
  static constexpr std::uint8_t none = 0, no_room = most + 1;
  static constexpr int rows_of_window = 128;

  /// Where in its window so many rows for a round find room; -1: nowhere.
  int room(int round, int count) const;
  std::ptrdiff_t place(int round) const {
    return std::ptrdiff_t{rows_of_window} * (round / rounds_of_window_) + first_[round];
  }

  int rounds_of_window_ = 1;
  std::unique_ptr<WatchRow[]> rows_;         ///< (windows) rows_of_window
  std::vector<std::uint8_t> first_, count_;  ///< (rounds) in the window
};

}  // namespace blocks::dynamics
