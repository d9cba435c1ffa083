#include "post/read/frame_units.hpp"

#include <type_traits>

#include "quantities/curve.hpp"
#include "quantities/model_quantity.hpp"
#include "quantities/quantity.hpp"

namespace blocks::post {

// Masses and forces are per unit thickness, [M] = M/L and [F] = M/T^2.

void convert(Frame& frame, const UnitScale& scale) {
  if (scale.is_one())
    return;
  const double stress = scale.of({-1, 1, -2});
  for (auto& outline : frame.outlines)
    for (Eigen::Vector2d& corner : outline)
      corner *= scale.length;
  for (WetSide& side : frame.wet_sides) {
    side.pressure *= stress;
    for (Eigen::Vector2d& end : side.ends)
      end *= scale.length;
  }
  for (Eigen::Vector2d& at : frame.water_line)
    at *= scale.length;
  frame.centroid *= scale.length;
  frame.velocity *= scale.of({1, 0, -1});
  frame.spin *= scale.of({0, 0, -1});
  frame.strain_rate *= scale.of({0, 0, -1});
  frame.force *= scale.of({0, 1, -2});
  frame.water_force *= scale.of({0, 1, -2});
  frame.unbalanced *= scale.of({0, 1, -2});
  frame.moment *= scale.of({1, 1, -2});
  frame.kinetic_energy *= scale.of({1, 1, -2});
  frame.area *= scale.of({2, 0, 0});
  frame.mass *= scale.of({-1, 1, 0});
  frame.inertia *= scale.of({1, 1, 0});
  frame.stress *= stress;
  frame.applied *= stress;
}

void convert(FrameContacts& contacts, const UnitScale& scale) {
  if (scale.is_one())
    return;
  const double force = scale.of({0, 1, -2}), stiffness = scale.of({-1, 1, -2});
  const auto factor = [&](StateDimension dimension) {
    return dimension == StateDimension::length      ? scale.length
           : dimension == StateDimension::stiffness ? stiffness
                                                    : 1.0;
  };
  contacts.point *= scale.length;
  contacts.overlap *= scale.length;
  contacts.normal_force *= force;
  contacts.shear_force *= force;
  for (LawState& state : contacts.states)
    each_law_field([&]<class Member>(const LawField& field, Member LawState::*member) {
      if constexpr (std::is_same_v<Member, double>)
        state.*member *= factor(field.dimension);
    });
}

void convert(std::vector<Crack>& cracks, const UnitScale& scale) {
  if (scale.is_one())
    return;
  const double stress = scale.of({-1, 1, -2}), area = scale.of({2, 0, 0}),
               energy = scale.of({1, 1, -2});
  for (Crack& crack : cracks) {
    crack.time *= scale.time;
    crack.stress *= stress;
    crack.from *= scale.length;
    crack.to *= scale.length;
    crack.moved *= scale.length;
    crack.parent_area *= area;
    crack.child_area *= area;
    for (double* value : {&crack.kinetic_before, &crack.kinetic_after,
                          &crack.strain_before, &crack.strain_after})
      *value *= energy;
  }
}

void convert(RecordedHistory& recorded, const UnitScale& scale) {
  if (scale.is_one())
    return;
  recorded.interval *= scale.time;
  for (double& time : recorded.time)
    time *= scale.time;
  for (std::size_t i = 0; i < recorded.quantities.size(); ++i) {
    const std::string name = quantities::parse_curve(recorded.quantities[i]).quantity;
    const quantities::OtherKind* other = quantities::find_other(name);
    recorded.values.row(static_cast<Eigen::Index>(i)) *=
        scale.of(other ? other->dimension : quantities::find_quantity(name)->dimension);
  }
}

}  // namespace blocks::post
