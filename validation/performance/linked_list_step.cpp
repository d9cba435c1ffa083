// One step of the code of 1982: FORD with its checks, MOTION and REBOX.
#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/contact_constants.hpp"
#include "linked_list.hpp"

namespace blocks::bench {
namespace {

constexpr double slack = geometry::contact_slack;
constexpr double sin_minus_10 = -0.17364817766693035;  // (20)

}  // namespace

void LinkedListCode::step() {
  if (update_)
    find_contacts();
  contact_forces();
  move();
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

/// Applies the checks of report 3.3, with slack (docs/departures.md#between).
bool LinkedListCode::touches(int b, const Contact& record) const {
  const Corner &c = corner(record.block, record.corner), &p1 = corner(b, record.edge),
               &p2 = corner(b, after(b, record.edge));
  const double ex = p2.x - p1.x, ey = p2.y - p1.y, wx = c.x - p1.x, wy = c.y - p1.y;
  if (!(wx * ey - wy * ex > 0.0))  // (19)
    return false;
  const double length = std::sqrt(ex * ex + ey * ey);
  const double along = (wx * ex + wy * ey) / length;
  return along >= -slack * length && along <= (1.0 + slack) * length &&
         faces(ey / length, ex / length, record.block, record.corner);
}

/// Applies (20) to both edges of the corner.
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

  // The velocity of the corner relative to the edge, at the time of the positions
  // (docs/theory.md#the-velocities-of-a-contact).
  const double x1 = record.x - one.x, y1 = record.y - one.y;
  const double x2 = record.x - two.x, y2 = record.y - two.y;
  const double in1 = 0.5 * dt_ * one.spin * one.spin,
               in2 = 0.5 * dt_ * two.spin * two.spin;
  const double ux =
      (one.vx - one.spin * y1 + in1 * x1) - (two.vx - two.spin * y2 + in2 * x2);
  const double uy =
      (one.vy + one.spin * x1 + in1 * y1) - (two.vy + two.spin * x2 + in2 * y2);
  const double turn = 0.25 * dt_ * (one.spin + two.spin);
  const double vx = ux - turn * uy, vy = uy + turn * ux;
  const double closing = vx * record.sine - vy * record.cosine;
  const double sliding = vx * record.cosine + vy * record.sine;

  // Equations (16) to (18).
  const double mass = one.fixed   ? two.mass
                      : two.fixed ? one.mass
                                  : one.mass * two.mass / (one.mass + two.mass);
  const double damping =
      2.0 * settings_.damping * std::sqrt(settings_.normal_stiffness * mass);
  double share = 1.0;  // part of the step since the contact began
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
      rebox(b * max_corners_ + k);
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
