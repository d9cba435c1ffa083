// The C++ interface of BLOCKS (docs/library.md). Cards define the model; member
// functions advance it step by step and query it. This header depends only on Eigen and
// the standard library.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace blocks {

namespace library {
class ModelAccess;
}

/// An error or a warning about cards.
struct DeckMessage {
  bool is_error = true;
  std::string file;           ///< name of the deck
  int line = 0, column = 0;   ///< from 1; line 0: the deck as a whole
  std::string card;           ///< in capitals; empty: none
  std::string message, hint;  ///< the hint may be empty
  std::string printed;        ///< with the line of the deck and a caret
};

/// Thrown when cards contain errors. what() holds every message in the format of
/// `blocks check`: file:line:col: error: CARD: message, followed by the source line, a
/// caret and a hint.
class DeckError : public std::runtime_error {
 public:
  DeckError(const std::string& what, std::vector<DeckMessage> messages)
      : std::runtime_error(what), messages_(std::move(messages)) {}
  /// All errors and warnings, in the order of the lines of the deck.
  const std::vector<DeckMessage>& messages() const { return messages_; }

 private:
  std::vector<DeckMessage> messages_;
};

/// Thrown when a step made the state unusable, most often because the time step is too
/// large. Lower FRACTION or raise STIFF. The causes
/// (docs/theory.md#the-force-in-its-order):
/// - A position is no longer a number, or too large to compute with.
/// - The spring of a contact is compressed by more than half the distance from its edge
///   to the middle of a block.
/// - A corner moved in one step by more than ctol and by more than half the distance
///   from an edge to the middle of the shallowest block.
///
/// The Simulation can still be queried, and write_frame() still works. Every later call
/// of step, cards, set_velocity or write_checkpoint throws UnsoundRun again.
class UnsoundRun : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The force of one corner on one edge in the last step. Blocks and corners are
/// numbered from 1, as on the cards. An edge has the number of its first corner.
struct ContactForce {
  int corner_block = 0;  ///< the block that the corner belongs to
  int corner = 0;        ///< number of the corner in its block
  int edge_block = 0;    ///< the block that the edge belongs to; 0 for a symmetry plane
  int edge = 0;          ///< number of the edge, or of the symmetry plane
  Eigen::Vector2d point = {0, 0};   ///< [L] position of the corner after the step
  Eigen::Vector2d normal = {0, 0};  ///< unit outward normal of the edge
  double normal_force = 0.0;        ///< [F] dashpot included, >= 0: no tension (16)
  double shear_force = 0.0;         ///< [F] dashpot included; limited by friction
  double overlap = 0.0;             ///< [L] >= 0 (19)

  /// The force on the corner's block, [F]. The edge's block receives the opposite
  /// force.
  Eigen::Vector2d force() const {
    return normal_force * normal -
           shear_force * Eigen::Vector2d(normal.y(), -normal.x());
  }
};

/// What to do with the MOTION, CYCLE and SOLVE cards of a deck.
enum class Motions {
  made,     ///< make their steps
  left_out  ///< execute the deck only up to the first of them
};

/// A model that the calling program advances. The same cards give bit-identical results
/// in `blocks run`. The only files written are those requested through this class;
/// OUTPUT, PLOTS, HISTORY and DUMP have no effect.
///
/// Dimensions are [L], [M], [T] and [F] per unit thickness, in any consistent units.
/// Anticlockwise rotation and tension are positive. Functions that take a block number
/// throw std::out_of_range if there is no such block.
class Simulation {
 public:
  /// Executes the cards of a deck in order: START to END, then blocks and loads.
  /// MOTION, CYCLE and SOLVE advance the time, unless they are left out. The number of
  /// threads is 1 to 1024 and does not affect the results. File names on cards are
  /// relative to the current directory.
  ///
  /// Throws DeckError for errors in the cards, and std::runtime_error if a file (READ9,
  /// RESTART) cannot be read. Throws std::invalid_argument if `threads` is out of range
  /// or BLOCKS_SIMD names an instruction set that the machine lacks. Throws UnsoundRun
  /// from one of these cards.
  explicit Simulation(const std::string& deck, int threads = 1,
                      Motions motions = Motions::made);

  /// Like the constructor, but reads the deck from a file. File names on its cards are
  /// relative to the folder of the deck.
  static Simulation from_file(const std::string& path, int threads = 1,
                              Motions motions = Motions::made);

  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// Executes further problem cards, one per line: "SETVEL, 3, 0, 1.5\nFRICTN, 0.4". If
  /// they contain errors, it throws DeckError and leaves the model unchanged, unless a
  /// MOTION, CYCLE or SOLVE among them has already advanced the time.
  void cards(const std::string& text);

