#include "post/view_data.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>

#include "post/colour_map.hpp"
#include "post/quantity.hpp"

namespace blocks::post {
namespace {

using Json = nlohmann::ordered_json;
using Bytes = std::vector<unsigned char>;

/// Those the page shows, in its order.
constexpr std::array shown = {
    "displacement", "dx", "dy", "speed",  "vx",  "vy",  "x",   "y",  "rotation",
    "spin",         "fx", "fy", "moment", "s11", "s22", "s12", "p1", "p2"};

/// Arrays one behind the other, and a note of each in the page's JSON.
class Store {
 public:
  template <class T>
  void add(const std::string& name, const char* type, const std::vector<T>& values) {
    note(name, type, values.size(), 0);
    append(values.data(), values.size() * sizeof(T));
  }

  /// Frames of `rows` values each: against the frame before, first bytes first, so that
  /// what does not change becomes zeros.
  template <class T>
  void add_frames(const std::string& name, const char* type, std::vector<T> values,
                  std::size_t rows) {
    note(name, type, values.size(), rows);
    Bytes raw(values.size() * sizeof(T));
    std::memcpy(raw.data(), values.data(), raw.size());
    const std::size_t frame = rows * sizeof(T);
    for (std::size_t i = raw.size(); i-- > frame;)
      raw[i] = static_cast<unsigned char>(raw[i] ^ raw[i - frame]);
    Bytes planes(raw.size());
    for (std::size_t k = 0; k < sizeof(T); ++k)
      for (std::size_t i = 0; i < values.size(); ++i)
        planes[k * values.size() + i] = raw[i * sizeof(T) + k];
    append(planes.data(), planes.size());
  }

  const Json& notes() const { return notes_; }

  /// zlib's stream in base64.
  std::string packed() const {
    uLongf size = compressBound(bytes_.size());
    Bytes deflated(size);
    if (compress2(deflated.data(), &size, bytes_.data(), bytes_.size(), 6) != Z_OK)
      throw std::runtime_error("the page's data cannot be compressed");
    deflated.resize(size);
    return base64(deflated);
  }

 private:
  void note(const std::string& name, const char* type, std::size_t count,
            std::size_t rows) {
    notes_.push_back(
        {{"name", name}, {"type", type}, {"count", count}, {"rows", rows}});
  }
  void append(const void* data, std::size_t size) {
    const auto* from = static_cast<const unsigned char*>(data);
    bytes_.insert(bytes_.end(), from, from + size);
  }
  static std::string base64(const Bytes& in) {
    constexpr const char* letters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve((in.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < in.size(); i += 3) {
      std::uint32_t word = static_cast<std::uint32_t>(in[i]) << 16;
      if (i + 1 < in.size())
        word |= static_cast<std::uint32_t>(in[i + 1]) << 8;
      if (i + 2 < in.size())
        word |= in[i + 2];
      out += letters[word >> 18];
      out += letters[(word >> 12) & 63];
      out += i + 1 < in.size() ? letters[(word >> 6) & 63] : '=';
      out += i + 2 < in.size() ? letters[word & 63] : '=';
    }
    return out;
  }

  Bytes bytes_;
  Json notes_ = Json::array();
};

/// The map from a block's first arms to the present ones: R(turn) for a rigid block.
struct Shape {
  double first_angle = 0.0;
  Eigen::Matrix2Xd arms;
  Eigen::Matrix2d inverse;  ///< (arms arms^T)^-1
  double extent = 0.0;
};

Eigen::Matrix2Xd arms(const Frame& frame, int b) {
  const auto& outline = frame.outlines[static_cast<std::size_t>(b)];
  Eigen::Matrix2Xd r(2, static_cast<Eigen::Index>(outline.size()));
  for (std::size_t c = 0; c < outline.size(); ++c)
    r.col(static_cast<Eigen::Index>(c)) = outline[c] - frame.centroid.col(b);
  return r;
}

/// One contact force to be drawn.
struct Arrow {
  int corner = 0;               ///< counted through all blocks
  unsigned char direction = 0;  ///< of 256 in a turn, from x to y
  double size = 0.0;
};

void put_varint(Bytes& bytes, unsigned value) {
  for (; value > 127; value >>= 7)
    bytes.push_back(static_cast<unsigned char>(value | 128));
  bytes.push_back(static_cast<unsigned char>(value));
}

class Packer {
 public:
  Packer(const ResultsReader& results, long every) : results_(results) {
    for (long i = 0; i < results.frames(); ++i)
      if (i % every == 0 || i + 1 == results.frames())
        chosen_.push_back(i);
    last_ = results.frame(results.frames() - 1);
    blocks_ = static_cast<std::size_t>(last_.size());
    first_corner_.push_back(0);
    for (const auto& outline : last_.outlines)
      first_corner_.push_back(first_corner_.back() + static_cast<int>(outline.size()));
  }

