// What the cards so far mean for the cards after them, besides the model.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "deck/commands.hpp"
#include "geometry/shared_corners.hpp"
#include "model/assembly_certificate.hpp"
#include "model/model.hpp"
#include "run/builder/missing_blocks.hpp"
#include "run/builder/unread_cards.hpp"
#include "run/plausibility/block_makers.hpp"
#include "run/plausibility/plausibility.hpp"

namespace blocks::run {

struct BuildOptions {
  std::optional<std::uint64_t> seed;  ///< --seed, which overrides the SEED card
  std::string tape9 = "tape9";  ///< --tape9: the mesh of a READ9 card without a name
  std::string folder;           ///< folder of the deck; file names are relative to it
  /// Cards that could not be read. Blocks, materials or functions that may be missing
  /// for that reason cause no further errors.
  std::vector<deck::UnreadCard> unread = {};
  /// Overlaps that were reported before the checkpoint of a RESTART deck was written.
  std::vector<geometry::BlockOverlap> overlaps = {};
  /// As CutOptions::progress, with the line of the CUT card.
  std::function<void(int line, const std::string& step, double part)> cut_progress = {};
  /// Likewise of the check that no two blocks overlap.
  geometry::ProgressFunction check_progress = {};
};

/// The memory of a Builder. Together with a copy of the model, a copy of it lets
/// another builder go on from the same card.
class BuilderState {
 public:
  BuilderState(const Model& model, const std::vector<deck::Command>& cards,
               BuildOptions options);

  /// Steps are made from the present card on, a MOTION, CYCLE, SOLVE or FOS. Without
  /// this call, no block moves, and the cards after it act on blocks that may be
  /// elsewhere in a run.
  void begin_to_move();

  /// Returns the notes on mesh files, shared corners and removed or freed blocks since
  /// the last call, one per line.
  std::vector<std::string> take_notes() { return std::exchange(notes_, {}); }

  /// The certificate of the blocks when the latest of them were made; null before the
  /// first motion.
  const SharedCertificate& certificate() const { return certificate_; }

 protected:
  /// The line of a card and its section between motions.
  struct GivenAt {
    int line = 0;
    std::size_t section = 0;
  };

  BuildOptions options_;
  UnreadCards unread_;
  long failed_blocks_ = 0;  ///< the most blocks that cards with errors should make
  MissingBlocks missing_;   ///< those of them that certainly count as blocks
  std::size_t unread_counted_ = 0;  ///< cards not read whose blocks are counted
  int certain_blocks_;              ///< blocks whose numbers are sure
  std::vector<geometry::SharedCorners> corners_;  ///< one for each section of the deck
  bool balanced_ = false;                         ///< there was a SOLVE or INSITU card
  std::size_t section_ = 0;  ///< index of the section between motions
  bool moves_ = false;       ///< steps are made at MOTION, CYCLE, SOLVE and FOS
  /// The blocks are where they will be when the next card acts. This is false after a
  /// motion that made no steps.
  bool in_place_ = true;
  /// Blocks inside the outlines of REMOVE cards that acted while not in place. They
  /// remain in the model, because they may be elsewhere when the run removes blocks.
  std::set<int> perhaps_removed_;
  /// FIX has acted on a selector while not in place, so others may be fixed in the run.
  bool perhaps_fixed_ = false;
  std::vector<int> chosen_;         ///< blocks on which the present REMOVE or FREE acts
  geometry::Polygon last_outline_;  ///< [L] of the last CUT card
  std::vector<std::pair<deck::SourceLocation, int>>
      crack_cards_;                ///< CRACK cards not checked yet, and their materials
  std::map<int, GivenAt> joints_;  ///< JOINT cards by id
  std::map<std::pair<int, int>, GivenAt> pairs_;  ///< JPAIR cards by materials
  std::vector<std::string> notes_;
  std::vector<deck::Command> planes_;  ///< SPLANE cards that are not checked yet
  std::vector<std::pair<deck::Command, deck::Material>> materials_;  ///< checked at END
  BlockMakers makers_;
  CardPlaces places_;
  Plausibility plausibility_;
  int domain_blocks_;  ///< blocks compared with the domain
  /// The number of blocks before the first motion in which blocks may split; empty if
  /// there is none, or if steps are made. Later blocks have unknown numbers.
  std::optional<long> sure_blocks_;
  int known_blocks_;                     ///< blocks after the last card
  std::optional<deck::Command> motion_;  ///< the last MOTION, CYCLE or SOLVE card
  int checked_blocks_;                   ///< blocks checked before an earlier motion
  int moved_blocks_;                     ///< blocks that have moved
  double warned_fraction_ = 0.0;         ///< safe FRACTION in the last warning
  std::optional<deck::Command>
      fraction_by_;                       ///< last FRACTION, DAMPING or LOCDAMP card
  std::optional<deck::Command> output_;   ///< OUTPUT card not checked yet
  std::vector<deck::Command> histories_;  ///< HISTORY cards not checked yet
  SharedCertificate certificate_;
};

}  // namespace blocks::run
