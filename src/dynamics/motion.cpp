#include "dynamics/motion.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "dynamics/domain.hpp"

namespace blocks::dynamics {
namespace {

static_assert(static_cast<int>(Fixity::driven) == driven_bit &&
              static_cast<int>(Fixity::removed) < driven_bit);

BlockColumns columns_of(Blocks& blocks) {
  return {.first_corner = blocks.first_corner.data(),
          .fixity = blocks.fixity.data(),
          .area = blocks.area.data(),
          .mass = blocks.mass.data(),
          .inertia = blocks.inertia.data(),
          .second_moment = blocks.second_moment.data(),
          .force = blocks.force.data(),
          .moment = blocks.moment.data(),
          .applied = blocks.applied.data(),
          .arm = blocks.arm.data(),
          .scale = blocks.has_scaled_masses() ? blocks.scale.data() : nullptr,
          .corner = blocks.corner.data(),
          .centroid = blocks.centroid.data(),
          .gradient = blocks.gradient.data(),
          .angle = blocks.angle.data(),
          .velocity = blocks.velocity.data(),
          .spin = blocks.spin.data(),
          .stress = blocks.stress.data(),
          .strain_rate = blocks.strain_rate.data()};
}

/// Calls work(first, last) for pieces of a range that a kernel takes at a time.
template <class Work> void each_part(BlockRange range, const Work& work) {
  for (int first = range.begin; first < range.end; first += max_at_once)
    work(first, std::min(range.end, first + max_at_once));
}

/// The constants of the materials of each block of a piece.
struct MaterialsOfBlocks {
  double c11[max_at_once], c12[max_at_once], twice_shear[max_at_once],
      damping[max_at_once];

