// The fields of the settings in a checkpoint. Part of model_fields.hpp, which describes
// archives.
#pragma once

#include "output/checkpoint/checkpoint_field.hpp"

namespace blocks::output {

template <class L, class P, class Archive>
void visit_laws(L& laws, P& pairs, Archive& ar) {
  ar.materials("settings/joint_laws", laws, [](auto& column, auto& id, auto& law) {
    auto& [kind, friction, cohesion, tension, residual_friction, residual_cohesion,
           residual_tension, dilation, dilation_limit, normal_stiffness,
           shear_stiffness, restitution, roughness, wall_strength, residual_angle,
           peak_slip, initial_stiffness, largest_closure, largest_stiffness,
           strength_share] = law;
    column({"id", positive}, id);
    column({"kind", {0.0, 2.0, "0, 1 or 2"}}, kind);
    column({"friction", not_negative}, friction);
    column({"cohesion", not_negative}, cohesion);
    column({"tension", not_negative}, tension);
    column({"residual_friction", not_negative}, residual_friction);
    column({"residual_cohesion", not_negative}, residual_cohesion);
    column({"residual_tension", not_negative}, residual_tension);
    column({"dilation", not_negative}, dilation);
    column({"dilation_limit", {0.0, infinite, "a number above 0", true}},
           dilation_limit);
    column({"normal_stiffness", not_negative}, normal_stiffness);
    column({"shear_stiffness", not_negative}, shear_stiffness);
    column({"restitution", {0.0, 1.0, "a number above 0, up to 1", true}}, restitution);
    column({"roughness", not_negative}, roughness);
    column({"wall_strength", not_negative}, wall_strength);
    column({"residual_angle", not_negative}, residual_angle);
    column({"peak_slip", not_negative}, peak_slip);
    column({"initial_stiffness", not_negative}, initial_stiffness);
    column({"largest_closure", not_negative}, largest_closure);
    column({"largest_stiffness", not_negative}, largest_stiffness);
    column({"strength_share", positive}, strength_share);
  });
  ar.materials("settings/joint_of_materials", pairs,
               [](auto& column, auto& pair, auto& id) {
                 auto& [first, second] = pair;
                 column("first", first);
                 column("second", second);
                 column("id", id);
               });
}

inline constexpr Range at_least_1{1.0, largest, "a number from 1"};
inline constexpr Range below_1{0.0, 0x1.fffffffffffffp-1, "a number from 0, below 1"};

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
  ar({"settings/max_blocks", not_negative}, max_blocks);
  ar({"settings/max_corners", not_negative}, max_corners);
  ar("settings/lower", lower);
  ar("settings/upper", upper);
  ar({"settings/boxes_x", at_least_1}, boxes_x);
  ar({"settings/boxes_y", at_least_1}, boxes_y);
  ar({"settings/contact_tolerance", positive}, contact_tolerance);
  ar({"settings/normal_stiffness", positive}, normal_stiffness);
  ar({"settings/shear_stiffness", positive}, shear_stiffness);
  ar({"settings/fraction", up_to_1}, fraction);
  ar({"settings/damping", not_negative}, damping);
  ar({"settings/friction", not_negative}, friction);
  ar("settings/gravity", gravity);
  {
    auto& [from, begin, duration] = gravity_ramp;
    ar("settings/gravity_ramp/from", from);
    ar({"settings/gravity_ramp/begin", not_negative}, begin);
    ar({"settings/gravity_ramp/duration", not_negative}, duration);
  }
  ar({"settings/local_damping", below_1}, local_damping);
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
                 column({"number", positive}, number);
                 column({"youngs_modulus", not_negative}, e);
                 column({"shear_modulus", not_negative}, g);
                 column({"density", positive}, rho);
                 column("name", name);
                 column({"damping", up_to_1}, z);
               });
  ar.materials("settings/crack_rules", crack_rules,
               [](auto& column, auto& number, auto& rule) {
                 auto& [strength, min_area, point_strength, joint] = rule;
                 column("number", number);
                 column({"strength", positive}, strength);
                 column({"least_area", positive}, min_area);
                 column({"point_strength", not_negative}, point_strength);
                 column({"joint", not_negative}, joint);
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
  ar({"settings/merge_ratio", not_negative}, merge_ratio);
  ar({"settings/layers_made", not_negative}, layers_made);
}

}  // namespace blocks::output
