#include "post/page/view_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "draw/colour_map.hpp"
#include "post/figure/sides.hpp"
#include "post/figure/symbols.hpp"
#include "post/page/view_bonds.hpp"
#include "post/page/view_faces.hpp"
#include "post/page/view_forces.hpp"
#include "post/page/view_numbers.hpp"
#include "post/page/view_quantities.hpp"
#include "post/page/view_shapes.hpp"
#include "post/page/view_store.hpp"
#include "post/page/view_water.hpp"
#include "post/read/crack_tracker.hpp"
#include "post/read/frame_quantity.hpp"
#include "post/read/piece_families.hpp"

namespace blocks::post {

using namespace draw;

namespace {

using Json = nlohmann::ordered_json;

class Packer {
 public:
  Packer(const ResultsReader& results, long every, const std::optional<double>& mirror)
      : results_(results), mirror_(mirror), tracker_(results), shapes_(results) {
    for (long i = 0; i < results.frames(); ++i)
      if (i % every == 0 || i + 1 == results.frames())
        chosen_.push_back(i);
    last_ = results.frame(results.frames() - 1);
    blocks_ = static_cast<std::size_t>(last_.size());
    names_ = names_of_quantities(results.has_unbalanced());
  }

  ViewData pack() {
    columns_.assign(names_.size(), DigitColumn{blocks_, {}, {}});
    for (const long i : chosen_) {
      const Frame now = results_.frame(i);
      take(now, tracker_.at(i, now), results_.contacts(i));
    }
    shapes_.end_frames();

    ViewStore store;
    shapes_.store_first(store);
    add_quantities(store);
    shapes_.store_rest(store);
    store.add_frames("fixed", fixed_, blocks_);
    forces_.store(store, shapes_.corners());
    if (bonds_.any())
      bonds_.store(store);
    if (faces_.any())
      faces_.store(store);
    if (water_.any())
      water_.store(store);
    PackedText packed = store.packed();
    return {meta(store, packed.bytes), std::move(packed.text)};
  }

 private:
  void take(const Frame& now, const CrackedBlocks& cracked,
            const FrameContacts& contacts) {
    times_.push_back(now.time);
    steps_.push_back(now.step);
    counts_.push_back(now.size());
    present_.push_back(now.count_present());
    crack_counts_.push_back(now.cracks);
    energy_.push_back(now.kinetic_energy);
    for (std::size_t k = 0; k < names_.size(); ++k) {
      const Eigen::VectorXd values =
          quantity(names_[k], now, cracked.first, contacts).values;
      for (std::size_t b = 0; b < blocks_; ++b)
        columns_[k].add(static_cast<int>(b) < now.size()
                            ? values[static_cast<Eigen::Index>(b)]
                            : 0.0);
    }
    for (std::size_t b = 0; b < blocks_; ++b)
      fixed_.push_back(
          static_cast<int>(b) < now.size() ? fixed_byte(now, static_cast<int>(b)) : 0);
    shapes_.add_frame(now, cracked);
    forces_.add_frame(contacts, shapes_, results_.path());
    bonds_.add_frame(contacts, shapes_);
    faces_.add_frame(now, cracked, shapes_);
    water_.add_frame(now, shapes_);
  }

  /// Returns 0 for a free block, 1 for a fixed one, 2 for a removed one.
  static unsigned char fixed_byte(const Frame& now, int b) {
    return now.is_removed(b) ? 2 : now.fixed[static_cast<std::size_t>(b)] != 0 ? 1 : 0;
  }

  /// Quantities that predict others are stored first.
  void add_quantities(ViewStore& store) const {
    const auto shown_by = [&](const std::string& name) -> const std::vector<float>& {
      const auto found = std::find(names_.begin(), names_.end(), name);
      return columns_[static_cast<std::size_t>(found - names_.begin())].shown;
    };
    const auto formula_of = [](const std::string& name) {
      return std::find_if(view_formulas.begin(), view_formulas.end(),
                          [&](const ViewFormula& one) { return one.quantity == name; });
    };
    for (std::size_t k = 0; k < names_.size(); ++k)
      if (formula_of(names_[k]) == view_formulas.end())
        store.add_digits(names_[k], columns_[k]);
    for (std::size_t k = 0; k < names_.size(); ++k) {
      const auto* formula = formula_of(names_[k]);
      if (formula == view_formulas.end())
        continue;
      std::array<const float*, 3> by{};
      for (std::size_t j = 0; j < 3; ++j)
        by[j] = formula->operands[j] == nullptr ? nullptr
                                                : shown_by(formula->operands[j]).data();
      const std::string name = formula->name;
      const std::vector<double>& origin = shapes_.origin();
      const Guess guess = [&, by](std::size_t i) -> double {
        const std::size_t shape = shapes_.of(i);
        const double a = by[0][i], b = by[1] == nullptr ? 0.0 : by[1][i],
                     c = by[2] == nullptr ? 0.0 : by[2][i];
        if (name == "moved_x")
          return origin[2 * shape] + a;
        if (name == "moved_y")
          return origin[2 * shape + 1] + a;
        if (name == "length")
          return std::sqrt(a * a + b * b);
        if (name == "energy")
          return 0.5 * (shapes_.mass()[shape] * (a * a + b * b) +
                        shapes_.inertia()[shape] * (c * c));
        const double half = 0.5 * (a - b), radius = std::sqrt(half * half + c * c);
        return 0.5 * (a + b) + (name == "principal_1" ? radius : -radius);
      };
      store.add_digits(names_[k], columns_[k], name, guess);
    }
  }

