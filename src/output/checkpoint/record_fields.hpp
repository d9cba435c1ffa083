// The fields of the records of a run in a checkpoint: what cards made, cracks, searches
// for equilibria and factors of safety. Part of model_fields.hpp, which describes
// archives.
#pragma once

#include "model/cracks.hpp"
#include "model/safety_factor.hpp"
#include "output/checkpoint/checkpoint_field.hpp"

namespace blocks::output {

template <class C, class R, class Archive>
void visit_cracks(C& cracks, R& refusals, Archive& ar) {
  ar.records({"cracks", not_negative}, cracks, [](auto& column, auto& crack) {
    auto& [step, time, parent, child, cause, stress, from, to, moved, parent_area,
           child_area, kinetic_before, kinetic_after, strain_before, strain_after] =
        crack;
    column("step", step);
    column("time", time);
    column({"parent", IndexOf::block}, parent);
    column({"child", IndexOf::block}, child);
    column({"cause", {0.0, 1.0, "0 or 1"}}, cause);
    column({"stress", positive}, stress);
    column({"from_x", finite}, from.x());
    column({"from_y", finite}, from.y());
    column({"to_x", finite}, to.x());
    column({"to_y", finite}, to.y());
    column("moved", moved);
    column({"parent_area", positive}, parent_area);
    column({"child_area", positive}, child_area);
    column("kinetic_before", kinetic_before);
    column("kinetic_after", kinetic_after);
    column("strain_before", strain_before);
    column("strain_after", strain_after);
  });
  ar.records("crack_refusals", refusals, [](auto& column, auto& refused) {
    auto& [block, why] = refused;
    column({"block", IndexOf::block}, block);
    column({"why", {0.0, crack_refusals - 1, "the number of a reason"}}, why);
  });
}

template <class E, class G, class L, class C, class J, class Archive>
void visit_block_records(E& exits, G& merges, L& layers, C& cuts, J& joint_lengths,
                         Archive& ar) {
  ar.records("exits", exits, [](auto& column, auto& exit) {
    auto& [block, when] = exit;
    column({"block", IndexOf::block}, block);
    column("time", when);
  });
  ar.records({"merges", not_negative}, merges, [](auto& column, auto& merge) {
    auto& [layer, absorbed, into, width_to_height, limit] = merge;
    column({"layer", positive}, layer);
    column({"absorbed", positive}, absorbed);
    column({"into", positive}, into);
    column("width_to_height", width_to_height);
    column("limit", limit);
  });
  ar.records({"layers", not_negative}, layers, [](auto& column, auto& layer) {
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
  ar.records({"cuts", not_negative}, cuts, [](auto& column, auto& cut) {
    auto& [number, first_block, block_count, cells, interior_edges, outline_edges, area,
           counts] = cut;
    auto& [vertices, edges, faces, components, p21_before, p21_after, islands,
           pinched_loops, absorbed_faces, straight_vertices, contractions, kept_short,
           merge_count, kept_small, largest_move, repaired_below, t_vertices,
           moved_t_vertices, kept_t_vertices, x_vertices] = counts;
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
  ar.records({"joint_lengths", not_negative}, joint_lengths,
             [](auto& column, auto& length) {
               auto& [cut, joint, drawn, pruned] = length;
               column("cut", cut);
               column("joint", joint);
               column("drawn", drawn);
               column("pruned", pruned);
             });
}

template <class S, class Archive> void visit_solves(S& solves, Archive& ar) {
  ar.records({"solves", not_negative}, solves, [](auto& column, auto& solve) {
    auto& [line, wanted, reached, step_count, end, converged, largest_force, at,
           wanted_local, reached_local, local_block, dt, min_scale, largest_scale] =
        solve;
    column("line", line);
    column("wanted", wanted);
    column("reached", reached);
    column("steps", step_count);
    column("time", end);
    column("converged", converged);
    column("largest", largest_force);
    column({"block", IndexOf::block_or_none}, at);
    column("wanted_local", wanted_local);
    column("reached_local", reached_local);
    column({"local_block", IndexOf::block_or_none}, local_block);
    column("dt", dt);
    column("least_scale", min_scale);
    column("largest_scale", largest_scale);
  });
}

template <class F, class T, class Archive>
void visit_safety(F& factors, T& trials, Archive& ar) {
  ar.records({"safety_factors", not_negative}, factors, [](auto& column, auto& card) {
    auto& [line, width, lower, upper, response, max_steps, complete] = card;
    column("line", line);
    column("width", width);
    column("lower", lower);
    column("upper", upper);
    column("response", response);
    column("most_steps", max_steps);
    column("complete", complete);
  });
  ar.records({"safety_trials", not_negative}, trials, [](auto& column, auto& trial) {
    auto& [search, factor, outcome, steps, ratio, local, speed, block, moved] = trial;
    column({"search", IndexOf::safety_factor}, search);
    column("factor", factor);
    column({"outcome", {0.0, trial_outcomes - 1, "0, 1 or 2"}}, outcome);
    column("steps", steps);
    column("ratio", ratio);
    column("local", local);
    column("speed", speed);
    column({"block", IndexOf::block_or_none}, block);
    column("moved", moved);
  });
}

}  // namespace blocks::output
