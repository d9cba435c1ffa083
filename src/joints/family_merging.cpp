#include "joints/family_merging.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace blocks::joints {
namespace {

constexpr double pi = std::numbers::pi;

double log_factorial(std::size_t n) {
  return std::lgamma(static_cast<double>(n) + 1.0);
}

/// Returns the directions of two groups, as differences from their mean axis.
std::vector<double> differences(const std::vector<double>& degrees,
                                const std::vector<int>& member, int a, int b) {
  double x = 0.0, y = 0.0;
  for (std::size_t i = 0; i < degrees.size(); ++i)
    if (member[i] == a || member[i] == b) {
      x += std::cos(degrees[i] * pi / 90.0);
      y += std::sin(degrees[i] * pi / 90.0);
    }
  const double mean = std::atan2(y, x) * 90.0 / pi;
  std::vector<double> off;
  for (std::size_t i = 0; i < degrees.size(); ++i)
    if (member[i] == a || member[i] == b) {
      const double one = degrees[i] - mean;
      off.push_back(one - 180.0 * std::round(one / 180.0));
    }
  return off;
}

}  // namespace

double family_evidence(const std::vector<double>& off) {
  const auto n = static_cast<double>(off.size());
  if (off.size() < 3)
    return -n * std::log(180.0);
  constexpr double finest = 0.01;  // degrees; directions are not known better
  double mean = 0.0, squares = 0.0, min = off[0], max = off[0];
  for (const double one : off) {
    mean += one / n;
    min = std::min(min, one), max = std::max(max, one);
  }
  for (const double one : off)
    squares += (one - mean) * (one - mean);
  const double range = std::max(max - min, finest);
  squares = std::max(squares, n * finest * finest);
  const double log_prior = -std::log(180.0 * 90.0);
  const double uniform =
      -(n - 2.0) * std::log(range) - std::log(2.0 * (n - 1.0) * (n - 2.0));
  const double normal = -0.5 * (n - 1.0) * std::log(2.0 * pi) - 0.5 * std::log(n) +
                        0.5 * (n - 4.0) * std::log(2.0) + std::lgamma(0.5 * (n - 2.0)) -
                        0.5 * (n - 2.0) * std::log(squares);
  return log_prior + std::max(uniform, normal);
}

std::vector<int> merge_families(const std::vector<double>& degrees,
                                std::vector<int> member) {
  const auto groups_of = [&] {
    std::set<int> groups(member.begin(), member.end());
    groups.erase(-1);
    return groups;
  };
  for (;;) {
    const std::set<int> groups = groups_of();
    double max = 0.0;
    int keep = -1, join = -1;
    for (const int a : groups)
      for (const int b : groups) {
        if (a >= b)
          continue;
        const auto one = differences(degrees, member, a, a);
        const auto other = differences(degrees, member, b, b);
        const double apart = family_evidence(one) + family_evidence(other) +
                             log_factorial(one.size()) + log_factorial(other.size()) -
                             log_factorial(one.size() + other.size() + 1);
        const double gain = family_evidence(differences(degrees, member, a, b)) - apart;
        if (gain > max)
          max = gain, keep = a, join = b;
      }
    if (keep < 0)
      break;
    std::replace(member.begin(), member.end(), join, keep);
  }
  const std::set<int> groups = groups_of();
  for (int& one : member)
    if (one >= 0)
      one = static_cast<int>(std::distance(groups.begin(), groups.find(one)));
  return member;
}

}  // namespace blocks::joints
