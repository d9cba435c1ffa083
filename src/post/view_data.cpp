#include "post/view_data.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <stdexcept>

#include "output/results.hpp"
#include "post/bond_sides.hpp"
#include "post/colour_map.hpp"
#include "post/quantity.hpp"
#include "post/view_bonds.hpp"
#include "post/view_numbers.hpp"
#include "post/view_quantities.hpp"
#include "post/view_store.hpp"

namespace blocks::post {
namespace {

using Json = nlohmann::ordered_json;

/// The first arms of a block. They give the map to its current arms, which is R(turn)
/// for a rigid block.
struct Shape {
  double first_angle = 0.0;
  Eigen::Matrix2Xd arms;
  Eigen::Matrix2d inverse;  ///< (arms arms^T)^-1
  double extent = 0.0;
};

Eigen::Matrix2Xd arms(const std::vector<Eigen::Vector2d>& outline,
                      const Eigen::Vector2d& centroid) {
  Eigen::Matrix2Xd r(2, static_cast<Eigen::Index>(outline.size()));
  for (std::size_t c = 0; c < outline.size(); ++c)
    r.col(static_cast<Eigen::Index>(c)) = outline[c] - centroid;
  return r;
}
Eigen::Matrix2Xd arms(const Frame& frame, int b) {
  return arms(frame.outlines[static_cast<std::size_t>(b)], frame.centroid.col(b));
}

/// Resolution of strains, which are only drawn: the error of a block of 1000 pixels is
/// a hundredth of a pixel.
constexpr double strain_step = 1e-5;

/// Rounds a strain to steps; NaN, with which a run may end, becomes 0.
int in_strain_steps(double strain) {
  return std::isnan(strain) ? 0
                            : static_cast<int>(std::lround(
                                  std::clamp(strain / strain_step, -1e9, 1e9)));
}

/// One contact force to draw.
struct Arrow {
  int corner = 0;               ///< index over all blocks
  unsigned char direction = 0;  ///< in units of 1/256 turn, from x towards y
  double size = 0.0;
};

class Packer {
 public:
  Packer(const ResultsReader& results, long every, const std::optional<double>& mirror)
      : results_(results), mirror_(mirror) {
    for (long i = 0; i < results.frames(); ++i)
      if (i % every == 0 || i + 1 == results.frames())
        chosen_.push_back(i);
    last_ = results.frame(results.frames() - 1);
    blocks_ = static_cast<std::size_t>(last_.size());
    last_outlines_ = results.last_outlines(results.frames() - 1);
    names_ = names_of_quantities(results.has_unbalanced());
    first_corner_.push_back(0);
    for (const auto& outline : last_outlines_)
      first_corner_.push_back(first_corner_.back() + static_cast<int>(outline.size()));
  }

  ViewData pack() {
    columns_.assign(names_.size(), DigitColumn{blocks_, {}, {}});
    const Frame first = results_.frame(0);
    for (const long i : chosen_)
      take(results_.frame(i), first, results_.contacts(i));

    ViewStore store;
    std::vector<std::uint16_t> corners;
    std::vector<double> origin;
    std::vector<float> arm;
    std::vector<float> angle;
    for (std::size_t b = 0; b < blocks_; ++b) {
      corners.push_back(
          static_cast<std::uint16_t>(first_corner_[b + 1] - first_corner_[b]));
      origin.insert(origin.end(), {origin_[b].x(), origin_[b].y()});
      for (const double value : shapes_[b].arms.reshaped())
        arm.push_back(static_cast<float>(value));
      angle.push_back(
          static_cast<float>(shapes_[b].first_angle * 180 / std::numbers::pi));
    }
    store.add("origin", "f64",
              origin);  // eight-byte values first: arrays stay aligned
    store.add("arm", "f32", arm);
    store.add("angle", "f32", angle);
    const auto single = [](const Eigen::VectorXd& values) {
      return std::vector<float>(values.begin(), values.end());
    };
    store.add("mass", "f32", single(last_.mass));
    store.add("inertia", "f32", single(last_.inertia));
    add_quantities(store, origin, single(last_.mass), single(last_.inertia));
    if (strained_)
      store.add_whole("strain", strain_, 4 * blocks_);
    store.add("corners", "u16", corners);
    const std::vector<int> ids = joint_ids();
    if (!ids.empty())
      store.add("joint", "u16", joints_of_sides(ids));
    store.add_frames("fixed", fixed_, blocks_);
    add_forces(store);
    if (bonds_.any())
      bonds_.store(store);
    PackedText packed = store.packed();
    return {meta(store, packed.bytes, ids), std::move(packed.text)};
  }

