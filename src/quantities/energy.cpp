#include "quantities/energy.hpp"

namespace blocks::quantities {
namespace {

template <EnergyEntry entry> double of(const EnergyAccount& account) {
  return account.of(entry);
}

}  // namespace

const std::vector<EnergyQuantity>& energy_quantities() {
  using enum EnergyEntry;
  static const std::vector<EnergyQuantity> all = {
      {"start", "energy at the start", [](const EnergyAccount& a) { return a.start; }},
      {"gravity", "work of gravity", of<gravity>},
      {"loads", "work of loads", of<loads>},
      {"water", "work of water", of<water>},
      {"drives", "work of driven blocks", of<drives>},
      {"dilation", "work of dilation", of<dilation>},
      {"kinetic", "kinetic energy", [](const EnergyAccount& a) { return a.kinetic; }},
      {"elastic", "energy of springs",
       [](const EnergyAccount& a) { return a.elastic; }},
      {"strain", "strain energy of blocks",
       [](const EnergyAccount& a) { return a.strain; }},
      {"friction", "energy taken by friction", of<friction>},
      {"dashpots", "energy taken by dashpots", of<dashpots>},
      {"breaking", "energy taken by breaking", of<breaking>},
      {"hysteresis", "energy taken by hysteresis", of<hysteresis>},
      {"transfer", "energy lost in transfers of springs", of<transfer>},
      {"removed", "energy removed", of<removed>},
      {"artificial", "energy taken by artificial damping", of<artificial>},
      {"quiet", "energy through quiet sides", of<quiet>},
      {"cracks", "energy released by cracks", of<cracks>},
      {"integration", "error of the integration", of<integration>},
      {"residual", "residual of the energies",
       [](const EnergyAccount& a) { return a.residual(); }},
      {"at_play", "energy at play",
       [](const EnergyAccount& a) { return a.at_play(); }}};
  return all;
}

}  // namespace blocks::quantities
