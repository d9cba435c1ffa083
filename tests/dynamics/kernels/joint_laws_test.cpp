// The laws of joints along given paths, against closed forms.
#include <gtest/gtest.h>

#include <algorithm>

#include "dynamics/expect_close.hpp"
#include "validation/laws/one_contact.hpp"

namespace blocks::validation {
namespace {

TEST(JointLaws, ShearStrengthFallsFromPeakToResidualInOneStep) {
  OneContact contact = bonded_joint(1 * MN);
  const double peak = 1.2002075382097097 * MN;  // 0.5 + tan 35
  slide(contact, 1 * MN, peak / (10 * GPa) * (1.0 - 1e-12), 1000);
  EXPECT_CLOSE(contact.force.shear, peak, 2e-12);
  EXPECT_EQ(contact.state.failed, 0.0);
  EXPECT_EQ(contact.state.slip, 0.0);

  contact.move(0.0, 3e-12 * peak / (10 * GPa));
  const double residual = 0.5773502691896257 * MN;
  EXPECT_CLOSE(contact.force.shear, residual, 1e-15);
  EXPECT_EQ(contact.state.failed, 1.0);
  EXPECT_EQ(contact.state.bonded, 0.0);
  EXPECT_CLOSE(contact.state.slip, (peak - residual) / (10 * GPa), 1e-11);

  contact.move(0.0, 1 * mm);
  EXPECT_CLOSE(contact.force.shear, residual, 1e-15);
  contact.move(0.0, -1.5 * mm);
  EXPECT_CLOSE(contact.force.shear, -residual, 1e-15);
  EXPECT_CLOSE(contact.state.path - contact.state.slip,
               2.0 * (1.5 * mm - 2.0 * residual / (10 * GPa)), 1e-12);
}

TEST(JointLaws, TensionFallsToItsResidual) {
  for (const double residual : {0.0, 0.05 * MPa}) {
    OneContact contact = bonded_joint(0.0);
    contact.law.tension = 0.2 * MPa, contact.law.residual_tension = residual;
    contact.state.length = 3.0;
    contact.move(-0.6 * MN / (10 * GPa), 0.0);  // the strength is not exceeded
    EXPECT_EQ(contact.state.failed, 0.0);
    EXPECT_CLOSE(contact.force.normal, -0.6 * MN, 1e-15);
    contact.move(-1e-12, 0.0);
    EXPECT_EQ(contact.state.failed, 1.0);
    EXPECT_EQ(contact.state.bonded, residual > 0.0 ? 1.0 : 0.0);
    EXPECT_EQ(contact.force.normal, -3.0 * residual);
    contact.move(-1 * mm, 0.0);
    EXPECT_EQ(contact.state.normal, -3.0 * residual);
  }
}

// A bond in tension that fails in shear has lost its tension too.
TEST(JointLaws, ShearFailureReleasesTension) {
  OneContact contact = bonded_joint(-0.1 * MN);
  contact.law.tension = 0.2 * MPa;
  contact.move(0.0, 1 * mm);
  EXPECT_EQ(contact.state.failed, 1.0);
  EXPECT_EQ(contact.state.bonded, 0.0);
  EXPECT_EQ(contact.force.normal, 0.0);
  EXPECT_EQ(contact.force.shear, 0.0);
}

TEST(JointLaws, DilationRisesToItsLimitAndComesBack) {
  OneContact contact = bonded_joint(1 * MN);
  contact.law.dilation = std::tan(10 * degree), contact.law.dilation_limit = 5 * mm;
  const double elastic = 0.5773502691896257 * MN / (10 * GPa);
  slide(contact, 1 * MN, 4 * mm + elastic, 4000);
  EXPECT_CLOSE(contact.state.offset, 4 * mm * std::tan(10 * degree), 1e-12);
  slide(contact, 1 * MN, 4 * mm, 4000);
  EXPECT_CLOSE(contact.state.offset, 0.8816349035423249 * mm, 1e-12);
  slide(contact, 1 * MN, -(8 * mm + 2.0 * elastic), 8000);
  EXPECT_NEAR(contact.state.slip, 0.0, 1e-15);
  EXPECT_NEAR(contact.state.offset, 0.0, 1e-15);
  slide(contact, 1 * MN, -3 * mm, 3000);
  EXPECT_CLOSE(contact.state.offset, 3 * mm * std::tan(10 * degree), 1e-12);
}

TEST(JointLaws, DilationPressesIfTheTopIsHeld) {
  OneContact contact = bonded_joint(1 * MN);
  contact.law.dilation = std::tan(10 * degree), contact.law.dilation_limit = 5 * mm;
  for (int i = 0; i < 10'000; ++i)
    contact.move(0.0, 1e-3 * mm);
  EXPECT_CLOSE(contact.force.normal, 9.816349035423249 * MN, 1e-12);
  EXPECT_CLOSE(contact.force.shear, 5.667471758060936 * MN, 1e-12);
}

TEST(JointLaws, WaltonLoadsUnloadsAndReloads) {
  OneContact contact(Kind::walton, 2e8, 2e8);
  contact.law.unloading_ratio = 4.0;  // e = 0.5
  const auto at = [&](double closure) {
    contact.move(closure - contact.state.closure, 0.0);
    return contact.force.normal;
  };
  EXPECT_CLOSE(at(1 * mm), 2e5, 1e-15);
  EXPECT_CLOSE(at(4 * mm), 8e5, 1e-15);
  EXPECT_CLOSE(contact.state.plastic, 3 * mm, 1e-14);
  EXPECT_CLOSE(at(3.5 * mm), 4e5, 1e-14);
  EXPECT_EQ(at(2.5 * mm), 0.0);  // open, although the corner is still inside
  EXPECT_EQ(at(2.9 * mm), 0.0);
  EXPECT_CLOSE(contact.state.plastic, 3 * mm, 1e-14);
  EXPECT_CLOSE(at(3.5 * mm), 4e5, 1e-13);  // reloads from a0
  EXPECT_CLOSE(at(4 * mm), 8e5, 1e-13);
  EXPECT_CLOSE(at(5 * mm), 1e6, 1e-14);  // loads on
  EXPECT_CLOSE(contact.state.plastic, 3.75 * mm, 1e-14);
}

/// What a mass that strikes k contacts with 1 m/s does.
struct Rebound {
  double speed = 0.0, overlap = 0.0, force = 0.0, duration = 0.0, plastic = 0.0;
};
Rebound rebound(double e, int contacts) {
  constexpr double mass = 2000.0, stiffness = 2e8, dt = 2e-8;
  OneContact contact(Kind::walton, stiffness / contacts, 0.0);
  contact.law.unloading_ratio = 1.0 / (e * e);
  Rebound found;
  double speed = 1.0, depth = 0.0;
  contact.starts = true;
  do {
    speed -= contacts * contact.force.normal / mass * dt;
    depth += speed * dt;
    contact.overlap = depth;
    contact.move(speed * dt, 0.0);
    found.force = std::max(found.force, contacts * contact.force.normal);
    found.overlap = std::max(found.overlap, depth);
    found.duration += dt;
  } while (contact.force.normal > 0.0);
  found.speed = -speed, found.plastic = contact.state.plastic;
  return found;
}

TEST(JointLaws, WaltonReboundsWithTheGivenRestitution) {
  const Rebound half = rebound(0.5, 4);
  EXPECT_CLOSE(half.speed, 0.5, 2e-5);
  EXPECT_CLOSE(half.overlap, 3.1622776601683795 * mm, 2e-5);
  EXPECT_CLOSE(half.force, 632455.5320336759, 2e-5);
  EXPECT_CLOSE(half.duration, 7.450941199347074e-3, 2e-5);
  EXPECT_CLOSE(half.plastic, 2.3717082451262845 * mm, 2e-5);
  for (const int contacts : {1, 2})
    EXPECT_CLOSE(rebound(0.5, contacts).speed, 0.5, 2e-5);
  EXPECT_CLOSE(rebound(0.9, 2).speed, 0.9, 2e-5);
  EXPECT_CLOSE(rebound(1.0, 2).speed, 1.0, 2e-5);
}

// In the first step Walton's contact has closed by its overlap. A spring that it has
// received is on the line of first loading, and the force does not jump.
TEST(JointLaws, WaltonStartsWithItsOverlapAndKeepsReceivedSprings) {
  OneContact contact(Kind::walton, 2e8, 2e8);
  contact.law.unloading_ratio = 4.0;
  contact.starts = true, contact.overlap = 0.1 * mm;
  contact.move(1 * mm, 0.0);
  EXPECT_CLOSE(contact.force.normal, 2e4, 1e-14);

  contact.state.normal = 1e5, contact.starts = true, contact.overlap = 5 * mm;
  contact.move(0.0, 0.0);
  EXPECT_CLOSE(contact.force.normal, 1e5, 1e-14);
  contact.move(0.1 * mm, 0.0);
  EXPECT_CLOSE(contact.force.normal, 1.2e5, 1e-14);

  contact.state.normal = 1e6, contact.starts = true, contact.overlap = 1 * mm;
  contact.move(0.0, 0.0);
  EXPECT_CLOSE(contact.force.normal, 2e5, 1e-14);
}

TEST(JointLaws, BartonPeakStrength) {
  const struct {
    double stress, angle, strength;
  } rows[] = {{1, 50, 1.19175359259421},
              {10, 40, 8.390996311772799},
              {100, 30, 57.735026918962575}};
  for (const auto& row : rows) {
    OneContact contact = rough_joint(1e14);
    load(contact, row.stress * MN);
    EXPECT_CLOSE(contact.force.normal, row.stress * MN, 1e-14);
    contact.move(0.0, contact.law.peak_slip);
    EXPECT_CLOSE(contact.force.shear, row.strength * MN, 1e-13);
    EXPECT_CLOSE(std::atan2(contact.force.shear, contact.force.normal) / degree,
                 row.angle, 1e-13);
  }
}

TEST(JointLaws, BartonMobilisesAndWearsItsRoughness) {
  // Angles at 1 MPa for JRC 10, where the peak adds 20 degrees to 30.
  const struct {
    double u, angle;
  } rows[] = {{0, 0},     {.15, 15}, {.3, 30},    {.45, 37.5}, {.6, 45},
              {.8, 47.5}, {1, 50},   {1.5, 48.5}, {2, 47},     {3, 45.5},
              {4, 44},    {10, 40},  {55, 35},    {100, 30},   {200, 30}};
  OneContact once = rough_joint(1e14);
  EXPECT_CLOSE(once.law.peak_slip, 4.275924179004464 * mm, 1e-15);
  for (const auto& row : rows) {
    OneContact contact = rough_joint(1e14);
    load(contact, 1 * MN);
    contact.move(0.0, row.u * contact.law.peak_slip);
    EXPECT_NEAR(std::atan(contact.force.shear / (1 * MN)) / degree, row.angle, 1e-11);
  }
  // The strength depends on the length of the path, not on the steps.
  load(once, 1 * MN);
  slide(once, 1 * MN, 2.0 * once.law.peak_slip, 5000);
  EXPECT_CLOSE(once.force.shear, 1.0723687100246826 * MN, 1e-11);
  slide(once, 1 * MN, -8.0 * once.law.peak_slip, 5000);
  EXPECT_CLOSE(once.force.shear, -std::tan(40 * degree) * MN, 1e-4);
}

// The integral of tan(JRCm g / 2) over the slip, by Simpson's rule for each segment.
TEST(JointLaws, BartonDilatesByHalfTheAddedAngle) {
  const auto rate = [](double part) { return std::tan(part * 20 * degree / 2.0); };
  const double u[] = {0.3, 0.6, 1.0, 2.0}, parts[] = {0.0, 0.75, 1.0, 0.85};
  double exact = 0.0;
  for (int i = 0; i < 3; ++i)
    exact += (u[i + 1] - u[i]) / 6.0 *
             (rate(parts[i]) + 4.0 * rate((parts[i] + parts[i + 1]) / 2.0) +
              rate(parts[i + 1]));
  OneContact contact = rough_joint(1e15);
  load(contact, 1 * MN);
  slide(contact, 1 * MN, 0.3 * contact.law.peak_slip, 1000);
  EXPECT_NEAR(contact.state.offset, 0.0, 1e-15);
  slide(contact, 1 * MN, 1.7 * contact.law.peak_slip, 100'000);
  EXPECT_CLOSE(contact.state.offset, exact * contact.law.peak_slip, 2e-5);

  // Sliding back closes the joint, and cycles do not open it more and more.
  const double opening = contact.state.offset, slip = contact.state.slip;
  slide(contact, 1 * MN, -slip / 4.0, 10'000);
  EXPECT_CLOSE(contact.state.offset, 0.75 * opening, 1e-5);
  slide(contact, 1 * MN, -3.0 * slip / 4.0, 30'000);
  EXPECT_NEAR(contact.state.offset, 0.0, 1e-5 * opening);
  for (int cycle = 0; cycle < 20; ++cycle)
    for (const double sign : {1.0, -1.0})
      slide(contact, 1 * MN, sign * slip, 1000);
  EXPECT_LT(contact.state.offset, 0.01 * opening);
}

TEST(JointLaws, BartonAnglesAreAtMost70Degrees) {
  OneContact contact = rough_joint(1e14);
  contact.law.roughness = 20.0;
  load(contact, 1e-4 * MN);  // 30 + 20 * 6 degrees without the limit
  contact.move(0.0, contact.law.peak_slip);
  EXPECT_CLOSE(contact.force.shear / contact.force.normal, std::tan(70 * degree),
               1e-13);
  slide(contact, 1e-4 * MN, 3.0 * contact.law.peak_slip, 2);
  EXPECT_CLOSE(contact.force.shear / contact.force.normal, std::tan(70 * degree),
               1e-13);
}

TEST(JointLaws, BartonWithoutFaceIsFriction) {
  OneContact contact = rough_joint(1e8);
  contact.state.length = 0.0;
  contact.move(0.3 * mm, 0.0);  // more than vm
  EXPECT_CLOSE(contact.force.normal, 3 * MN, 1e-15);
  contact.move(0.0, 1.0);
  EXPECT_CLOSE(contact.force.shear, std::tan(30 * degree) * 3 * MN, 1e-14);
  EXPECT_EQ(contact.state.offset, 0.0);
}

TEST(JointLaws, BandisClosure) {
  OneContact contact = rough_joint(1e10);
  contact.move(0.1 * mm, 0.0);
  EXPECT_CLOSE(contact.force.normal, 2 * MN, 1e-14);
  const double h = 1e-9;
  contact.move(h, 0.0);
  const double above = contact.force.normal;
  contact.move(-2.0 * h, 0.0);
  EXPECT_CLOSE((above - contact.force.normal) / (2.0 * h), 40 * GPa, 1e-9);
  // Beyond a tangent of knmax = 1000 GPa/m the force is linear.
  contact.move(0.18 * mm + h - contact.state.closure - h, 0.0);
  const double edge = contact.force.normal;
  EXPECT_CLOSE(edge, 10 * GPa * 0.18 * mm / 0.1, 1e-12);
  contact.move(1 * mm, 0.0);
  EXPECT_CLOSE(contact.force.normal - edge, 1000 * GPa * 1 * mm, 1e-12);
  contact.move(-2 * mm, 0.0);
  EXPECT_EQ(contact.force.normal, 0.0);
  EXPECT_EQ(contact.state.closure, 0.0);
}

// Rounding does not move a spring that is compressed and released many times.
TEST(JointLaws, BandisClosureDoesNotDrift) {
  OneContact contact = rough_joint(1e10);
  load(contact, 5 * MN);
  const double start = contact.state.normal;
  for (int i = 0; i < 1'000'000; ++i)
    contact.move(i % 2 == 0 ? 1e-10 : -1e-10, 0.0);
  EXPECT_CLOSE(contact.state.normal, start, 1e-10);
}

}  // namespace
}  // namespace blocks::validation
