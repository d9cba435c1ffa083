// Turns the cards of a deck into a model: every card but those that make time pass
// (MOTION, CYCLE) or write files (DUMP). Knows the deck and the model, no dynamics.
#pragma once

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "deck/commands.hpp"
#include "deck/diagnostics.hpp"
#include "geometry/shared_corners.hpp"
#include "model/assembly_certificate.hpp"
#include "model/model.hpp"

namespace blocks::run {

struct BuildOptions {
  std::optional<std::uint64_t> seed;  ///< --seed, wins over SEED
  std::string tape9 = "tape9";        ///< --tape9: mesh of a READ9 card without a name
  std::string folder;                 ///< of the deck: file names are relative to it
  /// Cards that could not be read, "" for a card of unknown name: no complaints about
  /// blocks, materials or functions that may only be missing for that reason.
  std::set<std::string> unread;
  /// Overlaps that the certificate named before the checkpoint of a RESTART deck.
  std::vector<geometry::BlockOverlap> overlaps = {};

  bool lacks(std::initializer_list<const char*> cards) const {
    return unread.contains("") ||
           std::any_of(cards.begin(), cards.end(),
                       [&](const char* card) { return unread.contains(card); });
  }
};

/// BuildOptions::unread of a deck with these diagnostics.
std::set<std::string> unread_cards(const deck::Diagnostics& diagnostics);

class Builder {
 public:
  /// cards: the whole deck, whose outlines share corners.
  Builder(Model& model, deck::Diagnostics& diagnostics,
          const std::vector<deck::Command>& cards, BuildOptions options);

  /// Acts on one card, the next of the deck. Faults go to the diagnostics; the model
  /// then stays as it was.
  void apply(const deck::Command& command);

  /// What must hold before time may pass: blocks present and without overlap, planes
  /// not in front of nothing, a time step that can do it. Called before MOTION and
  /// CYCLE. in_place: blocks stand where they will be then; no MOTION lies between.
  void check_before_motion(const deck::Command& command, bool in_place);

  /// Instead of it before the first MOTION or CYCLE, when another builder has checked
  /// the same cards. certificate: what that one found.
  void begin_to_move(SharedCertificate certificate);

  /// The next card is cards[next]: those before it made the model, whose blocks overlap
  /// as told.
  void go_on(const std::vector<deck::Command>& cards, std::size_t next,
             const std::vector<geometry::BlockOverlap>& overlaps);

  /// The same of the blocks, for a deck in which no (more) time passes.
  void check_without_motion(const deck::Command& last);

  /// Blocks named by OUTPUT, which may be made after it. Called when all cards are
  /// read.
  void check_output_blocks();

  /// What was found in the mesh files and of shared corners, a line each, since the
  /// last call.
  std::vector<std::string> take_notes() { return std::exchange(notes_, {}); }

  /// What the blocks proved to be when the latest were made; nothing before time
  /// passes.
  const SharedCertificate& certificate() const { return certificate_; }

 private:
  struct Visitor;
  void error_no_block(const deck::Command& command, const deck::Int& number);
  void check_planes();
  void check_room(const deck::Command& command);
  void check_overlaps(const deck::Command& command);
  void check_fraction(const deck::Command& command);
  void check_steps(const deck::Command& command);

  Model& model_;
  deck::Diagnostics& diagnostics_;
  BuildOptions options_;
  std::vector<geometry::SharedCorners> corners_;  ///< for each stretch of the deck
  std::size_t stretch_ = 0;                       ///< between MOTIONs and CYCLEs
  std::vector<std::string> notes_;
  std::vector<deck::Command> planes_;  ///< SPLANE cards not yet checked
  std::vector<std::pair<deck::Command, deck::Material>> materials_;  ///< checked at END
  int checked_blocks_;          ///< blocks already looked at before an earlier MOTION
  int moved_blocks_;            ///< blocks that time has passed for
  double fraction_told_ = 0.0;  ///< safe FRACTION that was last warned of
  std::optional<deck::Command> fraction_by_;  ///< last FRACTION or DAMPING card
  std::optional<deck::Command> output_;       ///< whose blocks are not yet checked
  std::optional<deck::SourceLocation>
      tolerance_;  ///< of the BOXES card, if there is one
  SharedCertificate certificate_;
};

}  // namespace blocks::run
