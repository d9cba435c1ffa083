#include "joints/track_search.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "joints/scanlines.hpp"
#include "joints/window.hpp"

namespace blocks::joints {
namespace {

using geometry::Vec2;

/// A piece in the coordinates of its family: along and across the mean direction.
struct Placed {
  double begin = 0.0, end = 0.0;    ///< [L] along the track
  double across = 0.0;              ///< [L] of the middle
  bool begins = true, ends = true;  ///< whether these ends are visible

  bool is_complete() const { return begins && ends; }
};

/// The traces of a track.
struct Track {
  double across = 0.0;  ///< [L] mean of the middles that define it
  std::vector<Placed> traces;
};

/// The line across the mean direction, and a range of it.
struct Frame {
  Vec2 origin, along, across;

  Frame(const Vec2& middle, double mean)
      : origin(middle), along(unit_vector(mean)), across(-along.y(), along.x()) {}

  Vec2 at(double offset) const { return origin + offset * across; }
};

double squared(double x) { return x * x; }

/// The longest chord along the direction at an offset; 0 outside.
double longest_chord(const geometry::Polygon& window, const Frame& frame,
                     double offset) {
  double longest = 0.0;
  for (const auto& [begin, end] : chords(window, frame.at(offset), frame.along))
    longest = std::max(longest, end - begin);
  return longest;
}

/// Returns the range of offsets around the longest chord in which chords are at least
/// half as long. Where the window is short, it may show nothing of a track.
std::pair<double, double> range_of_offsets(const geometry::Polygon& window,
                                           const Frame& frame) {
  constexpr int steps = 400;
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Vec2& corner : window) {
    const double offset = frame.across.dot(corner - frame.origin);
    low = std::min(low, offset), high = std::max(high, offset);
  }
  const auto offset = [&](int k) { return low + (high - low) * (k + 0.5) / steps; };
  int best = 0;
  double max = 0.0;
  for (int k = 0; k < steps; ++k)
    if (const double one = longest_chord(window, frame, offset(k)); one > max)
      max = one, best = k;
  int first = best, last = best;
  while (first > 0 && longest_chord(window, frame, offset(first - 1)) >= 0.5 * max)
    --first;
  while (last + 1 < steps &&
         longest_chord(window, frame, offset(last + 1)) >= 0.5 * max)
    ++last;
  const double half = 0.5 * (high - low) / steps;
  return {offset(first) - half, offset(last) + half};
}

/// Returns the pieces placed in the frame, in the order of their offsets.
std::vector<Placed> placed_in(const Frame& frame, const std::vector<Piece>& pieces) {
  std::vector<Placed> placed;
  for (const Piece& piece : pieces) {
    double begin = frame.along.dot(piece.from - frame.origin);
    double end = frame.along.dot(piece.to - frame.origin);
    bool begins = !piece.from_hidden, ends = !piece.to_hidden;
    if (begin > end) {
      std::swap(begin, end);
      std::swap(begins, ends);
    }
    if (begins && ends) {
      // It has turned about its middle, so it takes its whole length of the track.
      const double middle = 0.5 * (begin + end);
      const double half = 0.5 * (piece.to - piece.from).norm();
      begin = middle - half, end = middle + half;
    }
    placed.push_back({begin, end,
                      frame.across.dot(0.5 * (piece.from + piece.to) - frame.origin),
                      begins, ends});
  }
  std::sort(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) {
    return a.across != b.across ? a.across < b.across : a.begin < b.begin;
  });
  return placed;
}

/// Finds the tracks of placed pieces.
class TrackFinder {
 public:
  /// deviation: of the directions [radians]. least: [L] smallest distance of two
  /// tracks.
  TrackFinder(const std::vector<Placed>& placed, double deviation, double min)
      : placed_(placed) {
    constexpr double blurs = 4.0;
    const auto n = static_cast<double>(placed.size());
    double far = 0.0, longest = 0.0;
    for (const Placed& one : placed) {
      far += squared(0.5 * (one.begin + one.end)) / n;
      longest = std::max(longest, one.end - one.begin);
    }
    // The mean direction has an error, which moves all middles far along the tracks.
    reach_ = std::max(blurs * deviation * std::sqrt(far / n), min);
    // The middle of a cut trace is elsewhere, by up to half of what is hidden.
    cut_reach_ = [=, this](const Placed& one) {
      return reach_ + 2.0 * deviation * 0.5 * (longest - (one.end - one.begin));
    };
  }

  double reach() const { return reach_; }

  /// Complete traces define the tracks. Cut traces belong to the nearest track that is
  /// near enough; the others define tracks of their own.
  std::vector<Track> tracks() const {
    std::vector<Placed> complete, cut, left;
    for (const Placed& one : placed_)
      (one.is_complete() ? complete : cut).push_back(one);
    std::vector<Track> found =
        grouped(complete, [this](const Placed&) { return reach_; });
    for (const Placed& one : cut) {
      Track* nearest = nullptr;
      for (Track& track : found)
        if (nearest == nullptr || std::abs(track.across - one.across) <
                                      std::abs(nearest->across - one.across))
          nearest = &track;
      if (nearest != nullptr &&
          std::abs(nearest->across - one.across) <= cut_reach_(one))
        nearest->traces.push_back(one);
      else
        left.push_back(one);
    }
    for (Track& track : grouped(left, cut_reach_))
      found.push_back(std::move(track));
    std::sort(found.begin(), found.end(),
              [](const Track& a, const Track& b) { return a.across < b.across; });
    return found;
  }

