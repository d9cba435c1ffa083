// A curve of a history, which the user writes as QUANTITY or QUANTITY:WHERE.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "quantities/statistic.hpp"

namespace blocks::quantities {

/// Thrown if a curve cannot be read.
struct CurveFault : std::runtime_error {
  CurveFault(const std::string& message, std::string possible)
      : std::runtime_error(message), hint(std::move(possible)) {}
  std::string hint;          ///< the possible values
  std::string unknown = {};  ///< the name, if there is no such quantity
};

/// A quantity and its place: "kinetic_energy" for the model, "speed:9" for block 9,
/// "x:9.2" for its corner 2. For several blocks a statistic reduces the values to one:
/// "speed:max" for all blocks, "y:6-9" for the mean of blocks 6 to 9,
/// "y:6-9/12" for that of these and 12, "y:material=2:p90" for a percentile of those of
/// a material. The contacts of a joint with a law or those between two blocks have a
/// value too: "shear_force:joint=1", "slip:2+3".
struct Curve {
  enum class Subject { model, block, corner, blocks, joint, pair };
  std::string quantity;  ///< a name of quantity.hpp or model_quantity.hpp
  Subject subject = Subject::model;
  /// Numbers of the blocks, from 1; 0, 0: all. Of a pair: its two blocks, the lower
  /// number first.
  int first = 0, last = 0;
  /// The first and last numbers of several ranges, ascending; empty: first to last.
  std::vector<std::pair<int, int>> ranges = {};
  int joint = 0;         ///< joint id, from 1
  int corner = 0;        ///< from 1
  std::string material;  ///< number or name; empty: any
  Statistic statistic;   ///< of several blocks or contacts
  /// Of the contacts of a joint or a pair: false means the usual one of the quantity.
  bool has_statistic = false;

  /// The numbers of the blocks as a user writes them: "6-9" or "6-9/12".
  std::string numbers() const;
  /// Whether the ranges, if there are several, contain a number.
  bool has_block(int number) const;
  bool of_contacts() const {
    return subject == Subject::joint || subject == Subject::pair;
  }
  bool all_blocks() const {
    return subject == Subject::blocks && first == 0 && material.empty();
  }
  /// As the user writes it, in one form: curves with the same name are the same.
  std::string name() const;
};

/// Returns the place of several blocks, from 0 and ascending, as a curve has it:
/// "6-9", or "6-9/12" for more than one range.
std::string place_of_blocks(const std::vector<int>& blocks);

/// Reads QUANTITY or QUANTITY:WHERE. Throws CurveFault.
Curve parse_curve(const std::string& text);

/// Lists all that parse_curve accepts, for help and messages.
std::string history_help();

/// The curves of a history for which no other ones are named.
inline constexpr const char* usual_curves[] = {"kinetic_energy", "overlap", "contacts"};

}  // namespace blocks::quantities
