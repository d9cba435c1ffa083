// Turns the cards of a deck into a model: every card but those that make time pass
// (MOTION, CYCLE) or write files (DUMP). Knows the deck and the model, no dynamics.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "deck/commands.hpp"
#include "deck/diagnostics.hpp"
#include "model/assembly_certificate.hpp"
#include "model/model.hpp"

namespace blocks::run {

struct BuildOptions {
  std::optional<std::uint64_t> seed;  ///< --seed, wins over SEED
  std::string tape9 = "tape9";        ///< --tape9: mesh of a READ9 card without a name
  std::string folder;                 ///< of the deck: file names are relative to it
  /// Some cards could not be read: look at what was, without complaints that only
  /// follow from the missing ones (block numbers, materials).
  bool partial = false;
};

class Builder {
 public:
  Builder(Model& model, deck::Diagnostics& diagnostics, BuildOptions options);

  /// Acts on one card. Faults go to the diagnostics; the model then stays as it was.
  void apply(const deck::Command& command);

  /// What must hold before time may pass: blocks present, planes not in front of
  /// nothing, no step without a driving FUNCTION. Called before MOTION and CYCLE.
  void check_before_motion(const deck::Command& command);

  /// What was found in the mesh files, a line each, since the last call.
  std::vector<std::string> take_notes() { return std::exchange(notes_, {}); }

  /// What the blocks proved to be when time last passed; nothing before.
  const std::optional<AssemblyCertificate>& certificate() const { return certificate_; }

 private:
  struct Visitor;
  void check_planes();
  void check_overlaps(const deck::Command& command);

  Model& model_;
  deck::Diagnostics& diagnostics_;
  BuildOptions options_;
  std::vector<std::string> notes_;
  std::vector<deck::Command> planes_;  ///< SPLANE cards not yet checked
  std::vector<std::pair<deck::Command, deck::Material>> materials_;  ///< checked at END
  int checked_blocks_;  ///< blocks already looked at before an earlier MOTION
  std::optional<AssemblyCertificate> certificate_;
  bool fraction_checked_ = false;
};

}  // namespace blocks::run
