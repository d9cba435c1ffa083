// Cuts many random networks with the library and with a naive cutter, judges each
// result and writes the table of failures: ./go validate cuts.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>
#include <random>
#include <sstream>
#include <thread>

#include "validation/geometry/cut_families.hpp"
#include "validation/geometry/cut_judge.hpp"
#include "validation/geometry/exact_judge.hpp"
#include "validation/geometry/naive_cut.hpp"

namespace blocks::validation {
namespace {

using geometry::CutError;
using geometry::CutRequest;
using geometry::CutResult;

// Relative to the size of the domain: the smallest that round-off permits, a usual one
// and a coarse one.
constexpr std::array<double, 3> naive_tolerances = {1e-14, 1e-9, 1e-3};
// Calls of the progress function of a network, far above what any of them needs.
constexpr long max_calls = 100'000;

struct Hang {};

struct CutTally {
  long networks = 0, cells = 0;
  long refused = 0;  ///< by the library, with place and hint
  long wrong = 0;    ///< certified, but not according to the judge
  long faults = 0;   ///< other exceptions, no place or hint, no end, other bits
  struct Naive {
    long not_simple = 0, lost = 0, ended = 0;
    long other = 0;  ///< tiles with another number of cells than the exact one
    long failures() const { return not_simple + lost + ended; }
  };
  std::array<Naive, naive_tolerances.size()> naive;  ///< for each tolerance
  long repaired = 0;  ///< certified, with cells that rounding has destroyed
  std::map<std::string, long> reasons;  ///< of refusals
  std::vector<std::string> failed;      ///< numbers and what is wrong

