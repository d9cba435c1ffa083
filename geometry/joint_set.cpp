#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/exact/shared_point.hpp"
#include "geometry/joint_sources.hpp"
#include "geometry/numeric_environment.hpp"

namespace blocks::geometry {
namespace {

using exact::Point;
using exact::Rational;
using exact::Vector;

// Purposes of random numbers.
enum Use : std::uint32_t {
  spacing_use,
  phase_use,
  trace_use,
  gap_use,
  dip_use,
  chosen
};

constexpr double two_53 = 0x1p53;

// The bounding box of the outline in doubles, enlarged so that pieces that end outside
// of it end outside of the outline.
struct Window {
  Vec2 low, high;

  explicit Window(const std::vector<DecimalPoint>& outline)
      : low(HUGE_VAL, HUGE_VAL), high(-low) {
    for (const DecimalPoint& corner : outline) {
      const Vec2 p(corner.x.value(), corner.y.value());
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    const double margin = 0x1p-4 * (high - low).maxCoeff() +
                          0x1p-40 * std::max(low.lpNorm<Eigen::Infinity>(),
                                             high.lpNorm<Eigen::Infinity>());
    low.array() -= margin;
    high.array() += margin;
  }
  // Range of (p - start) . direction for p in the window, extended by round-off.
  std::pair<double, double> range(const Vec2& start, const Vec2& direction) const {
    double min = 0.0, max = 0.0;
    for (int axis = 0; axis < 2; ++axis) {
      const double a = (low[axis] - start[axis]) * direction[axis];
      const double b = (high[axis] - start[axis]) * direction[axis];
      min += std::min(a, b);
      max += std::max(a, b);
    }
    const double slack = 0x1p-40 * std::max(std::abs(min), std::abs(max));
    return {min - slack, max + slack};
  }
  double radius() const { return (high - low).norm() / 2.0; }
  Vec2 centre() const { return (low + high) / 2.0; }
};

[[noreturn]] void refuse(const JointSet& set, const std::string& message,
                         const std::string& hint) {
  throw CutError(CutError::Kind::generator, message,
                 {set.start.x.value(), set.start.y.value()}, hint);
}

void check(const JointSet& set) {
  if (set.id < 0)
    refuse(set, "the joint id is negative", "give 0 or more");
  if (!(set.spacing.mean.value() > 0.0))
    refuse(set, "the mean spacing is not positive", "give a spacing above 0");
  for (const Spread* spread : {&set.spacing, &set.trace, &set.gap, &set.dip})
    if (spread->deviation.value() < 0.0)
      refuse(set, "a deviation is negative", "give half ranges of 0 or more");
  if (set.law != SpacingLaw::poisson && set.trace.mean.value() == 0.0 &&
      !(set.dip.deviation.value() < 90.0))
    refuse(set, "joints that run through deviate by 90 degrees or more",
           "give ddev below 90, or law POISSON for all directions");
  if (set.law == SpacingLaw::uniform &&
      set.spacing.deviation.value() >= set.spacing.mean.value())
    refuse(set, "the spacing may be 0 or negative", "give sdev below space");
  if (set.trace.mean.value() < 0.0 || set.gap.mean.value() < 0.0)
    refuse(set, "a length is negative", "give trace and gap of 0 or more");
  if (set.trace.mean.value() > 0.0 &&
      set.trace.deviation.value() >= set.trace.mean.value())
    refuse(set, "traces may have length 0", "give tdev below trace");
  if (set.gap.deviation.value() > set.gap.mean.value())
    refuse(set, "gaps may be negative", "give gdev of at most gap");
}

class Generator {
 public:
  Generator(const JointSet& set, const std::vector<DecimalPoint>& outline,
            const ProgressFunction& progress)
      : set_(set), progress_(progress, "draw joints"), window_(outline),
        start_(exact::rational(set.start)),
        near_(set.start.x.value(), set.start.y.value()),
        dip_(exact::rational(set.dip.mean)),
        direction_(exact::direction_of_degrees(dip_)) {}

