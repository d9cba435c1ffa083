#include "post/read/crack_tracker.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace blocks::post {
namespace {

using Vector = Eigen::Vector2d;
using Outline = std::vector<Vector>;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// x' = matrix x + offset.
struct Affine {
  Eigen::Matrix2d matrix = Eigen::Matrix2d::Identity();
  Vector offset = Vector::Zero();
  Vector operator()(const Vector& p) const { return matrix * p + offset; }
};

Vector mean_of(const Outline& outline) {
  Vector sum = Vector::Zero();
  for (const Vector& p : outline)
    sum += p;
  return sum / static_cast<double>(outline.size());
}

/// Returns the affine map that takes one outline to the other, with the least squares
/// of the distances. Both have the same corners, at least three.
Affine fit(const Outline& from, const Outline& to) {
  const Vector middle = mean_of(from), image = mean_of(to);
  Eigen::Matrix2d both = Eigen::Matrix2d::Zero(), own = both;
  for (std::size_t k = 0; k < from.size(); ++k) {
    both += (to[k] - image) * (from[k] - middle).transpose();
    own += (from[k] - middle) * (from[k] - middle).transpose();
  }
  Affine map;
  map.matrix = both * own.inverse();
  map.offset = image - map.matrix * middle;
  return map;
}

Vector turned(const Vector& v, double angle) { return Eigen::Rotation2Dd(angle) * v; }

double distance_to_segment(const Vector& p, const Vector& a, const Vector& b) {
  const Vector along = b - a;
  const double square = along.squaredNorm();
  const double part =
      square > 0.0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0.0;
  return (p - a - part * along).norm();
}

/// A block of the earlier frame that splits, and its way back to the first frame.
class Whole {
 public:
  /// at: [T] time of its first crack.
  Whole(const Frame& before, int b, const Outline& first, double at)
      : back_(fit(before.outlines[static_cast<std::size_t>(b)], first)),
        centroid_(before.centroid.col(b)), velocity_(before.velocity.col(b)),
        before_(before.time), at_(at), angle_(before.angle[b]), spin_(before.spin[b]) {}

  /// Returns the place in the first frame of a point of the block, which is at p at a
  /// time between the frames.
  Vector first_place(const Vector& p, double time) const {
    return first_place(p, time, spin_ * (time - before_));
  }
  /// Returns the place in the first frame of a point of piece b at p in the later
  /// frame.
  Vector first_place(const Vector& p, const Frame& now, int b) const {
    const double after = now.time - at_;
    const Vector centroid = now.centroid.col(b), velocity = now.velocity.col(b);
    const double turn = now.spin[b] * after;
    const Vector at_crack = centroid - velocity * after + turned(p - centroid, -turn);
    return first_place(at_crack, at_, now.angle[b] - angle_ - turn);
  }

 private:
  Vector first_place(const Vector& p, double time, double turn) const {
    const Vector moved = centroid_ + velocity_ * (time - before_);
    return back_(centroid_ + turned(p - moved, -turn));
  }

  Affine back_;  ///< from the earlier frame to the first one
  Vector centroid_, velocity_;
  double before_, at_, angle_, spin_;
};

/// What a piece has in the first frame.
struct FirstPiece {
  Outline outline;
  Vector centroid = Vector::Constant(none);
  std::vector<int> faces;
  char later = 0;
};

/// The chord of a crack in the first frame.
struct FirstChord {
  Vector from, to;
  int face;
};

/// Returns the crack that made each side of a piece, or 0. A side is on a new chord, or
/// on the side of the whole block that is nearest to it.
std::vector<int> faces_of(const Outline& piece, const CrackedBlocks& blocks, int whole,
                          const std::vector<FirstChord>& chords) {
  const Outline& old = blocks.first.outlines[static_cast<std::size_t>(whole)];
  std::vector<int> faces;
  for (std::size_t k = 0; k < piece.size(); ++k) {
    const Vector middle = 0.5 * (piece[k] + piece[(k + 1) % piece.size()]);
    double min = std::numeric_limits<double>::infinity();
    int face = 0;
    const auto compare = [&](const Vector& from, const Vector& to, int its_face) {
      const double distance = distance_to_segment(middle, from, to);
      if (distance < min)
        min = distance, face = its_face;
    };
    for (std::size_t s = 0; s < old.size(); ++s)
      compare(old[s], old[(s + 1) % old.size()], blocks.face(whole, s));
    for (const FirstChord& chord : chords)
      compare(chord.from, chord.to, chord.face);
    faces.push_back(face);
  }
  return faces;
}

}  // namespace

CrackTracker::CrackTracker(Frame first, std::vector<Crack> cracks)
    : cracks_(std::move(cracks)) {
  blocks_.cracks = first.cracks;
  blocks_.version.resize(static_cast<std::size_t>(first.size()));
  blocks_.faces.resize(static_cast<std::size_t>(first.size()));
  blocks_.later.resize(static_cast<std::size_t>(first.size()));
  blocks_.first = std::move(first);
}

void CrackTracker::advance(const Frame& before, const Frame& now) {
  if (is_behind(now)) {
    place_later_blocks(before);
    split(before, now);
  }
  place_later_blocks(now);
}

