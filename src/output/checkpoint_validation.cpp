#include "output/checkpoint_validation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "output/checkpoint_crack_validation.hpp"
#include "output/checkpoint_expectations.hpp"
#include "output/checkpoint_kept_validation.hpp"
#include "output/checkpoint_law_validation.hpp"
#include "output/checkpoint_load_validation.hpp"
#include "output/checkpoint_plane_validation.hpp"
#include "output/checkpoint_rest_validation.hpp"
#include "quantities/curve.hpp"

namespace blocks::output {

using namespace expectations;

namespace {

void expect_settings(const Settings& s) {
  expect("settings/max_blocks", s.max_blocks, not_negative);
  expect("settings/max_corners", s.max_corners, not_negative);
  expect("settings/lower", s.lower);
  expect("settings/upper", s.upper);
  if (!(s.lower.x() < s.upper.x()) || !(s.lower.y() < s.upper.y()))
    reject_checkpoint("settings/upper is not above settings/lower");
  const Range boxes{1.0, largest, "a number from 1"};
  expect("settings/boxes_x", s.boxes_x, boxes);
  expect("settings/boxes_y", s.boxes_y, boxes);
  expect("settings/boxes_x times boxes_y",
         static_cast<double>(s.boxes_x) * static_cast<double>(s.boxes_y),
         {1.0, 1e8, "at most 100000000"});
  expect("settings/contact_tolerance", s.contact_tolerance, positive);
  expect("settings/normal_stiffness", s.normal_stiffness, positive);
  expect("settings/shear_stiffness", s.shear_stiffness, positive);
  expect("settings/fraction", s.fraction, {0.0, 1.0, "a number from 0 to 1"});
  expect("settings/damping", s.damping, not_negative);
  expect("settings/friction", s.friction, not_negative);
  expect("settings/gravity", s.gravity);
  for (const double value : {s.ground.xx, s.ground.yy, s.ground.xy, s.ground.per_y_xx,
                             s.ground.per_y_yy, s.ground.per_y_xy})
    expect("settings/ground", value, finite);
  expect("settings/gravity_ramp/from", s.gravity_ramp.from);
  expect("settings/gravity_ramp/begin", s.gravity_ramp.begin, not_negative);
  expect("settings/gravity_ramp/duration", s.gravity_ramp.duration, not_negative);
  expect("settings/local_damping", s.local_damping,
         {0.0, 0x1.fffffffffffffp-1, "a number from 0, below 1"});
  expect("settings/layers_made", s.layers_made, not_negative);
  for (const auto& [number, material] : s.materials) {
    expect("settings/materials/number", number, positive);
    expect("settings/materials/density", material.density, positive);
    expect("settings/materials/youngs_modulus", material.youngs_modulus, not_negative);
    expect("settings/materials/shear_modulus", material.shear_modulus, not_negative);
    expect("settings/materials/damping", material.damping,
           {0.0, 1.0, "a number from 0 to 1"});
  }
  expect_laws(s);
  for (const Plane& plane : s.planes) {
    expect("settings/planes", plane.a);
    expect("settings/planes", plane.b);
    if (plane.a == plane.b)
      reject_checkpoint("settings/planes has a plane through one point");
  }
  if (s.angle_min.value() > s.angle_max.value())
    reject_checkpoint("settings/angle_min is above angle_max");
  if (s.merge_ratio)
    expect("settings/merge_ratio", s.merge_ratio->value(), not_negative);
}

/// Expects consecutive blocks and the corners of each block in a ring.
void expect_corners(const Blocks& b) {
  const std::size_t n = b.material.size();
  if (b.first_corner.size() != n + 1 || b.first_corner[0] != 0)
    reject_checkpoint(fmt::format("blocks/first_corner has {} rows, expected {} from 0",
                                  b.first_corner.size(), n + 1));
  for (std::size_t i = 0; i < n; ++i)
    if (const long count = long{b.first_corner[i + 1]} - b.first_corner[i];
        count < 3 || count > geometry::max_corners)
      reject_checkpoint(fmt::format(
          "blocks/first_corner: block {} has {} than {} corners", i + 1,
          count < 3 ? "less" : "more", count < 3 ? 3 : geometry::max_corners));
  const auto m = static_cast<std::size_t>(b.corners());
  for (const auto& [name, column] : {std::pair{"blocks/next", &b.next},
                                     {"blocks/previous", &b.previous},
                                     {"blocks/corner_block", &b.corner_block}})
    if (column->size() != m)
      reject_checkpoint(
          fmt::format("{} has {} rows, expected {}", name, column->size(), m));
  for (int k = 0; k < b.size(); ++k)
    for (int first = b.first_corner[k], last = b.first_corner[k + 1] - 1, c = first;
         c <= last; ++c)
      if (b.corner_block[c] != k || b.next[c] != (c == last ? first : c + 1) ||
          b.previous[c] != (c == first ? last : c - 1))
        reject_checkpoint(
            fmt::format("corner {} of block {} is out of order", c - first + 1, k + 1));
}

/// Expects convex parts of blocks that are not convex, each with at least three
/// corners.
void expect_cuts(const Blocks& b) {
  const auto refuse = [] { reject_checkpoint("blocks/cuts holds no convex parts"); };
  std::vector<char> is_cut(b.convex.begin(), b.convex.end());
  for (std::size_t k = 0; k < b.cuts.size();) {
    const std::size_t left = b.cuts.size() - k;
    if (left < 2 || b.cuts[k] < 0 || b.cuts[k] >= b.size() || b.convex[b.cuts[k]] ||
        b.cuts[k + 1] < 3 || static_cast<std::size_t>(b.cuts[k + 1]) > left - 2)
      refuse();
    is_cut[b.cuts[k]] = 1;
    for (int i = 0; i < b.cuts[k + 1]; ++i)
      if (const int c = b.cuts[k + 2 + i]; c < 0 || c >= b.corners_of(b.cuts[k]))
        refuse();
    k += 2 + static_cast<std::size_t>(b.cuts[k + 1]);
  }
  if (std::find(is_cut.begin(), is_cut.end(), 0) != is_cut.end())
    refuse();
}

void expect_blocks(const Blocks& b, const Settings& settings) {
  expect_corners(b);
  const Eigen::Index n = b.size(), m = b.corners();
  expect_all("blocks/joint", b.joint, m, not_negative);
  expect_all("blocks/arm", b.arm, m, finite);
  expect_all("blocks/corner", b.corner, m, finite);
  for (const int number : b.material)
    if (!settings.materials.contains(number))
      reject_checkpoint(fmt::format(
          "blocks/material names material {}, which does not exist", number));
  expect_all("blocks/fixity", b.fixity, n, {0.0, 4.0, "0, 1, 2, 3 or 4"});
  expect_all("blocks/convex", b.convex, n, yes_or_no);
  expect_cuts(b);
  expect_all("blocks/layer", b.layer, n, not_negative);
  for (const auto& [name, column] : {std::pair{"blocks/area", &b.area},
                                     {"blocks/mass", &b.mass},
                                     {"blocks/inertia", &b.inertia}})
    expect_all(name, *column, n, positive);
  if (b.has_scaled_masses())
    expect_all("blocks/scale", b.scale, n, positive);
  for (const auto& [name, column] : {std::pair{"blocks/angle", &b.angle},
                                     {"blocks/spin", &b.spin},
                                     {"blocks/moment", &b.moment}})
    expect_all(name, *column, n, finite);
  for (const auto& [name, column] : {std::pair{"blocks/centroid", &b.centroid},
                                     {"blocks/velocity", &b.velocity},
                                     {"blocks/force", &b.force}})
    expect_all(name, *column, n, finite);
  for (const auto& [name, column] : {std::pair{"blocks/gradient", &b.gradient},
                                     {"blocks/applied", &b.applied},
                                     {"blocks/stress", &b.stress},
                                     {"blocks/strain_rate", &b.strain_rate},
                                     {"blocks/second_moment", &b.second_moment}})
    expect_all(name, *column, n, finite);
  for (int k = 0; k < b.size(); ++k)
    if (const auto moment = b.second_moment.col(k);
        !(moment[0] > 0.0 && moment[3] > 0.0 && moment[1] == moment[2]))
      reject_checkpoint(fmt::format(
          "blocks/second_moment: that of block {} belongs to no body", k + 1));
  for (int c = 0; c < b.corners(); ++c) {
    const auto gradient = b.gradient.col(b.corner_block[c]);
    const Vec2 made = b.arm.col(c);
    const Vec2 arm(gradient[0] * made.x() + gradient[1] * made.y(),
                   gradient[2] * made.x() + gradient[3] * made.y());
    const Vec2 there = b.centroid.col(b.corner_block[c]) + arm;
    const double size = there.cwiseAbs().maxCoeff() + arm.norm();
    if (!((there - b.corner.col(c)).norm() <= 1e-9 * size))
      reject_checkpoint(fmt::format(
          "blocks/corner: value {} is not the centroid plus the deformed arm", c + 1));
  }
}

void expect_contacts(const Model& model) {
  const std::vector<Contact>& contacts = model.contacts;
  const Blocks& b = model.blocks;
  for (const Contact& contact : contacts) {
    expect_index("contacts/corner", contact.corner, b.corners());
    expect_index("contacts/edge", contact.edge, b.corners());
  }
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Contact& contact = contacts[i];
    const auto [low, high] = pair_of(b, contact);
    if (low == high)
      reject_checkpoint(fmt::format("contact {} is between a block and itself", i + 1));
    if (i > 0 && !(sort_key(b, contacts[i - 1]) < sort_key(b, contact)))
      reject_checkpoint(fmt::format("contact {} is out of order", i + 1));
    // Bonded contacts have tension and gaps; dilation pushes contacts apart.
    const bool has_law = i < model.joint_states.size() &&
                         (model.joint_states[i].law != 0 || model.settings.in_situ);
    const Range& pressure = has_law ? finite : not_negative;
    for (const auto& [name, value, range] :
         {std::tuple{"normal_elastic", contact.normal_elastic, &pressure},
          {"normal_force", contact.normal_force, &pressure},
          {"overlap", contact.overlap, &pressure},
          {"shear_elastic", contact.shear_elastic, &finite},
          {"shear_force", contact.shear_force, &finite}})
      if (!holds(*range, value))
        expect(fmt::format("contact {}: {}", i + 1, name), value, *range);
  }
}

void expect_fixed_in_ground(const Model& model) {
  const std::vector<int>& fixed = model.fixed_in_ground;
  expect_indices("fixed_in_ground", fixed, fixed.size(), model.blocks.size());
  if (!std::is_sorted(fixed.begin(), fixed.end()))
    reject_checkpoint("fixed_in_ground is out of order");
}

/// Expects no order, or each block of the time step exactly once. If the time step is
/// to be chosen again, the number of its blocks is no longer known.
void expect_order(const Model& model) {
  if (model.order.empty())
    return;
  const auto blocks = model.time_step.blocks > 0
                          ? static_cast<std::size_t>(model.time_step.blocks)
                          : std::min(model.order.size(), model.blocks.material.size());
  expect_indices("order", model.order, blocks, static_cast<long>(blocks));
  std::vector<char> named(blocks, 0);
  for (const int block : model.order)
    if (std::exchange(named[block], 1) != 0)
      reject_checkpoint(fmt::format("order names block {} twice", block + 1));
}

/// Expects all blocks to have a time step and a place in the order if a motion is
/// partly done.
void expect_all_move(const Model& model, const Progress& at) {
  const int blocks = model.time_step.blocks;
  if (at.steps_left > 0 && blocks != model.blocks.size())
    reject_checkpoint(fmt::format("time_step/blocks is {}, but {} blocks are in motion",
                                  blocks, model.blocks.size()));
}

/// Expects valid output blocks, domain exits, merges and layers.
void expect_records(const Model& model) {
  for (const int block : model.output_blocks)
    expect("output/blocks", block, not_negative);
  for (const DomainExit& exit : model.exits) {
    expect_index("exits/block", exit.block, model.blocks.size());
    expect("exits/time", exit.time, finite);
  }
  for (const MergeRecord& merge : model.merges) {
    for (const int number : {merge.layer, merge.absorbed, merge.into})
      expect("merges", number, positive);
    expect("merges/width_to_height", merge.width_to_height, not_negative);
    expect("merges/limit", merge.limit, not_negative);
  }
  for (const LayerRecord& layer : model.layers) {
    for (const int count : {layer.number, layer.first_block, layer.blocks, layer.cells,
                            layer.interior_edges, layer.outline_edges, layer.redrawn,
                            layer.ruled, layer.redrawn_sides})
      expect("layers", count, not_negative);
    if (layer.blocks > model.blocks.size() - layer.first_block)
      reject_checkpoint("layers names blocks that do not exist");
  }
  for (const CutRecord& cut : model.cuts) {
    for (const long count : {static_cast<long>(cut.number),
                             static_cast<long>(cut.first_block),
                             static_cast<long>(cut.blocks),
                             static_cast<long>(cut.cells),
                             static_cast<long>(cut.interior_edges),
                             static_cast<long>(cut.outline_edges),
                             cut.vertices,
                             cut.edges,
                             cut.faces,
                             cut.components,
                             cut.islands,
                             cut.pinched_loops,
                             cut.absorbed_faces,
                             cut.straight_vertices,
                             cut.contractions,
                             cut.kept_short,
                             cut.merges,
                             cut.kept_small,
                             cut.t_vertices,
                             cut.moved_t_vertices,
                             cut.kept_t_vertices,
                             cut.x_vertices})
      expect("cuts", static_cast<double>(count), not_negative);
    for (const double value : {cut.area, cut.p21_before, cut.p21_after,
                               cut.largest_move, cut.repaired_below})
      expect("cuts", value, not_negative);
    if (cut.blocks > model.blocks.size() - cut.first_block)
      reject_checkpoint("cuts names blocks that do not exist");
  }
  for (const JointLengthRecord& length : model.joint_lengths)
    for (const double value :
         {static_cast<double>(length.cut), static_cast<double>(length.joint),
          length.drawn, length.pruned})
      expect("joint_lengths", value, not_negative);
}

void expect_history(const HistoryRequest& history) {
  expect("history/interval", history.interval, not_negative);
  if ((history.interval > 0.0) != !history.quantities.empty())
    reject_checkpoint("history/quantities does not fit history/interval");
  for (const std::string& quantity : history.quantities)
    try {
      quantities::parse_curve(quantity);
    } catch (const quantities::CurveFault& fault) {
      reject_checkpoint(fmt::format("history/quantities: {}", fault.what()));
    }
}

void expect_time(const Model& model) {
  expect("steps", static_cast<double>(model.steps), count_from_0);
  expect("last_kinetic_energy", model.last_kinetic_energy, not_negative);
  expect("step_origin", static_cast<double>(model.step_origin), count_from_0);
  if (model.step_origin > model.steps)
    reject_checkpoint("step_origin is greater than steps");
  expect("time", model.time, not_negative);
  expect("time_origin", model.time_origin, not_negative);
  const TimeStep& step = model.time_step;
  expect("time_step/dt", step.dt, not_negative);
  if (step.block < -1 || step.block >= model.blocks.size())
    reject_checkpoint(fmt::format("time_step/block names number {}", step.block + 1L));
  if (step.blocks < 0 || step.blocks > model.blocks.size())
    reject_checkpoint(fmt::format("time_step/blocks is {}", step.blocks));
  if (model.steps > 0 && !(step.dt > 0.0))
    reject_checkpoint("steps without a time_step/dt");
  const double time = model.time_origin +
                      static_cast<double>(model.steps - model.step_origin) * step.dt;
  if (!(std::abs(model.time - time) <= 1e-9 * time))
    reject_checkpoint(fmt::format("time is {}, its steps make {}", model.time, time));
  expect("search/left", model.search.left, not_negative);
  expect("search/updates", static_cast<double>(model.search.updates), count_from_0);
  expect("worst_overlap", model.worst_overlap, not_negative);
  expect_history(model.history);
  for (std::size_t i = 0; i < model.plot_times.size(); ++i) {
    expect("plots/times", model.plot_times[i], positive);
    if (i > 0 && !(model.plot_times[i - 1] < model.plot_times[i]))
      reject_checkpoint("plots/times do not increase");
  }
  for (const long steps : {model.plot_steps.interval, model.plot_steps.origin})
    expect("plots/steps", static_cast<double>(steps), not_negative);
  for (const auto& [name, clock] :
       {std::pair{"output", &model.output}, {"plots", &model.plots}}) {
    expect(std::string(name) + "/interval", clock->interval, not_negative);
    expect(std::string(name) + "/due", clock->due, finite);
  }
}

/// Expects finite energies, and all sums or, without an account, none.
void expect_energy(const EnergyAccount& energy) {
  const Eigen::Index entries = energy.kept ? energy_entries : 0;
  expect_all("energy/sums", energy.sums, entries, finite);
  expect_all("energy/errors", energy.errors, entries, finite);
  for (const auto& [name, value] : {std::pair{"start", energy.start},
                                    {"kinetic", energy.kinetic},
                                    {"strain", energy.strain},
                                    {"strain_work", energy.strain_work}})
    expect(std::string("energy/") + name, value, finite);
  for (const auto& [name, value] : {std::pair{"elastic", energy.elastic},
                                    {"next_kinetic", energy.next_kinetic},
                                    {"next_strain", energy.next_strain}})
    expect(std::string("energy/") + name, value, not_negative);
}

void expect_info(const CheckpointInfo& info, int blocks) {
  const Progress& at = info.progress;
  for (const auto& [name, count] : {std::pair{"results_frames", info.results_frames},
                                    {"listing_bytes", info.listing_bytes},
                                    {"progress/card", at.card},
                                    {"progress/steps_left", at.steps_left},
                                    {"progress/frames", at.frames},
                                    {"progress/samples", at.samples},
                                    {"progress/listing_bytes", at.listing_bytes},
                                    {"progress/tabled_step",  // -1: no table yet
                                     std::min(at.tabled_step, -1L) + 1}})
    expect(std::string("run/") + name, static_cast<double>(count), count_from_0);
  if (at.frames > info.results_frames || at.listing_bytes > info.listing_bytes)
    reject_checkpoint("run/progress is beyond the end of its results or listing");
  // It is infinite if no block is convex.
  expect("run/progress/half_depth", at.half_depth, {0.0, infinite, "a number from 0"});
  for (const geometry::BlockOverlap& overlap : at.overlaps) {
    expect_index("run/progress/overlaps/second", overlap.second, blocks);
    expect_index("run/progress/overlaps/first", overlap.first, overlap.second);
    expect("run/progress/overlaps/area", overlap.area, not_negative);
    expect("run/progress/overlaps/depth", overlap.depth, not_negative);
    expect("run/progress/overlaps", overlap.place);
  }
}

}  // namespace

void validate_checkpoint(const Model& model, const CheckpointInfo& info) {
  expect_settings(model.settings);
  expect_blocks(model.blocks, model.settings);
  expect_contacts(model);
  expect_joint_states(model);
  expect_drives(model);
  expect_plane_contacts(model);
  expect_fixed_in_ground(model);
  expect_loads(model.loads, model.blocks);
  expect_records(model);
  expect_equilibria(model);
  expect_cracks(model);
  expect_time(model);
  expect_order(model);
  expect_kept(model);
  expect_energy(model.energy);
  expect_info(info, model.blocks.size());
  expect_all_move(model, info.progress);
}

}  // namespace blocks::output
