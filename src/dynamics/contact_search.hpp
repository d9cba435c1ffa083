// Finds the corners that are close enough to an edge (UPDAT, report 3.2, rule 13).
#pragma once

#include <array>
#include <vector>

#include "dynamics/box_grid.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// Buffers of the search, kept between searches.
struct SearchBuffers {
  struct Record {
    int low, high;     ///< pair of blocks, lower number first
    int corner, edge;  ///< corner, first corner of the edge
    auto operator<=>(const Record&) const = default;
  };
  BoxGrid grid;
  std::vector<Record> found;
  Contacts next;
  PlaneContacts next_planes;
};

/// Brings the list of potential contacts up to date and sets the travel back to zero.
/// Listed: every corner within 2 CTOL of an edge of another block, at least one of the
/// two free, and every contact that acts. Records keep their elastic forces.
void update_contacts(Model& model, SearchBuffers& buffers);

/// Sets the dashpot constant C of (18) of every record: damping 2 sqrt(Kn m1 m2/(m1 +
/// m2)), a fixed block having infinite mass (rule 8).
void set_contact_damping(Model& model);

/// C of (18) of a corner against a plane or a fixed block: 2 b sqrt(m Kn).
double damping_against_fixed(const Settings& settings, double mass);

}  // namespace blocks::dynamics
