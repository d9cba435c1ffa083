#include "run/profile_table.hpp"

#include <fmt/format.h>

#include <numeric>

namespace blocks::run {

std::vector<std::string> profile_table(const dynamics::Profile& profile, double seconds,
                                       long steps, const Model& model, int threads) {
  using dynamics::Profile;
  std::vector<std::string> lines;
  const auto row = [&](const char* name, double part, const std::string& remark) {
    lines.push_back(fmt::format("  {:<18}{:>10.3f} s {:>6.1f} %   {}", name, part,
                                seconds > 0.0 ? 100.0 * part / seconds : 0.0, remark));
  };
  lines.push_back(
      fmt::format("time spent ({} thread{}):", threads, threads == 1 ? "" : "s"));
  const auto& of = profile.seconds;
  row("blocks", of[Profile::building], "built and checked");
  row("search", of[Profile::search], fmt::format("{} lists", model.search.updates));
  row("contact decisions", of[Profile::decisions], "");
  row("contact forces", of[Profile::forces],
      fmt::format("predicates evaluated in exact arithmetic: {}", profile.exact_calls));
  row("motion", of[Profile::motion], "with loads and planes");
  row("output", of[Profile::output], "with the checkpoint");
  const double told = std::accumulate(of.begin(), of.end(), 0.0);
  row("the rest", std::max(0.0, seconds - told), "terminal, audit");
  const double work = static_cast<double>(steps) * model.blocks.size();
  if (work > 0.0)
    lines.push_back(fmt::format("  {:.0f} ns per block and step, {:.3g} block-steps/s",
                                1e9 * seconds / work, work / seconds));
  return lines;
}

}  // namespace blocks::run