  /// All warnings so far, in printed form. Cards give warnings such as overlapping
  /// blocks or a large FRACTION. Steps give a warning for each block that left the
  /// domain, where it is then fixed. They also warn once that a corner moved by more
  /// than ctol in one step. A SOLVE card that has not converged gives a warning.
  const std::vector<std::string>& warnings() const;

  /// Makes `count` steps of time_step(). The contacts of the last one are known only if
  /// it is read, which may take as long as the step. Throws UnsoundRun,
  /// std::logic_error if there are no blocks, and std::invalid_argument if `count` is
  /// negative.
  void step(long count = 1, bool read = true);
  /// Whether the contacts of the last step are known. Before the first step there are
  /// none.
  bool is_read() const;

  long steps() const;        ///< number of steps made so far
  double time() const;       ///< [T] current time
  double time_step() const;  ///< [T] of the next step (4); 0 without blocks

  int blocks() const;  ///< number of blocks, numbered from 1 in order of creation
  int material(int block) const;  ///< number of its MATERIAL card
  bool is_free(int block) const;  ///< false if fixed, outside the domain or removed
  double area(int block) const;   ///< [L^2] area when it was created
  double mass(int block) const;   ///< [M]
  Eigen::Matrix2Xd corners(int block) const;  ///< [L] shape (2, corners), clockwise
  Eigen::Vector2d centroid(int block) const;  ///< [L]
  Eigen::Vector2d velocity(int block) const;  ///< [L/T] velocity of the centroid
  double angle(int block) const;              ///< [rad] rotation since it was created
  double spin(int block) const;               ///< [rad/T] angular velocity
  Eigen::Vector2d force(int block) const;     ///< [F] in the last step, without gravity
  double moment(int block) const;             ///< [F L] in the last step
  Eigen::Matrix2d stress(int block) const;    ///< [F/L^2] internal stress (12)

  /// The contacts that acted in the last step, ordered by pair of blocks. Contacts with
  /// symmetry planes come last. Throws std::logic_error if that step was not read.
  std::vector<ContactForce> contacts() const;

  /// The sum of the contact forces on a block in the last step, [F]. Throws
  /// std::logic_error if that step was not read.
  Eigen::Vector2d contact_force(int block) const;

  double kinetic_energy() const;  ///< [F L]
  double worst_overlap() const;   ///< [L] largest overlap of any contact so far
  /// The ratio of the unbalanced forces in the last step: 0 in equilibrium, 1 if all
  /// blocks fall freely. It means nothing before the first step.
  double unbalanced_ratio() const;

  /// Sets the velocity [L/T] and spin [rad/T] of a free block. Forces change them from
  /// the next step on.
  ///
  /// Throws std::logic_error if the block is fixed, std::invalid_argument if a value is
  /// not finite, and UnsoundRun if a step has thrown it.
  void set_velocity(int block, const Eigen::Vector2d& velocity, double spin = 0.0);

  /// Sets the force [F] that acts at the centroid of a block in every step from now on,
  /// in addition to the loads of the cards. It replaces the force that this function
  /// has set before; 0 ends it. Throws std::invalid_argument if a value is not finite.
  void set_force(int block, const Eigen::Vector2d& force);

  /// Appends the state as a frame to the results file `path` (.vtkhdf), which `blocks
  /// plot`, ParaView and h5py can read. The first call with a path creates the file and
  /// renames an existing one to `path`.bak, `path`.bak2, ... If the state is already
  /// the last frame, nothing is written. After cards() or set_velocity() there may be
  /// two frames with the same time.
  ///
  /// Throws std::runtime_error if the file cannot be written, is a folder, device or
  /// FIFO, or is in use by another Simulation of this program.
  void write_frame(const std::string& path);

  /// Writes the state as a checkpoint for RESTART, here or in `blocks run`. The first
  /// call with a path renames existing files with the names `path` and `path`.prev to
  /// .bak, .bak2, ... Later calls keep the previous checkpoint as `path`.prev. Throws
  /// std::runtime_error if the file cannot be written or is a folder, device or FIFO.
  /// Throws UnsoundRun if a step has thrown it.
  void write_checkpoint(const std::string& path) const;

 private:
  friend class library::ModelAccess;
  struct State;
  explicit Simulation(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace blocks
