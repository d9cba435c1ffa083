// The list of all fields of a model. The writer and the reader of checkpoints both use
// it, so they always agree, and so does the check of values. The structured bindings
// name every member, so a new member of a struct does not compile until it is listed
// here.
#pragma once

#include "model/model.hpp"
#include "output/checkpoint/kept_fields.hpp"
#include "output/checkpoint/record_fields.hpp"
#include "output/checkpoint/settings_fields.hpp"

namespace blocks::output {

// An archive provides
//   ar(field, value)             for numbers, enums, texts, vectors, Eigen columns
//   ar.records(field, list, f)   for lists of structs: f(column, record) calls
//                                column(field, member) for every member
//   ar.materials(field, map, f)  for maps, such as the materials: f(column, key, value)
// A field is a name, and what the values must be (checkpoint_field.hpp). What relates
// several fields to each other is in checkpoint_validation.cpp. M is Model or const
// Model.

template <class B, class Archive> void visit_blocks(B& blocks, Archive& ar) {
  auto& [first_corner, corner_block, next, previous, joint, arm, corner, material,
         fixity, convex, cuts, layer, area, mass, inertia, second_moment, scale,
         centroid, velocity, gradient, angle, spin, force, moment, applied, stress,
         strain_rate] = blocks;
  ar("blocks/first_corner", first_corner);
  ar("blocks/corner_block", corner_block);
  ar("blocks/next", next);
  ar("blocks/previous", previous);
  ar({"blocks/joint", not_negative, Rows::per_corner}, joint);
  ar({"blocks/arm", Rows::per_corner}, arm);
  ar({"blocks/corner", Rows::per_corner}, corner);
  ar("blocks/material", material);
  ar({"blocks/fixity", {0.0, 4.0, "0, 1, 2, 3 or 4"}, Rows::per_block}, fixity);
  ar({"blocks/convex", yes_or_no, Rows::per_block}, convex);
  ar("blocks/cuts", cuts);
  ar({"blocks/layer", not_negative, Rows::per_block}, layer);
  ar({"blocks/area", positive, Rows::per_block}, area);
  ar({"blocks/mass", positive, Rows::per_block}, mass);
  ar({"blocks/inertia", positive, Rows::per_block}, inertia);
  ar({"blocks/second_moment", Rows::per_block}, second_moment);
  ar({"blocks/scale", positive, Rows::per_block_or_none}, scale);
  ar({"blocks/centroid", Rows::per_block}, centroid);
  ar({"blocks/velocity", Rows::per_block}, velocity);
  ar({"blocks/gradient", Rows::per_block}, gradient);
  ar({"blocks/angle", Rows::per_block}, angle);
  ar({"blocks/spin", Rows::per_block}, spin);
  ar({"blocks/force", Rows::per_block}, force);
  ar({"blocks/moment", Rows::per_block}, moment);
  ar({"blocks/applied", Rows::per_block}, applied);
  ar({"blocks/stress", Rows::per_block}, stress);
  ar({"blocks/strain_rate", Rows::per_block}, strain_rate);
}

template <class C, class Archive> void visit_contacts(C& contacts, Archive& ar) {
  ar.records("contacts", contacts, [](auto& column, auto& contact) {
    auto& [corner, edge, normal_elastic, shear_elastic, normal_force, shear_force,
           overlap] = contact;
    column({"corner", IndexOf::corner}, corner);
    column({"edge", IndexOf::corner}, edge);
    column("normal_elastic", normal_elastic);
    column("shear_elastic", shear_elastic);
    column("normal_force", normal_force);
    column("shear_force", shear_force);
    column("overlap", overlap);
  });
}

template <class S, class Archive> void visit_law_states(S& states, Archive& ar) {
  ar.records("joint_states", states, [](auto& column, auto& state) {
    each_law_field([&](const LawField& field, auto member) {
      column({field.name, field.range == StateRange::finite ? finite : not_negative},
             state.*member);
    });
  });
}

template <class C, class Archive> void visit_plane_contacts(C& contacts, Archive& ar) {
  ar.records(
      {"plane_contacts", not_negative}, contacts, [](auto& column, auto& contact) {
        auto& [plane, corner, active, normal_elastic, normal_force, overlap, offset] =
            contact;
        column({"plane", IndexOf::plane}, plane);
        column({"corner", IndexOf::corner}, corner);
        column("active", active);
        column("normal_elastic", normal_elastic);
        column("normal_force", normal_force);
        column("overlap", overlap);
        column("offset", offset);
      });
}

template <class W, class Archive> void visit_water(W& water, Archive& ar) {
  auto& [table, joints] = water;
  {
    auto& [gamma, up, place, from, to, begin, duration, drains] = table;
    ar({"loads/water/gamma", not_negative}, gamma);
    ar("loads/water/up", up);
    ar("loads/water/place", place);
    ar("loads/water/from", from);
    ar("loads/water/to", to);
    ar("loads/water/begin", begin);
    ar({"loads/water/duration", not_negative}, duration);
    ar("loads/water/drains", drains);
  }
  ar.records("loads/water/joints", joints, [](auto& column, auto& one) {
    auto& [joint, a, b, p1, p2, reach, begin, duration] = one;
    column({"joint", not_negative}, joint);
    column("ax", a.x());
    column("ay", a.y());
    column("bx", b.x());
    column("by", b.y());
    column({"p1", not_negative}, p1);
    column({"p2", not_negative}, p2);
    column({"reach", not_negative}, reach);
    column("begin", begin);
    column({"duration", not_negative}, duration);
  });
}

template <class L, class Archive> void visit_loads(L& loads, Archive& ar) {
  auto& [function, pressures, forces, quiet_sides, water] = loads;
  auto& [t, p] = function;
  ar("loads/function/t", t);
  ar("loads/function/p", p);
  ar.records("loads/pressures", pressures, [](auto& column, auto& pressure) {
    auto& [block, side, p1, p2, arrival] = pressure;
    column({"block", IndexOf::block}, block);
    column("side", side);
    column("p1", p1);
    column("p2", p2);
    column("arrival", arrival);
  });
  ar.records("loads/forces", forces, [](auto& column, auto& centroid_force) {
    auto& [block, force, arrival] = centroid_force;
    column({"block", IndexOf::block}, block);
    column("fx", force.x());
    column("fy", force.y());
    column("arrival", arrival);
  });
  ar.records("loads/quiet_sides", quiet_sides, [](auto& column, auto& quiet) {
    auto& [block, side, cp, cs, first, second] = quiet;
    column({"block", IndexOf::block}, block);
    column("side", side);
    column({"cp", positive}, cp);
    column({"cs", positive}, cs);
    column("first_x", first.x());
    column("first_y", first.y());
    column("second_x", second.x());
    column("second_y", second.y());
  });
  visit_water(water, ar);
}

template <class C, class Archive>
void visit_clock(C& clock, const char* interval_name, const char* due_name,
                 Archive& ar) {
  auto& [interval, due] = clock;
  ar({interval_name, not_negative}, interval);
  ar(due_name, due);
}

template <class E, class Archive> void visit_energy(E& energy, Archive& ar) {
  auto& [kept, start, kinetic, elastic, strain, next_kinetic, next_strain, strain_work,
         sums, errors] = energy;
  ar("energy/kept", kept);
  ar("energy/start", start);
  ar("energy/kinetic", kinetic);
  ar({"energy/elastic", not_negative}, elastic);
  ar("energy/strain", strain);
  ar({"energy/next_kinetic", not_negative}, next_kinetic);
  ar({"energy/next_strain", not_negative}, next_strain);
  ar("energy/strain_work", strain_work);
  ar("energy/sums", sums);
  ar("energy/errors", errors);
}

template <class M, class Archive> void visit_model(M& model, Archive& ar) {
  auto& [settings, blocks, contacts, law_states, bonds_made, plane_contacts,
         fixed_in_ground, loads, drives, servos, time_step, search, output, plots,
         plot_times, plot_steps, history, output_blocks, order, exits, merges, layers,
         cuts, joint_lengths, steps, time, time_origin, step_origin, started,
         worst_overlap, energy, kept, solves, safety_factors, safety_trials, cracks,
         crack_refusals, last_kinetic_energy] = model;
  visit_settings(settings, ar);
  visit_blocks(blocks, ar);
  visit_contacts(contacts, ar);
  visit_law_states(law_states, ar);
  ar("bonds_made", bonds_made);
  visit_plane_contacts(plane_contacts, ar);
  ar({"fixed_in_ground", IndexOf::block}, fixed_in_ground);
  visit_loads(loads, ar);
  ar.records("drives", drives, [](auto& column, auto& drive) {
    auto& [block, velocity, spin] = drive;
    column({"block", IndexOf::block}, block);
    column("vx", velocity.x());
    column("vy", velocity.y());
    column("spin", spin);
  });
  ar.records("servos", servos, [](auto& column, auto& servo) {
    auto& [block, side, target, max_speed] = servo;
    column({"block", IndexOf::block}, block);
    column("side", side);
    column("target", target);
    column({"most", positive}, max_speed);
  });
  {
    auto& [dt, block, block_count, elastic, pieces] = time_step;
    ar({"time_step/dt", not_negative}, dt);
    ar({"time_step/block", IndexOf::block_or_none}, block);
    ar("time_step/blocks", block_count);
    ar("time_step/elastic", elastic);
    ar("time_step/pieces", pieces);
  }
  {
    auto& [current, left, updates] = search;
    ar("search/current", current);
    ar({"search/left", not_negative}, left);
    ar({"search/updates", count_from_0}, updates);
  }
  visit_clock(output, "output/interval", "output/due", ar);
  visit_clock(plots, "plots/interval", "plots/due", ar);
  ar({"plots/times", positive}, plot_times);
  {
    auto& [interval, origin] = plot_steps;
    ar({"plots/steps/interval", not_negative}, interval);
    ar({"plots/steps/origin", not_negative}, origin);
  }
  {
    auto& [interval, quantities] = history;
    ar({"history/interval", not_negative}, interval);
    ar("history/quantities", quantities);
  }
  ar({"output/blocks", not_negative}, output_blocks);
  ar("order", order);
  visit_block_records(exits, merges, layers, cuts, joint_lengths, ar);
  ar({"steps", count_from_0}, steps);
  ar({"time", not_negative}, time);
  ar({"time_origin", not_negative}, time_origin);
  ar({"step_origin", count_from_0}, step_origin);
  ar("started", started);
  ar({"worst_overlap", not_negative}, worst_overlap);
  visit_energy(energy, ar);
  visit_kept(kept, ar);
  visit_solves(solves, ar);
  visit_safety(safety_factors, safety_trials, ar);
  visit_cracks(cracks, crack_refusals, ar);
  ar({"last_kinetic_energy", not_negative}, last_kinetic_energy);
}

}  // namespace blocks::output