  double expected() const {
    const double spacing = set_.spacing.mean.value();
    double tracks = 0.0;  // between the start and the window, and in the window
    double inner = 2.0 * window_.radius() / spacing;
    if (set_.law == SpacingLaw::poisson) {
      tracks = 2.0 * ((window_.centre() - near_).norm() + window_.radius()) / spacing;
    } else {
      const auto [low, high] = reach();
      inner = (high - low) / spacing;
      if (!(std::max(high, -low) / spacing < 0x1p50))  // numbers of tracks are doubles
        refuse(set_, "the start is too many tracks away from the outline",
               "increase the spacing, or give a start near the outline");
      tracks = exact_spacing() ? inner
                               : (std::max(high, 0.0) - std::min(low, 0.0)) / spacing;
    }
    double pieces = 2.0;
    if (!through_going()) {
      const auto [from, to] = window_.range(near_, direction_);
      // Traces between the foot of the start and the window take time as well.
      const double far = (window_.centre() - near_).norm() + window_.radius();
      const double length = set_.law == SpacingLaw::poisson
                                ? std::max(2.0 * window_.radius(), far)
                                : std::max(to, 0.0) - std::min(from, 0.0);
      pieces += length / (set_.trace.mean.value() + set_.gap.mean.value());
    }
    return std::max(tracks - inner, 0.0) + std::max(inner, 1.0) * pieces;
  }

  std::vector<JointSegment> pieces() {
    expected_ = expected();
    if (set_.law == SpacingLaw::poisson) {
      poisson();
    } else {
      parallel_tracks();
    }
    return std::move(pieces_);
  }

 private:
  bool through_going() const { return set_.trace.mean.value() == 0.0; }
  bool exact_spacing() const {
    return set_.law == SpacingLaw::uniform && set_.spacing.deviation.value() == 0.0;
  }
  static Vec2 left_of(const Vec2& direction) {
    return {0.0 - direction.y(), direction.x()};
  }
  // Tracks whose pieces may meet the window are between these distances from the start.
  std::pair<double, double> reach() const {
    auto [low, high] = window_.range(near_, left_of(direction_));
    // A piece that deviates leaves its track by at most half of its length.
    if (set_.dip.deviation.value() > 0.0) {
      if (through_going()) {
        const double far = (window_.centre() - near_).norm() + window_.radius();
        low -= max_tilt() * far;
        high += max_tilt() * far;
      } else {
        const double half =
            (set_.trace.mean.value() + set_.trace.deviation.value()) / 2.0;
        low -= half;
        high += half;
      }
    }
    return {low, high};
  }
  // Bounds the tangent of the deviation. More tracks cost time, but never change a
  // piece.
  double max_tilt() const {
    constexpr double degree = 3.14159265358979323846 / 180.0;
    return 1.01 * std::tan(set_.dip.deviation.value() * degree);
  }

  // A random number in (0, 1), a multiple of 2^-54.
  double random(std::uint64_t track, std::uint32_t piece, std::uint32_t use) const {
    return (static_cast<double>(random_53_bits(set_.stream, track, piece, use)) + 0.5) /
           two_53;
  }
  // Counters of tracks and pieces in both directions.
  static std::uint64_t counter(long k) {
    return k < 0 ? 2 * static_cast<std::uint64_t>(-k) - 1
                 : 2 * static_cast<std::uint64_t>(k);
  }
  static std::uint32_t counter(int j) {
    return static_cast<std::uint32_t>(counter(static_cast<long>(j)));
  }
  // A uniform value about the mean, rounded to a double; the decimal if it is certain.
  Rational draw(const Spread& spread, std::uint64_t track, std::uint32_t piece,
                std::uint32_t use) const {
    const Rational mean = exact::rational(spread.mean);
    if (spread.deviation.value() == 0.0)
      return mean;
    const Rational u(2.0 * random(track, piece, use) - 1.0);
    return {exact::nearest(mean + exact::rational(spread.deviation) * u)};
  }
  // Called for each track and trace, also for those that do not meet the window.
  void watch() {
    done_ += 1.0;
    if (progress_.is_due())
      progress_.report(std::min(done_ / expected_, 1.0));
  }
  Rational spacing(long k) {
    watch();
    if (set_.law == SpacingLaw::uniform)
      return draw(set_.spacing, counter(k), 0, spacing_use);
    return {set_.spacing.mean.value() *
            exact::negative_logarithm(random(counter(k), 0, spacing_use))};
  }

