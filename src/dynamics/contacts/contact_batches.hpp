// The memory of all batches of contacts.
#pragma once

#include <memory>
#include <utility>

#include "dynamics/kernels/contact_batch.hpp"

namespace blocks::dynamics {

/// The memory of batches and their rows. Pair k of a batch has lane number 8 batch + k.
/// Its contact in a row has slot number 8 row + k.
class ContactBatches : public BatchArrays {
 public:
  int batches() const { return batches_; }
  int rows() const { return rows_; }
  /// Removes all batches and reserves memory for others, with the arrays for laws of
  /// joints if `with_laws`. It is a sixteenth larger, so that a pile that falls is
  /// seldom given new memory. The operating system provides pages when they are first
  /// used.
  void reserve(int batches, int rows, bool with_laws);
  /// Adds a batch of idle lanes and vacant slots, and returns its number.
  int add_batch(int rows);

  /// Adds the law of a contact to those of its batch.
  void include_law(int batch, int law, LawBits bit) {
    BatchPairs& own = pairs[batch];
    own.only_law = own.laws == 0 || own.only_law == law ? law : -1;
    own.laws |= bit;
  }

  /// Finds which contacts in lane k of a batch share ends of faces with others that
  /// act. Call it when contacts have begun or ceased to act.
  void find_shared_ends(int batch, int k);

  /// The springs at the end of this step become those at the start of the next step.
  void advance_springs() {
    std::swap(springs, advanced);
    std::swap(law_states, advanced_law_states);
  }

  /// Returns a number of one lane or slot, such as at(slot, &ContactRow::corner).
  template <class Part, class Number>
  Number& at(int i, PerLane<Number> Part::*row) const {
    return (part(static_cast<Part*>(nullptr))[i / lane_count].*row)[i % lane_count];
  }
  /// Returns whether a bit of one slot is set.
  template <class Part> bool is(int slot, LaneBits Part::*which) const {
    const LaneBits all = part(static_cast<Part*>(nullptr))[slot / lane_count].*which;
    return (all >> slot % lane_count & 1U) != 0;
  }
  template <class Part> void set(int slot, LaneBits Part::*which, bool yes) {
    LaneBits& all = part(static_cast<Part*>(nullptr))[slot / lane_count].*which;
    const unsigned bit = 1U << slot % lane_count;
    all = static_cast<LaneBits>(yes ? all | bit : all & ~bit);
  }

 private:
  BatchPairs* part(BatchPairs*) const { return pairs; }
  ContactRow* part(ContactRow*) const { return contacts; }
  SpringRow* part(SpringRow*) const { return springs; }
  FaceRow* part(FaceRow*) const { return faces; }
  LawRow* part(LawRow*) const { return law_states; }
  ContactTests* part(ContactTests*) const { return tests; }
  ContactStates* part(ContactStates*) const { return states; }

  int batches_ = 0, rows_ = 0;
  int capacity_ = 0, row_capacity_ = 0, law_capacity_ = 0;  ///< batches, rows, rows
  bool with_laws_ = false;
  std::unique_ptr<BatchPairs[]> own_pairs_;
  std::unique_ptr<BatchMarks[]> own_marks_;
  std::unique_ptr<PairForce[]> own_forces_;
  std::unique_ptr<PairStress[]> own_stresses_;
  std::unique_ptr<PairWork[]> own_works_;
  std::unique_ptr<ContactRow[]> own_contacts_;
  std::unique_ptr<ContactTests[]> own_tests_;
  std::unique_ptr<ContactStates[]> own_states_;
  std::unique_ptr<SpringRow[]> own_springs_, own_advanced_;
  std::unique_ptr<ReadingRow[]> own_readings_;
  std::unique_ptr<FaceRow[]> own_faces_;
  std::unique_ptr<DashpotRow[]> own_dashpots_;
  std::unique_ptr<LawRow[]> own_law_states_, own_advanced_law_states_;
};

}  // namespace blocks::dynamics
