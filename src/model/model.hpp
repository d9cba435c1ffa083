// Everything a run knows: settings, blocks, contacts, loads and where time stands.
// A checkpoint is exactly this struct, written out.
#pragma once

#include <string>
#include <vector>

#include "model/blocks.hpp"
#include "model/contacts.hpp"
#include "model/loads.hpp"
#include "model/settings.hpp"

namespace blocks {

/// Which limit set the time step.
struct TimeStep {
  double dt = 0.0;       ///< [T] TDEL; 0: not chosen yet
  int block = -1;        ///< the block that set it
  int blocks = 0;        ///< how many blocks there were when it was chosen
  bool elastic = false;  ///< limited by deformability, not by contacts (4)
};

/// State of the search for potential contacts.
struct SearchState {
  bool current = false;  ///< false: search before the next force evaluation (IUFLG)
  double left = 0.0;     ///< [L] how far corners may still move before the next search
  long updates = 0;      ///< number of searches (NUPDAT)

  /// Blocks have been added, fixed or changed.
  void invalidate() { current = false; }
  /// Begins a search that holds until a corner has moved by `distance`, [L].
  void renew(double distance) { current = true, left = distance, ++updates; }
  /// Takes a motion of corners, [L], off the distance that is left.
  void spend(double distance) {
    left -= distance;
    if (left < 0.0)
      current = false, left = 0.0;
  }
};

struct DomainExit {
  int block = 0;
  double time = 0.0;
};

/// One block absorbed under MERGE, for listing and summary. Blocks count within the
/// layer before MERGE, from 1.
struct MergeRecord {
  int layer = 0, absorbed = 0, into = 0;
  double width_to_height = 0.0, limit = 0.0;

  /// "0.125 < 0.2", with digits enough to tell the two apart. A width/height equal to
  /// the limit is kept; one that is below it by less than doubles hold says so.
  std::string why() const;
};

/// How each LAYER card turned out.
struct LayerRecord {
  int number = 0;                   ///< of the LAYER card, from 1
  int first_block = 0, blocks = 0;  ///< first block (from 0) and how many
  int cells = 0, interior_edges = 0, outline_edges = 0;  ///< certificate counts
  int redrawn = 0, ruled = 0;  ///< angles drawn again, sides that took the ruling
  int redrawn_sides = 0;       ///< sides with an angle drawn again
};

struct Model {
  Settings settings;
  Blocks blocks;
  std::vector<Contact> contacts;  ///< those that act, ascending in sort_key
  PlaneContacts plane_contacts;
  Loads loads;
  TimeStep time_step;
  SearchState search;
  OutputClock output, plots;
  std::vector<int> output_blocks;  ///< OUTPUT's list, from 0; empty: all
  /// Blocks in the order in which they are stepped, all that there were when the time
  /// step was chosen; empty: that of their numbers (model/numbering.hpp).
  std::vector<int> order;
  std::vector<DomainExit> exits;
  std::vector<MergeRecord> merges;
  std::vector<LayerRecord> layers;
  long steps = 0;              ///< MCYCLE, steps done
  double time = 0.0;           ///< [T] TIME = time_origin + (steps - step_origin) dt
  double time_origin = 0.0;    ///< [T] when the present dt came into force
  long step_origin = 0;        ///< likewise in steps
  bool started = false;        ///< a MOTION or CYCLE has run: FRACTION is fixed
  double worst_overlap = 0.0;  ///< [L] of any acting contact in any step so far
};

/// Sums over the model. [F L], [M L/T], [M L^2/T], [L].
struct ModelTotals {
  double kinetic_energy = 0.0;
  Vec2 momentum = Vec2::Zero();
  double angular_momentum = 0.0;  ///< about the origin
  int active_contacts = 0;        ///< corner-edge and corner-plane
  int listed_contacts = 0;        ///< and corners near planes that do not act
  double worst_overlap = 0.0;
  double fastest = 0.0;  ///< largest speed of a centroid, [L/T]
};
ModelTotals totals(const Model& model);

}  // namespace blocks