  /// Returns evenly spaced colours of a map. Their number is odd, so that the one in
  /// the middle of a diverging map is that of zero.
  static Json colours_of(const ColourMap& map) {
    constexpr int shades = 65;
    Json colours = Json::array();
    for (int i = 0; i < shades; ++i)
      colours.push_back(css(map.at(i / (shades - 1.0))));
    return colours;
  }

  /// Returns the maps that the page offers, with their colours.
  static Json colour_maps() {
    Json maps = Json::object();
    for (const std::string& name : all_colour_maps()) {
      const ColourMap map = colour_map(name);
      maps[name] = {{"diverging", map.diverging}, {"colours", colours_of(map)}};
    }
    return maps;
  }

  /// Returns the colours of the pieces of each block that has split, by its number, as
  /// in figures of families. That of whole blocks has the number 0.
  Json family_colours() const {
    Json colours = {{"0", css(whole_colour)}};
    for (const int family : families_of(last_))
      if (family > 0)
        colours[std::to_string(family)] = css(material_colour(family));
    return colours;
  }

  /// Returns the cracks up to the last frame.
  Json cracks() const {
    Json list = Json::array();
    for (const Crack& crack : tracker_.cracks())
      list.push_back({{"time", crack.time},
                      {"parent", crack.parent - 1},
                      {"child", crack.child - 1},
                      {"cause", crack.cause()},
                      {"stress", crack.stress},
                      {"angle", crack.angle()},
                      {"length", crack.length()},
                      {"released", crack.released()}});
    return list;
  }

  /// Describes a quantity of blocks or of faces.
  Json note_of(const std::string& name, const Quantity& kind, bool odd) const {
    return {{"name", name},
            {"label", kind.label},
            {"unit", unit_text(kind.dimension, results_.units())},
            {"map", usual_colour_map(kind.zero)},
            {"odd", odd}};
  }

  std::string meta(const ViewStore& store, std::size_t packed) const {
    const std::optional<Units>& units = results_.units();
    Json quantities = Json::array();
    for (const std::string& name : names_)
      quantities.push_back(note_of(name, quantity(name, last_, last_), is_odd(name)));
    Json materials = Json::object();
    for (const int material : last_.material)
      materials[std::to_string(material)] = css(material_colour(material));
    Json names = Json::object();
    for (const auto& [material, name] : results_.material_names())
      names[std::to_string(material)] = name;
    Json json = {{"title", results_.title()},
                 {"file", results_.path()},
                 {"blocks", blocks_},
                 {"times", times_},
                 {"steps", steps_},
                 {"counts", counts_},
                 {"present", present_},
                 {"material", last_.material},
                 {"materials", materials},
                 {"material_names", names},
                 {"quantities", quantities},
                 {"maps", colour_maps()},
                 {"kinetic_energy", energy_},
                 {"contacts", forces_.counts()},
                 {"largest_force", forces_.largest()},
                 {"time_unit", unit_text({0, 0, 1, "s", ""}, units)},
                 {"length_unit", unit_text({1, 0, 0, "m", ""}, units)},
                 {"units_known", units.has_value()},
                 {"force_unit", unit_text({0, 1, -2, "N/m", ""}, units)},
                 {"energy_unit", unit_text({1, 1, -2, "J/m", ""}, units)},
                 {"intensity", colours_of({intensity})},
                 {"mirror", mirror_ ? Json(*mirror_) : Json()},
                 {"strain_step", ViewShapes::strain_step},
                 {"packed", packed},
                 {"arrays", store.notes()}};
    if (const std::vector<int> joints = shapes_.joint_ids(); !joints.empty())
      json["joints"] = joints;
    for (const auto& [a, b] : results_.planes())
      json["planes"].push_back({a.x(), a.y(), b.x(), b.y()});
    if (!tracker_.cracks().empty()) {
      json["cracks"] = cracks();
      json["crack_counts"] = crack_counts_;
      json["crack_colour"] = css(crack_colour);
      json["families"] = families_of(last_);
      json["family_colours"] = family_colours();
      json["stress_unit"] = unit_text({-1, 1, -2, "Pa", ""}, units);
    }
    if (faces_.any())
      for (const std::string name : {"opening", "shear_displacement"})
        json["face_quantities"].push_back(
            note_of(name, face_quantity(name), name != "opening"));
    if (water_.any())
      json["face_quantities"].push_back(
          note_of("water_pressure", face_quantity("water_pressure"), false));
    if (const Json lines = water_.lines(); !lines.is_null()) {
      json["water_lines"] = lines;
      json["water_colour"] = css(water_colour);
    }
    if (bonds_.any()) {
      json["largest_slip"] = bonds_.largest_slip();
      json["bonded_colour"] = css(bonded_colour);
      json["slip_colours"] = colours_of({slip_colour});
      json["stress_unit"] = unit_text({-1, 1, -2, "Pa", ""}, units);
    }
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
  }

  const ResultsReader& results_;
  std::optional<double> mirror_;
  std::vector<long> chosen_;
  Frame last_;
  std::size_t blocks_ = 0;
  ResultsTracker tracker_;
  ViewShapes shapes_;
  std::vector<std::string> names_;  ///< of the quantities
  std::vector<DigitColumn> columns_;
  std::vector<unsigned char> fixed_;
  ViewForces forces_;
  ViewBonds bonds_;
  ViewFaces faces_;
  ViewWater water_;
  std::vector<double> times_, energy_;
  std::vector<long> steps_;
  std::vector<long> crack_counts_;  ///< up to each frame
  std::vector<int> counts_;   ///< blocks of each frame, including the removed ones
  std::vector<int> present_;  ///< blocks of each frame that are not removed
};

}  // namespace

ViewData view_data(const ResultsReader& results, long every,
                   const std::optional<double>& mirror) {
  return Packer(results, every, mirror).pack();
}

}  // namespace blocks::post
