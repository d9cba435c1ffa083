#include "model/contacts.hpp"

namespace blocks {

void PlaneContacts::resize(int k) {
  const auto n = static_cast<std::size_t>(k);
  plane.resize(n);
  corner.resize(n);
  active.resize(n);
  for (auto* column : {&normal_elastic, &normal_force, &overlap})
    column->setZero(k);
}

}  // namespace blocks