 private:
  void take(const Frame& now, const Frame& first, const FrameContacts& contacts) {
    times_.push_back(now.time);
    steps_.push_back(now.step);
    counts_.push_back(now.size());
    present_.push_back(now.count_present());
    energy_.push_back(now.kinetic_energy);
    for (std::size_t k = 0; k < names_.size(); ++k) {
      const Eigen::VectorXd values = quantity(names_[k], now, first, contacts).values;
      for (std::size_t b = 0; b < blocks_; ++b)
        columns_[k].add(static_cast<int>(b) < now.size()
                            ? values[static_cast<Eigen::Index>(b)]
                            : 0.0);
    }
    for (std::size_t b = 0; b < blocks_; ++b) {
      const bool there = static_cast<int>(b) < now.size();
      fixed_.push_back(there ? fixed_byte(now, static_cast<int>(b)) : 0);
      const Eigen::Matrix2d strain =
          there ? follow(now, first, static_cast<int>(b)) : Eigen::Matrix2d::Zero();
      for (const double value : strain.reshaped())
        strain_.push_back(in_strain_steps(value));
    }
    take_contacts(contacts);
    bonds_.add_frame(contacts, first_corner_);
    joints_.resize(blocks_);
    for (std::size_t b = 0; b < now.joints.size(); ++b)
      if (!now.joints[b].empty())
        joints_[b] = now.joints[b];
  }

  /// Returns all joint ids in their order, with 0 as the first; empty if every id is 0.
  std::vector<int> joint_ids() const {
    std::set<int> ids = {0};
    for (const auto& sides : joints_)
      ids.insert(sides.begin(), sides.end());
    return ids.size() > 1 ? std::vector<int>(ids.begin(), ids.end())
                          : std::vector<int>();
  }
  /// Returns the index of the joint id of each side, in the order of all corners.
  std::vector<std::uint16_t> joints_of_sides(const std::vector<int>& ids) const {
    std::vector<std::uint16_t> indices(static_cast<std::size_t>(first_corner_.back()));
    for (std::size_t b = 0; b < blocks_; ++b)
      for (std::size_t k = 0; k < joints_[b].size(); ++k)
        indices[static_cast<std::size_t>(first_corner_[b]) + k] =
            static_cast<std::uint16_t>(
                std::lower_bound(ids.begin(), ids.end(), joints_[b][k]) - ids.begin());
    return indices;
  }

  /// Returns 0 for a free block, 1 for a fixed one, 2 for a removed one.
  static unsigned char fixed_byte(const Frame& now, int b) {
    return now.is_removed(b) ? 2 : now.fixed[static_cast<std::size_t>(b)] != 0 ? 1 : 0;
  }

  /// Quantities that predict others are stored first.
  void add_quantities(ViewStore& store, const std::vector<double>& origin,
                      const std::vector<float>& mass,
                      const std::vector<float>& inertia) const {
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
        by[j] = formula->of[j] == nullptr ? nullptr : shown_by(formula->of[j]).data();
      const std::string name = formula->name;
      const Guess guess = [&, by, n = blocks_](std::size_t i) -> double {
        const double a = by[0][i], b = by[1] == nullptr ? 0.0 : by[1][i],
                     c = by[2] == nullptr ? 0.0 : by[2][i];
        if (name == "moved_x")
          return origin[2 * (i % n)] + a;
        if (name == "moved_y")
          return origin[2 * (i % n) + 1] + a;
        if (name == "length")
          return std::sqrt(a * a + b * b);
        if (name == "energy")
          return 0.5 * (mass[i % n] * (a * a + b * b) + inertia[i % n] * (c * c));
        const double half = 0.5 * (a - b), radius = std::sqrt(half * half + c * c);
        return 0.5 * (a + b) + (name == "principal_1" ? radius : -radius);
      };
      store.add_digits(names_[k], columns_[k], name, guess);
    }
  }

