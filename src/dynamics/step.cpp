#include "dynamics/step.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "dynamics/contact_readings.hpp"
#include "dynamics/domain.hpp"
#include "dynamics/huge_pages.hpp"
#include "dynamics/loads.hpp"
#include "dynamics/time_step.hpp"
#include "model/numbering.hpp"

namespace blocks::dynamics {
namespace {

/// Of more groups (100 MB, of 170,000 bricks) there is no room for those of two lists.
constexpr std::size_t most_left = std::size_t{1} << 21;

/// Leaves the groups of a list that is to be made anew, for what they know of it, or to
/// give their memory back.
void leave_groups(const Model& model, SearchBuffers& buffers) {
  ContactGroups& groups = buffers.groups;
  const bool moved_only = buffers.outdated_at == model.steps &&
                          buffers.grouped_update == model.search.updates &&
                          groups.swing.way.size() == model.blocks.material.size();
  buffers.outdated_at = -1;
  buffers.earlier.clear();
  if (groups.all.size() > most_left)
    groups.give_back();
  else if (moved_only)
    buffers.earlier.take(groups);
}

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

void catch_up(Model& model, SearchBuffers& buffers) {
  ContactGroups& groups = buffers.groups;
  Blocks& blocks = model.blocks;
  if (model.settings.rigid && groups.read)
    blocks.applied.array().rowwise() /= blocks.area.transpose().array();
  else if (model.settings.rigid && groups.loaded)
    blocks.applied.setZero();
  groups.store(model.contacts);
  groups.read = false;
}

Displacement advance(Model& model, SearchBuffers& buffers, bool readings,
                     double alarm) {
  Blocks& blocks = model.blocks;

  // 1. potential contacts
  if (!model.search.current) {
    const Profile::Timer timer(buffers.profile, Profile::search);
    buffers.groups.store(model.contacts);
    leave_groups(model, buffers);
    update_contacts(model, buffers);
  }
  if (buffers.grouped_update != model.search.updates) {  // a new list, or a restart
    const Profile::Timer timer(buffers.profile, Profile::search);
    group_contacts(blocks, model.contacts, model.settings.rigid, buffers.groups, false,
                   buffers.workers->threads(), &buffers.earlier);
    buffers.earlier.clear();
    // no more than one of each group acts: no step asks for memory
    model.contacts.acting.reserve(buffers.groups.all.size());
    buffers.grouped_update = model.search.updates;
    if (std::exchange(buffers.corners_at, blocks.corner.data()) != blocks.corner.data())
      move_to_huge_pages(blocks);
  }

  // 2. contact forces
  const Extremes touching =
      evaluate_contacts(blocks, model.contacts, buffers.groups, model.settings,
                        model.time_step.dt, *buffers.workers, buffers.profile);
  if (readings || !(touching.spring <= alarm)) {
    const Profile::Timer timer(buffers.profile, Profile::forces);
    read_contacts(blocks, model.contacts, buffers.groups, model.settings,
                  model.time_step.dt);
  }
  return move(model, buffers, touching);
}

Displacement move(Model& model, SearchBuffers& buffers,
                  const Extremes& blocks_touching) {
  return move(model, buffers, buffers.groups, blocks_touching);
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
