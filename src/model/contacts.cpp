#include "model/contacts.hpp"

namespace blocks {

void Contacts::resize(int k) {
  const auto n = static_cast<std::size_t>(k);
  for (auto* column : {&corner, &edge, &corner_block, &edge_block})
    column->resize(n);
  active.resize(n);
  for (auto* column : {&normal_elastic, &shear_elastic, &normal_force, &shear_force,
                       &overlap, &damping})
    column->setZero(k);
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
