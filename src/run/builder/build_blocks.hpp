// Executes the cards that make blocks: CREATE with CLOOP, LAYER, READ9 (report
// A.2.1-A.2.6), and CUT with its group.
#pragma once

#include "deck/commands.hpp"
#include "deck/diagnostics.hpp"
#include "geometry/layer.hpp"
#include "geometry/polygon.hpp"
#include "geometry/shared_corners.hpp"
#include "model/model.hpp"
#include "run/builder/unread_cards.hpp"
#include "run/cutting/cut_outcome.hpp"

namespace blocks::run {

/// Executes one card. Errors go to the diagnostics, and the model is then unchanged.
class BlockBuilder {
 public:
  /// `corners` holds the shared corners of this section of the deck, up to the next
  /// MOTION, CYCLE or SOLVE. `unread` are the cards that could not be read, which may
  /// define materials. `missing` blocks before those of this card were not made,
  /// because their cards are faulty. Limits of START are not checked if it is missing.
  BlockBuilder(Model& model, deck::Diagnostics& diagnostics,
               const deck::Command& command, const geometry::SharedCorners& corners,
               const UnreadCards& unread, long missing)
      : model_(model), diagnostics_(diagnostics), command_(command), corners_(corners),
        unread_(unread), missing_(missing) {}

  void create(const deck::Create& card);
  void layer(const deck::Layer& card);
  /// Cuts the domain. Returns notes on the joints, one per line.
  std::vector<std::string> cut(const deck::Cut& card, const CutOptions& options);
  /// Returns a description of what was found in the file; empty after an error.
  std::string read_mesh(const deck::Read9& card, const std::string& path);

 private:
  bool has_start() const { return model_.settings.max_blocks > 0; }
  void error(deck::SourceLocation where, const std::string& message,
             const std::string& hint = {}) {
    diagnostics_.error(where, command_.name, message, hint);
  }
  void warning(deck::SourceLocation where, const std::string& message,
               const std::string& hint = {}) {
    diagnostics_.warning(where, command_.name, message, hint);
  }

  /// The density of a defined material. If it is undefined, reports an error at `where`
  /// and returns 0.
  double density(long material, deck::SourceLocation where);
  /// Whether `more` blocks still fit under START's maximum. Reports an error if not.
  bool fits(long more, deck::SourceLocation where);
  /// Whether area and second moment are finite and positive. Reports an error if not.
  /// hint_if_thin: what to do if the block is not small, but thin.
  bool has_weight(const geometry::Polygon& clockwise, deck::SourceLocation where,
                  const std::string& what,
                  const std::string& hint_if_thin = "move its sides apart");
  /// Checks an outline exactly and makes it clockwise. Each side keeps its joint id in
  /// `joints`, which may be null. `what` names the outline in messages.
  /// `warned` is set once a warning was given, which is then not repeated.
  bool accept(geometry::Polygon& outline, deck::SourceLocation where,
              const std::string& what, bool& warned,
              std::vector<int>* joints = nullptr);
  /// Puts the corners of a layer in clockwise order. Reports an error if that is not
  /// possible.
  bool orient_corners(const deck::Layer& card, geometry::LayerRequest& request);
  void record(const geometry::Layer& cut, int number);
  void record(const CutOutcome& outcome);
  /// Warns of joints that do not cut, and of edges and cells that remain small.
  void warn_of(const deck::Cut& card, const CutRecord& record);
  void append(const std::vector<NewBlock>& blocks);

  Model& model_;
  deck::Diagnostics& diagnostics_;
  const deck::Command& command_;
  const geometry::SharedCorners& corners_;
  const UnreadCards& unread_;
  long missing_;
};

}  // namespace blocks::run
