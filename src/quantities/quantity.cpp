#include "quantities/quantity.hpp"

#include <cctype>
#include <cmath>
#include <limits>
#include <numbers>

namespace blocks::quantities {

double principal(const Eigen::Vector4d& tensor, double sign) {
  const double mean = 0.5 * (tensor[0] + tensor[3]),
               half = 0.5 * (tensor[0] - tensor[3]);
  return mean + sign * std::sqrt(half * half + tensor[1] * tensor[1]);
}

namespace {

constexpr Dimension pure{}, length{1, 0, 0, "m", ""}, area{2, 0, 0, "m²", ""},
    velocity{1, 0, -1, "m/s", ""}, degrees{0, 0, 0, "degrees", "degrees"},
    spin{0, 0, -1, "rad/s", "rad"}, force{0, 1, -2, "N/m", ""},
    moment{1, 1, -2, "N m/m", ""}, stress{-1, 1, -2, "Pa", ""},
    rate{0, 0, -1, "1/s", ""}, mass{-1, 1, 0, "kg/m", ""}, inertia{1, 1, 0, "kg m", ""},
    energy{1, 1, -2, "J/m", ""}, momentum{0, 1, -1, "N s/m", ""},
    angular_momentum{1, 1, -1, "N s", ""};

Eigen::Vector2d moved(const BlockStates& now, const Positions& first, int b) {
  if (b >= first.centroid.cols())
    return Eigen::Vector2d::Zero();
  return now.centroid.col(b) - first.centroid.col(b);
}

/// Computed exactly as in the totals of the model, to the last bit. Driven blocks have
/// no finite mass.
double kinetic_energy(const BlockStates& now, int b) {
  if (!now.is_free(b))
    return 0.0;
  const Eigen::Vector2d v = now.velocity.col(b), p = now.mass[b] * v;
  return 0.5 * (p.dot(v) + now.inertia[b] * now.spin[b] * now.spin[b]);
}

double about_origin(const BlockStates& now, int b) {
  const Eigen::Vector2d at = now.centroid.col(b), v = now.velocity.col(b);
  return now.mass[b] * (at.x() * v.y() - at.y() * v.x()) + now.inertia[b] * now.spin[b];
}

using Value = std::function<double(const BlockStates&, const Positions&, int)>;

/// A quantity that does not depend on the first frame: quantity(now, b).
template <class Quantity> Value of_now(Quantity quantity) {
  return [quantity](const BlockStates& now, const Positions&, int b) {
    return quantity(now, b);
  };
}

}  // namespace

const std::vector<QuantityKind>& quantity_kinds() {
  using B = BlockStates;
  constexpr bool magnitude = false, is_signed = true, each = false, additive = true;
  const auto stress_row = [](int i) {
    return of_now([i](const B& now, int b) { return now.stress(i, b); });
  };
  const auto applied_row = [](int i) {
    return of_now([i](const B& now, int b) { return now.applied(i, b); });
  };
  const auto rate_row = [](int i) {
    return of_now([i](const B& now, int b) { return now.strain_rate(i, b); });
  };
  const auto moved_along = [](int i) -> Value {
    return [i](const B& now, const Positions& first, int b) {
      return moved(now, first, b)[i];
    };
  };
  const auto principal_stress = [](double sign) {
    return of_now(
        [sign](const B& now, int b) { return principal(now.stress.col(b), sign); });
  };
  const auto of_water = [](int i) {
    return of_now([i](const B& now, int b) {
      return now.water == nullptr ? 0.0 : (*now.water)(i, b);
    });
  };
  static const std::vector<QuantityKind> kinds = {
      {"speed", "", "speed", velocity, magnitude, each,
       of_now([](const B& now, int b) { return now.velocity.col(b).norm(); })},
      {"displacement", "", "displacement", length, magnitude, each,
       [](const B& now, const Positions& first, int b) {
         return moved(now, first, b).norm();
       }},
      {"rotation", "", "rotation", degrees, is_signed, each,
       of_now([](const B& now, int b) {
         return now.angle[b] * (180.0 / std::numbers::pi);
       })},
      {"x", "", "x", length, magnitude, each,
       of_now([](const B& now, int b) { return now.centroid(0, b); })},
      {"y", "", "y", length, magnitude, each,
       of_now([](const B& now, int b) { return now.centroid(1, b); })},
      {"dx", "", "displacement x", length, is_signed, each, moved_along(0)},
      {"dy", "", "displacement y", length, is_signed, each, moved_along(1)},
      {"vx", "VELX", "velocity x", velocity, is_signed, each,
       of_now([](const B& now, int b) { return now.velocity(0, b); })},
      {"vy", "VELY", "velocity y", velocity, is_signed, each,
       of_now([](const B& now, int b) { return now.velocity(1, b); })},
      {"spin", "TDOT", "spin", spin, is_signed, each,
       of_now([](const B& now, int b) { return now.spin[b]; })},
      {"fx", "FORCEX", "force x", force, is_signed, additive,
       of_now([](const B& now, int b) { return now.force(0, b); })},
      {"fy", "FORCEY", "force y", force, is_signed, additive,
       of_now([](const B& now, int b) { return now.force(1, b); })},
      {"moment", "MOMENT", "moment", moment, is_signed, each,
       of_now([](const B& now, int b) { return now.moment[b]; })},
      {"s11", "SIGXX", "stress 11", stress, is_signed, each, stress_row(0)},
      {"s12", "SIGXY", "stress 12", stress, is_signed, each, stress_row(1)},
      {"s21", "SIGYX", "stress 21", stress, is_signed, each, stress_row(2)},
      {"s22", "SIGYY", "stress 22", stress, is_signed, each, stress_row(3)},
      {"p1", "", "principal stress 1", stress, is_signed, each, principal_stress(1)},
      {"p2", "", "principal stress 2", stress, is_signed, each, principal_stress(-1)},
      {"a11", "", "applied stress 11", stress, is_signed, each, applied_row(0)},
      {"a12", "", "applied stress 12", stress, is_signed, each, applied_row(1)},
      {"a21", "", "applied stress 21", stress, is_signed, each, applied_row(2)},
      {"a22", "", "applied stress 22", stress, is_signed, each, applied_row(3)},
      {"e11", "", "strain rate 11", rate, is_signed, each, rate_row(0)},
      {"e12", "", "strain rate 12", rate, is_signed, each, rate_row(1)},
      {"e22", "", "strain rate 22", rate, is_signed, each, rate_row(3)},
      {"unbalanced", "", "unbalanced force", force, magnitude, additive,
       of_now([](const B& now, int b) {
         return now.unbalanced == nullptr ? std::numeric_limits<double>::quiet_NaN()
                                          : (*now.unbalanced)[b];
       })},
      {"local_ratio", "", "local ratio", pure, magnitude, each,
       of_now([](const B& now, int b) {
         return now.local_ratio == nullptr ? std::numeric_limits<double>::quiet_NaN()
                                           : (*now.local_ratio)[b];
       })},
      {"water_x", "", "force of water x", force, is_signed, additive, of_water(0)},
      {"water_y", "", "force of water y", force, is_signed, additive, of_water(1)},
      {"kinetic_energy", "", "kinetic energy", energy, magnitude, additive,
       of_now(kinetic_energy)},
      {"momentum_x", "", "momentum x", momentum, is_signed, additive,
       of_now([](const B& now, int b) { return now.mass[b] * now.velocity(0, b); })},
      {"momentum_y", "", "momentum y", momentum, is_signed, additive,
       of_now([](const B& now, int b) { return now.mass[b] * now.velocity(1, b); })},
      {"angular_momentum", "", "angular momentum", angular_momentum, is_signed,
       additive, of_now(about_origin)},
      {"mass", "", "mass", mass, magnitude, additive,
       of_now([](const B& now, int b) { return now.mass[b]; })},
      {"area", "", "area", area, magnitude, additive,
       of_now([](const B& now, int b) { return now.area[b]; })},
      {"inertia", "", "moment of inertia", inertia, magnitude, each,
       of_now([](const B& now, int b) { return now.inertia[b]; })}};
  return kinds;
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
  if (wanted == "KE")
    return find_quantity("kinetic_energy");
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

bool is_of_equilibrium(const std::string& name) {
  return name == "unbalanced" || name == ratio_name || is_of_local_ratio(name);
}

bool is_of_water(const std::string& name) {
  return name == "water_x" || name == "water_y";
}

bool is_of_local_ratio(const std::string& name) {
  return name == "local_ratio" || name == largest_local_name;
}

bool is_stress(const QuantityKind& kind) {
  return kind.label.find("stress") != std::string::npos;
}

}  // namespace blocks::quantities