  void add(const CutTally& other) {
    networks += other.networks;
    cells += other.cells;
    refused += other.refused;
    wrong += other.wrong;
    faults += other.faults;
    repaired += other.repaired;
    for (std::size_t i = 0; i < naive.size(); ++i) {
      naive[i].not_simple += other.naive[i].not_simple;
      naive[i].lost += other.naive[i].lost;
      naive[i].ended += other.naive[i].ended;
      naive[i].other += other.naive[i].other;
    }
    for (const auto& [reason, count] : other.reasons)
      reasons[reason] += count;
    failed.insert(failed.end(), other.failed.begin(), other.failed.end());
  }
};

// Everything that the order of the joints must not change, to the bit.
std::string bits(const CutResult& result) {
  std::ostringstream out;
  out << std::hexfloat;
  for (const auto& v : result.mesh.vertices)
    out << v.x() << ' ' << v.y() << '\n';
  for (std::size_t i = 0; i < result.blocks.size(); ++i)
    for (const auto* list : {&result.mesh.cells[i], &result.joints[i],
                             &result.blocks[i].corners, &result.blocks[i].joints}) {
      for (const int v : *list)
        out << v << ' ';
      out << '\n';
    }
  for (const auto& [id, length] : result.report.lengths)
    out << id << ' ' << length.drawn << ' ' << length.pruned << '\n';
  const auto& report = result.report;
  out << report.p21_before << ' ' << report.p21_after << ' ' << report.contractions
      << ' ' << report.largest_move << ' ' << report.merges << ' ' << report.islands
      << ' ' << report.pinched_loops << ' ' << report.kept_t_vertices;
  return out.str();
}

CutResult cut(CutRequest request) {
  long calls = 0;
  request.progress = [&calls](const std::string&, double) {
    if (++calls > max_calls)
      throw Hang();
  };
  return geometry::cut_outline(request);
}

// Returns the bits of the result, or the text and the place of the refusal.
std::string outcome(const CutRequest& request) {
  try {
    return bits(cut(request));
  } catch (const CutError& error) {
    std::ostringstream out;
    out << std::hexfloat << error.what() << ' ' << error.place.x() << ' '
        << error.place.y();
    return out.str();
  }
}

std::string shuffled_outcome(CutRequest request, std::uint64_t number) {
  std::mt19937_64 random(number);
  std::shuffle(request.joints.begin(), request.joints.end(), random);
  for (auto& joint : request.joints)
    if (random() % 2 == 0)
      std::swap(joint.from, joint.to);
  return outcome(request);
}

// The last part of the reason of a refusal, without its numbers.
std::string reason_of(const CutError& error) {
  const std::string all = error.what();
  std::string text;
  for (const char c : all.substr(all.find_last_of(':') + 1))
    if ((c < '0' || c > '9') && !(c == ' ' && (text.empty() || text.back() == ' ')))
      text += c;
  return text;
}

// Returns the number of cells of the exact arrangement, or 0 if the result has others.
std::size_t examine_ours(const CutRequest& request, std::uint64_t number,
                         CutTally& tally) {
  std::size_t exact_cells = 0;
  const auto fail = [&](long& count, const std::string& what) {
    ++count;
    tally.failed.push_back(std::to_string(number) + " (" + what + ")");
  };
  try {
    const CutResult result = cut(request);
    tally.cells += static_cast<long>(result.mesh.cells.size());
    const bool changed = result.report.contractions + result.report.merges > 0;
    tally.repaired += changed && request.emin + request.amin == 0.0 ? 1 : 0;
    exact_cells = changed ? 0 : result.mesh.cells.size();
    if (const std::string fault = judge_cut(request, result); !fault.empty())
      fail(tally.wrong, fault);
  } catch (const CutError& error) {
    ++tally.refused;
    ++tally.reasons[reason_of(error)];
    if (error.hint.empty() || !error.place.allFinite() || *error.what() == '\0')
      fail(tally.faults, "refused without a place or a hint");
  } catch (const Hang&) {
    fail(tally.faults, "does not end");
    return 0;
  } catch (const std::exception& error) {
    fail(tally.faults, error.what());
    return 0;
  }
  if (number % 4 == 0 && outcome(request) != shuffled_outcome(request, number))
    fail(tally.faults, "depends on the order of the joints");
  return exact_cells;
}

void examine_naive(const CutRequest& request, double tolerance, std::size_t exact_cells,
                   CutTally::Naive& tally) {
  try {
    const geometry::Mesh mesh = naive_cut(request, tolerance);
    const Judgement judgement = judge(mesh);
    if (judgement.reason == "a cell is not simple and clockwise" ||
        judgement.reason == "the outline is not simple and clockwise")
      ++tally.not_simple;
    else if (!judgement.tiles)
      ++tally.lost;
    else if (exact_cells > 0 && mesh.cells.size() != exact_cells)
      ++tally.other;
  } catch (const std::exception&) {
    ++tally.ended;
  }
}

struct Run {
  std::vector<CutTally> families;
  double seconds = 0.0;
  int threads = 1;
};

Run run_all(long networks, int threads, const std::string& only) {
  const auto start = std::chrono::steady_clock::now();
  struct Item {
    std::size_t family;
    std::uint64_t number;
  };
  std::vector<Item> work;
  for (std::size_t f = 0; f < cut_families().size(); ++f)
    for (long i = 0; i < std::max(1L, networks * cut_families()[f].weight / 1000); ++i)
      if (only.empty() || only == cut_families()[f].name)
        work.push_back({f, static_cast<std::uint64_t>(i)});
  std::atomic<std::size_t> next = 0;
  std::vector<std::vector<CutTally>> parts(
      static_cast<std::size_t>(threads), std::vector<CutTally>(cut_families().size()));
  std::vector<std::thread> workers;
  for (auto& part : parts)
    workers.emplace_back([&] {
      for (std::size_t i = next++; i < work.size(); i = next++) {
        CutTally& tally = part[work[i].family];
        const CutRequest request = cut_families()[work[i].family].make(work[i].number);
        ++tally.networks;
        const std::size_t cells = examine_ours(request, work[i].number, tally);
        for (std::size_t k = 0; k < naive_tolerances.size(); ++k)
          examine_naive(request, naive_tolerances[k], cells, tally.naive[k]);
      }
    });
  for (auto& worker : workers)
    worker.join();
  Run run;
  run.threads = threads;
  run.families.resize(cut_families().size());
  for (const auto& part : parts)
    for (std::size_t f = 0; f < part.size(); ++f)
      run.families[f].add(part[f]);
  run.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return run;
}

std::string markdown(const Run& run) {
  std::ostringstream out;
  CutTally all;
  for (const CutTally& tally : run.families)
    all.add(tally);
  out << "| family | networks | cells | ours: repaired | ours: refused | ours: wrong "
         "| naive 1e-14 | naive 1e-9 | naive 1e-3 |\n"
         "|---|---|---|---|---|---|---|---|---|\n";
  const auto row = [&out](std::string_view name, const CutTally& t) {
    out << "| " << name << " | " << t.networks << " | " << t.cells << " | "
        << t.repaired << " | " << t.refused << " | " << t.wrong + t.faults << " |";
    for (const auto& naive : t.naive)
      out << ' ' << naive.failures() << " + " << naive.other << " |";
    out << '\n';
  };
  for (std::size_t f = 0; f < run.families.size(); ++f)
    row(cut_families()[f].name, run.families[f]);
  row("**all**", all);
  out << "\nThe naive cutter, all families:\n\n| tolerance | not simple | overlap, gap "
         "or area lost | no result | other cells |\n|---|---|---|---|---|\n";
  for (std::size_t k = 0; k < naive_tolerances.size(); ++k)
    out << "| " << naive_tolerances[k] << " | " << all.naive[k].not_simple << " | "
        << all.naive[k].lost << " | " << all.naive[k].ended << " | "
        << all.naive[k].other << " |\n";
  out << "\nRefusals by family and reason:\n\n| family | reason | networks |\n"
         "|---|---|---|\n";
  for (std::size_t f = 0; f < run.families.size(); ++f)
    for (const auto& [reason, count] : run.families[f].reasons)
      out << "| " << cut_families()[f].name << " | " << reason << " | " << count
          << " |\n";
  for (std::size_t f = 0; f < run.families.size(); ++f)
    for (std::size_t k = 0; k < std::min<std::size_t>(run.families[f].failed.size(), 8);
         ++k)
      out << "\nFailure: " << cut_families()[f].name << ':' << run.families[f].failed[k]
          << '\n';
  char line[128];
  std::snprintf(line, sizeof line, "\n%ld networks, %.0f s on %d threads.\n",
                all.networks, run.seconds, run.threads);
  out << line;
  return out.str();
}

// Cuts one network again and prints it with the verdicts.
int replay(const std::string& which) {
  const auto colon = which.rfind(':');
  for (const CutFamily& family : cut_families()) {
    if (colon == which.npos || which.substr(0, colon) != family.name)
      continue;
    const CutRequest request = family.make(std::stoull(which.substr(colon + 1)));
    std::printf("emin %.17g, amin %.17g, outline", request.emin, request.amin);
    for (const auto& corner : request.outline)
      std::printf(" (%.17g, %.17g)", corner.x.value(), corner.y.value());
    std::printf("\n");
    for (const auto& joint : request.joints)
      std::printf("joint %d (%.17g, %.17g) (%.17g, %.17g)\n", joint.id,
                  joint.from.nearest().x(), joint.from.nearest().y(),
                  joint.to.nearest().x(), joint.to.nearest().y());
    try {
      const CutResult result = cut(request);
      const std::string fault = judge_cut(request, result);
      std::printf("ours: %zu cells, %ld contractions, %ld merges; judge: %s\n",
                  result.mesh.cells.size(), result.report.contractions,
                  result.report.merges, fault.empty() ? "right" : fault.c_str());
    } catch (const CutError& error) {
      std::printf("ours: refused: %s at (%.17g, %.17g) (%s)\n", error.what(),
                  error.place.x(), error.place.y(), error.hint.c_str());
    }
    for (const double tolerance : naive_tolerances)
      try {
        const auto mesh = naive_cut(request, tolerance);
        const auto judgement = judge(mesh);
        std::printf("naive %g: %zu cells; judge: %s\n", tolerance, mesh.cells.size(),
                    judgement.reason.empty() ? "tiles" : judgement.reason.c_str());
      } catch (const std::exception& error) {
        std::printf("naive %g: %s\n", tolerance, error.what());
      }
    return 0;
  }
  std::cerr << "blocks: error: no family in '" << which
            << "'; FAMILY:NUMBER, FAMILY is";
  for (const CutFamily& family : cut_families())
    std::cerr << " '" << family.name << "'";
  std::cerr << "\n";
  return 2;
}

int run(int argc, char** argv) {
  CLI::App app{"random networks of joints, cut in two ways and judged"};
  long networks = 100000;
  int threads = 2;
  std::string report, again, only;
  app.add_option("--networks", networks, "number of networks")
      ->check(CLI::Range(1L, 100000000L));
  app.add_option("--threads", threads, "number of threads")->check(CLI::Range(1, 1024));
  app.add_option("--report", report, "write NAME.md");
  app.add_option("--family", only, "only the networks of this family");
  app.add_option("--replay", again,
                 "cut the network FAMILY:NUMBER again and print the verdicts");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  if (!again.empty())
    return replay(again);
  const Run result = run_all(networks, threads, only);
  const std::string text = markdown(result);
  std::cout << text;
  if (!report.empty()) {
    std::ofstream out(report + ".md");
    out << "# Cut domains: failures\n\nWritten by `./go validate cuts`; do not edit. "
           "What it means:\n[robustness of "
           "joints](../../docs/robustness-joints.md).\n\n"
        << text;
    out.flush();
    if (!out) {
      std::cerr << "blocks: error: cannot write " << report << ".md\n";
      return 5;
    }
  }
  for (const CutTally& tally : result.families)
    if (tally.wrong + tally.faults > 0)
      return 4;
  return 0;
}

}  // namespace
}  // namespace blocks::validation

int main(int argc, char** argv) { return blocks::validation::run(argc, argv); }