  /// Returns the strain of the arms of a block before its rotation. Also records new
  /// blocks and whether a block is strained.
  Eigen::Matrix2d follow(const Frame& now, const Frame& first, int b) {
    if (now.is_removed(b)) {
      if (static_cast<std::size_t>(b) == shapes_.size())
        add_hidden(b);
      return Eigen::Matrix2d::Zero();
    }
    const Eigen::Matrix2Xd r = arms(now, b);
    if (static_cast<std::size_t>(b) == shapes_.size()) {
      const bool from_first = b < first.size();
      const double none = std::nan("");  // the page then uses x and y
      origin_.push_back(from_first ? Eigen::Vector2d(first.centroid.col(b))
                                   : Eigen::Vector2d(none, none));
      const Eigen::Matrix2Xd own = from_first ? arms(first, b) : r;
      shapes_.push_back({from_first ? first.angle[b] : now.angle[b], own,
                         (own * own.transpose()).inverse(),
                         own.colwise().norm().maxCoeff()});
    }
    const Shape& shape = shapes_[static_cast<std::size_t>(b)];
    if (r.cols() != shape.arms.cols())
      refuse(now, b);
    const double turn = now.angle[b] - shape.first_angle;
    const Eigen::Matrix2d rotation = Eigen::Rotation2Dd(turn).toRotationMatrix();
    if ((r - rotation * shape.arms).cwiseAbs().maxCoeff() < 1e-6 * shape.extent)
      return Eigen::Matrix2d::Zero();
    strained_ = true;
    const Eigen::Matrix2d map = r * shape.arms.transpose() * shape.inverse;
    if ((r - map * shape.arms).cwiseAbs().maxCoeff() > 1e-4 * shape.extent)
      refuse(now, b);
    return rotation.transpose() * map - Eigen::Matrix2d::Identity();
  }
  /// Adds the shape of a block that is removed in all frames of the page.
  void add_hidden(int b) {
    const double none = std::nan("");
    origin_.emplace_back(none, none);
    const auto& outline = last_outlines_[static_cast<std::size_t>(b)];
    shapes_.push_back({0.0,
                       arms(outline, outline.empty() ? Eigen::Vector2d::Zero().eval()
                                                     : outline.front()),
                       Eigen::Matrix2d::Identity(), 0.0});
  }
  [[noreturn]] void refuse(const Frame& now, int b) const {
    throw std::runtime_error(fmt::format(
        "{}: block {} has changed its outline at time {:g}; the page cannot show that",
        results_.path(), b + 1, now.time));
  }

