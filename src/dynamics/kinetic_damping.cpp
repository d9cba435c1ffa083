#include "dynamics/kinetic_damping.hpp"

#include "dynamics/energy/block_energy.hpp"

namespace blocks::dynamics {

bool stop_at_peak(Model& model, Workers& workers, std::vector<BlockTally>& tallies) {
  Blocks& blocks = model.blocks;
  const bool rigid = model.settings.rigid;
  const auto visit = [&](int b, BlockTally& tally) {
    tally.kinetic += kinetic_energy(blocks, b, rigid);
  };
  const double energy = tally_all(blocks.size(), tallies, workers, visit).kinetic;
  const bool has_peaked = energy < model.last_kinetic_energy;
  model.last_kinetic_energy = has_peaked ? 0.0 : energy;
  if (!has_peaked)
    return false;
  for (int b = 0; b < blocks.size(); ++b)
    if (blocks.is_free(b)) {
      blocks.velocity.col(b).setZero();
      blocks.spin[b] = 0.0;
      blocks.strain_rate.col(b).setZero();
    }
  return true;
}

}  // namespace blocks::dynamics
