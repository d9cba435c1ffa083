#include "dynamics/step.hpp"

#include <algorithm>
#include <limits>

#include "dynamics/domain.hpp"
#include "dynamics/loads.hpp"
#include "dynamics/pair_decisions.hpp"
#include "dynamics/pair_step.hpp"
#include "dynamics/symmetry_planes.hpp"
#include "dynamics/time_step.hpp"
#include "model/numbering.hpp"

namespace blocks::dynamics {
namespace {

/// Before planes and loads push. Of rigid blocks the applied stress is for readers
/// only: pushes add up there until it is read or set to 0 (catch_up).
void clear_forces(Blocks& blocks, bool rigid) {
  blocks.force.setZero();
  blocks.moment.setZero();
  if (!rigid)
    blocks.applied.setZero();
}

/// Forces to corners for so many blocks in turn: what one call reads is still in the
/// cache for the next.
constexpr int blocks_at_once = 64;

}  // namespace

void prepare(Model& model) {
  fix_outside_domain(model);
  if (model.time_step.blocks != model.blocks.size()) {
    // Time goes on from here in the new step.
    model.time_origin = model.time;
    model.step_origin = model.steps;
    model.time_step = choose_time_step(model);
    model.order = better_order(model.blocks);
  }
  model.started = true;
}

double time_after_step(const Model& model) {
  const auto steps = static_cast<double>(model.steps + 1 - model.step_origin);
  return model.time_origin + steps * model.time_step.dt;
}

Displacement step(Model& model, SearchBuffers& buffers) {
  const Displacement moved = advance(model, buffers, true);
  catch_up(model, buffers);
  return moved;
}

void catch_up(Model& model, SearchBuffers& buffers) { catch_up_pairs(model, buffers); }

Displacement advance(Model& model, SearchBuffers& buffers, bool readings,
                     double alarm) {
  return advance_by_pairs<ContactRules>(model, buffers, readings, alarm);
}

Displacement move(Model& model, SearchBuffers& buffers, ActingLanes& acting,
                  const Extremes& blocks_touching) {
  const Profile::Timer timer(buffers.profile, Profile::motion);
  Blocks& blocks = model.blocks;
  const Settings& settings = model.settings;
  const double dt = model.time_step.dt;

  // 2. symmetry planes
  const bool pushed = model.plane_contacts.size() > 0 || !model.loads.none();
  if (pushed)
    clear_forces(blocks, settings.rigid);
  const Extremes planes_touching =
      add_plane_forces(blocks, model.plane_contacts, settings, dt);

  // 3. loads at time t
  add_loads(blocks, model.loads, model.time);

  // 4. springs, velocities, strain rates, internal stress; 5. corners
  acting.lanes.advance_springs();
  buffers.moved.assign(buffers.workers->threads(), {});
  buffers.workers->each(acting.split.blocks, [&](int part, int first, int last) {
    for (; first < last; first += blocks_at_once) {
      const BlockRange range{first, std::min(last, first + blocks_at_once)};
      sum_contacts(blocks, acting, range, pushed, settings.rigid);
      update_velocities(blocks, range, settings.gravity, dt);
      if (!settings.rigid) {
        update_strain(blocks, range, settings, dt);
      }
      buffers.moved[part].include(
          move_blocks(blocks, range, acting.swing, settings, dt));
    }
  });
  Displacement moved;
  for (const Displacement& part : buffers.moved)
    moved.include(part);
  double& travel = acting.swing.travel;
  travel += moved.finite ? moved.way + 0x1p-52 * travel
                         : std::numeric_limits<double>::infinity();
  moved.strongest = std::max(blocks_touching.spring, planes_touching.spring);
  model.worst_overlap =
      std::max({model.worst_overlap, blocks_touching.overlap, planes_touching.overlap});
  model.time = time_after_step(model);
  ++model.steps;

  // 6. domain, travel
  if (moved.left_domain)
    fix_outside_domain(model);
  model.search.left -= moved.largest;
  if (model.search.left < 0.0)
    model.search.current = false, model.search.left = 0.0;
  buffers.outdated_at = model.search.current ? -1 : model.steps;
  return moved;
}

}  // namespace blocks::dynamics