  void take_contacts(const FrameContacts& contacts) {
    std::vector<Arrow> arrows;
    for (int i = 0; i < contacts.size(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      const int block = contacts.corner_block[k] - 1;
      if (block < 0 || block >= static_cast<int>(blocks_))
        continue;
      const auto first = first_corner_.begin() + block;
      if (contacts.corner[k] < 1 || contacts.corner[k] > first[1] - first[0])
        throw output::FileError(fmt::format(
            "cannot read {}: it is damaged: a contact is at corner {} of "
            "block {}, which has {}",
            results_.path(), contacts.corner[k], block + 1, first[1] - first[0]));
      const Eigen::Vector2d n = contacts.normal.col(i), t(n.y(), -n.x());
      const Eigen::Vector2d f =
          n * contacts.normal_force[i] - t * contacts.shear_force[i];
      const double turn = std::atan2(f.y(), f.x()) / (2 * std::numbers::pi);
      arrows.push_back({*first + contacts.corner[k] - 1,
                        static_cast<unsigned char>(std::lround(256 * (turn + 1)) % 256),
                        f.norm()});
      largest_ = std::max(largest_, arrows.back().size);
    }
    std::stable_sort(arrows.begin(), arrows.end(), [](const Arrow& a, const Arrow& b) {
      return a.corner < b.corner;
    });
    arrows_.push_back(std::move(arrows));
  }

  /// Stores the number of forces of each corner in each frame, then the direction and
  /// size of all forces. They are stored as differences from the same corner in the
  /// previous frame. The size is on a logarithmic scale of 255 steps over six decades
  /// below the largest.
  void add_forces(ViewStore& store) const {
    const auto corners = static_cast<std::size_t>(first_corner_.back());
    Bytes acting, directions, sizes;
    std::vector<Bytes> old_directions(corners), old_sizes(corners);
    for (const auto& arrows : arrows_) {
      std::vector<Bytes> new_directions(corners), new_sizes(corners);
      for (const Arrow& arrow : arrows) {
        const auto corner = static_cast<std::size_t>(arrow.corner);
        const auto tell = [&](unsigned char value, Bytes& told, Bytes& now,
                              const Bytes& before) {
          const std::size_t rank = now.size();
          told.push_back(static_cast<unsigned char>(
              value - (rank < before.size() ? before[rank] : 0)));
          now.push_back(value);
        };
        const double decades =
            arrow.size > 0.0 ? std::log10(arrow.size / largest_) : -9;
        tell(arrow.direction, directions, new_directions[corner],
             old_directions[corner]);
        tell(static_cast<unsigned char>(
                 std::clamp(std::lround(255 * (1 + decades / 6)), 0L, 255L)),
             sizes, new_sizes[corner], old_sizes[corner]);
      }
      for (const Bytes& of_corner : new_sizes)
        acting.push_back(static_cast<unsigned char>(of_corner.size()));
      old_directions = std::move(new_directions);
      old_sizes = std::move(new_sizes);
    }
    store.add_frames("acting", acting, corners);
    store.add("directions", "u8", directions);
    store.add("sizes", "u8", sizes);
  }

  static std::string css(const Colour& c) {
    const auto byte = [](double part) {
      return static_cast<int>(std::lround(255 * std::clamp(part, 0.0, 1.0)));
    };
    return fmt::format("#{:02x}{:02x}{:02x}", byte(c.r), byte(c.g), byte(c.b));
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

  std::string meta(const ViewStore& store, std::size_t packed,
                   const std::vector<int>& joints) const {
    const std::optional<Units>& units = results_.units();
    Json quantities = Json::array();
    for (const std::string& name : names_) {
      const Quantity kind = quantity(name, last_, last_);
      quantities.push_back({{"name", name},
                            {"label", kind.label},
                            {"unit", unit_text(kind.dimension, units)},
                            {"map", usual_colour_map(kind.zero)},
                            {"odd", is_odd(name)}});
    }
    Json materials = Json::object();
    for (const int material : last_.material)
      materials[std::to_string(material)] = css(material_colour(material));
    Json names = Json::object();
    for (const auto& [material, name] : results_.material_names())
      names[std::to_string(material)] = name;
    std::vector<std::size_t> acting;
    for (const auto& arrows : arrows_)
      acting.push_back(arrows.size());
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
                 {"contacts", acting},
                 {"largest_force", largest_},
                 {"time_unit", unit_text({0, 0, 1, "s", ""}, units)},
                 {"length_unit", unit_text({1, 0, 0, "m", ""}, units)},
                 {"units_known", units.has_value()},
                 {"force_unit", unit_text({0, 1, -2, "N/m", ""}, units)},
                 {"energy_unit", unit_text({1, 1, -2, "J/m", ""}, units)},
                 {"intensity", colours_of({intensity})},
                 {"mirror", mirror_ ? Json(*mirror_) : Json()},
                 {"strain_step", strain_step},
                 {"packed", packed},
                 {"arrays", store.notes()}};
    if (!joints.empty())
      json["joints"] = joints;
    if (bonds_.any()) {
      json["largest_slip"] = bonds_.largest_slip();
      json["slip_colours"] = colours_of({slip_colour});
      json["stress_unit"] = unit_text({-1, 1, -2, "Pa", ""}, units);
    }
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
  }

  const ResultsReader& results_;
  std::optional<double> mirror_;
  std::vector<long> chosen_;
  Frame last_;
  std::vector<std::vector<Eigen::Vector2d>> last_outlines_;
  std::size_t blocks_ = 0;
  std::vector<int> first_corner_;
  std::vector<std::string> names_;  ///< of the quantities
  std::vector<DigitColumn> columns_;
  std::vector<int> strain_;  ///< in steps
  std::vector<unsigned char> fixed_;
  bool strained_ = false;
  std::vector<Shape> shapes_;
  std::vector<Eigen::Vector2d> origin_;
  std::vector<std::vector<int>> joints_;  ///< of the sides of each block
  std::vector<std::vector<Arrow>> arrows_;
  ViewBonds bonds_;
  double largest_ = 0.0;
  std::vector<double> times_, energy_;
  std::vector<long> steps_;
  std::vector<int> counts_;   ///< blocks of each frame, including the removed ones
  std::vector<int> present_;  ///< blocks of each frame that are not removed
};

}  // namespace

ViewData view_data(const ResultsReader& results, long every,
                   const std::optional<double>& mirror) {
  return Packer(results, every, mirror).pack();
}

}  // namespace blocks::post
