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
#include "run/builder/block_numbers.hpp"
#include "run/builder/unread_cards.hpp"
#include "run/plausibility/block_makers.hpp"
#include "run/plausibility/plausibility.hpp"

namespace blocks::run {

struct BuildOptions {
  std::optional<std::uint64_t> seed = {};  ///< --seed, which overrides the SEED card
  std::string tape9 = "tape9";  ///< --tape9: the mesh of a READ9 card without a name
  std::string folder = {};      ///< folder of the deck; file names are relative to it
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
struct BuilderState {
  /// `cards` is the whole deck, because outlines of different cards share corners.
  BuilderState(const Model& model, const std::vector<deck::Command>& cards,
               BuildOptions build_options);

  /// The line of a card and its section between motions.
  struct GivenAt {
    int line = 0;
    std::size_t section = 0;
  };

  BuildOptions options;
  UnreadCards unread;
  BlockNumbers numbers;
  BlockMakers makers;
  CardPlaces places;
  Plausibility plausibility;
  std::vector<std::string> notes;  ///< on what cards have done, one per line

  // Time
  std::size_t section = 0;              ///< index of the section between motions
  std::optional<deck::Command> motion;  ///< the last card with which time passes
  bool balanced = false;                ///< there was a SOLVE or INSITU card
  bool moves = false;  ///< steps are made at MOTION, CYCLE, SOLVE and FOS
  /// The blocks are where they will be when the next card acts. This is false after a
  /// motion that made no steps.
  bool in_place = true;
  /// Blocks inside the outlines of REMOVE cards that acted while not in place. They
  /// remain in the model, because they may be elsewhere when the run removes blocks.
  std::set<int> perhaps_removed;
  /// FIX has acted on a selector while not in place, so others may be fixed in the run.
  bool perhaps_fixed = false;

  // What later cards refer to
  std::vector<geometry::SharedCorners> corners;  ///< one for each section of the deck
  geometry::Polygon last_outline;                ///< [L] of the last CUT card
  std::vector<int> chosen;        ///< blocks on which the present REMOVE or FREE acts
  std::map<int, GivenAt> joints;  ///< JOINT cards by id
  std::map<std::pair<int, int>, GivenAt> pairs;  ///< JPAIR cards by materials

  // Cards that are checked later
  std::vector<deck::Command> materials;   ///< at END
  std::vector<deck::Command> planes;      ///< SPLANE; before a motion
  std::vector<deck::Command> cracks;      ///< before a motion
  std::optional<deck::Command> fraction;  ///< last FRACTION, DAMPING or LOCDAMP
  std::vector<deck::Command> histories;   ///< at the end
  std::optional<deck::Command> output;    ///< at the end

  // What has been checked
  int known_blocks;              ///< blocks after the last card
  int checked_blocks;            ///< blocks checked before an earlier motion
  int moved_blocks;              ///< blocks that have moved
  int domain_blocks;             ///< blocks compared with the domain
  double warned_fraction = 0.0;  ///< safe FRACTION in the last warning
  /// The certificate of the blocks when the latest of them were made; null before the
  /// first motion.
  SharedCertificate certificate;
};

}  // namespace blocks::run
