#include "geometry/exact/joint_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "geometry/exact/shared_point.hpp"

namespace blocks::geometry::exact {
namespace {

// Cuts off what is outside the window. Returns false if nothing remains.
bool clip(Point& p, Point& q) {
  const Rational limit(4.0 * largest_coordinate);
  Rational first = 0, last = 1;  // of p + t (q - p)
  const auto d = q - p;
  for (const auto& [from, run] : {std::pair(p.x(), d.x()), std::pair(p.y(), d.y())}) {
    if (run == 0) {
      if (abs(from) > limit)
        return false;
      continue;
    }
    Rational in = (-limit - from) / run, out = (limit - from) / run;
    if (out < in)
      std::swap(in, out);
    first = std::max(first, in);
    last = std::min(last, out);
  }
  if (!(first < last))
    return false;
  const Point start = p;
  p = start + first * d;
  q = start + last * d;
  return true;
}

bool is_far(const ExactPoint& p) {
  return p.nearest().cwiseAbs().maxCoeff() > 4.0 * largest_coordinate;
}

// Groups and sorts pieces by the line and the order along it.
class Overlaps {
 public:
  explicit Overlaps(std::vector<JointPiece> pieces) : pieces_(std::move(pieces)) {
    for (JointPiece& piece : pieces_) {
      if (precedes(piece.to, piece.from))
        std::swap(piece.from, piece.to);
      Line& line = piece.line;
      if (line.a < 0 || (line.a == 0 && line.b < 0)) {
        line.a = -line.a;
        line.b = -line.b;
        line.c = -line.c;
        line.run = -line.run;
        line.rise = -line.rise;
      }
      starts_.push_back(nearest(piece.from));
    }
  }

  std::vector<JointPiece> split() {
    std::vector<std::size_t> order(pieces_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(),
              [this](std::size_t i, std::size_t j) { return less(i, j); });
    std::vector<std::size_t> run;  // pieces of one line without gaps between them
    const JointPiece* farthest = nullptr;
    for (const std::size_t i : order) {
      const JointPiece& piece = pieces_[i];
      if (!run.empty() && (compare(pieces_[run[0]].line, piece.line) != 0 ||
                           !precedes(piece.from, farthest->to))) {
        split_run(run);
        run.clear();
      }
      if (run.empty() || precedes(farthest->to, piece.to))
        farthest = &piece;
      run.push_back(i);
    }
    split_run(run);
    return std::move(result_);
  }

 private:
  static bool precedes(const Point& p, const Point& q) {
    return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y();
  }
  static int compare(const Line& s, const Line& t) {
    for (const auto member : {&Line::a, &Line::b, &Line::c})
      if (const int sign = mpz_cmp((s.*member).mpz(), (t.*member).mpz()); sign != 0)
        return sign;
    return 0;
  }
  bool less(std::size_t i, std::size_t j) const {
    if (const int sign = compare(pieces_[i].line, pieces_[j].line); sign != 0)
      return sign < 0;
    const Vec2 &p = starts_[i], &q = starts_[j];
    if (p != q)
      return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y();
    if (pieces_[i].from != pieces_[j].from)
      return precedes(pieces_[i].from, pieces_[j].from);
    return i < j;
  }

  // Splits overlapping pieces of one line at all their ends.
  void split_run(const std::vector<std::size_t>& run) {
    if (run.size() < 2) {
      for (const std::size_t i : run)
        result_.push_back(pieces_[i]);
      return;
    }
    std::vector<Point> ends;
    for (const std::size_t i : run)
      ends.insert(ends.end(), {pieces_[i].from, pieces_[i].to});
    std::sort(ends.begin(), ends.end(), precedes);
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    std::vector<std::size_t> by_end = run;
    std::sort(by_end.begin(), by_end.end(), [this](std::size_t i, std::size_t j) {
      return precedes(pieces_[i].to, pieces_[j].to);
    });
    std::multiset<int> joints;  // of the pieces that contain the present part
    std::size_t begun = 0, ended = 0;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      for (; begun < run.size() && pieces_[run[begun]].from == ends[k]; ++begun)
        joints.insert(pieces_[run[begun]].joint);
      for (; ended < run.size() && pieces_[by_end[ended]].to == ends[k]; ++ended)
        joints.erase(joints.find(pieces_[by_end[ended]].joint));
      const auto named = joints.upper_bound(0);
      result_.push_back({ends[k], ends[k + 1], named == joints.end() ? 0 : *named,
                         pieces_[run[0]].line});
    }
  }

  std::vector<JointPiece> pieces_, result_;
  std::vector<Vec2> starts_;
};

}  // namespace

int common_joint(int a, int b) { return a == 0 || b == 0 ? a + b : std::min(a, b); }

std::vector<JointPiece> joint_pieces(const std::vector<JointSegment>& joints) {
  std::vector<JointPiece> pieces;
  pieces.reserve(joints.size());
  for (const JointSegment& joint : joints) {
    Point p = point_of(joint.from), q = point_of(joint.to);
    if (p == q || ((is_far(joint.from) || is_far(joint.to)) && !clip(p, q)))
      continue;
    const Line line(p, q);
    pieces.push_back({p, q, joint.id, line});
  }
  return Overlaps(std::move(pieces)).split();
}

}  // namespace blocks::geometry::exact
