// The values of curves in one state.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "quantities/curve.hpp"
#include "quantities/model_quantity.hpp"
#include "quantities/quantity.hpp"

namespace blocks::quantities {

/// The numbers of materials by their names.
using MaterialNumbers = std::map<std::string, int>;
MaterialNumbers material_numbers(const Settings& settings);

/// Returns the number that a curve means by its material: the text as a number, or the
/// number of the material with that name. Returns 0 if there is none.
int material_number(const std::string& material, const MaterialNumbers& numbers);

/// Evaluates a list of curves. Allocates memory only in the first state and if the
/// number of blocks or contacts has grown.
class CurveValues {
 public:
  explicit CurveValues(const std::vector<Curve>& curves,
                       const MaterialNumbers& numbers = {});

  std::size_t size() const { return curves_.size(); }
  /// Whether a value depends on the contacts of the state, or on the first positions.
  bool has_contacts() const;
  bool has_displacements() const;
  /// Whether a value depends on the unbalanced forces of the state.
  bool has_unbalanced() const;
  /// Whether a value depends on the local ratios of the state.
  bool has_local_ratios() const;
  /// Whether a value depends on the forces of water in the state.
  bool has_water() const;

  /// Sets values[i] to that of curve i: NaN if its blocks do not exist yet or were
  /// removed, or for displacements of blocks without a first position. Such blocks do
  /// not count in statistics. Sums are taken in the order of the blocks.
  void evaluate(const State& now, const Positions& first, std::span<double> values);

 private:
  struct Reader {
    Curve curve;
    const QuantityKind* kind = nullptr;
    const OtherKind* other = nullptr;
    int material = 0;
  };
  double value(const Reader& reader, const State& now, const Positions& first);
  double of_contacts(const Reader& reader, const State& now);
  double of_joint(const Reader& reader, const State& now);

  std::vector<Reader> curves_;
  std::vector<double> scratch_;    ///< values to be reduced
  std::vector<double> of_blocks_;  ///< (blocks) a quantity of contacts
};

}  // namespace blocks::quantities
