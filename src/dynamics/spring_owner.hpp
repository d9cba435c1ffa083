// Records where the current springs of contacts are: in the list of the model
// (Model::contacts), in the arrays of the step, or in both; after cracks, those of the
// pieces are in the list and all others in the arrays.
#pragma once

namespace blocks::dynamics {

class SpringOwner {
 public:
  /// To be called when the model was made, restored from a checkpoint or changed from
  /// outside. The arrays are then out of date.
  void list_changed() { owner_ = Owner::list; }
  /// To be called after a step that did not write the list. The list is then out of
  /// date.
  void arrays_changed() { owner_ = Owner::arrays; }
  /// To be called when the arrays were made from the list, or the list from the arrays.
  void both_agree() { owner_ = Owner::both; }
  /// To be called when blocks have split and the list has followed. The arrays are then
  /// current except for the pairs of those blocks.
  void blocks_split() { owner_ = Owner::list_and_unsplit; }

  bool arrays_are_current() const {
    return owner_ == Owner::arrays || owner_ == Owner::both;
  }
  bool arrays_lack_pieces() const { return owner_ == Owner::list_and_unsplit; }
  bool list_is_current() const { return owner_ != Owner::arrays; }

 private:
  enum class Owner { list, arrays, both, list_and_unsplit };
  Owner owner_ = Owner::list;
};

}  // namespace blocks::dynamics
