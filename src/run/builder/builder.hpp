// Turns the cards of a deck into a model. It executes every card except those that
// advance the time (MOTION, CYCLE) or write files (DUMP). It depends on deck and model,
// not on the time loop.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "deck/commands.hpp"
#include "deck/diagnostics.hpp"
#include "model/model.hpp"
#include "model/selection.hpp"
#include "run/builder/builder_state.hpp"

namespace blocks::run {

/// Sides that a card names, and the line on which a selector has found them.
struct SelectedSides {
  std::vector<BlockSide> sides;
  std::optional<Plane> line = {};
};

class Builder : public BuilderState {
 public:
  /// `cards` is the whole deck, because outlines of different cards share corners.
  Builder(Model& model, deck::Diagnostics& diagnostics,
          const std::vector<deck::Command>& cards, BuildOptions options);
  /// Goes on where another builder had this state, with a copy of its model.
  Builder(Model& model, deck::Diagnostics& diagnostics, BuilderState state)
      : BuilderState(std::move(state)), model_(model), diagnostics_(diagnostics) {}

  /// Executes the next card of the deck. Errors go to the diagnostics, and the model is
  /// then unchanged.
  void apply(const deck::Command& command);

  /// Checks what must hold before MOTION and CYCLE. There must be blocks; no symmetry
  /// plane may have all blocks behind it; the time step must allow the motion.
  /// Overlapping blocks cause a warning. `in_place` means that no MOTION, CYCLE or
  /// SOLVE lies between, so the blocks are where they will be at that moment.
  void check_before_motion(const deck::Command& command, bool in_place);

  /// After errors of cards, checks before the first motion what does not depend on
  /// these: the planes and the time step, if no card that makes blocks has failed.
  void check_despite_errors(const deck::Command& command);

  /// Tests the rules of plausibility about the blocks before a motion. The blocks are
  /// taken where the deck puts them, so the run need not repeat this.
  void check_plausibility(const deck::Command& motion);
  /// Tests the rules of plausibility about the whole deck, when all cards are read. A
  /// model that a program drives needs no MOTION.
  void check_deck(std::span<const deck::Command> cards, bool driven);

  /// Continues a resumed run at cards[next]. The cards before it made the model.
  /// `overlaps` are the overlaps reported so far.
  void go_on(const std::vector<deck::Command>& cards, std::size_t next,
             const std::vector<geometry::BlockOverlap>& overlaps);

  /// The same checks of blocks and planes at the end of a deck, when no more time
  /// passes.
  void check_without_motion(const deck::Command& last);

  /// Checks the blocks named by OUTPUT and HISTORY, which may be made after these
  /// cards. Call it when all cards are read.
  void check_output_blocks();

 private:
  struct Visitor;
  /// Takes in the blocks that have split off since the last card. They are not checked
  /// as blocks that a card has made.
  void take_in_pieces();
  /// How many blocks are missing at most above this line, because their cards failed.
  long max_missing(int line) const;
  /// Counts the blocks of faulty CREATE cards above this line that were not read, and
  /// the blocks whose numbers are sure.
  void count_blocks(int line);
  /// The number of the last block here, if no other card than CREATE has failed.
  long last_number() const { return model_.blocks.size() + missing_.count(); }
  /// Returns "block 3 is" or "blocks 3 to 5 are".
  std::string blocks_are(const std::vector<int>& blocks) const;
  void error_no_block(const deck::Command& command, const deck::Int& number);
  /// Whether a block with this number, from 1, may be a piece when the deck runs, and
  /// not the block that a card makes.
  bool is_unsure(long number) const {
    return sure_blocks_ && number > *sure_blocks_ && number <= last_number();
  }
  void error_unsure(const deck::Command& command, const deck::Int& number);
  /// Returns the index of the block with this number, counted from 0. Reports an error
  /// and returns -1 if there is none. Returns -1 without an error for a block that a
  /// faulty card did not make, and for one whose number is not sure for that reason.
  int block(const deck::Command& command, const deck::Int& number);
  /// Returns the index like block(). Also returns -1 for a removed block, with a
  /// warning that the card has no effect.
  int block_to_change(const deck::Command& command, const deck::Int& number);
  /// Returns the hint of a warning that the card finds no blocks.
  static std::string place_hint(const deck::Command& command);
  /// Returns the blocks of a range, or nothing after an error; nb2 is 0 for the first
  /// block alone and negative for all blocks so far.
  std::vector<int> blocks_in_range(const deck::Command& command, const deck::Int& nb1,
                                   const deck::Int& nb2);
  /// Returns the blocks of a material. Returns nothing after an error, or if there are
  /// none, with a warning.
  std::vector<int> blocks_of_material(const deck::Command& command,
                                      const deck::Int& material);
  /// Deletes the removed blocks from the list. Warns that the card has no effect if no
  /// others are in it.
  void leave_out_removed(const deck::Command& command, deck::SourceLocation where,
                         std::vector<int>& chosen);
  /// `given` is the number or name of the material as the card has it.
  void error_no_material(const deck::Command& command, deck::SourceLocation where,
                         const std::string& given);
  /// Returns whether the material is defined. Reports an error if not.
  bool has_material(const deck::Command& command, const deck::Int& number);