 private:
  /// Divides traces, in the order of their offsets, where two neighbours are farther
  /// apart than their reach.
  static std::vector<Track> grouped(const std::vector<Placed>& traces,
                                    const std::function<double(const Placed&)>& reach) {
    std::vector<Track> found;
    for (const Placed& one : traces) {
      if (found.empty() || one.across - found.back().traces.back().across > reach(one))
        found.emplace_back();
      found.back().traces.push_back(one);
    }
    for (Track& track : found)
      for (const Placed& one : track.traces)
        track.across += one.across / static_cast<double>(track.traces.size());
    return found;
  }

  const std::vector<Placed>& placed_;
  double reach_;
  std::function<double(const Placed&)> cut_reach_;
};

/// Adds the gaps of a track, whose traces are in order. Returns how many traces
/// overlap.
std::size_t add_gaps(const Track& track, const geometry::Polygon& window,
                     const Frame& frame, LengthSample& gaps) {
  std::size_t overlaps = 0;
  const std::vector<Placed>& traces = track.traces;
  for (std::size_t i = 0; i + 1 < traces.size(); ++i) {
    if (!traces[i].ends || !traces[i + 1].begins)
      continue;
    const double gap = traces[i + 1].begin - traces[i].end;
    overlaps += gap < 0.0 ? 1U : 0U;
    gaps.complete.push_back(std::max(gap, 0.0));
  }
  const auto parts = chords(window, frame.at(track.across), frame.along);
  const auto add_cut = [&](double place, bool towards_begin) {
    for (const auto& [begin, end] : parts)
      if (place >= begin && place <= end)
        gaps.one_hidden.push_back(towards_begin ? place - begin : end - place);
  };
  if (traces.front().begins)
    add_cut(traces.front().begin, true);
  if (traces.back().ends)
    add_cut(traces.back().end, false);
  return overlaps;
}

}  // namespace

Vec2 middle_of(const geometry::Polygon& window) {
  Vec2 low = window.front(), high = low;
  for (const Vec2& corner : window) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  return 0.5 * (low + high);
}

Tracks find_tracks(const std::vector<Piece>& pieces, const geometry::Polygon& window,
                   double mean, double deviation) {
  constexpr std::size_t fewest = 6;
  Tracks tracks;
  if (pieces.size() < fewest)
    return tracks;
  const Frame frame(middle_of(window), mean);
  const std::vector<Placed> placed = placed_in(frame, pieces);
  const auto [low, high] = range_of_offsets(window, frame);
  constexpr double rounding = 1e-9;
  const TrackFinder finder(placed, deviation * std::numbers::pi / 180.0,
                           rounding * (high - low));
  std::size_t overlaps = 0, on_tracks = 0;
  double last = 0.0;
  SpacingSample& spacing = tracks.spacing;
  spacing.length = high - low;
  spacing.resolution = 1e-6 * (high - low);
  for (Track& track : finder.tracks()) {
    if (track.across < low || track.across > high)
      continue;
    std::sort(track.traces.begin(), track.traces.end(),
              [](const Placed& a, const Placed& b) { return a.begin < b.begin; });
    overlaps += add_gaps(track, window, frame, tracks.gaps);
    on_tracks += track.traces.size();
    if (spacing.tracks++ == 0)
      spacing.beyond.push_back(track.across - low);
    else
      spacing.spacings.push_back(track.across - last);
    last = track.across;
  }
  if (spacing.tracks < 3)
    return tracks;
  spacing.beyond.push_back(high - last);
  const double mean_spacing = spacing.length / spacing.tracks;
  constexpr double apart = 3.0, crowd = 1.5, few = 0.02;
  tracks.found = mean_spacing > apart * finder.reach() &&
                 static_cast<double>(on_tracks) > crowd * spacing.tracks &&
                 static_cast<double>(overlaps) <=
                     few * static_cast<double>(tracks.gaps.complete.size());
  return tracks;
}

SpacingSample spacings_across(const Network& network, const std::vector<char>& chosen,
                              double mean, double resolution) {
  SpacingSample sample;
  sample.resolution = resolution;
  sample.lines = 0;
  const Frame frame(middle_of(network.window), mean);
  const auto parts = chords(network.window, frame.origin, frame.across);
  if (parts.empty())
    return sample;
  const Scanline line{frame.origin + parts.front().first * frame.across,
                      frame.origin + parts.back().second * frame.across};
  const std::vector<Crossing> all = crossings_of(line, network);
  for (const auto& [begin, end] : parts) {
    const double from = begin - parts.front().first, to = end - parts.front().first;
    sample.length += to - from;
    double last = from;
    int seen = 0;
    for (const Crossing& one : all) {
      if (chosen[one.piece] == 0 || one.place < from || one.place > to)
        continue;
      (seen++ == 0 ? sample.beyond : sample.spacings).push_back(one.place - last);
      last = one.place;
    }
    sample.tracks += seen;
    if (seen > 0) {
      ++sample.lines;
      sample.beyond.push_back(to - last);
    }
  }
  return sample;
}

}  // namespace blocks::joints
