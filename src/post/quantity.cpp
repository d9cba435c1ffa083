#include "post/quantity.hpp"

#include <algorithm>
#include <cctype>
#include <numbers>
#include <set>
#include <stdexcept>

#include "post/model_quantity.hpp"

namespace blocks::post {
namespace {

using Eigen::ArrayXd;
using Eigen::VectorXd;

constexpr Dimension pure{0, 0, 0, "", ""}, length{1, 0, 0, "m", ""},
    area{2, 0, 0, "m²", ""}, velocity{1, 0, -1, "m/s", ""},
    degrees{0, 0, 0, "degrees", "degrees"}, spin{0, 0, -1, "rad/s", "rad"},
    force{0, 1, -2, "N/m", ""}, moment{1, 1, -2, "N m/m", ""},
    stress{-1, 1, -2, "Pa", ""}, rate{0, 0, -1, "1/s", ""}, mass{-1, 1, 0, "kg/m", ""},
    inertia{1, 1, 0, "kg m", ""}, energy{1, 1, -2, "J/m", ""},
    momentum{0, 1, -1, "N s/m", ""}, angular_momentum{1, 1, -1, "N s", ""};

/// Blocks made after the first frame have not moved.
Eigen::Matrix2Xd moved(const Frame& now, const Frame& first) {
  Eigen::Matrix2Xd d = Eigen::Matrix2Xd::Zero(2, now.centroid.cols());
  const auto common = std::min(now.centroid.cols(), first.centroid.cols());
  d.leftCols(common) = now.centroid.leftCols(common) - first.centroid.leftCols(common);
  return d;
}

/// Largest (sign 1) or smallest (-1) principal value.
VectorXd principal(const Eigen::Matrix4Xd& tensor, double sign) {
  const ArrayXd mean = 0.5 * (tensor.row(0) + tensor.row(3)).array();
  const ArrayXd half = 0.5 * (tensor.row(0) - tensor.row(3)).array();
  const ArrayXd shear = tensor.row(1).array();
  return (mean + sign * (half.square() + shear.square()).sqrt()).matrix();
}

/// Computed exactly as in the run, to the last bit.
VectorXd kinetic_energy(const Frame& now) {
  VectorXd values(now.size());
  for (int b = 0; b < now.size(); ++b) {
    const Eigen::Vector2d v = now.velocity.col(b), p = now.mass[b] * v;
    values[b] = 0.5 * (p.dot(v) + now.inertia[b] * now.spin[b] * now.spin[b]);
  }
  return values;
}

VectorXd about_origin(const Frame& now) {
  const ArrayXd x = now.centroid.row(0), y = now.centroid.row(1);
  const ArrayXd vx = now.velocity.row(0), vy = now.velocity.row(1);
  return (now.mass.array() * (x * vy - y * vx) + now.inertia.array() * now.spin.array())
      .matrix();
}

using Values = std::function<VectorXd(const Frame& now, const Frame& first)>;

/// A quantity that is a row of a matrix or a vector of the frame, without further
/// calculation.
Values row(auto Frame::*field, int i) {
  return
      [=](const Frame& now, const Frame&) -> VectorXd { return (now.*field).row(i); };
}
Values column(VectorXd Frame::*field) {
  return [=](const Frame& now, const Frame&) { return now.*field; };
}
Values momentum_along(int i) {
  return [=](const Frame& now, const Frame&) -> VectorXd {
    return now.mass.cwiseProduct(now.velocity.row(i).transpose());
  };
}
Values moved_along(int i) {
  return [=](const Frame& now, const Frame& first) -> VectorXd {
    return moved(now, first).row(i);
  };
}
Values principal_stress(double sign) {
  return [=](const Frame& now, const Frame&) { return principal(now.stress, sign); };
}

}  // namespace

const std::vector<QuantityKind>& quantity_kinds() {
  using F = Frame;
  constexpr bool magnitude = false, is_signed = true, each = false, additive = true;
  static const std::vector<QuantityKind> kinds = {
      {"speed", "", "speed", velocity, magnitude, each,
       [](const F& now, const F&) -> VectorXd {
         return now.velocity.colwise().norm();
       }},
      {"displacement", "", "displacement", length, magnitude, each,
       [](const F& now, const F& first) -> VectorXd {
         return moved(now, first).colwise().norm();
       }},
      {"rotation", "", "rotation", degrees, is_signed, each,
       [](const F& now, const F&) -> VectorXd {
         return now.angle * (180.0 / std::numbers::pi);
       }},
      {"x", "", "x", length, magnitude, each, row(&F::centroid, 0)},
      {"y", "", "y", length, magnitude, each, row(&F::centroid, 1)},
      {"dx", "", "displacement x", length, is_signed, each, moved_along(0)},
      {"dy", "", "displacement y", length, is_signed, each, moved_along(1)},
      {"vx", "VELX", "velocity x", velocity, is_signed, each, row(&F::velocity, 0)},
      {"vy", "VELY", "velocity y", velocity, is_signed, each, row(&F::velocity, 1)},
      {"spin", "TDOT", "spin", spin, is_signed, each, column(&F::spin)},
      {"fx", "FORCEX", "force x", force, is_signed, additive, row(&F::force, 0)},
      {"fy", "FORCEY", "force y", force, is_signed, additive, row(&F::force, 1)},
      {"moment", "MOMENT", "moment", moment, is_signed, each, column(&F::moment)},
      {"s11", "SIGXX", "stress 11", stress, is_signed, each, row(&F::stress, 0)},
      {"s12", "SIGXY", "stress 12", stress, is_signed, each, row(&F::stress, 1)},
      {"s21", "SIGYX", "stress 21", stress, is_signed, each, row(&F::stress, 2)},
      {"s22", "SIGYY", "stress 22", stress, is_signed, each, row(&F::stress, 3)},
      {"p1", "", "principal stress 1", stress, is_signed, each, principal_stress(1)},
      {"p2", "", "principal stress 2", stress, is_signed, each, principal_stress(-1)},
      {"a11", "", "applied stress 11", stress, is_signed, each, row(&F::applied, 0)},
      {"a12", "", "applied stress 12", stress, is_signed, each, row(&F::applied, 1)},
      {"a21", "", "applied stress 21", stress, is_signed, each, row(&F::applied, 2)},
      {"a22", "", "applied stress 22", stress, is_signed, each, row(&F::applied, 3)},
      {"e11", "", "strain rate 11", rate, is_signed, each, row(&F::strain_rate, 0)},
      {"e12", "", "strain rate 12", rate, is_signed, each, row(&F::strain_rate, 1)},
      {"e22", "", "strain rate 22", rate, is_signed, each, row(&F::strain_rate, 3)},
      {"kinetic_energy", "", "kinetic energy", energy, magnitude, additive,
       [](const F& now, const F&) { return kinetic_energy(now); }},
      {"momentum_x", "", "momentum x", momentum, is_signed, additive,
       momentum_along(0)},
      {"momentum_y", "", "momentum y", momentum, is_signed, additive,
       momentum_along(1)},
      {"angular_momentum", "", "angular momentum", angular_momentum, is_signed,
       additive, [](const F& now, const F&) { return about_origin(now); }},
      {"mass", "", "mass", mass, magnitude, additive, column(&F::mass)},
      {"area", "", "area", area, magnitude, additive, column(&F::area)},
      {"inertia", "", "moment of inertia", inertia, magnitude, each,
       column(&F::inertia)}};
  return kinds;
}

namespace {

Zero zero_of(const QuantityKind& kind) {
  static const std::set<std::string> magnitudes = {"speed", "displacement",
                                                   "kinetic_energy"};
  return kind.is_signed                   ? Zero::middle
         : magnitudes.contains(kind.name) ? Zero::lowest
                                          : Zero::none;
}

bool is_stress(const QuantityKind& kind) {
  return kind.label.find("stress") != std::string::npos;
}

}  // namespace

std::string sign_convention(const QuantityKind& kind, bool compression_positive) {
  if (!is_stress(kind))
    return "";
  return compression_positive ? ", compression positive" : ", tension positive";
}

bool is_internal_stress(const QuantityKind& kind) {
  return is_stress(kind) && !kind.label.starts_with("applied");
}

const QuantityKind* find_quantity(const std::string& name) {
  const auto upper = [](std::string text) {
    for (char& c : text)
      c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
  };
  const std::string wanted = upper(name);
  if (wanted == "TOUT")  // misprint in Table F.1
    return find_quantity("TDOT");
  for (const QuantityKind& kind : quantity_kinds())
    if (wanted == upper(kind.name) || (!wanted.empty() && wanted == kind.report_name))
      return &kind;
  return nullptr;
}

std::string quantity_names() {
  std::string names;
  for (const QuantityKind& kind : quantity_kinds())
    names += (names.empty() ? "" : ", ") + kind.name;
  return names;
}

std::string block_quantity_names() {
  std::string names = quantity_names();
  for (const auto& [name, kind] : other_kinds())
    if (kind.rows)
      names += ", " + name;
  return names;
}

bool is_odd(const std::string& name) {
  static const std::set<std::string> odd = {
      "dx",  "vx",  "fx",  "momentum_x", "rotation",        "spin", "moment", "s12",
      "s21", "a12", "a21", "e12",        "angular_momentum"};
  const QuantityKind* kind = find_quantity(name);
  return kind && odd.contains(kind->name);
}

Eigen::VectorXd in_mirror(const std::string& name, const Eigen::VectorXd& values,
                          double plane) {
  const QuantityKind* kind = find_quantity(name);
  if (kind && kind->name == "x")
    return 2.0 * plane - values.array();
  return is_odd(name) ? Eigen::VectorXd(-values) : values;
}

Quantity quantity(const std::string& name, const Frame& now, const Frame& first,
                  const FrameContacts& contacts) {
  if (const QuantityKind* kind = find_quantity(name))
    return {kind->label + sign_convention(*kind, now.compression_positive),
            kind->dimension, kind->values(now, first), zero_of(*kind)};
  if (const OtherKind* kind = find_other(name); kind && kind->rows)
    return {kind->label, kind->dimension, per_block(*kind, contacts, now.size()),
            Zero::lowest};
  throw std::runtime_error("there is no quantity '" + name + "': choose material, " +
                           block_quantity_names());
}

}  // namespace blocks::post