  ViewData pack(const std::optional<Units>& units) {
    for (const char* name : shown)
      kinds_.push_back(find_quantity(name));
    columns_.resize(kinds_.size());
    const Frame first = results_.frame(0);
    for (const long i : chosen_)
      take(results_.frame(i), first, results_.contacts(i));

    Store store;
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
    store.add("origin", "f64", origin);  // eight bytes first: arrays stay aligned
    store.add("arm", "f32", arm);
    store.add("angle", "f32", angle);
    for (std::size_t k = 0; k < kinds_.size(); ++k)
      store.add_frames(kinds_[k]->name, "f32", std::move(columns_[k]), blocks_);
    if (strained_)
      store.add_frames("strain", "f32", std::move(strain_), 4 * blocks_);
    store.add("corners", "u16", corners);
    store.add_frames("fixed", "u8", std::move(fixed_), blocks_);
    store.add("contacts", "u8", contact_bytes());
    return {meta(store, units), store.packed()};
  }

 private:
  void take(const Frame& now, const Frame& first, const FrameContacts& contacts) {
    times_.push_back(now.time);
    steps_.push_back(now.step);
    counts_.push_back(now.size());
    energy_.push_back(now.kinetic_energy);
    for (std::size_t k = 0; k < kinds_.size(); ++k) {
      const Eigen::VectorXd values = kinds_[k]->values(now, first);
      for (std::size_t b = 0; b < blocks_; ++b)
        columns_[k].push_back(static_cast<int>(b) < now.size()
                                  ? six_digits(values[static_cast<Eigen::Index>(b)])
                                  : 0.0F);
    }
    for (std::size_t b = 0; b < blocks_; ++b) {
      const bool there = static_cast<int>(b) < now.size();
      fixed_.push_back(there && now.fixed[b] != 0 ? 1 : 0);
      const Eigen::Matrix2d map =
          there ? follow(now, first, static_cast<int>(b)) : Eigen::Matrix2d::Identity();
      for (const double value : map.reshaped())
        strain_.push_back(static_cast<float>(value));
    }
    take_contacts(contacts);
  }

  /// The map of the block's arms; notes a new block and strained ones.
  Eigen::Matrix2d follow(const Frame& now, const Frame& first, int b) {
    const Eigen::Matrix2Xd r = arms(now, b);
    if (static_cast<std::size_t>(b) == shapes_.size()) {
      const bool from_first = b < first.size();
      const double none = std::nan("");  // the page takes x and y instead
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
      return rotation;
    strained_ = true;
    const Eigen::Matrix2d map = r * shape.arms.transpose() * shape.inverse;
    if ((r - map * shape.arms).cwiseAbs().maxCoeff() > 1e-4 * shape.extent)
      refuse(now, b);
    return map;
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
      const Eigen::Vector2d n = contacts.normal.col(i), t(n.y(), -n.x());
      const Eigen::Vector2d f =
          n * contacts.normal_force[i] - t * contacts.shear_force[i];
      const double turn = std::atan2(f.y(), f.x()) / (2 * std::numbers::pi);
      arrows.push_back(
          {first_corner_[static_cast<std::size_t>(block)] + contacts.corner[k] - 1,
           static_cast<unsigned char>(std::lround(256 * (turn + 1)) % 256), f.norm()});
      largest_ = std::max(largest_, arrows.back().size);
    }
    std::stable_sort(arrows.begin(), arrows.end(), [](const Arrow& a, const Arrow& b) {
      return a.corner < b.corner;
    });
    arrows_.push_back(std::move(arrows));
  }

