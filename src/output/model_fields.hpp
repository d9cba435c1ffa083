// The list of all fields of a model. The writer and the reader of checkpoints both use
// it, so they always agree. The structured bindings name every member, so a new member
// of a struct does not compile until it is listed here.
#pragma once

#include "model/model.hpp"
#include "output/kept_fields.hpp"
#include "output/record_fields.hpp"

namespace blocks::output {

// An archive provides
//   ar(name, field)             for numbers, enums, texts, vectors, Eigen columns
//   ar.records(name, list, f)   for lists of structs: f(column, record) calls
//                               column(name, member) for every member
//   ar.materials(name, map, f)  for maps, such as the materials: f(column, key, value)
// M is Model or const Model.

template <class L, class P, class Archive>
void visit_laws(L& laws, P& pairs, Archive& ar) {
  ar.materials("settings/joint_laws", laws, [](auto& column, auto& id, auto& law) {
    auto& [kind, friction, cohesion, tension, residual_friction, residual_cohesion,
           residual_tension, dilation, dilation_limit, normal_stiffness,
           shear_stiffness, restitution, roughness, wall_strength, residual_angle,
           peak_slip, initial_stiffness, largest_closure, largest_stiffness,
           strength_share] = law;
    column("id", id);
    column("kind", kind);
    column("friction", friction);
    column("cohesion", cohesion);
    column("tension", tension);
    column("residual_friction", residual_friction);
    column("residual_cohesion", residual_cohesion);
    column("residual_tension", residual_tension);
    column("dilation", dilation);
    column("dilation_limit", dilation_limit);
    column("normal_stiffness", normal_stiffness);
    column("shear_stiffness", shear_stiffness);
    column("restitution", restitution);
    column("roughness", roughness);
    column("wall_strength", wall_strength);
    column("residual_angle", residual_angle);
    column("peak_slip", peak_slip);
    column("initial_stiffness", initial_stiffness);
    column("largest_closure", largest_closure);
    column("largest_stiffness", largest_stiffness);
    column("strength_share", strength_share);
  });
  ar.materials("settings/joint_of_materials", pairs,
               [](auto& column, auto& pair, auto& id) {
                 auto& [first, second] = pair;
                 column("first", first);
                 column("second", second);
                 column("id", id);
               });
}

template <class S, class Archive> void visit_settings(S& settings, Archive& ar) {
  auto& [title, units, max_blocks, max_corners, lower, upper, boxes_x, boxes_y,
         contact_tolerance, normal_stiffness, shear_stiffness, fraction, damping,
         friction, gravity, gravity_ramp, local_damping, kinetic_damping, mass_scaling,
         in_situ, ground, rigid, materials, joint_laws, joint_of_materials, crack_rules,
         planes, seed, angle_min, angle_max, merge_ratio, layers_made] = settings;
  ar("settings/title", title);
  {
    auto& [length, mass, time] = units;
    ar("settings/units/length", length);
    ar("settings/units/mass", mass);
    ar("settings/units/time", time);
  }
  ar("settings/max_blocks", max_blocks);
  ar("settings/max_corners", max_corners);
  ar("settings/lower", lower);
  ar("settings/upper", upper);
  ar("settings/boxes_x", boxes_x);
  ar("settings/boxes_y", boxes_y);
  ar("settings/contact_tolerance", contact_tolerance);
  ar("settings/normal_stiffness", normal_stiffness);
  ar("settings/shear_stiffness", shear_stiffness);
  ar("settings/fraction", fraction);
  ar("settings/damping", damping);
  ar("settings/friction", friction);
  ar("settings/gravity", gravity);
  {
    auto& [from, begin, duration] = gravity_ramp;
    ar("settings/gravity_ramp/from", from);
    ar("settings/gravity_ramp/begin", begin);
    ar("settings/gravity_ramp/duration", duration);
  }
  ar("settings/local_damping", local_damping);
  ar("settings/kinetic_damping", kinetic_damping);
  ar("settings/mass_scaling", mass_scaling);
  ar("settings/in_situ", in_situ);
  {
    auto& [xx, yy, xy, per_y_xx, per_y_yy, per_y_xy] = ground;
    ar("settings/ground/xx", xx);
    ar("settings/ground/yy", yy);
    ar("settings/ground/xy", xy);
    ar("settings/ground/per_y_xx", per_y_xx);
    ar("settings/ground/per_y_yy", per_y_yy);
    ar("settings/ground/per_y_xy", per_y_xy);
  }
  ar("settings/rigid", rigid);
  ar.materials("settings/materials", materials,
               [](auto& column, auto& number, auto& material) {
                 auto& [e, g, rho, name, z] = material;
                 column("number", number);
                 column("youngs_modulus", e);
                 column("shear_modulus", g);
                 column("density", rho);
                 column("name", name);
                 column("damping", z);
               });
  ar.materials("settings/crack_rules", crack_rules,
               [](auto& column, auto& number, auto& rule) {
                 auto& [strength, least_area, point_strength, joint] = rule;
                 column("number", number);
                 column("strength", strength);
                 column("least_area", least_area);
                 column("point_strength", point_strength);
                 column("joint", joint);
               });
  visit_laws(joint_laws, joint_of_materials, ar);
  ar.records("settings/planes", planes, [](auto& column, auto& plane) {
    auto& [a, b] = plane;
    column("ax", a.x());
    column("ay", a.y());
    column("bx", b.x());
    column("by", b.y());
  });
  ar("settings/seed", seed);
  ar("settings/angle_min", angle_min);
  ar("settings/angle_max", angle_max);
  ar("settings/merge_ratio", merge_ratio);
  ar("settings/layers_made", layers_made);
}

template <class B, class Archive> void visit_blocks(B& blocks, Archive& ar) {
  auto& [first_corner, corner_block, next, previous, joint, arm, corner, material,
         fixity, convex, cuts, layer, area, mass, inertia, second_moment, scale,
         centroid, velocity, gradient, angle, spin, force, moment, applied, stress,
         strain_rate] = blocks;
  ar("blocks/first_corner", first_corner);
  ar("blocks/corner_block", corner_block);
  ar("blocks/next", next);
  ar("blocks/previous", previous);
  ar("blocks/joint", joint);
  ar("blocks/arm", arm);
  ar("blocks/corner", corner);
  ar("blocks/material", material);
  ar("blocks/fixity", fixity);
  ar("blocks/convex", convex);
  ar("blocks/cuts", cuts);
  ar("blocks/layer", layer);
  ar("blocks/area", area);
  ar("blocks/mass", mass);
  ar("blocks/inertia", inertia);
  ar("blocks/second_moment", second_moment);
  ar("blocks/scale", scale);
  ar("blocks/centroid", centroid);
  ar("blocks/velocity", velocity);
  ar("blocks/gradient", gradient);
  ar("blocks/angle", angle);
  ar("blocks/spin", spin);
  ar("blocks/force", force);
  ar("blocks/moment", moment);
  ar("blocks/applied", applied);
  ar("blocks/stress", stress);
  ar("blocks/strain_rate", strain_rate);
}

template <class C, class Archive> void visit_contacts(C& contacts, Archive& ar) {
  ar.records("contacts", contacts, [](auto& column, auto& contact) {
    auto& [corner, edge, normal_elastic, shear_elastic, normal_force, shear_force,
           overlap] = contact;
    column("corner", corner);
    column("edge", edge);
    column("normal_elastic", normal_elastic);
    column("shear_elastic", shear_elastic);
    column("normal_force", normal_force);
    column("shear_force", shear_force);
    column("overlap", overlap);
  });
}

template <class S, class Archive> void visit_joint_states(S& states, Archive& ar) {
  ar.records("joint_states", states, [](auto& column, auto& state) {
    each_joint_field([&](const JointField& field, auto member) {
      column(field.name, state.*member);
    });
  });
}

template <class C, class Archive> void visit_plane_contacts(C& contacts, Archive& ar) {
  ar.records("plane_contacts", contacts, [](auto& column, auto& contact) {
    auto& [plane, corner, active, normal_elastic, normal_force, overlap, offset] =
        contact;
    column("plane", plane);
    column("corner", corner);
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
    ar("loads/water/gamma", gamma);
    ar("loads/water/up", up);
    ar("loads/water/place", place);
    ar("loads/water/from", from);
    ar("loads/water/to", to);
    ar("loads/water/begin", begin);
    ar("loads/water/duration", duration);
    ar("loads/water/drains", drains);
  }
  ar.records("loads/water/joints", joints, [](auto& column, auto& one) {
    auto& [joint, a, b, p1, p2, reach, begin, duration] = one;
    column("joint", joint);
    column("ax", a.x());
    column("ay", a.y());
    column("bx", b.x());
    column("by", b.y());
    column("p1", p1);
    column("p2", p2);
    column("reach", reach);
    column("begin", begin);
    column("duration", duration);
  });
}

template <class L, class Archive> void visit_loads(L& loads, Archive& ar) {
  auto& [function, pressures, forces, quiet_sides, water] = loads;
  auto& [t, p] = function;
  ar("loads/function/t", t);
  ar("loads/function/p", p);
  ar.records("loads/pressures", pressures, [](auto& column, auto& pressure) {
    auto& [block, side, p1, p2, arrival] = pressure;
    column("block", block);
    column("side", side);
    column("p1", p1);
    column("p2", p2);
    column("arrival", arrival);
  });
  ar.records("loads/forces", forces, [](auto& column, auto& centroid_force) {
    auto& [block, force, arrival] = centroid_force;
    column("block", block);
    column("fx", force.x());
    column("fy", force.y());
    column("arrival", arrival);
  });
  ar.records("loads/quiet_sides", quiet_sides, [](auto& column, auto& quiet) {
    auto& [block, side, cp, cs, first, second] = quiet;
    column("block", block);
    column("side", side);
    column("cp", cp);
    column("cs", cs);
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
  ar(interval_name, interval);
  ar(due_name, due);
}

template <class E, class Archive> void visit_energy(E& energy, Archive& ar) {
  auto& [kept, start, kinetic, elastic, strain, next_kinetic, next_strain, strain_work,
         sums, errors] = energy;
  ar("energy/kept", kept);
  ar("energy/start", start);
  ar("energy/kinetic", kinetic);
  ar("energy/elastic", elastic);
  ar("energy/strain", strain);
  ar("energy/next_kinetic", next_kinetic);
  ar("energy/next_strain", next_strain);
  ar("energy/strain_work", strain_work);
  ar("energy/sums", sums);
  ar("energy/errors", errors);
}

template <class M, class Archive> void visit_model(M& model, Archive& ar) {
  auto& [settings, blocks, contacts, joint_states, bonds_made, plane_contacts,
         fixed_in_ground, loads, drives, servos, time_step, search, output, plots,
         plot_times, plot_steps, history, output_blocks, order, exits, merges, layers,
         cuts, joint_lengths, steps, time, time_origin, step_origin, started,
         worst_overlap, energy, kept, solves, safety_factors, safety_trials, cracks,
         crack_refusals, last_kinetic_energy] = model;
  visit_settings(settings, ar);
  visit_blocks(blocks, ar);
  visit_contacts(contacts, ar);
  visit_joint_states(joint_states, ar);
  ar("bonds_made", bonds_made);
  visit_plane_contacts(plane_contacts, ar);
  ar("fixed_in_ground", fixed_in_ground);
  visit_loads(loads, ar);
  ar.records("drives", drives, [](auto& column, auto& drive) {
    auto& [block, velocity, spin] = drive;
    column("block", block);
    column("vx", velocity.x());
    column("vy", velocity.y());
    column("spin", spin);
  });
  ar.records("servos", servos, [](auto& column, auto& servo) {
    auto& [block, side, target, most] = servo;
    column("block", block);
    column("side", side);
    column("target", target);
    column("most", most);
  });
  {
    auto& [dt, block, block_count, elastic, pieces] = time_step;
    ar("time_step/dt", dt);
    ar("time_step/block", block);
    ar("time_step/blocks", block_count);
    ar("time_step/elastic", elastic);
    ar("time_step/pieces", pieces);
  }
  {
    auto& [current, left, updates] = search;
    ar("search/current", current);
    ar("search/left", left);
    ar("search/updates", updates);
  }
  visit_clock(output, "output/interval", "output/due", ar);
  visit_clock(plots, "plots/interval", "plots/due", ar);
  ar("plots/times", plot_times);
  {
    auto& [interval, origin] = plot_steps;
    ar("plots/steps/interval", interval);
    ar("plots/steps/origin", origin);
  }
  {
    auto& [interval, quantities] = history;
    ar("history/interval", interval);
    ar("history/quantities", quantities);
  }
  ar("output/blocks", output_blocks);
  ar("order", order);
  ar.records("exits", exits, [](auto& column, auto& exit) {
    auto& [block, when] = exit;
    column("block", block);
    column("time", when);
  });
  ar.records("merges", merges, [](auto& column, auto& merge) {
    auto& [layer, absorbed, into, width_to_height, limit] = merge;
    column("layer", layer);
    column("absorbed", absorbed);
    column("into", into);
    column("width_to_height", width_to_height);
    column("limit", limit);
  });
  ar.records("layers", layers, [](auto& column, auto& layer) {
    auto& [number, first_block, block_count, cells, interior_edges, outline_edges,
           redrawn, ruled, redrawn_sides] = layer;
    column("number", number);
    column("first_block", first_block);
    column("blocks", block_count);
    column("cells", cells);
    column("interior_edges", interior_edges);
    column("outline_edges", outline_edges);
    column("redrawn", redrawn);
    column("ruled", ruled);
    column("redrawn_sides", redrawn_sides);
  });
  ar.records("cuts", cuts, [](auto& column, auto& cut) {
    auto& [number, first_block, block_count, cells, interior_edges, outline_edges, area,
           vertices, edges, faces, components, p21_before, p21_after, islands,
           pinched_loops, absorbed_faces, straight_vertices, contractions, kept_short,
           merge_count, kept_small, largest_move, repaired_below, t_vertices,
           moved_t_vertices, kept_t_vertices, x_vertices] = cut;
    column("number", number);
    column("first_block", first_block);
    column("blocks", block_count);
    column("cells", cells);
    column("interior_edges", interior_edges);
    column("outline_edges", outline_edges);
    column("area", area);
    column("vertices", vertices);
    column("edges", edges);
    column("faces", faces);
    column("components", components);
    column("p21_before", p21_before);
    column("p21_after", p21_after);
    column("islands", islands);
    column("pinched_loops", pinched_loops);
    column("absorbed_faces", absorbed_faces);
    column("straight_vertices", straight_vertices);
    column("contractions", contractions);
    column("kept_short", kept_short);
    column("merges", merge_count);
    column("kept_small", kept_small);
    column("largest_move", largest_move);
    column("repaired_below", repaired_below);
    column("t_vertices", t_vertices);
    column("moved_t_vertices", moved_t_vertices);
    column("kept_t_vertices", kept_t_vertices);
    column("x_vertices", x_vertices);
  });
  ar.records("joint_lengths", joint_lengths, [](auto& column, auto& length) {
    auto& [cut, joint, drawn, pruned] = length;
    column("cut", cut);
    column("joint", joint);
    column("drawn", drawn);
    column("pruned", pruned);
  });
  ar("steps", steps);
  ar("time", time);
  ar("time_origin", time_origin);
  ar("step_origin", step_origin);
  ar("started", started);
  ar("worst_overlap", worst_overlap);
  visit_energy(energy, ar);
  visit_kept(kept, ar);
  ar.records("solves", solves, [](auto& column, auto& solve) {
    auto& [line, wanted, reached, step_count, end, converged, largest, at, wanted_local,
           reached_local, local_block, dt, least_scale, largest_scale] = solve;
    column("line", line);
    column("wanted", wanted);
    column("reached", reached);
    column("steps", step_count);
    column("time", end);
    column("converged", converged);
    column("largest", largest);
    column("block", at);
    column("wanted_local", wanted_local);
    column("reached_local", reached_local);
    column("local_block", local_block);
    column("dt", dt);
    column("least_scale", least_scale);
    column("largest_scale", largest_scale);
  });
  visit_safety(safety_factors, safety_trials, ar);
  visit_cracks(cracks, crack_refusals, ar);
  ar("last_kinetic_energy", last_kinetic_energy);
}

}  // namespace blocks::output
