#include "run/reports/profile_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace blocks::run {

std::vector<std::string> profile_table(const dynamics::Profile& profile, double seconds,
                                       long steps, const Model& model, int threads) {
  using dynamics::Profile;
  std::vector<std::string> lines;
  const auto percent = [](double part, double whole) {
    return whole > 0.0 ? 100.0 * part / whole : 0.0;
  };
  const auto row = [&](const char* name, double part, const std::string& serial,
                       const std::string& remark) {
    lines.push_back(fmt::format("  {:<18}{:>10.3f} s {:>6.1f} % {:>8}   {}", name, part,
                                percent(part, seconds), serial, remark));
  };
  double of_steps = 0.0, serial_of_steps = 0.0;
  const auto call = [&](const char* name, Profile::Phase phase,
                        const std::string& remark) {
    const double part = profile.seconds[phase],
                 serial = std::max(0.0, part - profile.shared[phase]);
    of_steps += part, serial_of_steps += serial;
    row(name, part, fmt::format("{:.1f} %", percent(serial, part)), remark);
  };
  const std::string title =
      fmt::format("time spent ({} thread{}):", threads, threads == 1 ? "" : "s");
  lines.push_back(fmt::format("{:<32}{:>9}{:>9}", title, "share", "serial"));
  const auto& phase_seconds = profile.seconds;
  row("blocks", phase_seconds[Profile::building], "", "built and checked");
  call("search", Profile::search, fmt::format("{} lists", model.search.updates));
  call("contact decisions", Profile::decisions, "");
  call(
      "contact forces", Profile::forces,
      fmt::format("predicates evaluated in exact arithmetic: {}", profile.exact_calls));
  call("motion", Profile::motion, "with loads and planes");
  row("output", phase_seconds[Profile::output], "", "with the checkpoint");
  const double listed =
      std::accumulate(phase_seconds.begin(), phase_seconds.end(), 0.0);
  row("the rest", std::max(0.0, seconds - listed), "", "terminal, audit");
  lines.push_back(fmt::format(
      "  serial, so one thread works and others would wait: {:.1f} % of the steps",
      percent(serial_of_steps, of_steps)));
  const double work = static_cast<double>(steps) * model.blocks.size();
  if (work > 0.0)
    lines.push_back(fmt::format("  {:.0f} ns per block and step, {:.3g} block-steps/s",
                                1e9 * seconds / work, work / seconds));
  return lines;
}

}  // namespace blocks::run
