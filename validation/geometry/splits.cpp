// Cuts many random blocks along random and awkward lines, judges each result by brute
// force and writes the table of faults: ./go validate splits.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <iostream>
#include <sstream>
#include <thread>
#include <vector>

#include "geometry/polygon.hpp"
#include "validation/geometry/split_cases.hpp"
#include "validation/geometry/split_judge.hpp"

namespace blocks::validation {
namespace {

using geometry::Split;
using geometry::SplitFault;
using Clock = std::chrono::steady_clock;

struct SplitTally {
  long blocks = 0, re_entrant = 0, moved = 0;
  std::array<long, 4> faults = {};  ///< results for each SplitFault
  long not_moved = 0;               ///< unsound, although no end has moved
  long below = 0;        ///< pieces smaller than the least area, by the judge
  long wrong = 0;        ///< results that the judge refuses
  long thrown = 0;       ///< exceptions
  double seconds = 0.0;  ///< in split_outline
  std::vector<std::string> failed;  ///< numbers and what is wrong

  void add(const SplitTally& other) {
    blocks += other.blocks;
    re_entrant += other.re_entrant;
    moved += other.moved;
    for (std::size_t i = 0; i < faults.size(); ++i)
      faults[i] += other.faults[i];
    not_moved += other.not_moved;
    below += other.below;
    wrong += other.wrong;
    thrown += other.thrown;
    seconds += other.seconds;
    failed.insert(failed.end(), other.failed.begin(), other.failed.end());
  }
};

// Returns the processor time of this thread.
double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void examine(std::size_t family, std::uint64_t number, SplitTally& tally) {
  const SplitCase k = make_split_case(family, number);
  ++tally.blocks;
  tally.re_entrant += geometry::check_outline(k.outline).convex ? 0 : 1;
  try {
    const double start = processor_seconds();
    const Split split = geometry::split_outline(k.outline, k.line, k.min_area);
    tally.seconds += processor_seconds() - start;
    ++tally.faults[static_cast<std::size_t>(split.fault)];
    if (split.fault == SplitFault::none)
      for (const auto& end : split.ends)
        tally.moved += end.moved > 0.0 ? 1 : 0;
    if (split.fault == SplitFault::unsound)
      tally.not_moved += split.ends[0].moved + split.ends[1].moved > 0.0 ? 0 : 1;
    const std::string fault = judge_split(k.outline, k.line, k.min_area, split);
    tally.below += fault == piece_too_small ? 1 : 0;
    if (!fault.empty()) {
      ++tally.wrong;
      tally.failed.push_back(std::to_string(number) + " (" + fault + ")");
    }
  } catch (const std::exception& error) {
    ++tally.thrown;
    tally.failed.push_back(std::to_string(number) + " (" + error.what() + ")");
  }
}

struct SplitRun {
  std::vector<SplitTally> families;
  double seconds = 0.0;
  int threads = 1;
};

SplitRun run_all(long blocks, int threads) {
  const auto start = Clock::now();
  struct Item {
    std::size_t family;
    std::uint64_t number;
  };
  const auto families = split_families();
  std::vector<Item> work;
  for (std::size_t f = 0; f < families.size(); ++f)
    for (long i = 0; i < std::max(1L, blocks * families[f].weight / 100); ++i)
      work.push_back({f, static_cast<std::uint64_t>(i)});
  std::atomic<std::size_t> next = 0;
  std::vector<std::vector<SplitTally>> parts(static_cast<std::size_t>(threads),
                                             std::vector<SplitTally>(families.size()));
  std::vector<std::thread> workers;
  for (auto& part : parts)
    workers.emplace_back([&] {
      for (std::size_t i = next++; i < work.size(); i = next++)
        examine(work[i].family, work[i].number, part[work[i].family]);
    });
  for (auto& worker : workers)
    worker.join();
  SplitRun run;
  run.threads = threads;
  run.families.resize(families.size());
  for (const auto& part : parts)
    for (std::size_t f = 0; f < part.size(); ++f)
      run.families[f].add(part[f]);
  run.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return run;
}

std::string markdown(const SplitRun& run) {
  std::ostringstream out;
  SplitTally all;
  for (const SplitTally& tally : run.families)
    all.add(tally);
  out << "| lines | blocks | re-entrant | cut | ends moved | no chord | small | "
         "unsound | not moved | wrong | below amin | exceptions |\n"
         "|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  const auto row = [&out](std::string_view name, const SplitTally& t) {
    out << "| " << name;
    for (const long count :
         {t.blocks, t.re_entrant, t.faults[0], t.moved, t.faults[1], t.faults[2],
          t.faults[3], t.not_moved, t.wrong, t.below, t.thrown})
      out << " | " << count;
    out << " |\n";
  };
  for (std::size_t f = 0; f < run.families.size(); ++f)
    row(split_families()[f].name, run.families[f]);
  row("**all**", all);
  for (std::size_t f = 0; f < run.families.size(); ++f)
    for (std::size_t k = 0; k < std::min<std::size_t>(run.families[f].failed.size(), 8);
         ++k)
      out << "\nFailure: " << split_families()[f].name << ':'
          << run.families[f].failed[k] << '\n';
  char line[160];
  std::snprintf(line, sizeof line,
                "\n%ld blocks, %.0f s on %d threads with the judge; %.0f us for each "
                "call of `split_outline`.\n",
                all.blocks, run.seconds, run.threads,
                1e6 * all.seconds / static_cast<double>(all.blocks));
  out << line;
  return out.str();
}

// Cuts one block again and prints it with the verdict.
int replay(const std::string& which) {
  const auto colon = which.rfind(':');
  const auto families = split_families();
  for (std::size_t f = 0; f < families.size(); ++f) {
    if (colon == which.npos || which.substr(0, colon) != families[f].name)
      continue;
    const SplitCase k = make_split_case(f, std::stoull(which.substr(colon + 1)));
    std::printf("least area %.17g, near %.17g, point (%.17g, %.17g), along (%.17g, "
                "%.17g), outline",
                k.min_area, k.line.near, k.line.point.x(), k.line.point.y(),
                k.line.along.x(), k.line.along.y());
    for (const auto& corner : k.outline)
      std::printf(" (%.17g, %.17g)", corner.x(), corner.y());
    const Split split = geometry::split_outline(k.outline, k.line, k.min_area);
    std::printf("\nfault %d, certificate: %s\n", static_cast<int>(split.fault),
                split.certificate.fault.c_str());
    for (const auto& end : split.ends)
      std::printf("end (%.17g, %.17g), corner %d, side %d, part %.17g, moved %.17g\n",
                  end.place.x(), end.place.y(), end.corner, end.side, end.part,
                  end.moved);
    const std::string fault = judge_split(k.outline, k.line, k.min_area, split);
    std::printf("judge: %s\n", fault.empty() ? "right" : fault.c_str());
    return 0;
  }
  std::cerr << "blocks: error: no family in '" << which
            << "'; FAMILY:NUMBER, FAMILY is";
  for (const SplitFamily& family : families)
    std::cerr << " '" << family.name << "'";
  std::cerr << "\n";
  return 2;
}

int run(int argc, char** argv) {
  CLI::App app{"random blocks, cut along random and awkward lines and judged"};
  long blocks = 100000;
  int threads = 2;
  std::string report, again;
  app.add_option("--blocks", blocks, "number of blocks")
      ->check(CLI::Range(1L, 100000000L));
  app.add_option("--threads", threads, "number of threads")->check(CLI::Range(1, 1024));
  app.add_option("--report", report, "write NAME.md");
  app.add_option("--replay", again,
                 "cut the block FAMILY:NUMBER again and print the verdict");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  if (!again.empty())
    return replay(again);
  const SplitRun result = run_all(blocks, threads);
  const std::string text = markdown(result);
  std::cout << text;
  if (!report.empty()) {
    std::ofstream out(report + ".md");
    out << "# Blocks cut in two\n\n"
           "Written by `./go validate splits`; do not edit. Each block is cut by "
           "`geometry::split_outline`,\nand `split_judge` examines the result by "
           "brute force on rationals: the chord, its ends, the\nfault and the pieces. "
           "The blocks are polygons of 3 to 20 corners, some of them with straight\n"
           "corners, flat down to 3e-14, 1e-9 large or 1e8 from the origin. amin is 0, "
           "1e-3, 0.1 or 0.4 of\nthe area; crossings move to corners nearer than 0, "
           "0.05 sqrt(amin) or 0.1 of the size.\n\n"
           "*Ends moved*: ends of the cuts that moved to a corner. *No chord*, *small* "
           "and *unsound* are\nrefusals, each confirmed by the judge. *Not moved*: "
           "unsound although no end has moved, so\nrounding alone has spoilt a piece. "
           "*Wrong*: the judge found another result. *Below amin*: a\npiece smaller "
           "than amin without a refusal.\n\n"
        << text;
    out.flush();
    if (!out) {
      std::cerr << "blocks: error: cannot write " << report << ".md\n";
      return 5;
    }
  }
  for (const SplitTally& tally : result.families)
    if (tally.wrong + tally.thrown > 0)
      return 4;
  return 0;
}

}  // namespace
}  // namespace blocks::validation

int main(int argc, char** argv) { return blocks::validation::run(argc, argv); }
