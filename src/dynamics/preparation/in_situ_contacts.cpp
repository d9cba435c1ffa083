#include "dynamics/preparation/in_situ_contacts.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/kernels/face_length.hpp"
#include "dynamics/kernels/laws.hpp"

namespace blocks::dynamics {
namespace {

/// Returns the length of joint that a contact stands for in its first step, [L].
/// acts(at) tells which contacts act.
template <class Acts>
double length_of(const Blocks& blocks, const CornerOnEdge& at, const Acts& acts) {
  const auto corner = [&](int c) { return Vec2(blocks.corner.col(c)); };
  const int before = blocks.previous[at.corner], after = blocks.next[at.corner];
  const int edge_end = blocks.next[at.edge];
  const Vec2 edge = corner(edge_end) - corner(at.edge);
  const double place = (corner(at.corner) - corner(at.edge)).dot(edge);
  const EdgeLine<double> line = {edge.x(), edge.y(), edge.squaredNorm(), place};
  const Vec2 from = corner(before) - corner(at.corner);
  const Vec2 to = corner(at.corner) - corner(after);
  const double share_before = acts({at.edge, before}) ? 0.5 : 1.0;
  const double share_after = acts({edge_end, at.corner}) ? 0.5 : 1.0;
  const double both = common_length(line, from.x(), from.y(), true) * share_before +
                      common_length(line, to.x(), to.y(), false) * share_after;
  return 0.5 * both / std::sqrt(line.square);
}

void unload(ContactEntry& entry) {
  auto& [contact, state] = entry;
  contact.normal_elastic = contact.normal_force = 0.0;
  contact.shear_elastic = contact.shear_force = 0.0;
  state.offset = state.closure = state.plastic = 0.0;
}

/// Returns the least slip that mobilises a strength of BARTON of at least the shear
/// force, [L]; 0 if no slip does.
double mobilising_path(const LawValues<double>& law, const LawState& state,
                       const FaceLoad& load) {
  const double shear = std::abs(load.shear);
  const double elastic =
      state.shear_stiffness > 0.0 ? shear / state.shear_stiffness : 0.0;
  constexpr double margin = 1e-12;  // for the rounding of later steps
  const auto holds = [&](double path) {
    const double u = (path + elastic) / law.peak_slip;
    return rough_strength(law, state.length, load.normal, u).limit >=
           (1.0 + margin) * shear;
  };
  double low = 0.0, high = std::max(0.0, law.peak_slip - elastic);
  if (holds(low) || !holds(high))
    return 0.0;
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (holds(middle) ? high : low) = middle;
  }
  return high;
}

}  // namespace

void ContactLoading::load(const std::vector<FaceLoad>& loads) {
  for (const FaceLoad& load : loads)
    put(load, loads);
}

/// Returns whether the contact can carry tension.
bool ContactLoading::is_bonded(const FaceLoad& load) {
  const ContactEntry* const listed = table_.find(load.at);
  return listed != nullptr && listed->second.bonded &&
         laws_.bit(laws_.law_of(model_.blocks, load.at.corner, load.at.edge)) ==
             coulomb_bit;
}

bool ContactLoading::carries(const FaceLoad& load) {
  return load.normal > 0.0 || is_bonded(load);
}

void ContactLoading::put(const FaceLoad& load, const std::vector<FaceLoad>& loads) {
  if (!carries(load)) {
    report_.open += load.normal < 0.0;
    if (ContactEntry* const listed = table_.find(load.at))
      unload(*listed);
    return;
  }
  const double length = length_of(model_.blocks, load.at, [&](CornerOnEdge at) {
    return std::any_of(loads.begin(), loads.end(), [&](const FaceLoad& one) {
      return one.at == at && carries(one);
    });
  });
  ContactEntry& entry = table_.find_or_add(load.at);
  ++report_.contacts;
  const int law = laws_.law_of(model_.blocks, load.at.corner, load.at.edge);
  set(entry, load, law, length);
  test(entry, law);
}

void ContactLoading::set(ContactEntry& entry, const FaceLoad& load, int law,
                         double length) {
  auto& [contact, state] = entry;
  const Settings& settings = model_.settings;
  const LawValues<double>& values = laws_.values(law);
  const double depth = depth_below(model_.blocks, load.at);
  contact.normal_elastic = contact.normal_force = load.normal;
  contact.shear_elastic = contact.shear_force = load.shear;
  contact.overlap = std::max(0.0, depth);
  if (!state.bonded)
    state.failed = true;
  state.law = laws_.id(law);
  state.length = length;
  state.stiffness = stiffness_of(state.stiffness, values.normal_stiffness, length,
                                 settings.normal_stiffness);
  state.shear_stiffness = stiffness_of(state.shear_stiffness, values.shear_stiffness,
                                       length, settings.shear_stiffness);
  double compression = load.normal / state.stiffness;
  if (laws_.bit(law) == walton_bit) {
    // On the line of first loading, a little beyond it so that FN is kept exactly.
    constexpr double beyond = 1.0 + 0x1p-50;
    state.closure = compression * beyond;
    state.plastic = state.closure - compression / values.unloading_ratio;
  } else if (laws_.bit(law) == barton_bit) {
    const BandisClosure<double> bandis(values, length, state.stiffness);
    state.closure = compression = bandis.closure(load.normal);
    state.plastic = 0.0;
    state.path = mobilising_path(values, state, load);
  }
  state.offset = std::max(0.0, compression - depth);
}

/// Makes a step without motion, and reports a contact whose spring does not stay.
void ContactLoading::test(const ContactEntry& entry, int law) {
  const auto& [contact, state] = entry;
  ContactMotion<double> still{};
  still.overlap = contact.overlap;
  ContactState<double> now = state_of(contact, state);
  ContactForce<double> force{};
  constexpr double any_step = 1.0;
  each_law(laws_.bit(law), [&]<LawBits kind>(std::integral_constant<LawBits, kind>) {
    apply_law<kind, false>(laws_.values(law), any_step, still, now, force);
  });
  const double normal = contact.normal_elastic, shear = contact.shear_elastic;
  const double lost = std::hypot(normal - now.normal, shear - now.shear);
  constexpr double rounding = 1e-9;
  if (lost > rounding * std::hypot(normal, shear))
    report_.add_weak(model_.blocks.corner.col(contact.corner), normal, shear, lost);
}

}  // namespace blocks::dynamics
