#include "linked_list.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace blocks::bench {
namespace {

constexpr double slack = 1e-6;                         // of an edge's length (rule 10)
constexpr double sin_minus_10 = -0.17364817766693035;  // (20)
constexpr double inadmissible = std::numeric_limits<double>::infinity();

/// (4), for the lightest block.
double critical_time_step(const Model& model) {
  const Settings& s = model.settings;
  return s.fraction * 2.0 *
         std::sqrt(model.blocks.mass.minCoeff() /
                   std::max(s.normal_stiffness, s.shear_stiffness));
}

}  // namespace

LinkedListCode::LinkedListCode(const Model& start, Checks checks)
    : checks_(checks), settings_(start.settings), dt_(critical_time_step(start)) {
  const blocks::Blocks& from = start.blocks;
  const Loads& loads = start.loads;
  if (!settings_.rigid || !settings_.planes.empty() || !loads.pressures.empty() ||
      !loads.forces.empty())
    throw std::invalid_argument("linked lists: rigid blocks without planes and loads");
  const Vec2 size = settings_.upper - settings_.lower;
  boxes_per_length_ = {settings_.boxes_x / size.x(), settings_.boxes_y / size.y()};
  most_corners_ = 0;
  for (int b = 0; b < from.size(); ++b)
    most_corners_ = std::max(most_corners_, from.corners_of(b));
  boxes_.assign(static_cast<std::size_t>(settings_.boxes_x) * settings_.boxes_y, none);
  corners_.resize(static_cast<std::size_t>(from.size()) * most_corners_);
  for (int b = 0; b < from.size(); ++b) {
    blocks_.push_back({from.corners_of(b),
                       !from.is_free(b),
                       from.convex[b] != 0,
                       none,
                       from.centroid(0, b),
                       from.centroid(1, b),
                       from.velocity(0, b),
                       from.velocity(1, b),
                       from.spin[b],
                       0.0,
                       0.0,
                       0.0,
                       {},
                       from.mass[b],
                       from.inertia[b],
                       from.area[b]});
    free_ += from.is_free(b) ? 1 : 0;
    for (int k = 0; k < from.corners_of(b); ++k) {
      const int c = from.first_corner[b] + k;
      Corner& own = corner(b, k);
      own = {from.corner(0, c),
             from.corner(1, c),
             from.arm(0, c),
             from.arm(1, c),
             0,
             none};
      own.box = box_of(own.x, own.y);
      own.link = std::exchange(boxes_[own.box], b * most_corners_ + k);
    }
  }
  find_contacts();
  for (int i = 0; i < start.contacts.size(); ++i) {
    const int b = from.corner_block[start.contacts.edge[i]];
    const int other = from.corner_block[start.contacts.corner[i]];
    for (int address = blocks_[b].contact; address != none;
         address = contacts_[address].link) {
      Contact& record = contacts_[address];
      if (record.block == other &&
          record.edge == start.contacts.edge[i] - from.first_corner[b] &&
          record.corner == start.contacts.corner[i] - from.first_corner[other]) {
        record.active = start.contacts.active[i] != 0;
        record.fn = start.contacts.at(i).normal_elastic;
        record.fs = start.contacts.at(i).shear_elastic;
      }
    }
  }
}

Eigen::Matrix2Xd LinkedListCode::corners() const {
  std::vector<const Corner*> all;
  for (int b = 0; b < static_cast<int>(blocks_.size()); ++b)
    for (int k = 0; k < blocks_[b].corners; ++k)
      all.push_back(&corner(b, k));
  Eigen::Matrix2Xd result(2, static_cast<Eigen::Index>(all.size()));
  for (std::size_t c = 0; c < all.size(); ++c)
    result.col(static_cast<Eigen::Index>(c)) << all[c]->x, all[c]->y;
  return result;
}

int LinkedListCode::acting_contacts() const {
  return static_cast<int>(
      std::count_if(contacts_.begin(), contacts_.end(),
                    [](const Contact& record) { return record.active; }));
}

void LinkedListCode::run(long steps) {
  for (long i = 0; i < steps; ++i)
    step();
}

void LinkedListCode::step() {
  if (update_)
    find_contacts();
  contact_forces();
  move();
}

int LinkedListCode::box_of(double x, double y) const {
  const int i = static_cast<int>((x - settings_.lower.x()) * boxes_per_length_.x()),
            j = static_cast<int>((y - settings_.lower.y()) * boxes_per_length_.y());
  return std::clamp(j, 0, settings_.boxes_y - 1) * settings_.boxes_x +
         std::clamp(i, 0, settings_.boxes_x - 1);
}

void LinkedListCode::find_contacts() {
  for (int b = 0; b < static_cast<int>(blocks_.size()); ++b)
    for (int edge = 0; edge < blocks_[b].corners; ++edge)
      find_contacts_of_edge(b, edge);
  update_ = false;
  travel_ = 0.0;
  ++searches_;
}