/// Makes space for the blocks of a frame, and moves those that were made later there.
void CrackTracker::place_later_blocks(const Frame& now) {
  Frame& first = blocks_.first;
  const auto size = static_cast<std::size_t>(now.size());
  if (blocks_.later.size() < size) {
    first.centroid.conservativeResize(2, now.size());
    first.outlines.resize(size);
    blocks_.version.resize(size);
    blocks_.faces.resize(size);
    blocks_.later.resize(size, 1);
  }
  for (std::size_t b = 0; b < size; ++b)
    if (blocks_.later[b] != 0) {
      const auto column = static_cast<Eigen::Index>(b);
      first.centroid.col(column) = now.centroid.col(column);
      first.outlines[b] = now.outlines[b];
    }
}

void CrackTracker::split(const Frame& before, const Frame& now) {
  // Blocks that split again between the two frames are pieces of the same whole.
  std::map<int, int> whole_of;
  std::map<int, Whole> wholes;
  std::map<int, std::vector<FirstChord>> chords;
  const auto begin = static_cast<std::size_t>(blocks_.cracks),
             end = std::min(static_cast<std::size_t>(now.cracks), cracks_.size());
  for (std::size_t i = begin; i < end; ++i) {
    const Crack& crack = cracks_[i];
    const int parent = crack.parent - 1, child = crack.child - 1;
    if (std::max(parent, child) >= now.size())
      continue;
    const int whole = whole_of.try_emplace(parent, parent).first->second;
    whole_of[child] = whole;
    const auto w = static_cast<std::size_t>(whole);
    if (whole >= before.size() || before.outlines[w].size() < 3 ||
        before.outlines[w].size() != blocks_.first.outlines[w].size())
      continue;
    const Whole& one =
        wholes.try_emplace(whole, before, whole, blocks_.first.outlines[w], crack.time)
            .first->second;
    chords[whole].push_back({one.first_place(crack.from, crack.time),
                             one.first_place(crack.to, crack.time),
                             static_cast<int>(i) + 1});
  }
  std::map<int, FirstPiece> pieces;
  for (const auto& [b, whole] : whole_of) {
    FirstPiece& piece = pieces[b];
    const auto found = wholes.find(whole);
    if (found == wholes.end() || now.is_removed(b))
      continue;
    const auto place = [&, b = b](const Vector& p) {
      return found->second.first_place(p, now, b);
    };
    piece.later = blocks_.later[static_cast<std::size_t>(whole)];
    piece.centroid = place(now.centroid.col(b));
    for (const Vector& p : now.outlines[static_cast<std::size_t>(b)])
      piece.outline.push_back(place(p));
    piece.faces = faces_of(piece.outline, blocks_, whole, chords[whole]);
  }
  place_later_blocks(now);
  for (auto& [b, piece] : pieces) {
    const auto k = static_cast<std::size_t>(b);
    blocks_.later[k] = piece.later;
    blocks_.first.outlines[k] = std::move(piece.outline);
    blocks_.first.centroid.col(b) = piece.centroid;
    blocks_.faces[k] = std::move(piece.faces);
    ++blocks_.version[k];
  }
  blocks_.cracks = now.cracks;
}

CrackedBlocks cracked_blocks(const std::vector<const ResultsReader*>& parts,
                             const Frame& now) {
  Frame before = parts.front()->frame(0);
  CrackTracker tracker(before, parts.back()->cracks());
  for (std::size_t part = 0; part < parts.size() && tracker.is_behind(now); ++part) {
    const auto& times = parts[part]->times();
    for (std::size_t i = 0; i < times.size(); ++i) {
      if (times[i] >= now.time ||
          (part + 1 < parts.size() && times[i] >= parts[part + 1]->times().front()))
        break;
      Frame later = parts[part]->frame(static_cast<long>(i));
      tracker.advance(before, later);
      before = std::move(later);
    }
  }
  tracker.advance(before, now);
  return tracker.blocks();
}

ResultsTracker::ResultsTracker(const ResultsReader& results)
    : results_(results), first_(results.frame(0)), tracker_(first_, results.cracks()) {}

const CrackedBlocks& ResultsTracker::at(long i, const Frame& now) {
  if (i < at_) {
    tracker_ = CrackTracker(first_, tracker_.cracks());
    at_ = 0;
  }
  const auto& times = results_.times();
  while (tracker_.is_behind(now)) {
    // Goes to the first frame after the next crack.
    const auto next = static_cast<std::size_t>(tracker_.blocks().cracks);
    long k = at_ + 1;
    if (next < tracker_.cracks().size()) {
      const double time = tracker_.cracks()[next].time;
      const auto later = std::lower_bound(times.begin() + k, times.begin() + i, time);
      k = later - times.begin();
    }
    Frame before = results_.frame(k - 1);
    while (k < i) {
      Frame after = results_.frame(k);
      if (tracker_.is_behind(after)) {
        tracker_.advance(before, after);
        break;
      }
      before = std::move(after);
      ++k;
    }
    if (k >= i)
      tracker_.advance(before, now);
    at_ = std::min(k, i);
  }
  tracker_.advance(now, now);
  at_ = std::max(at_, i);
  return tracker_.blocks();
}

}  // namespace blocks::post