  MaterialsOfBlocks(const Blocks& blocks, int first, int last,
                    const Settings& settings) {
    // Materials are looked up only when they change: successive blocks often have the
    // same one, such as those of a layer.
    int material = 0;
    double now_c11 = 0.0, now_c12 = 0.0, now_twice_shear = 0.0, now_damping = 0.0;
    for (int b = first; b < last; ++b) {
      if (blocks.is_free(b) && blocks.material[b] != material) {
        material = blocks.material[b];
        const Material& m = settings.materials.at(material);
        now_c11 = m.c11(), now_c12 = m.c12(), now_twice_shear = 2.0 * m.shear_modulus;
        now_damping = 2.0 * m.damping * std::sqrt(now_c11);
      }
      const int k = b - first;
      c11[k] = now_c11, c12[k] = now_c12, twice_shear[k] = now_twice_shear;
      damping[k] = now_damping;
    }
  }
  MaterialColumns columns() const { return {c11, c12, twice_shear, damping}; }
};

}  // namespace

void Displacement::include(const Displacement& others) {
  // Of equally fast blocks the one with the lowest number counts, whatever the order of
  // the pieces.
  if (others.largest > largest || (others.largest == largest && others.block < block))
    largest = others.largest, block = others.block;
  bound = std::max(bound, others.bound);
  finite = finite && others.finite;
  left_domain = left_domain || others.left_domain;
}

namespace {

template <bool rigid>
void sum_contacts_of(Blocks& blocks, const ContactArrays& contacts, BlockRange range,
                     bool loaded) {
  for (int b = range.begin; b < range.end; ++b) {
    double x = 0.0, y = 0.0, moment = 0.0;
    Eigen::Vector4d applied = Eigen::Vector4d::Zero();
    if (loaded) {
      x = blocks.force(0, b), y = blocks.force(1, b), moment = blocks.moment[b];
      if (!rigid)
        applied = blocks.applied.col(b);
    }
    contacts.each_lane_of(b, [&](unsigned lane, bool low) {
      const PairForce& force = contacts.batches.forces[lane];
      if (low)
        x += force.fx, y += force.fy, moment += force.moment_low;
      else
        x -= force.fx, y -= force.fy, moment += force.moment_high;
      if constexpr (!rigid) {
        const PairStress& stress = contacts.batches.stresses[lane];
        applied += Eigen::Map<const Eigen::Vector4d>(low ? stress.low : stress.high);
      }
    });
    blocks.force(0, b) = x, blocks.force(1, b) = y;
    blocks.moment[b] = moment;
    if (!rigid)
      blocks.applied.col(b) = applied / blocks.area[b];
  }
}

}  // namespace

void sum_contacts(Blocks& blocks, const ContactArrays& contacts, BlockRange range,
                  bool loaded, bool rigid) {
  const auto sum = rigid ? sum_contacts_of<true> : sum_contacts_of<false>;
  sum(blocks, contacts, range, loaded);
}

void damp_unbalanced(Blocks& blocks, BlockRange range, const Settings& settings,
                     const StepMotion& step, const Kernels& chosen) {
  const LocalDamping damping = {.alpha_dt = settings.local_damping * step.dt,
                                .gravity_x = step.gravity.x(),
                                .gravity_y = step.gravity.y(),
                                .work = step.damped};
  chosen.damp_unbalanced(columns_of(blocks), damping, settings.rigid, range.begin,
                         range.end);
}

void update_velocities(Blocks& blocks, BlockRange range, const Vec2& gravity,
                       double kick, const Kernels& chosen) {
  chosen.update_velocities(columns_of(blocks), range.begin, range.end, gravity.x(),
                           gravity.y(), kick);
}

void update_strain(Blocks& blocks, BlockRange range, const Settings& settings,
                   const StepMotion& step, const double* rates, const Kernels& chosen) {
  each_part(range, [&](int first, int last) {
    const MaterialsOfBlocks materials(blocks, first, last, settings);
    VibrationDamping damping{nullptr, step.damped};
    if (rates != nullptr)
      damping.rates = rates + std::ptrdiff_t{4} * (first - range.begin);
    chosen.update_strain(columns_of(blocks), materials.columns(), damping, first, last,
                         step.kick, step.dt);
  });
}

bool damps_vibration(const Settings& settings) {
  return std::any_of(
      settings.materials.begin(), settings.materials.end(),
      [](const auto& material) { return material.second.damping > 0.0; });
}

Displacement move_corners(Blocks& blocks, BlockRange range, MotionBounds& bounds,
                          const Settings& settings, double dt, const Kernels& chosen) {
  const BlockColumns columns = columns_of(blocks);
  const Rectangle domain = {settings.lower.x(), settings.lower.y(), settings.upper.x(),
                            settings.upper.y()};
  Displacement result;
  each_part(range, [&](int first, int last) {
    const Moved moved = chosen.move(columns, bounds.longest.data(), bounds.path.data(),
                                    domain, settings.rigid, first, last, dt);
    Displacement part{.largest = moved.largest,
                      .block = moved.block,
                      .bound = moved.bound,
                      .finite = std::isfinite(moved.sum)};
    for (std::uint64_t left = moved.near_edge; left != 0; left &= left - 1)
      if (!is_inside_domain(blocks, first + std::countr_zero(left), settings))
        part.left_domain = true;
    result.include(part);
  });
  return result;
}

Displacement move_blocks(Blocks& blocks, const Settings& settings,
                         const StepMotion& step, const ContactArrays& contacts,
                         MotionBounds& bounds, const std::vector<int>& shares,
                         Workers& workers, std::vector<Displacement>& threads) {
  // Data that one stage has read are still in the cache when the next stage needs them.
  constexpr int blocks_at_once = 64;
  const bool vibration = !settings.rigid && damps_vibration(settings);
  threads.assign(threads.size(), {});
  workers.each(shares, [&](int thread, int begin, int end) {
    Eigen::Matrix<double, 4, blocks_at_once> rates;  // before the step
    for (; begin < end; begin += blocks_at_once) {
      const BlockRange range{begin, std::min(end, begin + blocks_at_once)};
      sum_contacts(blocks, contacts, range, step.loaded, settings.rigid);
      if (vibration)
        rates.leftCols(range.end - range.begin) =
            blocks.strain_rate.middleCols(range.begin, range.end - range.begin);
      if (settings.local_damping > 0.0)
        damp_unbalanced(blocks, range, settings, step);
      update_velocities(blocks, range, step.gravity, step.kick);
      if (!settings.rigid)
        update_strain(blocks, range, settings, step,
                      vibration ? rates.data() : nullptr);
      threads[thread].include(move_corners(blocks, range, bounds, settings, step.dt));
    }
  });
  Displacement all;
  for (const Displacement& part : threads)
    all.include(part);
  bounds.grow(all.finite ? all.bound : std::numeric_limits<double>::infinity());
  return all;
}

}  // namespace blocks::dynamics
