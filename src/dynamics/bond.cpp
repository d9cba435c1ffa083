#include "dynamics/bond.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "dynamics/contacts/law_table.hpp"
#include "dynamics/rules/pair_rule.hpp"
#include "dynamics/search/near_pairs.hpp"
#include "geometry/contact_predicates.hpp"

namespace blocks::dynamics {
namespace {

/// One of the two ends of a face: the contacts there, at most two.
struct FaceEnd {
  std::array<CornerOnEdge, 2> records;
  int count = 0;
  double gap = 0.0;  ///< [L] distance of the two sides
};

/// The two sides of a face: e of one block, f of another, in opposite directions.
class Face {
 public:
  Face(const Blocks& blocks, int e, int f)
      : blocks_(blocks), e_(e), f_(f), start_(at(e)),
        along_(at(blocks.next[e]) - start_), length_(along_.norm()) {
    along_ /= length_;
  }

  /// Returns whether the two sides face each other, overlap in projection, and are at
  /// most `tolerance` apart at both ends.
  bool is_flush(double tolerance) const {
    const Vec2 other = at(blocks_.next[f_]) - at(f_);
    return along_.dot(other) <= -0.95 * other.norm() &&
           high() - low() > std::max(tolerance, geometry::contact_slack * length_) &&
           end(true, tolerance).gap <= tolerance &&
           end(false, tolerance).gap <= tolerance;
  }
  /// Returns the end at the end of e, or at its start.
  FaceEnd end(bool at_end_of_e, double tolerance) const {
    // f runs backwards: its start is at the end of e.
    const int of_e = at_end_of_e ? blocks_.next[e_] : e_;
    const int of_f = at_end_of_e ? f_ : blocks_.next[f_];
    const double here = at_end_of_e ? length_ : 0.0, there = position(of_f);
    const double beyond = at_end_of_e ? there - here : here - there;
    const double slack = std::max(tolerance, geometry::contact_slack * length_);
    FaceEnd found;
    const auto add = [&](int corner, int edge) {
      found.records[static_cast<std::size_t>(found.count++)] = {corner, edge};
      found.gap = std::max(found.gap, std::abs(depth(corner, edge)));
    };
    if (beyond <= slack)
      add(of_f, e_);
    if (beyond >= -slack)
      add(of_e, f_);
    return found;
  }

 private:
  Vec2 at(int corner) const { return blocks_.corner.col(corner); }
  double position(int corner) const { return along_.dot(at(corner) - start_); }
  double low() const { return std::max(0.0, position(blocks_.next[f_])); }
  double high() const { return std::min(length_, position(f_)); }
  double depth(int corner, int edge) const {
    const Vec2 side = at(blocks_.next[edge]) - at(edge);
    return geometry::cross(at(corner) - at(edge), side) / side.norm();
  }

  const Blocks& blocks_;
  int e_, f_;
  Vec2 start_, along_;
  double length_;
};

/// Contacts of the model with their states, sorted.
class BondedList {
 public:
  explicit BondedList(Model& model) : model_(model) {
    model.joint_states.resize(model.contacts.size());
    for (std::size_t i = 0; i < model.contacts.size(); ++i)
      all_.push_back({model.contacts[i], model.joint_states[i]});
    listed_ = all_.size();
  }
  /// Bonds a contact. Adds it if it is not listed.
  void bond(const CornerOnEdge& at, int id) {
    Contact contact;
    contact.corner = at.corner, contact.edge = at.edge;
    const auto key = sort_key(model_.blocks, contact);
    const auto end = all_.begin() + static_cast<std::ptrdiff_t>(listed_);
    const auto place =
        std::lower_bound(all_.begin(), end, key, [&](const auto& one, const auto& of) {
          return sort_key(model_.blocks, one.first) < of;
        });
    const bool is_listed = place != end && sort_key(model_.blocks, place->first) == key;
    JointState& state =
        is_listed ? place->second : all_.emplace_back(contact, JointState{}).second;
    if (!state.bonded || state.failed)
      ++model_.bonds_made;
    state.law = id, state.bonded = true, state.failed = false;
    ++bonded_;
  }
  /// Writes the lists back and returns the number of bonded contacts.
  int finish() {
    std::sort(all_.begin(), all_.end(), [&](const auto& l, const auto& r) {
      return sort_key(model_.blocks, l.first) < sort_key(model_.blocks, r.first);
    });
    model_.contacts.clear(), model_.joint_states.clear();
    for (const auto& [contact, state] : all_)
      model_.contacts.push_back(contact), model_.joint_states.push_back(state);
    return bonded_;
  }

 private:
  Model& model_;
  std::vector<std::pair<Contact, JointState>> all_;
  std::size_t listed_ = 0;
  int bonded_ = 0;
};

}  // namespace

int bond_faces(Model& model, int id, double tolerance) {
  const Blocks& blocks = model.blocks;
  LawTable laws;
  laws.make(model.settings, blocks);
  NearSearch memory;
  std::vector<NearPair> pairs;
  find_near_pairs(blocks, tolerance, memory, pairs);
  BondedList list(model);
  std::vector<CornerOnEdge> bonded;
  for (const NearPair& pair : pairs) {
    if (!laws.may_act(blocks, pair.low, pair.high))
      continue;
    bonded.clear();
    for (int e = blocks.first_corner[pair.low]; e < blocks.first_corner[pair.low + 1];
         ++e)
      for (int f = blocks.first_corner[pair.high];
           f < blocks.first_corner[pair.high + 1]; ++f) {
        const Face face(blocks, e, f);
        if (!face.is_flush(tolerance))
          continue;
        for (const bool at_end_of_e : {false, true}) {
          const FaceEnd end = face.end(at_end_of_e, tolerance);
          bonded.insert(bonded.end(), end.records.begin(),
                        end.records.begin() + end.count);
        }
      }
    for (std::size_t i = 0; i < bonded.size(); ++i) {
      const CornerOnEdge& at = bonded[i];
      const int law = laws.law_of(blocks, at.corner, at.edge);
      const bool is_new =
          std::find(bonded.begin(), bonded.begin() + static_cast<std::ptrdiff_t>(i),
                    at) == bonded.begin() + static_cast<std::ptrdiff_t>(i);
      if (is_new && law != 0 && laws.bit(law) != barton_bit &&
          (id == 0 || laws.id(law) == id))
        list.bond(at, laws.id(law));
    }
  }
  return list.finish();
}

}  // namespace blocks::dynamics
