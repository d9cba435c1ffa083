// The columns of cracks and of factors of safety in a checkpoint, as in
// model_fields.hpp.
#pragma once

namespace blocks::output {

template <class C, class R, class Archive>
void visit_cracks(C& cracks, R& refusals, Archive& ar) {
  ar.records("cracks", cracks, [](auto& column, auto& crack) {
    auto& [step, time, parent, child, cause, stress, from, to, moved, parent_area,
           child_area, kinetic_before, kinetic_after, strain_before, strain_after] =
        crack;
    column("step", step);
    column("time", time);
    column("parent", parent);
    column("child", child);
    column("cause", cause);
    column("stress", stress);
    column("from_x", from.x());
    column("from_y", from.y());
    column("to_x", to.x());
    column("to_y", to.y());
    column("moved", moved);
    column("parent_area", parent_area);
    column("child_area", child_area);
    column("kinetic_before", kinetic_before);
    column("kinetic_after", kinetic_after);
    column("strain_before", strain_before);
    column("strain_after", strain_after);
  });
  ar.records("crack_refusals", refusals, [](auto& column, auto& refused) {
    auto& [block, why] = refused;
    column("block", block);
    column("why", why);
  });
}

template <class F, class T, class Archive>
void visit_safety(F& factors, T& trials, Archive& ar) {
  ar.records("safety_factors", factors, [](auto& column, auto& card) {
    auto& [line, width, lower, upper, response, most_steps, complete] = card;
    column("line", line);
    column("width", width);
    column("lower", lower);
    column("upper", upper);
    column("response", response);
    column("most_steps", most_steps);
    column("complete", complete);
  });
  ar.records("safety_trials", trials, [](auto& column, auto& trial) {
    auto& [search, factor, outcome, steps, ratio, local, speed, block, moved] = trial;
    column("search", search);
    column("factor", factor);
    column("outcome", outcome);
    column("steps", steps);
    column("ratio", ratio);
    column("local", local);
    column("speed", speed);
    column("block", block);
    column("moved", moved);
  });
}

}  // namespace blocks::output
