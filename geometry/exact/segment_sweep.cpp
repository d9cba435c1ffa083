#include "geometry/exact/segment_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>
#include <set>
#include <utility>

#include "geometry/exact/enclosure.hpp"

namespace blocks::geometry::exact {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// The point where piece `below` crosses piece `above`.
struct Crossing {
  Enclosure box;
  int below, above;
};

class Sweep {
 public:
  Sweep(const std::vector<ExactPoint>& ends, const std::vector<Piece>& pieces,
        const Lines& lines)
      : ends_(ends), pieces_(pieces), lines_(lines), status_(Order{this}),
        slots_(pieces.size(), status_.end()), by_end_(ordered_by_end()),
        crossings_(Later{this}) {}

  void run(const std::function<void(const SweepVertex&)>& visit,
           StepProgress& progress) {
    const RoundUpwards upwards;
    const auto count = static_cast<int>(ends_.size());
    while (end_ < count || !crossings_.empty()) {
      if (progress.is_due()) {
        const RoundToNearestAgain nearest;
        progress.report(static_cast<double>(end_) / count);
      }
      if (!crossings_.empty() && !is_adjacent(crossings_.top()))
        crossings_.pop();  // another piece is between the two, or they have crossed
      else if (!crossings_.empty() && is_before_end(crossings_.top()))
        process_crossing(visit);
      else
        process_end(visit);
    }
  }

 private:
  // A place in the status. The order of the places is that of their insertion; it never
  // changes, but pieces change their places.
  struct Slot {
    mutable int piece;
  };
  struct Order {
    using is_transparent = void;
    const Sweep* sweep;
    bool operator()(const Slot&, const Slot&) const { return false; }
    /// Whether the piece is below the present point.
    bool operator()(const Slot& slot, const Sweep& now) const {
      return now.side(slot.piece) > 0;
    }
  };
  using Status = std::multiset<Slot, Order>;  // from the lowest to the highest piece
  using Iterator = Status::iterator;
  struct Later {
    const Sweep* sweep;
    bool operator()(const Crossing& a, const Crossing& b) const {
      return sweep->order(a, b) > 0;
    }
  };

  std::vector<int> ordered_by_end() const {
    std::vector<int> first(ends_.size() + 1, 0), order(pieces_.size());
    for (const Piece& piece : pieces_)
      ++first[at(piece.to) + 1];
    for (std::size_t i = 1; i < first.size(); ++i)
      first[i] += first[i - 1];
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      order[at(first[at(pieces_[i].to)]++)] = static_cast<int>(i);
    return order;
  }

  Line line(int piece) const { return lines_[at(pieces_[at(piece)].line)]; }
  const ExactPoint& from(int piece) const { return ends_[at(pieces_[at(piece)].from)]; }
  const ExactPoint& to(int piece) const { return ends_[at(pieces_[at(piece)].to)]; }

  // The side of the piece on which the point is: 1 above it, -1 below it.
  std::optional<int> certain_side(int piece, const Enclosure& point) const {
    const Enclosure start = enclosure(from(piece)), stop = enclosure(to(piece));
    return certain_sign((stop.x - start.x) * (point.y - start.y) -
                        (stop.y - start.y) * (point.x - start.x));
  }
  // Likewise of the present point.
  int side(int piece) const {
    if (const auto certain = certain_side(piece, box_))
      return *certain;
    if (!is_exact_) {
      if (at_end_ >= 0)
        place_.set(ends_[at(at_end_)]);
      else
        place_.set(line(crossing_.below), line(crossing_.above));
      is_exact_ = true;
    }
    return side_of(line(piece), place_);
  }
  // Likewise of an end.
  int side(int piece, int end) const {
    if (const auto certain = certain_side(piece, enclosure(ends_[at(end)])))
      return *certain;
    first_.set(ends_[at(end)]);
    return side_of(line(piece), first_);
  }

  Enclosure enclosure_of(int below, int above) const {
    const Enclosure p = enclosure(from(below)), q = enclosure(to(below)),
                    r = enclosure(from(above)), s = enclosure(to(above));
    const Interval run = q.x - p.x, rise = q.y - p.y;
    const Interval other_run = s.x - r.x, other_rise = s.y - r.y;
    const Interval area = run * other_rise - rise * other_run;
    // Where lines are nearly parallel, bounds of their intersection are too wide.
    constexpr double widest = 0x1p-20;
    if (std::min(std::abs(area.inf()), std::abs(area.sup())) * widest >
        area.sup() - area.inf()) {
      const Interval part = ((r.x - p.x) * other_rise - (r.y - p.y) * other_run) / area;
      return {p.x + part * run, p.y + part * rise};
    }
    first_.set(line(below), line(above));
    const RoundToNearestAgain nearest;
    const Vec2 rounded = first_.nearest();
    const RoundUpwards upwards;
    return around(rounded);
  }

