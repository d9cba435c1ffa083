#include "quantities/statistic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace blocks::quantities {
namespace {

using How = Statistic::How;

const std::map<std::string, How> names = {{"sum", How::sum},
                                          {"mean", How::mean},
                                          {"min", How::smallest},
                                          {"max", How::largest}};

double percentile(double percent, std::span<double> values) {
  const double at = percent / 100.0 * static_cast<double>(values.size() - 1);
  const auto low = static_cast<std::size_t>(at);
  const auto low_at = values.begin() + static_cast<std::ptrdiff_t>(low);
  std::nth_element(values.begin(), low_at, values.end());
  if (low + 1 == values.size())
    return *low_at;
  return std::lerp(*low_at, *std::min_element(low_at + 1, values.end()),
                   at - static_cast<double>(low));
}

}  // namespace

std::string Statistic::name() const {
  for (const auto& [name, its_how] : names)
    if (its_how == how)
      return name;
  return fmt::format("p{}", percent);
}

bool Statistic::parse(const std::string& given, Statistic& statistic) {
  std::string text = given;
  for (char& c : text)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (const auto found = names.find(text); found != names.end()) {
    statistic = {found->second};
    return true;
  }
  constexpr std::size_t longest = 12;  // p99.99999999
  if (text.size() < 2 || text.size() > longest || text[0] != 'p' ||
      text.find_first_not_of("0123456789.", 1) != std::string::npos ||
      std::count(text.begin(), text.end(), '.') > 1 || text == "p.")
    return false;
  const double percent = std::stod(text.substr(1));
  statistic = {How::percentile, percent};
  return percent <= 100.0;
}

double reduce(const Statistic& statistic, std::span<double> values) {
  if (std::any_of(values.begin(), values.end(), [](double x) { return std::isnan(x); }))
    return std::numeric_limits<double>::quiet_NaN();
  switch (statistic.how) {
  case How::sum:
    return std::accumulate(values.begin(), values.end(), 0.0);
  case How::mean:
    return std::accumulate(values.begin(), values.end(), 0.0) /
           static_cast<double>(values.size());
  case How::smallest:
    return *std::min_element(values.begin(), values.end());
  case How::largest:
    return *std::max_element(values.begin(), values.end());
  case How::percentile:
    break;
  }
  return percentile(statistic.percent, values);
}

}  // namespace blocks::quantities
