// BLOCKS from C++ (docs/library.md): cards make the model, calls drive it step by step
// and read it. This header stands alone: Eigen and the standard library.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace blocks {

/// Cards that cannot be obeyed. what() holds every message as `blocks check` prints it:
/// file:line:col: error: CARD: message, the line, a caret, a hint.
class DeckError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Some position is no longer a number, a contact is pressed in by more than half of
/// what a block is deep, or a block has moved by more than that and ctol in one step:
/// lower FRACTION, or raise STIFF. From then on the Simulation can be read and its
/// state written as a frame; whatever would go on from that state (step, cards,
/// set_velocity, write_checkpoint) throws UnsoundRun again.
class UnsoundRun : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A corner that pressed on an edge in the last step. Blocks and corners count from 1
/// as on the cards; an edge is named by its first corner.
struct ContactForce {
  int corner_block = 0;  ///< block whose corner presses
  int corner = 0;        ///< that corner
  int edge_block = 0;    ///< block of the edge; 0: the edge is a symmetry plane
  int edge = 0;          ///< the edge, or the number of the plane
  Eigen::Vector2d point = {0, 0};   ///< [L] the corner, where the step left it
  Eigen::Vector2d normal = {0, 0};  ///< unit vector out of the edge's block
  double normal_force = 0.0;        ///< [F] with the dashpot, >= 0: no tension (16)
  double shear_force = 0.0;         ///< [F] with the dashpot, at most friction times it
  double overlap = 0.0;             ///< [L] >= 0 (19)

  /// [F] on the corner's block; the edge's block feels the opposite.
  Eigen::Vector2d force() const {
    return normal_force * normal -
           shear_force * Eigen::Vector2d(normal.y(), -normal.x());
  }
};

/// A model that is stepped from outside the command line. Same cards, same bits as
/// `blocks run`; no file is written but those asked for here (OUTPUT, PLOTS and DUMP
/// say nothing). Dimensions [L], [M], [T], [F] per unit thickness, any consistent
/// units; rotation anticlockwise positive, tension positive. Functions with a block
/// number throw std::out_of_range where there is no such block.
class Simulation {
 public:
  /// The cards of a deck act in order: START ... END, blocks, loads; MOTION and CYCLE
  /// make time pass. threads: 1 to 1024; results do not depend on it. File names on
  /// cards are relative to the present folder. Throws DeckError; std::runtime_error for
  /// a file (READ9, RESTART) that cannot be read; std::invalid_argument for another
  /// number of threads, or a BLOCKS_SIMD that the machine does not have.
  explicit Simulation(const std::string& deck, int threads = 1);

  /// The same for the deck in a file; names on its cards are relative to its folder.
  static Simulation from_file(const std::string& path, int threads = 1);

  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// Further problem cards, a line each: "SETVEL, 3, 0, 1.5\nFRICTN, 0.4". After a
  /// DeckError of theirs the model is as it was, unless time passed among them.
  void cards(const std::string& text);

  /// What the cards were warned of, as printed: overlaps, a large FRACTION ...; and
  /// the steps, once: blocks that left the domain and are fixed there, a corner that
  /// moved by more than ctol in one step.
  const std::vector<std::string>& warnings() const;

  /// Makes `count` >= 0 steps of time_step(). Throws UnsoundRun; std::logic_error where
  /// there are no blocks.
  void step(long count = 1);

  long steps() const;        ///< made so far
  double time() const;       ///< [T]
  double time_step() const;  ///< [T] of the next step (4); 0 without blocks

  int blocks() const;  ///< how many; they are 1 ... blocks(), in order of creation
  int material(int block) const;              ///< number on its MATERIAL card
  bool is_free(int block) const;              ///< false: fixed, by the deck or outside
  double area(int block) const;               ///< [L^2] when it was made
  double mass(int block) const;               ///< [M]
  Eigen::Matrix2Xd corners(int block) const;  ///< [L] (2, corners) clockwise
  Eigen::Vector2d centroid(int block) const;  ///< [L]
  Eigen::Vector2d velocity(int block) const;  ///< [L/T] of the centroid
  double angle(int block) const;              ///< rad turned since it was made
  double spin(int block) const;               ///< rad/T
  Eigen::Vector2d force(int block) const;     ///< [F] of the last step, without gravity
  double moment(int block) const;             ///< [F L] of the last step
  Eigen::Matrix2d stress(int block) const;    ///< [F/L^2] internal (12)

  /// The contacts that acted in the last step, by pair of blocks, then symmetry planes.
  std::vector<ContactForce> contacts() const;

  /// [F] sum of the contact forces on a block in the last step.
  Eigen::Vector2d contact_force(int block) const;

  double kinetic_energy() const;  ///< [F L]
  double worst_overlap() const;   ///< [L] of any contact in any step so far

  /// Sets the velocity [L/T] and spin [rad/T] of a free block from now on; the next
  /// step adds what forces do to it. A force F through one step is
  /// velocity + time_step() / mass * F. Throws std::logic_error for a fixed block.
  void set_velocity(int block, const Eigen::Vector2d& velocity, double spin = 0.0);

  /// Appends the state as a frame to the results `path` (.vtkhdf), for `blocks plot`,
  /// ParaView and h5py. The first call with a path begins the file; an existing one is
  /// kept as `path`.bak. A state that already is the last frame is not written again;
  /// after cards() or set_velocity() there may be two frames of one time. Throws
  /// std::runtime_error: the file cannot be written, is a folder, device or fifo, or
  /// belongs to another Simulation of this program that still lives.
  void write_frame(const std::string& path);

  /// Writes the state for RESTART, here or by `blocks run`; an existing one is kept as
  /// `path`.prev. Throws std::runtime_error: it cannot be written, or is a folder,
  /// device or fifo; UnsoundRun where a step did.
  void write_checkpoint(const std::string& path) const;

 private:
  struct State;
  explicit Simulation(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace blocks