  int order(const Crossing& a, const Crossing& b) const {
    if (a.below == b.below && a.above == b.above)
      return 0;
    if (const auto certain = certain_order(a.box, b.box))
      return *certain;
    first_.set(line(a.below), line(a.above));
    second_.set(line(b.below), line(b.above));
    return compare(first_, second_);
  }
  // Whether the crossing is before the next end.
  bool is_before_end(const Crossing& crossing) const {
    if (at(end_) == ends_.size())
      return true;
    const ExactPoint& end = ends_[at(end_)];
    if (const auto certain = certain_order(crossing.box, enclosure(end)))
      return *certain < 0;
    first_.set(line(crossing.below), line(crossing.above));
    second_.set(end);
    return compare(first_, second_) < 0;
  }
  bool is_adjacent(const Crossing& crossing) const {
    const Iterator below = slots_[at(crossing.below)];
    return below != status_.end() && std::next(below) != status_.end() &&
           std::next(below)->piece == crossing.above;
  }

  void process_crossing(const std::function<void(const SweepVertex&)>& visit) {
    crossing_ = crossings_.top();
    crossings_.pop();
    at_end_ = -1;
    box_ = crossing_.box;
    is_exact_ = false;
    process(slots_[at(crossing_.below)], std::next(slots_[at(crossing_.above)]), visit);
  }

  void process_end(const std::function<void(const SweepVertex&)>& visit) {
    at_end_ = end_++;
    box_ = enclosure(ends_[at(at_end_)]);
    is_exact_ = false;
    const auto ends_here = [this] {
      return ended_ < by_end_.size() && pieces_[at(by_end_[ended_])].to == at_end_;
    };
    if (ends_here()) {
      const Iterator known = slots_[at(by_end_[ended_])];
      while (ends_here())
        ++ended_;
      process(known, std::next(known), visit);
    } else {
      const Iterator above = status_.lower_bound(*this);
      process(above, above, visit);
    }
  }

  // Processes the present point. The pieces in [first, last) contain it, and others
  // beside them may.
  void process(Iterator first, Iterator last,
               const std::function<void(const SweepVertex&)>& visit) {
    while (first != status_.begin() && side(std::prev(first)->piece) == 0)
      --first;
    while (last != status_.end() && side(last->piece) == 0)
      ++last;
    left_.clear();
    right_.clear();
    for (Iterator slot = first; slot != last; ++slot)
      left_.push_back(slot->piece);
    for (auto piece = left_.rbegin(); piece != left_.rend(); ++piece)
      if (at_end_ < 0 || pieces_[at(*piece)].to != at_end_)
        right_.push_back(*piece);
    const std::size_t continued = right_.size();
    for (; begun_ < pieces_.size() && pieces_[begun_].from == at_end_; ++begun_)
      right_.push_back(static_cast<int>(begun_));
    if (right_.size() > continued)
      std::sort(right_.begin(), right_.end(), [this](int s, int t) {
        return lines_.turn(at(pieces_[at(s)].line), at(pieces_[at(t)].line)) > 0;
      });
    const int below = first == status_.begin() ? -1 : std::prev(first)->piece;
    visit({at_end_, left_, right_, below});
    for (const int piece : left_)
      slots_[at(piece)] = status_.end();
    Iterator slot = first;
    for (const int piece : right_) {
      if (slot != last)
        slot->piece = piece;
      else
        slot = status_.emplace_hint(last, Slot{piece});
      slots_[at(piece)] = slot++;
    }
    status_.erase(slot, last);
    const int above = last == status_.end() ? -1 : last->piece;
    test(below, right_.empty() ? above : right_.front());
    if (!right_.empty())
      test(right_.back(), above);
  }

  // Notes whether two neighbours cross. They meet in a point of the earlier end, or
  // cross before it if it is on the other side.
  void test(int below, int above) {
    if (below < 0 || above < 0)
      return;
    const int stop = pieces_[at(below)].to, other_stop = pieces_[at(above)].to;
    if (stop < other_stop ? side(above, stop) > 0
                          : stop > other_stop && side(below, other_stop) < 0)
      crossings_.push({enclosure_of(below, above), below, above});
  }

  const std::vector<ExactPoint>& ends_;
  const std::vector<Piece>& pieces_;
  const Lines& lines_;
  Status status_;
  std::vector<Iterator> slots_;  ///< of each piece; the end if it is not in the status
  std::vector<int> by_end_;      ///< pieces, ascending by their last ends
  std::priority_queue<Crossing, std::vector<Crossing>, Later> crossings_;
  int end_ = 0;                        ///< the next end
  std::size_t begun_ = 0, ended_ = 0;  ///< numbers of pieces, likewise
  // The present point.
  int at_end_ = -1;    ///< number of the end there; -1: a crossing
  Crossing crossing_;  ///< if it is no end
  Enclosure box_;
  mutable bool is_exact_ = false;  ///< place_ is set
  mutable Place place_;
  mutable Place first_, second_;  ///< for comparisons
  std::vector<int> left_, right_;
};

}  // namespace

void sweep_pieces(const std::vector<ExactPoint>& ends, const std::vector<Piece>& pieces,
                  const Lines& lines,
                  const std::function<void(const SweepVertex&)>& visit,
                  StepProgress& progress) {
  Sweep(ends, pieces, lines).run(visit, progress);
}

}  // namespace blocks::geometry::exact
