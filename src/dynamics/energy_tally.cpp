#include "dynamics/energy_tally.hpp"

namespace blocks::dynamics {

void BlockTally::include(const BlockTally& other) {
  gravity += other.gravity;
  water += other.water;
  drives += other.drives;
  artificial += other.artificial;
  kinetic += other.kinetic;
  next_kinetic += other.next_kinetic;
  error += other.error;
  next_strain += other.next_strain;
  strain_work += other.strain_work;
}

}  // namespace blocks::dynamics
