// The list of contacts of a model while a card changes it.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "dynamics/rules/pair_rule.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// A contact and the state of its law.
using ContactEntry = std::pair<Contact, LawState>;

/// Finds and adds contacts. Refers to the model, whose list does not change before
/// `finish`.
class ContactTable {
 public:
  explicit ContactTable(Model& model);

  /// Returns a contact that the model lists; null if it does not. It does not find
  /// contacts that find_or_add has added.
  ContactEntry* find(const CornerOnEdge& at);
  /// Returns a contact. Adds it, without springs, if the model does not list it. A
  /// second call for an added contact would add it again, so it is not allowed. The
  /// next call invalidates the reference.
  ContactEntry& find_or_add(const CornerOnEdge& at);
  /// Writes all contacts to the model, sorted.
  void finish();

 private:
  Model& model_;
  std::vector<ContactEntry> all_;
  std::size_t listed_ = 0;
};

}  // namespace blocks::dynamics
