// Which of the two holds the springs of contacts: the list of the model
// (Model::contacts) or the arrays of the steps.
#pragma once

namespace blocks::dynamics {

class SpringOwner {
 public:
  /// The model was made, read or changed from outside: the arrays are out of date.
  void list_changed() { owner_ = Owner::list; }
  /// A step was made without writing the list, which is out of date.
  void arrays_changed() { owner_ = Owner::arrays; }
  /// The arrays were made from the list, or the list was written from the arrays.
  void both_agree() { owner_ = Owner::both; }

  bool arrays_are_current() const { return owner_ != Owner::list; }
  bool list_is_current() const { return owner_ != Owner::arrays; }

 private:
  enum class Owner { list, arrays, both };
  Owner owner_ = Owner::list;
};

}  // namespace blocks::dynamics
