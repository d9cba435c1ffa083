// The complete state of a run: settings, blocks, contacts, loads, time and steps. A
// checkpoint contains exactly this struct.
#pragma once

#include <string>
#include <vector>

#include "geometry/cut_counts.hpp"
#include "model/blocks.hpp"
#include "model/contacts.hpp"
#include "model/cracks.hpp"
#include "model/energy.hpp"
#include "model/kept_decisions.hpp"
#include "model/loads.hpp"
#include "model/safety_factor.hpp"
#include "model/settings.hpp"

namespace blocks {

/// The time step and the limit that determined it.
struct TimeStep {
  double dt = 0.0;       ///< [T] TDEL; 0 if not chosen yet
  int block = -1;        ///< block that determines it
  int blocks = 0;        ///< number of blocks when it was chosen; 0: to be chosen again
  bool elastic = false;  ///< deformability is the limit, not (4)
  bool pieces = false;   ///< of the pieces into which CRACK may split the block
};

/// State of the search for potential contacts.
struct SearchState {
  bool current = false;  ///< false: search before the next force evaluation (IUFLG)
  double left = 0.0;     ///< [L] distance corners may still move before the next search
  long updates = 0;      ///< number of searches (NUPDAT)

  /// Demands a new search, because blocks have been added, fixed or changed.
  void invalidate() { current = false; }
  /// Registers a new search whose result is valid until a corner has moved by
  /// `distance`, [L].
  void renew(double distance) { current = true, left = distance, ++updates; }
  /// Subtracts a motion of corners, [L], from the distance that is left.
  void spend(double distance) {
    left -= distance;
    if (left < 0.0)
      current = false, left = 0.0;
  }
};

/// A block that left the domain, and when.
struct DomainExit {
  int block = 0;
  double time = 0.0;  ///< [T]
};

/// One block absorbed by MERGE, for listing and summary. Block numbers count within the
/// layer before MERGE, from 1.
struct MergeRecord {
  int layer = 0, absorbed = 0, into = 0;
  double width_to_height = 0.0, limit = 0.0;
};

/// Result of cutting the layer of one LAYER card.
struct LayerRecord {
  int number = 0;                   ///< number of the LAYER card, from 1
  int first_block = 0, blocks = 0;  ///< first block, from 0, and number of blocks
  /// The counts of the tiling certificate.
  int cells = 0, interior_edges = 0, outline_edges = 0;
  int redrawn = 0, ruled = 0;  ///< redrawn angles, sides that use the ruling
  int redrawn_sides = 0;       ///< sides with a redrawn angle
};

/// Result of one CUT card (docs/joints.md).
struct CutRecord {
  int number = 0;                   ///< number of the CUT card, from 1
  int first_block = 0, blocks = 0;  ///< first block, from 0, and number of blocks
  /// The counts of the tiling certificate.
  int cells = 0, interior_edges = 0, outline_edges = 0;
  double area = 0.0;  ///< [L^2] of the outline
  geometry::CutCounts counts;
};

/// Length of the joints with one id in the domain of one CUT card, [L].
struct JointLengthRecord {
  int cut = 0;         ///< number of the CUT card, from 1
  int joint = 0;       ///< joint id
  double drawn = 0.0;  ///< before pruning
  double pruned = 0.0;
};

/// Result of one SOLVE card.
struct SolveRecord {
  int line = 0;          ///< line of the card in its deck, from 1
  double wanted = 0.0;   ///< ratio of the card
  double reached = 0.0;  ///< the ratio after the last step (equilibrium.hpp)
  long steps = 0;        ///< steps made
  double time = 0.0;     ///< [T] at the end
  bool converged = false;
  /// [F] largest unbalanced force at the end, and its block; -1: all are balanced
  double largest = 0.0;
  int block = -1;
  double wanted_local = 0.0;  ///< local ratio of the card
  double reached_local =
      0.0;               ///< the largest one after the last step (local_ratio.hpp)
  int local_block = -1;  ///< its block; -1: all are in equilibrium
  double dt = 0.0;       ///< [T] time step
  /// smallest and largest Blocks::scale of free blocks; 1 without MSCALE
  double min_scale = 1.0, largest_scale = 1.0;
};

/// The state of a run.
struct Model {
  Settings settings;
  Blocks blocks;
  std::vector<Contact> contacts;  ///< active contacts, ascending in sort_key
  /// (contacts) states of their laws; empty if the deck has no JOINT or INSITU card
  std::vector<LawState> law_states;
  /// Number of contacts that BOND has bonded, without bonds that REMOVE took away.
  long bonds_made = 0;
  std::vector<PlaneContact> plane_contacts;
  /// Fixed blocks that INSITU has put into its field, ascending. They had no contacts
  /// with each other, and get them when they are freed.
  std::vector<int> fixed_in_ground;
  Loads loads;
  std::vector<Drive> drives;  ///< ascending in block
  std::vector<Servo> servos;  ///< ascending in block; each has a drive
  TimeStep time_step;
  SearchState search;
  OutputClock output, plots;
  std::vector<double> plot_times;  ///< [T] further times of PLOTS, strictly ascending
  StepClock plot_steps;
  HistoryRequest history;
  std::vector<int> output_blocks;  ///< list of the OUTPUT card, from 0; empty: all
  /// Order in which the blocks are stepped: a permutation of all blocks that existed
  /// when the time step was chosen. If empty, blocks are stepped in the order of their
  /// numbers (model/numbering.hpp).
  std::vector<int> order;
  std::vector<DomainExit> exits;
  std::vector<MergeRecord> merges;
  std::vector<LayerRecord> layers;
  std::vector<CutRecord> cuts;
  std::vector<JointLengthRecord> joint_lengths;  ///< ascending in cut and joint
  long steps = 0;                                ///< MCYCLE, number of steps done
  double time = 0.0;         ///< [T] TIME = time_origin + (steps - step_origin) dt
  double time_origin = 0.0;  ///< [T] time at which the present dt was set
  long step_origin = 0;      ///< value of `steps` at that time
  bool started = false;      ///< a MOTION, CYCLE or SOLVE has run, so FRACTION is fixed
  double worst_overlap = 0.0;  ///< [L] largest of any active contact so far
  EnergyAccount energy;
  /// Only in checkpoints, and from there until the next step: the decisions about pairs
  /// that a motion goes on with.
  KeptDecisions kept;
  std::vector<SolveRecord> solves;
  std::vector<SafetyFactor> safety_factors;  ///< one for each FOS card
  std::vector<SafetyTrial> safety_trials;    ///< ascending in search, as made
  std::vector<CrackRecord> cracks;           ///< in the order in which blocks split
  std::vector<RefusedCrack> crack_refusals;  ///< ascending in block and reason
  /// [F L] kinetic energy before the last step; 0 if that stopped the blocks; only with
  /// KINDAMP
  double last_kinetic_energy = 0.0;
};

/// Sums over the model, in [F L], [M L/T], [M L^2/T] and [L].
struct ModelTotals {
  double kinetic_energy = 0.0;
  Vec2 momentum = Vec2::Zero();
  double angular_momentum = 0.0;  ///< about the origin
  int active_contacts = 0;        ///< corner-edge and corner-plane contacts
  int listed_contacts = 0;        ///< also counts inactive corners near planes
  double worst_overlap = 0.0;
  double fastest = 0.0;  ///< largest speed of a centroid, [L/T]
  // Contacts with the law of a joint.
  int with_law = 0;
  int bonded = 0;   ///< they act in tension too
  int failed = 0;   ///< they have the residual strengths; some may be bonded
  long broken = 0;  ///< bonds that BOND made and that have failed since
};
ModelTotals totals(const Model& model);

}  // namespace blocks
