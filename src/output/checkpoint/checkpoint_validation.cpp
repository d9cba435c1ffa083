#include "output/checkpoint/checkpoint_validation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "output/checkpoint/checkpoint_expectations.hpp"
#include "output/checkpoint/checkpoint_fields.hpp"
#include "output/checkpoint/expecting_archive.hpp"
#include "quantities/curve.hpp"

namespace blocks::output {
namespace {

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
  expect_rows("blocks/next", b.next, b.corners());
  expect_rows("blocks/previous", b.previous, b.corners());
  expect_rows("blocks/corner_block", b.corner_block, b.corners());
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

void expect_settings(const Settings& s) {
  if (!(s.lower.x() < s.upper.x()) || !(s.lower.y() < s.upper.y()))
    reject_checkpoint("settings/upper is not above settings/lower");
  expect("settings/boxes_x times boxes_y",
         static_cast<double>(s.boxes_x) * static_cast<double>(s.boxes_y),
         {1.0, 1e8, "at most 100000000"});
  expect_laws(s);
  for (const auto& [material, rule] : s.crack_rules)
    if (!s.materials.contains(material))
      reject_checkpoint(fmt::format("settings/crack_rules: no material {}", material));
  for (const Plane& plane : s.planes)
    if (plane.a == plane.b)
      reject_checkpoint("settings/planes has a plane through one point");
  if (s.angle_min.value() > s.angle_max.value())
    reject_checkpoint("settings/angle_min is above angle_max");
}

void expect_blocks(const Blocks& b, const Settings& settings) {
  for (const int number : b.material)
    if (!settings.materials.contains(number))
      reject_checkpoint(fmt::format(
          "blocks/material names material {}, which does not exist", number));
  expect_cuts(b);
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
  const Blocks& b = model.blocks;
  expect_ascending("contact", model.contacts,
                   [&](const Contact& contact) { return sort_key(b, contact); });
  expect_ascending("plane contact", model.plane_contacts,
                   [](const PlaneContact& contact) {
                     return std::pair(contact.plane, contact.corner);
                   });
  for (std::size_t i = 0; i < model.contacts.size(); ++i) {
    const Contact& contact = model.contacts[i];
    if (const auto [low, high] = pair_of(b, contact); low == high)
      reject_checkpoint(fmt::format("contact {} is between a block and itself", i + 1));
    // Bonded contacts have tension and gaps; dilation pushes contacts apart.
    if (i < model.law_states.size() &&
        (model.law_states[i].law != 0 || model.settings.in_situ))
      continue;
    for (const auto& [name, value] :
         {std::pair{"normal_elastic", contact.normal_elastic},
          {"normal_force", contact.normal_force},
          {"overlap", contact.overlap}})
      if (value < 0.0)
        expect(fmt::format("contact {}: {}", i + 1, name), value, not_negative);
  }
}

/// Expects no order, or each block of the time step exactly once. If the time step is
/// to be chosen again, the number of its blocks is no longer known.
void expect_order(const Model& model) {
  if (model.order.empty())
    return;
  const auto blocks = model.time_step.blocks > 0
                          ? static_cast<std::size_t>(model.time_step.blocks)
                          : std::min(model.order.size(), model.blocks.material.size());
  expect_rows("order", model.order, static_cast<long>(blocks));
  std::vector<char> named(blocks, 0);
  for (const int block : model.order) {
    expect_index("order", block, static_cast<long>(blocks));
    if (std::exchange(named[block], 1) != 0)
      reject_checkpoint(fmt::format("order names block {} twice", block + 1));
  }
}

/// Expects all blocks to have a time step and a place in the order if a motion is
/// partly done.
void expect_all_move(const Model& model, const Progress& at) {
  const int blocks = model.time_step.blocks;
  if (at.steps_left > 0 && blocks != model.blocks.size())
    reject_checkpoint(fmt::format("time_step/blocks is {}, but {} blocks are in motion",
                                  blocks, model.blocks.size()));
}

/// Expects that the blocks of each card exist.
template <class Record>
void expect_made_blocks(const char* name, const std::vector<Record>& list, int blocks) {
  for (const Record& record : list)
    if (record.blocks > blocks - record.first_block)
      reject_checkpoint(fmt::format("{} names blocks that do not exist", name));
}

/// Expects blocks that split off once, in ascending order, and reasons in order.
void expect_cracks(const Model& model) {
  int last = 0;
  for (const CrackRecord& crack : model.cracks) {
    if (crack.child <= last)
      reject_checkpoint(fmt::format("block {} split off twice", crack.child + 1));
    last = crack.child;
  }
  expect_ascending("refused crack", model.crack_refusals);
}

void expect_history(const HistoryRequest& history) {
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
  if (model.step_origin > model.steps)
    reject_checkpoint("step_origin is greater than steps");
  const TimeStep& step = model.time_step;
  if (step.blocks < 0 || step.blocks > model.blocks.size())
    reject_checkpoint(fmt::format("time_step/blocks is {}", step.blocks));
  if (model.steps > 0 && !(step.dt > 0.0))
    reject_checkpoint("steps without a time_step/dt");
  const double time = model.time_origin +
                      static_cast<double>(model.steps - model.step_origin) * step.dt;
  if (!(std::abs(model.time - time) <= 1e-9 * time))
    reject_checkpoint(fmt::format("time is {}, its steps make {}", model.time, time));
  expect_history(model.history);
  expect_ascending("plots/times: value", model.plot_times);
}

/// Expects all sums, or none without an account.
void expect_energy(const EnergyAccount& energy) {
  const int entries = energy.kept ? energy_entries : 0;
  expect_rows("energy/sums", energy.sums, entries);
  expect_rows("energy/errors", energy.errors, entries);
}

void expect_progress(const CheckpointInfo& info) {
  const Progress& at = info.progress;
  if (at.frames > info.results_frames || at.listing_bytes > info.listing_bytes)
    reject_checkpoint("run/progress is beyond the end of its results or listing");
  for (const geometry::BlockOverlap& overlap : at.overlaps)
    expect_index("run/progress/overlaps/first", overlap.first, overlap.second);
}

}  // namespace

void validate_checkpoint(const Model& model, const CheckpointInfo& info) {
  expect_corners(model.blocks);
  ExpectingArchive archive(model);
  visit_checkpoint(model, info, archive);
  expect_settings(model.settings);
  expect_blocks(model.blocks, model.settings);
  expect_contacts(model);
  expect_law_states(model);
  expect_drives(model);
  if (!std::is_sorted(model.fixed_in_ground.begin(), model.fixed_in_ground.end()))
    reject_checkpoint("fixed_in_ground is out of order");
  expect_loads(model.loads, model.blocks);
  expect_made_blocks("layers", model.layers, model.blocks.size());
  expect_made_blocks("cuts", model.cuts, model.blocks.size());
  expect_cracks(model);
  expect_time(model);
  expect_order(model);
  expect_energy(model.energy);
  expect_progress(info);
  expect_all_move(model, info.progress);
  expect_kept(model);
}

}  // namespace blocks::output
