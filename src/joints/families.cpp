#include "joints/families.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "joints/family_merging.hpp"
#include "joints/von_mises.hpp"

namespace blocks::joints {
namespace {

constexpr double pi = std::numbers::pi;

/// A component in the doubled angle.
struct Component {
  double mean = 0.0, kappa = 1.0, weight = 1.0;

  /// The logarithm of the factor of exp(kappa (cos - 1)), with the weight.
  double log_factor() const {
    return std::log(weight / (2.0 * pi)) - log_scaled_i0(kappa);
  }
  double log_shape(double angle) const {
    return kappa * (std::cos(angle - mean) - 1.0);
  }
  /// The same as log_shape without a cosine.
  struct Turned {
    double kappa, x, y;
    double log_shape(double cosine, double sine) const {
      return kappa * (cosine * x + sine * y - 1.0);
    }
  };
  Turned turned() const { return {kappa, std::cos(mean), std::sin(mean)}; }
};

class Expectation {
 public:
  explicit Expectation(const std::vector<double>& degrees) {
    for (const double one : degrees) {
      angles_.push_back(2.0 * one * pi / 180.0);
      cosines_.push_back(std::cos(angles_.back()));
      sines_.push_back(std::sin(angles_.back()));
    }
  }

  /// Improves the components until the likelihood hardly grows.
  double improve(std::vector<Component>& components) {
    constexpr int max_rounds = 500;
    constexpr double enough = 1e-6;  // relative to the number of directions
    double last = -HUGE_VAL;
    for (int round = 0; round < max_rounds; ++round) {
      const double now = expect(components);
      if (now - last < enough * static_cast<double>(angles_.size()))
        break;
      last = now;
      maximise(components);
    }
    return expect(components);
  }

  /// Fills the probabilities of membership; returns the log likelihood.
  double expect(const std::vector<Component>& components) {
    const std::size_t k = components.size();
    probability_.resize(angles_.size() * k);
    std::vector<double> factors;
    std::vector<Component::Turned> turned;
    for (const Component& one : components) {
      factors.push_back(one.log_factor());
      turned.push_back(one.turned());
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < angles_.size(); ++i) {
      double* const p = probability_.data() + i * k;
      double max = -HUGE_VAL;
      for (std::size_t c = 0; c < k; ++c) {
        p[c] = factors[c] + turned[c].log_shape(cosines_[i], sines_[i]);
        max = std::max(max, p[c]);
      }
      double total = 0.0;
      for (std::size_t c = 0; c < k; ++c)
        total += p[c] = std::exp(p[c] - max);
      for (std::size_t c = 0; c < k; ++c)
        p[c] /= total;
      sum += max + std::log(total);
    }
    return sum;
  }

  int member(std::size_t i, std::size_t k) const {
    const double* const p = probability_.data() + i * k;
    return static_cast<int>(std::max_element(p, p + k) - p);
  }
  const std::vector<double>& angles() const { return angles_; }

  /// Where the directions are most numerous compared with the mixture.
  double min_explained(const std::vector<Component>& components) const {
    constexpr int places = 90;
    constexpr double width = 2.0 * pi / places;
    std::array<double, places> seen{};
    for (const double angle : angles_) {
      const double turn = angle / (2.0 * pi);
      const double place = (turn - std::floor(turn)) * places;
      seen[static_cast<std::size_t>(place) % places] +=
          1.0 / static_cast<double>(angles_.size());
    }
    int best = 0;
    double max = -HUGE_VAL;
    for (int k = 0; k < places; ++k) {
      double excess = 0.0;
      for (int near = -2; near <= 2; ++near) {
        const int at = (k + near + places) % places;
        double density = 0.0;
        for (const Component& one : components)
          density += std::exp(one.log_factor() + one.log_shape((at + 0.5) * width));
        excess += seen[static_cast<std::size_t>(at)] - density * width;
      }
      if (excess > max)
        max = excess, best = k;
    }
    return (best + 0.5) * width;
  }

 private:
  void maximise(std::vector<Component>& components) {
    const std::size_t k = components.size();
    for (std::size_t c = 0; c < k; ++c) {
      double weight = 0.0, x = 0.0, y = 0.0;
      for (std::size_t i = 0; i < angles_.size(); ++i) {
        const double p = probability_[i * k + c];
        weight += p;
        x += p * cosines_[i];
        y += p * sines_[i];
      }
      constexpr double min_weight = 1e-9;  // an empty component stays where it is
      components[c].weight =
          std::max(weight / static_cast<double>(angles_.size()), min_weight);
      if (weight > min_weight) {
        components[c].mean = std::atan2(y, x);
        components[c].kappa = kappa_of(std::hypot(x, y) / weight);
      }
    }
  }

