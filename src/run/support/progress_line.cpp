#include "run/support/progress_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace blocks::run {
namespace {

/// Returns the remaining time, or an empty text if no step has been made.
std::string remaining(const RunProgress& run) {
  return run.share > 0.0 ? duration(run.spent * (1.0 - run.share) / run.share) + " left"
                         : std::string();
}

/// Returns "local ratio 0.0e+00" and the block that has it; empty if it is not known.
std::string local_text(const Balance& balance) {
  if (std::isnan(balance.local))
    return "";
  const std::string text = fmt::format("local ratio {:.1e}", balance.local);
  return balance.block < 0 ? text : text + fmt::format(" block {}", balance.block + 1);
}

/// A part of the line. A part of higher rank is left out first.
struct Part {
  std::string text;
  int rank;
};

}  // namespace

std::string duration(double seconds) {
  const long s = static_cast<long>(seconds + 0.5);
  if (s < 60)
    return fmt::format("{} s", s);
  if (s < 3600)
    return fmt::format("{} min {:02} s", s / 60, s % 60);
  return fmt::format("{} h {:02} min", s / 3600, s / 60 % 60);
}

std::string progress_line(const RunProgress& run, int width) {
  constexpr int widest_bar = 24, narrowest_bar = 10, brackets = 2;
  std::vector<Part> parts = {
      {fmt::format(" step {}", run.steps), 3},
      {fmt::format(" t {:.4g}", run.time), 2},
      {fmt::format(" Ek {:.3g}", run.totals.kinetic_energy), 5},
      {fmt::format(" contacts {}", run.totals.active_contacts), 4}};
  if (const std::string local = local_text(run.balance); !local.empty())
    parts.insert(parts.begin(), {' ' + local, 1});
  if (!std::isnan(run.balance.ratio))
    parts.insert(parts.begin(), {fmt::format(" ratio {:.1e}", run.balance.ratio), 0});
  if (const std::string left = remaining(run); !left.empty())
    parts.push_back({' ' + left, -1});
  const auto space = [&] {  // for the bar
    int used = brackets;
    for (const Part& part : parts)
      used += static_cast<int>(part.text.size());
    return width - used;
  };
  while (!parts.empty() && space() < narrowest_bar)
    parts.erase(
        std::max_element(parts.begin(), parts.end(),
                         [](const Part& a, const Part& b) { return a.rank < b.rank; }));
  const int bar = std::clamp(space(), 0, widest_bar);
  const int filled = static_cast<int>(run.share * bar);
  std::string line = fmt::format("[{:#<{}}{:.<{}}]", "", filled, "", bar - filled);
  for (const Part& part : parts)
    line += part.text;
  return line.substr(0, static_cast<std::size_t>(std::max(width, 0)));
}

std::string log_line(const RunProgress& run) {
  const std::string left = remaining(run);
  std::string ratio;
  if (!std::isnan(run.balance.ratio))
    ratio = fmt::format("ratio {:.1e}, ", run.balance.ratio);
  if (const std::string local = local_text(run.balance); !local.empty())
    ratio += local + ", ";
  return fmt::format("progress {:.0f} %: {}step {}, t {:.4g}, Ek {:.3g}, contacts {}{}",
                     100.0 * run.share, ratio, run.steps, run.time,
                     run.totals.kinetic_energy, run.totals.active_contacts,
                     left.empty() ? "" : ", " + left);
}

}  // namespace blocks::run