void LinkedListCode::find_contacts_of_edge(int b, int edge) {
  const Corner &p1 = corner(b, edge), &p2 = corner(b, after(b, edge));
  const double near = 2.0 * settings_.contact_tolerance;
  const double ex = p2.x - p1.x, ey = p2.y - p1.y, length2 = ex * ex + ey * ey;
  const int first = box_of(std::min(p1.x, p2.x) - near, std::min(p1.y, p2.y) - near),
            last = box_of(std::max(p1.x, p2.x) + near, std::max(p1.y, p2.y) + near);
  const int columns = settings_.boxes_x;
  for (int row = first / columns; row <= last / columns; ++row)
    for (int column = first % columns; column <= last % columns; ++column)
      for (int address = boxes_[row * columns + column]; address != none;
           address = corners_[address].link) {
        const int other = address / most_corners_, k = address % most_corners_;
        if (other == b || (blocks_[b].fixed && blocks_[other].fixed))
          continue;
        const Corner& c = corners_[address];
        const double s =
            std::clamp(((c.x - p1.x) * ex + (c.y - p1.y) * ey) / length2, 0.0, 1.0);
        const double dx = c.x - p1.x - s * ex, dy = c.y - p1.y - s * ey;
        if (dx * dx + dy * dy > near * near || listed(b, edge, other, k))
          continue;
        contacts_.push_back({edge, k, other, blocks_[b].contact, false, 0.0, 0.0, 0.0,
                             0.0, 0.0, 0.0, 0.0});
        blocks_[b].contact = static_cast<int>(contacts_.size()) - 1;
      }
}

bool LinkedListCode::listed(int b, int edge, int other, int k) const {
  for (int address = blocks_[b].contact; address != none;
       address = contacts_[address].link) {
    const Contact& record = contacts_[address];
    if (record.edge == edge && record.block == other && record.corner == k)
      return true;
  }
  return false;
}

void LinkedListCode::contact_forces() {
  for (Block& block : blocks_) {
    block.fx = block.fy = block.moment = 0.0;
    std::fill(std::begin(block.applied), std::end(block.applied), 0.0);
  }
  for (int b = 0; b < static_cast<int>(blocks_.size()); ++b)
    for (int address = blocks_[b].contact; address != none;
         address = contacts_[address].link) {
      Contact& record = contacts_[address];
      if (touches(b, record)) {
        act(b, record);
      } else {
        record.active = false;
        record.overlap = record.fn = record.fs = 0.0;
      }
    }
}

/// The checks of report 3.3, with the slack of rule 10.
bool LinkedListCode::touches(int b, const Contact& record) const {
  const Corner &c = corner(record.block, record.corner), &p1 = corner(b, record.edge),
               &p2 = corner(b, after(b, record.edge));
  const double ex = p2.x - p1.x, ey = p2.y - p1.y, wx = c.x - p1.x, wy = c.y - p1.y;
  if (!(wx * ey - wy * ex > 0.0))  // (19)
    return false;
  if (checks_ == Checks::program)
    return touches_nearest(b, record);
  const double length = std::sqrt(ex * ex + ey * ey);
  const double along = (wx * ex + wy * ey) / length;
  return along >= -slack * length && along <= (1.0 + slack) * length &&
         faces(ey / length, ex / length, record.block, record.corner);
}

bool LinkedListCode::touches_nearest(int b, const Contact& record) const {
  if (blocks_[b].convex && !inside(b, corner(record.block, record.corner)))
    return false;
  const double depth =
      admissible_depth(b, record.edge, record.block, record.corner, inadmissible);
  if (depth == inadmissible)
    return false;
  for (int edge = 0; edge < blocks_[b].corners; ++edge)
    if (edge != record.edge &&
        admissible_depth(b, edge, record.block, record.corner, depth) < depth)
      return false;
  return true;
}

/// Behind all edges, up to the slack.
bool LinkedListCode::inside(int b, const Corner& c) const {
  for (int edge = 0; edge < blocks_[b].corners; ++edge) {
    const Corner &p1 = corner(b, edge), &p2 = corner(b, after(b, edge));
    const double ex = p2.x - p1.x, ey = p2.y - p1.y;
    if ((c.x - p1.x) * ey - (c.y - p1.y) * ex < -slack * (ex * ex + ey * ey))
      return false;
  }
  return true;
}

/// Overlap of a corner with an edge; infinite where it is not below the limit or the
/// checks of 3.3 exclude it.
double LinkedListCode::admissible_depth(int b, int edge, int other, int k,
                                        double limit) const {
  const Corner &c = corner(other, k), &p1 = corner(b, edge),
               &p2 = corner(b, after(b, edge));
  const double ex = p2.x - p1.x, ey = p2.y - p1.y;
  const double length = std::sqrt(ex * ex + ey * ey);
  const double cosine = ex / length, sine = ey / length;
  const double wx = c.x - p1.x, wy = c.y - p1.y;
  const double depth = wx * sine - wy * cosine, along = wx * cosine + wy * sine;
  if (!(depth < limit))
    return inadmissible;
  // between the corners of the edge; of a convex block that is asked as a whole
  if (!blocks_[b].convex && (depth < -slack * length || along < -slack * length ||
                             along > (1.0 + slack) * length))
    return inadmissible;
  // not deeper than the centroid
  if (depth > (blocks_[b].x - p1.x) * sine - (blocks_[b].y - p1.y) * cosine)
    return inadmissible;
  return faces(sine, cosine, other, k) ? depth : inadmissible;
}