  std::vector<double> angles_, cosines_, sines_;
  std::vector<double> probability_;  ///< of each direction and component
};

/// Adds a component to a mixture. It begins where the mixture explains least, with
/// several concentrations; another start has evenly spaced components. The best counts.
std::vector<Component> with_one_more(Expectation& all,
                                     const std::vector<Component>& fewer) {
  const std::size_t k = fewer.size() + 1;
  std::vector<Component> best;
  double max = -HUGE_VAL;
  const auto attempt = [&](std::vector<Component> start) {
    const double now = all.improve(start);
    if (now > max)
      max = now, best = std::move(start);
  };
  if (k > 1) {
    constexpr double part = 0.2;
    const double place = all.min_explained(fewer);
    for (const double kappa : {2.0, 20.0, 200.0}) {
      std::vector<Component> start = fewer;
      for (Component& one : start)
        one.weight *= 1.0 - part;
      start.push_back({place, kappa, part});
      attempt(std::move(start));
    }
  }
  std::vector<Component> even;
  for (std::size_t c = 0; c < k; ++c)
    even.push_back({2.0 * pi * static_cast<double>(c) / static_cast<double>(k), 4.0,
                    1.0 / static_cast<double>(k)});
  attempt(std::move(even));
  return best;
}

double degrees_of(double doubled) {
  double degrees = 0.5 * doubled * 180.0 / pi;
  degrees -= 180.0 * std::floor(degrees / 180.0);
  return degrees < 180.0 ? degrees : 0.0;
}

Mixture mixture_of(Expectation& all, const std::vector<Component>& components) {
  const auto n = static_cast<double>(all.angles().size());
  const std::size_t k = components.size();
  Mixture mixture;
  mixture.log_likelihood = k == 0 ? -n * std::log(2.0 * pi) : all.expect(components);
  const double parameters = k == 0 ? 0.0 : 3.0 * static_cast<double>(k) - 1.0;
  mixture.bic = parameters * std::log(std::max(n, 1.0)) - 2.0 * mixture.log_likelihood;
  mixture.components = static_cast<int>(k);
  std::vector<std::size_t> order(k);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return degrees_of(components[a].mean) < degrees_of(components[b].mean);
  });
  std::vector<int> place(k);
  for (std::size_t c = 0; c < k; ++c) {
    const Component& one = components[order[c]];
    mixture.families.push_back({degrees_of(one.mean), one.kappa, one.weight});
    place[order[c]] = static_cast<int>(c);
  }
  for (std::size_t i = 0; i < all.angles().size(); ++i)
    mixture.member.push_back(
        k == 0 ? -1 : place[static_cast<std::size_t>(all.member(i, k))]);
  return mixture;
}

/// Joins components, and describes the families by their members.
Mixture joined(Mixture mixture, const std::vector<double>& degrees) {
  for (int& member : mixture.member)
    if (member >= 0 &&
        mean_resultant(mixture.families[static_cast<std::size_t>(member)].kappa) <
            min_resultant)
      member = -1;
  mixture.member = merge_families(degrees, std::move(mixture.member));
  mixture.families.clear();
  std::vector<double> n, x, y;
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    if (mixture.member[i] < 0)
      continue;
    const auto k = static_cast<std::size_t>(mixture.member[i]);
    if (k >= n.size())
      n.resize(k + 1), x.resize(k + 1), y.resize(k + 1);
    n[k] += 1.0;
    x[k] += std::cos(degrees[i] * pi / 90.0);
    y[k] += std::sin(degrees[i] * pi / 90.0);
  }
  std::vector<Family> families(n.size());
  std::vector<std::size_t> order(n.size());
  for (std::size_t k = 0; k < n.size(); ++k) {
    families[k] = {degrees_of(std::atan2(y[k], x[k])),
                   kappa_of(std::hypot(x[k], y[k]) / n[k]),
                   n[k] / static_cast<double>(degrees.size())};
    order[k] = k;
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return families[a].mean < families[b].mean;
  });
  std::vector<int> place(n.size());
  for (std::size_t k = 0; k < n.size(); ++k) {
    place[order[k]] = static_cast<int>(k);
    mixture.families.push_back(families[order[k]]);
  }
  for (int& member : mixture.member)
    if (member >= 0)
      member = place[static_cast<std::size_t>(member)];
  return mixture;
}

}  // namespace

Mixture find_families(const std::vector<double>& degrees, int max) {
  Expectation all(degrees);
  std::vector<Component> components;
  Mixture best = mixture_of(all, components);
  // Three numbers describe a component, so it needs more directions than that. Two
  // components more that do not help end the search.
  constexpr std::size_t fewest = 4;
  for (int k = 1; k <= std::min(max, best.components + 2) &&
                  degrees.size() >= fewest * static_cast<std::size_t>(k);
       ++k) {
    components = with_one_more(all, components);
    if (Mixture one = mixture_of(all, components); one.bic < best.bic)
      best = std::move(one);
  }
  return joined(std::move(best), degrees);
}

}  // namespace blocks::joints