  void parallel_tracks() {
    const auto [low, high] = reach();
    const Vec2 normal = left_of(direction_);
    const auto track = [&](long k, const Rational& distance) {
      const Vector offset(Rational(normal.x()) * distance,
                          Rational(normal.y()) * distance);
      add_track(counter(k), start_ + offset, dip_, direction_, k != 0);
    };
    if (exact_spacing()) {
      const Rational space = exact::rational(set_.spacing.mean);
      const double step = set_.spacing.mean.value();
      const auto last = static_cast<long>(std::ceil(high / step));
      for (auto k = static_cast<long>(std::floor(low / step)); k <= last; ++k)
        track(k, space * Rational(static_cast<double>(k)));
      return;
    }
    if (low <= 0.0 && high >= 0.0)
      track(0, Rational(0));
    for (const long sign : {1L, -1L}) {
      // Sums of doubles are exact rationals with few digits.
      Rational distance = 0;
      for (long k = sign;; k += sign) {
        distance += static_cast<int>(sign) * spacing(k);
        const double d = exact::nearest(distance);
        if (sign > 0 ? d > high : d < low)
          break;
        if (d >= low && d <= high)
          track(k, distance);
      }
    }
  }

  // Lines at Poisson distances from the start, in isotropic directions.
  void poisson() {
    const double far = (window_.centre() - near_).norm() + window_.radius();
    for (const long sign : {1L, -1L}) {
      Rational distance = 0;
      for (long k = sign;; k += sign) {
        distance += static_cast<int>(sign) * spacing(k);
        const double d = exact::nearest(distance);
        if (std::abs(d) > far)
          break;
        const Rational dip = Rational(180) * Rational(random(counter(k), 0, dip_use));
        const Vec2 direction = exact::direction_of_degrees(dip),
                   normal = left_of(direction);
        const auto [low, high] = window_.range(near_, normal);
        if (d < low || d > high)
          continue;
        const Vector offset(Rational(normal.x()) * distance,
                            Rational(normal.y()) * distance);
        add_track(counter(k), start_ + offset, dip, direction, true);
      }
    }
  }

  void add_track(std::uint64_t track, const Point& foot, const Rational& dip,
                 const Vec2& direction, bool random_phase) {
    watch();
    if (through_going()) {
      add_line(foot, turned(dip, direction, track, 0));
      return;
    }
    // The interval of trace and gap about the foot. The interval that contains a given
    // point is longer than the others on average: its probability is proportional to
    // its length.
    Rational trace, gap;
    const double longest = set_.trace.mean.value() + set_.trace.deviation.value() +
                           set_.gap.mean.value() + set_.gap.deviation.value();
    const bool constant =
        set_.trace.deviation.value() == 0.0 && set_.gap.deviation.value() == 0.0;
    Rational begin = 0;
    std::uint32_t redraw = 0;
    do {
      trace = draw(set_.trace, track, redraw, chosen + trace_use);
      gap = draw(set_.gap, track, redraw, chosen + gap_use);
    } while (random_phase && !constant &&
             random(track, redraw++, chosen) * longest > exact::nearest(trace + gap));
    if (random_phase)
      begin = Rational(-random(track, 0, phase_use) * exact::nearest(trace + gap));
    const auto range = window_.range(exact::nearest(foot), direction);
    const double low = range.first, high = range.second;
    const double half =
        set_.dip.deviation.value() > 0.0
            ? (set_.trace.mean.value() + set_.trace.deviation.value()) / 2.0
            : 0.0;
    const double from = low - half, to = high + half;
    const auto add = [&](const Rational& at, const Rational& length, int j) {
      if (exact::nearest(at + length) >= from && exact::nearest(at) <= to)
        add_trace(foot, at, length, dip, direction, track, counter(j), low, high);
    };
    add(begin, trace, 0);
    Rational at = begin + trace + gap;
    for (int j = 1; exact::nearest(at) <= to; ++j) {
      watch();
      const Rational length = draw(set_.trace, track, counter(j), trace_use);
      add(at, length, j);
      at += length + draw(set_.gap, track, counter(j), gap_use);
    }
    at = begin;
    for (int j = -1; exact::nearest(at) >= from; --j) {
      watch();
      const Rational length = draw(set_.trace, track, counter(j), trace_use);
      at -= length + draw(set_.gap, track, counter(j), gap_use);
      add(at, length, j);
    }
  }

