#include "dynamics/face_ends.hpp"

#include "geometry/contact_constants.hpp"
#include "geometry/contact_predicates.hpp"

namespace blocks::dynamics {
namespace {

/// A corner that has slipped by more than this share of its edge slides.
constexpr double sliding = 0x1p-10;

/// The two contacts at one end of a face.
class SharedEnd {
 public:
  SharedEnd(const Blocks& blocks, ContactArrays& arrays, int first, int second)
      : blocks_(blocks), arrays_(arrays),
        batches_(arrays.batches), ends_{Contact(*this, first), Contact(*this, second)} {
  }

  void share() {
    auto& [a, b] = ends_;
    if ((!a.acted && !b.acted) || !may_share())
      return;
    pass_on_held(a, b), pass_on_held(b, a);
    if ((!a.acts && !b.acts) || (a.acts == a.acted && b.acts == b.acted))
      return;
    copy_state(a, b), copy_state(b, a);
    const double part = a.acts && b.acts ? 0.5 : 1.0;
    for (const auto column : {&SpringRow::normal_elastic, &SpringRow::shear_elastic})
      spread(column, part);
    for (const auto column : {&LawRow::stiffness, &LawRow::shear_stiffness})
      spread(column, part);
    for (const Contact& contact : ends_) {
      batches_.set(contact.slot, &ContactStates::acts, contact.acts);
      batches_.set(contact.slot, &ContactStates::starts, false);
      batches_.set(contact.slot, &ContactStates::ends, false);
    }
  }

 private:
  struct Contact {
    int slot;
    CornerOnEdge at;
    bool acts, acted;  ///< in this step, in the step before

    Contact(const SharedEnd& end, int number)
        : slot(number), at(end.arrays_.at(number)),
          acts(end.batches_.is(number, &ContactStates::acts)),
          acted(acts ? !end.batches_.is(number, &ContactStates::starts)
                     : end.batches_.is(number, &ContactStates::ends)) {}
  };

  Vec2 at(int corner) const { return blocks_.corner.col(corner); }
  Vec2 side(const Contact& contact) const {
    return at(blocks_.next[contact.at.edge]) - at(contact.at.edge);
  }
  /// Returns the depth of the corner of a contact below its edge, [L]; negative: a gap.
  double depth(const Contact& contact) const {
    const Vec2 along = side(contact);
    return geometry::cross(at(contact.at.corner) - at(contact.at.edge), along) /
           along.norm();
  }
  double& offset(const Contact& contact) const {
    return batches_.at(contact.slot, &LawRow::offset);
  }

  /// Returns whether the corner of a contact slides along its edge. Its spring then
  /// goes with the corner to the next edge.
  bool slides(const Contact& contact) const {
    const double slip = batches_.at(contact.slot, &LawRow::slip);
    return contact.acted &&
           slip * slip > sliding * sliding * side(contact).squaredNorm();
  }
  bool may_share() const {
    const auto& [a, b] = ends_;
    const int law = batches_.at(a.slot, &FaceRow::law);
    if (law != batches_.at(b.slot, &FaceRow::law))
      return false;
    const bool held = arrays_.laws.in_situ() && (offset(a) > 0.0 || offset(b) > 0.0);
    if (!held && (!arrays_.laws.has_stiffness(law) || slides(a) || slides(b)))
      return false;
    const Vec2 one = side(a), other = side(b);
    const double along = one.dot(other);
    constexpr double square = geometry::face_cosine * geometry::face_cosine;
    return along < 0.0 &&
           along * along >= square * one.squaredNorm() * other.squaredNorm();
  }
  /// If `from` has left its edge although its offset would hold it, the other corner
  /// acts in its place.
  void pass_on_held(const Contact& from, Contact& to) const {
    if (!from.acted || from.acts || to.acts || to.acted || !(offset(from) > 0.0) ||
        !(depth(from) + offset(from) > 0.0))
      return;
    const auto [corner, edge] = to.at;
    to.acts = geometry::between(at(corner), at(edge), at(blocks_.next[edge]));
  }
  /// Gives a contact that begins to act the state of the other one. Its offset is such
  /// that both are equally deep.
  void copy_state(const Contact& from, const Contact& to) const {
    if (!to.acts || to.acted)
      return;
    each_state(
        [&](double* value, const double* other) {
          value[to.slot % lane_count] = other[from.slot % lane_count];
        },
        batches_.law_states[to.slot / lane_count],
        batches_.law_states[from.slot / lane_count]);
    batches_.at(to.slot, &LawRow::stiffness) = 0.0;
    batches_.at(to.slot, &LawRow::shear_stiffness) = 0.0;
    if (offset(from) > 0.0)
      offset(to) += depth(from) - depth(to);
  }
  /// Divides the sum of a number of both contacts among those that act.
  template <class Row> void spread(PerLane<double> Row::*column, double part) const {
    const auto& [a, b] = ends_;
    const double sum = (a.acted ? batches_.at(a.slot, column) : 0.0) +
                       (b.acted ? batches_.at(b.slot, column) : 0.0);
    for (const Contact& contact : ends_)
      batches_.at(contact.slot, column) = contact.acts ? part * sum : 0.0;
  }

  const Blocks& blocks_;
  const ContactArrays& arrays_;
  ContactBatches& batches_;
  Contact ends_[2];
};

}  // namespace

void share_ends(const Blocks& blocks, ContactArrays& arrays, int batch) {
  ContactBatches& batches = arrays.batches;
  const BatchPairs& pairs = batches.pairs[batch];
  LaneBits changed = 0;
  for (int row = 0; row < pairs.rows; ++row) {
    const ContactStates& states = batches.states[pairs.first_row + row];
    changed |= states.starts | states.ends;
  }
  for (int k = 0; k < lane_count; ++k) {
    if ((changed >> k & 1U) == 0)
      continue;
    // Of the two contacts at an end, each is the partner of the other.
    for (int row = 0; row < pairs.rows; ++row)
      for (const auto partner : {&FaceRow::partner_before, &FaceRow::partner_after}) {
        const int slot = (pairs.first_row + row) * lane_count + k;
        const int other = batches.at(slot, partner);
        if (other > row)
          SharedEnd(blocks, arrays, slot, (pairs.first_row + other) * lane_count + k)
              .share();
      }
    batches.find_shared_ends(batch, k);
  }
}

}  // namespace blocks::dynamics