  // Selectors, in selectors.cpp. What is removed is never selected.
  /// Whether the block is removed, or may be removed before the run gets here.
  bool is_gone(int b) const;
  /// Returns the blocks of a selector. Reports an error if there are none.
  std::vector<int> select(const deck::Command& command, deck::SourceLocation where,
                          const deck::Selector& selector);
  /// Returns the blocks that a field names, and records the choice of a selector.
  /// Returns nothing after an error or a warning.
  std::vector<int> blocks_named(const deck::Command& command,
                                const deck::NumberOrSelector& named);
  /// Returns the block that a field names. Returns -1 after an error, which several
  /// blocks are too, or a warning.
  int block_named(const deck::Command& command, const deck::NumberOrSelector& named);
  /// Returns the sides that the fields for a block and a side name, and records the
  /// choice of a selector. Returns nothing after an error or a warning.
  SelectedSides sides_named(const deck::Command& command,
                            const deck::NumberOrSelector& block,
                            const deck::NumberOrSelector& side);
  /// Returns the sides of a selector, or nothing after an error.
  std::optional<SelectedSides> select_sides(const deck::Command& command,
                                            deck::SourceLocation where,
                                            const deck::Selector& selector);
  /// Returns the number of the material of a selector; 0 after an error.
  int material_of(const deck::Command& command, deck::SourceLocation where,
                  const deck::Selector& selector);
  std::vector<int> output_blocks(const deck::Command& command,
                                 const deck::Output& card);
  /// Returns a HISTORY card whose selectors are replaced by numbers.
  deck::Command with_numbers(const deck::Command& command);
  /// Returns the place of a quantity with numbers; empty after an error.
  std::string place_of(const deck::Command& command, deck::SourceLocation where,
                       const deck::Selector& selector);
  void error_nothing(const deck::Command& command, deck::SourceLocation where,
                     const deck::Selector& selector, std::string hint);
  void error_several(const deck::Command& command, const deck::NumberOrSelector& named,
                     const std::string& how_many);
  std::string nearest_hint(const Vec2& point) const;
  std::string time_of_note() const;
  void note_selected(const deck::Command& command, const deck::Selector& selector,
                     const std::string& what, const std::vector<int>& chosen);
  void note_selected_sides(const deck::Command& command, const deck::Selector& selector,
                           const std::vector<BlockSide>& sides);

  // Excavation, in excavation.cpp
  void remove(const deck::Command& command, const deck::Selection& named);
  void free(const deck::Command& command, const deck::Selection& named);
  /// Returns the blocks that the card names, removed ones included. Returns nothing
  /// after an error, or if there are none, with a warning.
  std::vector<int> chosen_by(const deck::Command& command,
                             const deck::Selection& named);
  std::vector<int> select_inside(const deck::Command& command,
                                 const deck::Selection& named);
  /// Records what the card did, for the listing and the report of `check`.
  void note(const deck::Command& command, const char* done,
            const std::vector<int>& chosen);

