// The laws of joints in the layout of the kernels, and which law acts at a contact
// (docs/laws.md#which-law-acts).
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "dynamics/kernels/joint_batch.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// Laws are numbered in the order of their joint ids, from 1. Law 0 is that of STIFF
/// and FRICTN. After INSITU every contact has a state, also those of law 0.
class LawTable {
 public:
  /// Returns whether no contact has a state (LawState): the model has no laws of
  /// joints and no INSITU card.
  bool none() const { return ids_.size() <= 1 && !in_situ_; }
  /// Returns whether an INSITU card has acted. Contacts of law 0 have offsets then.
  bool in_situ() const { return in_situ_; }
  /// Returns whether the table was made from these settings.
  bool is_of(const Settings& settings) const;
  /// Makes the table.
  void make(const Settings& settings, const Blocks& blocks);

  /// Returns the number of the law of a contact between a corner and an edge.
  int law_of(const Blocks& blocks, int corner, int edge) const;
  /// Returns whether contacts of two blocks may have a state: a law other than 0, or
  /// any law after INSITU.
  bool may_act(const Blocks& blocks, int low, int high) const;
  /// Returns the joint id of a law; 0 for law 0.
  int id(int law) const { return ids_[static_cast<std::size_t>(law)]; }
  /// Returns the number of the law of a joint id; 0: it has none.
  int number_of(int id) const;
  /// Returns the bit of the kind of a law.
  LawBits bit(int law) const { return bits_[static_cast<std::size_t>(law)]; }
  /// Returns the values of a law.
  const LawValues<double>& values(int law) const {
    return values_[static_cast<std::size_t>(law)];
  }
  /// Returns whether the law has its own stiffness per length.
  bool has_stiffness(int law) const { return values(law).normal_stiffness > 0.0; }
  const LawColumns& columns() const { return columns_; }

 private:
  std::map<int, JointLaw> laws_;
  std::map<std::pair<int, int>, int> of_materials_;
  double friction_ = 0.0;
  bool in_situ_ = false;
  std::vector<int> ids_;         ///< (laws) 0 first
  std::vector<char> block_has_;  ///< (blocks) an edge has an id with a law
  std::vector<LawValues<double>> values_ = {{}};  ///< (laws)
  std::vector<LawBits> bits_ = {coulomb_bit};     ///< (laws)
  std::vector<double> numbers_;                   ///< the columns one after the other
  LawColumns columns_;
};

}  // namespace blocks::dynamics