  Vec2 turned(const Rational& dip, const Vec2& direction, std::uint64_t track,
              std::uint32_t piece) const {
    if (set_.dip.deviation.value() == 0.0 || set_.law == SpacingLaw::poisson)
      return direction;
    const Rational u(2.0 * random(track, piece, dip_use) - 1.0);
    return exact::direction_of_degrees(dip + exact::rational(set_.dip.deviation) * u);
  }

  static Point along(const Point& foot, const Vec2& direction, const Rational& at) {
    return {foot.x() + Rational(direction.x()) * at,
            foot.y() + Rational(direction.y()) * at};
  }

  // The line reaches beyond the window. Its ends have coarse parameters, because short
  // numbers are faster.
  void add_line(const Point& foot, const Vec2& direction) {
    const auto [low, high] = window_.range(exact::nearest(foot), direction);
    add_piece(along(foot, direction, Rational(coarse_below(low))),
              along(foot, direction, Rational(-coarse_below(-high))));
  }
  double coarse_below(double value) const {
    const double unit = std::exp2(std::floor(std::log2(window_.radius())) - 6.0);
    return unit * (std::floor(value / unit) - 1.0);
  }

  void add_trace(const Point& foot, const Rational& at, const Rational& length,
                 const Rational& dip, const Vec2& direction, std::uint64_t track,
                 std::uint32_t piece, double low, double high) {
    const Vec2 own = turned(dip, direction, track, piece);
    if (own == direction) {
      // What is beyond the window is left out.
      const Rational from =
          exact::nearest(at) < low && !set_.whole ? Rational(coarse_below(low)) : at;
      const Rational to = exact::nearest(at + length) > high && !set_.whole
                              ? Rational(-coarse_below(-high))
                              : Rational(at + length);
      if (from < to)
        add_piece(along(foot, direction, from), along(foot, direction, to));
      return;
    }
    const Point middle = along(foot, direction, at + length / 2);
    add_piece(along(middle, own, -length / 2), along(middle, own, length / 2));
  }

  void add_piece(const Point& p, const Point& q) {
    if (static_cast<double>(pieces_.size()) >= max_joint_pieces)
      refuse(set_, "the joint set has too many pieces",
             "give a larger spacing or trace");
    pieces_.push_back({exact::exact_point(p), exact::exact_point(q), set_.id});
  }

  const JointSet& set_;
  StepProgress progress_;
  Window window_;
  Point start_;
  Vec2 near_;  ///< start_, rounded
  Rational dip_;
  Vec2 direction_;
  double expected_ = 1.0;
  double done_ = 0.0;  ///< tracks and traces, also those that do not meet the window
  std::vector<JointSegment> pieces_;
};

}  // namespace

double expected_pieces(const JointSet& set, const std::vector<DecimalPoint>& outline) {
  const RoundToNearest mode;
  check(set);
  return Generator(set, outline, {}).expected();
}

std::vector<JointSegment> joint_set(const JointSet& set,
                                    const std::vector<DecimalPoint>& outline,
                                    const ProgressFunction& progress) {
  const RoundToNearest mode;
  if (!(expected_pieces(set, outline) <= max_joint_pieces))
    refuse(set, "the joint set has too many pieces for its spacing",
           "give a larger spacing or trace, or a start near the outline");
  return Generator(set, outline, progress).pieces();
}

}  // namespace blocks::geometry