/// (20), for both edges of the corner.
bool LinkedListCode::faces(double sine, double cosine, int other, int k) const {
  const Corner& c = corner(other, k);
  for (const int neighbour : {before(other, k), after(other, k)}) {
    const double tx = corner(other, neighbour).x - c.x,
                 ty = corner(other, neighbour).y - c.y;
    if ((ty * cosine - tx * sine) / std::sqrt(tx * tx + ty * ty) < sin_minus_10)
      return false;
  }
  return true;
}

void LinkedListCode::act(int b, Contact& record) {
  const Corner &c = corner(record.block, record.corner), &p1 = corner(b, record.edge),
               &p2 = corner(b, after(b, record.edge));
  Block &one = blocks_[record.block], &two = blocks_[b];
  const double ex = p2.x - p1.x, ey = p2.y - p1.y;
  const double length = std::sqrt(ex * ex + ey * ey);
  record.cosine = ex / length;
  record.sine = ey / length;
  record.x = c.x;
  record.y = c.y;
  record.overlap = (c.x - p1.x) * record.sine - (c.y - p1.y) * record.cosine;

  // velocity of the corner against the edge
  const double x1 = record.x - one.x, y1 = record.y - one.y;
  const double x2 = record.x - two.x, y2 = record.y - two.y;
  const double vx = (one.vx - one.spin * y1) - (two.vx - two.spin * y2);
  const double vy = (one.vy + one.spin * x1) - (two.vy + two.spin * x2);
  const double closing = vx * record.sine - vy * record.cosine;
  const double sliding = vx * record.cosine + vy * record.sine;

  // (16)-(18)
  const double mass = one.fixed   ? two.mass
                      : two.fixed ? one.mass
                                  : one.mass * two.mass / (one.mass + two.mass);
  const double damping =
      2.0 * settings_.damping * std::sqrt(settings_.normal_stiffness * mass);
  double share = 1.0;  // of the step in which the contact began
  if (!record.active && closing * dt_ > record.overlap)
    share = record.overlap / (closing * dt_);
  record.fn =
      std::max(0.0, record.fn + share * settings_.normal_stiffness * closing * dt_);
  if (!record.active)
    record.fn = std::min(record.fn, settings_.normal_stiffness * record.overlap);
  const double normal = std::max(0.0, record.fn + damping * closing);
  const double limit = settings_.friction * normal;
  const double trial = record.fs + share * settings_.shear_stiffness * sliding * dt_;
  record.fs = std::clamp(trial, -limit, limit);
  const double shear = record.fs != trial
                           ? record.fs
                           : std::clamp(record.fs + damping * sliding, -limit, limit);
  record.active = true;

  const double fx = -normal * record.sine - shear * record.cosine;
  const double fy = normal * record.cosine - shear * record.sine;
  const auto add = [](Block& block, double x, double y, double px, double py) {
    block.fx += px;
    block.fy += py;
    block.moment += x * py - y * px;
    block.applied[0] += px * x;
    block.applied[1] += px * y;
    block.applied[2] += py * x;
    block.applied[3] += py * y;
  };
  add(one, x1, y1, fx, fy);
  add(two, x2, y2, -fx, -fy);
}

void LinkedListCode::move() {
  double largest = 0.0;
  for (int b = 0; b < static_cast<int>(blocks_.size()); ++b) {
    Block& block = blocks_[b];
    for (double& sum : block.applied)
      sum /= block.area;
    if (block.fixed)
      continue;
    block.vx += dt_ * (block.fx / block.mass + settings_.gravity.x());
    block.vy += dt_ * (block.fy / block.mass + settings_.gravity.y());
    block.spin += dt_ * (block.moment / block.inertia);
    block.x += dt_ * block.vx;
    block.y += dt_ * block.vy;
    const double h = 0.5 * dt_ * block.spin, scale = 1.0 / (1.0 + h * h);
    const double cosine = (1.0 - h * h) * scale, sine = 2.0 * h * scale;
    for (int k = 0; k < block.corners; ++k) {
      Corner& own = corner(b, k);
      const double x = cosine * own.arm_x - sine * own.arm_y,
                   y = sine * own.arm_x + cosine * own.arm_y;
      own.arm_x = x;
      own.arm_y = y;
      const double dx = block.x + x - own.x, dy = block.y + y - own.y;
      largest = std::max(largest, dx * dx + dy * dy);
      own.x = block.x + x;
      own.y = block.y + y;
      rebox(b * most_corners_ + k);
    }
  }
  travel_ += std::sqrt(largest);
  update_ = travel_ > settings_.contact_tolerance;
}

void LinkedListCode::rebox(int address) {
  Corner& own = corners_[address];
  const int box = box_of(own.x, own.y);
  if (box == own.box)
    return;
  int* link = &boxes_[own.box];
  while (*link != address)
    link = &corners_[*link].link;
  *link = own.link;
  own.box = box;
  own.link = std::exchange(boxes_[box], address);
}

}  // namespace blocks::bench