  // Laws of joints and driven blocks, in laws.cpp
  void define_joint(const deck::Command& command, const deck::Joint& card);
  void define_walton(const deck::Command& command, const deck::Walton& card);
  void define_barton(const deck::Command& command, const deck::Barton& card);
  void pair_materials(const deck::Command& command, const deck::Jpair& card);
  void bond(const deck::Command& command, const deck::Bond& card);
  void drive(const deck::Command& command, const deck::Drive& card);
  /// Returns whether DRIVE or SERVO can act on the block: it is fixed and inside the
  /// domain. Otherwise reports an error or a warning.
  bool can_drive(const deck::Command& command, int b,
                 const deck::NumberOrSelector& named);
  /// Whether a MOTION, CYCLE or SOLVE lies before the present card.
  bool has_moved() const { return section_ > 0 || model_.steps > 0; }
  /// Returns the law of this joint id. Reports an error and returns null if no JOINT
  /// card defines it.
  JointLaw* law(const deck::Command& command, const deck::Int& id);
  /// Returns the law that WALTON or BARTON extends, or null after an error.
  JointLaw* law_to_extend(const deck::Command& command, const deck::Int& id);
  /// Demands a new time step if one of the laws has a stiffness of its own.
  void law_changed(const JointLaw& before, const JointLaw& after);

  // Loads, in loads.cpp
  void press(const deck::Command& command, const deck::PressBc& card);
  void push(const deck::Command& command, const deck::Force& card);
  /// Returns whether there is a FUNCTION card. Reports an error if not.
  bool has_function(const deck::Command& command);
  /// Returns the side of block b with this number, from 0. Returns -1 after an error.
  int side(const deck::Command& command, int b, const deck::Int& number);
  /// Returns whether block b is inside the domain, where blocks move. Otherwise reports
  /// an error, or a warning if the block has left it.
  bool can_move(const deck::Command& command, int b, deck::SourceLocation where);

  // Water, in water.cpp
  void set_water(const deck::Command& command, const deck::Water& card);
  /// Adds the points of the card to a table, in the order of their places. Returns
  /// false after an error.
  bool read_points(const deck::Command& command, const deck::Water& card,
                   WaterTable& table);
  /// Warns if gravity has another direction than the depth below a water table.
  void check_direction_of_water(const deck::Command& command);
  /// Warns if the table presses on nothing, or acts before the weight of blocks does.
  void check_water(const deck::Command& command, const deck::Water& card);
  void set_joint_water(const deck::Command& command, const deck::Jwater& card);

  // Rest and waves, in rest.cpp and quiet.cpp
  void load_in_situ(const deck::Command& command, const deck::Insitu& card);
  /// Warns if INSITU came before a plane on which sides lie.
  void check_plane_in_ground(const deck::Command& command, const Plane& plane);
  void servo(const deck::Command& command, const deck::Servo& card);
  void make_quiet(const deck::Command& command, const deck::Quiet& card);
  void make_quiet(const deck::Command& command, const deck::Quiet& card,
                  const BlockSide& side);
  /// Puts the wave speeds of the card or of the block's material into `quiet`. Returns
  /// false if they cannot be known.
  bool find_speeds(const deck::Command& command, const deck::Quiet& card,
                   QuietSide& quiet);
  /// Warns if the dashpots of the block's quiet sides are too strong for the time step.
  void warn_of_dashpots(const deck::Command& command, int b);

  // Cracks, in cracks.cpp
  void let_crack(const deck::Command& command, const deck::Crack& card);
  void damp_material(const deck::Command& command, const deck::Mdamp& card);
  /// Warns of CRACK cards by which no block can split, once for each card.
  void check_cracks();

  Plan plan(std::span<const deck::Command> cards) const;
  void check_planes();
  void check_memory(const deck::Command& command);
  void check_overlaps(const deck::Command& command);
  /// Warns at the card that made the second block. `hint` goes before the usual hint.
  void warn_of_overlap(const geometry::BlockOverlap& pair, const deck::Command& motion,
                       std::string hint);
  void check_fraction(const deck::Command& command);
  /// Warns at a SOLVE card if nothing damps the motion.
  void check_damping(const deck::Command& solve);
  /// Reports a FOS card before which no SOLVE or INSITU has balanced the forces.
  void check_equilibrium(const deck::Command& fos);
  void check_steps(const deck::Command& command);
  void check_history_blocks(const deck::Command& command);
  /// The number of corners of the block with this number; the largest number of all if
  /// a faulty card hides it.
  int corners_of(long number) const;
  void check_history_interval(const deck::Command& motion);

  Model& model_;
  deck::Diagnostics& diagnostics_;
};

}  // namespace blocks::run
