#include "model/energy.hpp"

#include <cmath>
#include <cstddef>

namespace blocks {

void EnergyAccount::add(EnergyEntry entry, double amount) {
  const auto i = static_cast<std::size_t>(entry);
  const double before = sums[i], total = before + amount;
  // The error of the addition, exactly (Neumaier).
  errors[i] += std::abs(before) >= std::abs(amount) ? (before - total) + amount
                                                    : (amount - total) + before;
  sums[i] = total;
}

double EnergyAccount::of(EnergyEntry entry) const {
  const auto i = static_cast<std::size_t>(entry);
  return i < sums.size() ? sums[i] + errors[i] : 0.0;
}

double EnergyAccount::residual() const {
  double rest = start - kinetic - elastic - strain;
  for (int i = 0; i < energy_entries; ++i) {
    const double energy = of(static_cast<EnergyEntry>(i));
    rest += i < first_taken_entry ? energy : -energy;
  }
  return rest;
}

double EnergyAccount::at_play() const {
  double all = std::abs(start) + std::abs(kinetic) + elastic + std::abs(strain);
  for (int i = 0; i < energy_entries; ++i)
    all += std::abs(of(static_cast<EnergyEntry>(i)));
  return 0.5 * all;
}

}  // namespace blocks
