#include "dynamics/preparation/contact_table.hpp"

#include <algorithm>

namespace blocks::dynamics {
namespace {

Contact unloaded(const CornerOnEdge& at) {
  Contact contact;
  contact.corner = at.corner, contact.edge = at.edge;
  return contact;
}

}  // namespace

ContactTable::ContactTable(Model& model) : model_(model) {
  model.law_states.resize(model.contacts.size());
  for (std::size_t i = 0; i < model.contacts.size(); ++i)
    all_.push_back({model.contacts[i], model.law_states[i]});
  listed_ = all_.size();
}

ContactEntry* ContactTable::find(const CornerOnEdge& at) {
  const auto key = sort_key(model_.blocks, unloaded(at));
  const auto end = all_.begin() + static_cast<std::ptrdiff_t>(listed_);
  const auto place = std::lower_bound(
      all_.begin(), end, key, [&](const auto& one, const auto& wanted) {
        return sort_key(model_.blocks, one.first) < wanted;
      });
  const bool is_listed = place != end && sort_key(model_.blocks, place->first) == key;
  return is_listed ? &*place : nullptr;
}

ContactEntry& ContactTable::find_or_add(const CornerOnEdge& at) {
  ContactEntry* const listed = find(at);
  return listed != nullptr ? *listed : all_.emplace_back(unloaded(at), LawState{});
}

void ContactTable::finish() {
  std::sort(all_.begin(), all_.end(), [&](const auto& l, const auto& r) {
    return sort_key(model_.blocks, l.first) < sort_key(model_.blocks, r.first);
  });
  model_.contacts.clear(), model_.law_states.clear();
  for (const auto& [contact, state] : all_)
    model_.contacts.push_back(contact), model_.law_states.push_back(state);
}

}  // namespace blocks::dynamics
