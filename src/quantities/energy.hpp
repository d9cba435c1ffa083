// The entries of the energy account as quantities of the model (docs/laws.md#energy).
#pragma once

#include <string>
#include <vector>

#include "model/energy.hpp"

namespace blocks::quantities {

/// A quantity of the account. HISTORY names it "energy:" and its name.
struct EnergyQuantity {
  std::string name, label;
  double (*value)(const EnergyAccount&);  ///< [F L]
};

/// All of them: the energies of the state, the entries, the residual, the energy at
/// play.
const std::vector<EnergyQuantity>& energy_quantities();

/// The beginning of the names in HISTORY.
inline constexpr const char* energy_prefix = "energy:";

}  // namespace blocks::quantities