  /// Per frame: their number; then of each the step to its corner, its direction and
  /// its size on a logarithmic scale of 255 steps over six decades below the largest.
  Bytes contact_bytes() const {
    Bytes bytes;
    for (const auto& arrows : arrows_) {
      put_varint(bytes, static_cast<unsigned>(arrows.size()));
      int before = 0;
      for (const Arrow& arrow : arrows) {
        put_varint(bytes, static_cast<unsigned>(arrow.corner - before));
        before = arrow.corner;
      }
      for (const Arrow& arrow : arrows)
        bytes.push_back(arrow.direction);
      for (const Arrow& arrow : arrows) {
        const double decades =
            arrow.size > 0.0 ? std::log10(arrow.size / largest_) : -9;
        bytes.push_back(static_cast<unsigned char>(
            std::clamp(std::lround(255 * (1 + decades / 6)), 0L, 255L)));
      }
    }
    return bytes;
  }

  static std::string css(const Colour& c) {
    const auto byte = [](double part) {
      return static_cast<int>(std::lround(255 * std::clamp(part, 0.0, 1.0)));
    };
    return fmt::format("#{:02x}{:02x}{:02x}", byte(c.r), byte(c.g), byte(c.b));
  }

  std::string meta(const Store& store, const std::optional<Units>& units) const {
    Json quantities = Json::array();
    for (const QuantityKind* kind : kinds_)
      quantities.push_back({{"name", kind->name},
                            {"label", kind->label},
                            {"unit", unit_text(kind->dimension, units)},
                            {"signed", kind->is_signed}});
    Json sequential_map = Json::array(), diverging_map = Json::array(),
         materials = Json::object();
    constexpr int shades = 64;
    for (int i = 0; i < shades; ++i) {
      sequential_map.push_back(css(sequential(i / (shades - 1.0))));
      diverging_map.push_back(css(diverging(i / (shades - 1.0))));
    }
    for (const int material : last_.material)
      materials[std::to_string(material)] = css(material_colour(material));
    std::vector<std::size_t> acting;
    for (const auto& arrows : arrows_)
      acting.push_back(arrows.size());
    const Json json = {{"title", results_.title()},
                       {"file", results_.path()},
                       {"blocks", blocks_},
                       {"times", times_},
                       {"steps", steps_},
                       {"counts", counts_},
                       {"material", last_.material},
                       {"materials", materials},
                       {"quantities", quantities},
                       {"sequential", sequential_map},
                       {"diverging", diverging_map},
                       {"kinetic_energy", energy_},
                       {"contacts", acting},
                       {"largest_force", largest_},
                       {"time_unit", unit_text({0, 0, 1, "s", ""}, units)},
                       {"length_unit", unit_text({1, 0, 0, "m", ""}, units)},
                       {"force_unit", unit_text({0, 1, -2, "N/m", ""}, units)},
                       {"energy_unit", unit_text({1, 1, -2, "J/m", ""}, units)},
                       {"arrays", store.notes()}};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
  }

  const ResultsReader& results_;
  std::vector<long> chosen_;
  Frame last_;
  std::size_t blocks_ = 0;
  std::vector<int> first_corner_;
  std::vector<const QuantityKind*> kinds_;
  std::vector<std::vector<float>> columns_;
  std::vector<float> strain_;
  std::vector<unsigned char> fixed_;
  bool strained_ = false;
  std::vector<Shape> shapes_;
  std::vector<Eigen::Vector2d> origin_;
  std::vector<std::vector<Arrow>> arrows_;
  double largest_ = 0.0;
  std::vector<double> times_, energy_;
  std::vector<long> steps_;
  std::vector<int> counts_;
};

}  // namespace

float six_digits(double value) {
  if (value == 0.0 || !std::isfinite(value))
    return static_cast<float>(value);
  std::array<char, 40> text{};
  const auto end = fmt::format_to_n(text.data(), text.size(), "{:.5e}", value).out;
  float nearest = 0.0F;
  std::from_chars(text.data(), end, nearest);
  return std::abs(nearest) < 1e-37F ? 0.0F : nearest;
}

ViewData view_data(const ResultsReader& results, long every,
                   const std::optional<Units>& units) {
  return Packer(results, every).pack(units);
}

}  // namespace blocks::post
