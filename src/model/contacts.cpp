#include "model/contacts.hpp"

#include <algorithm>

namespace blocks {

void Contacts::resize(int k) {
  const auto n = static_cast<std::size_t>(k);
  for (auto* column : {&corner, &edge})
    column->resize(n);
  active.assign(n, 0);
  acting.clear();
}

ActingContact Contacts::at(int i) const {
  const auto found = std::lower_bound(
      acting.begin(), acting.end(), i,
      [](const ActingContact& a, int record) { return a.record < record; });
  return found != acting.end() && found->record == i ? *found : ActingContact{i};
}

void PlaneContacts::resize(int k) {
  const auto n = static_cast<std::size_t>(k);
  plane.resize(n);
  corner.resize(n);
  active.resize(n);
  for (auto* column : {&normal_elastic, &normal_force, &overlap})
    column->setZero(k);
}

}  // namespace blocks
