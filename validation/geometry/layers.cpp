// Makes many random layers in three ways, judges each one and writes the failure table.
#include <CLI/CLI.hpp>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <optional>
#include <thread>

#include "validation/geometry/exact_judge.hpp"
#include "validation/geometry/families.hpp"
#include "validation/geometry/naive_layer.hpp"
#include "validation/geometry/tally.hpp"

namespace blocks::validation {
namespace {

using geometry::LayerRequest;
using geometry::Mesh;
using geometry::Vec2;

std::array<Vec2, 4> corners_of(const LayerRequest& request) {
  std::array<Vec2, 4> corners;
  for (std::size_t i = 0; i < 4; ++i)
    corners[i] = {request.corners[i].x.value(), request.corners[i].y.value()};
  return corners;
}

// Returns the layer of a generator, or nothing if it is refused.
std::optional<Mesh> make(const LayerRequest& request, std::size_t generator) {
  if (generator == 1)
    return naive_layer(request, Crossings::ignored);
  if (generator == 2)
    return naive_layer(request, Crossings::checked);
  try {
    return geometry::cut_layer(request).mesh;
  } catch (const geometry::LayerError&) {
    return std::nullopt;
  }
}

void examine(const Family& family, std::uint64_t number, bool brute_force,
             FamilyTally& tallies) {
  const LayerRequest request = family.make(number);
  for (std::size_t g = 0; g < generators; ++g) {
    Tally& tally = tallies[g];
    ++tally.layers;
    const auto mesh = make(request, g);
    if (!mesh) {
      ++tally.refused;
      continue;
    }
    tally.blocks += static_cast<long>(mesh->cells.size());
    const bool certified = geometry::certify_tiling(*mesh).holds;
    bool failed = !certified || family.refuse;
    // The judge needs n^2 comparisons: minutes for a layer of 2000 blocks.
    if (brute_force && mesh->cells.size() <= 300) {
      const Judgement judgement = judge(*mesh);
      const bool good = judgement.tiles && judgement.conforming;
      ++tally.judged;
      tally.disagree += good != certified ? 1 : 0;
      const bool kept = g > 0 || within_corners(*mesh, corners_of(request));
      tally.judge_says += good && kept ? 0 : 1;
      failed = failed || !good || !kept;
    }
    if (failed) {
      ++tally.failures;
      tally.failed.push_back(number);
    }
  }
}

// The list of all layers of a run, family by family: entry i is a family and a number.
class Work {
 public:
  explicit Work(long layers) {
    for (const Family& family : families())
      ends_.push_back((ends_.empty() ? 0 : ends_.back()) +
                      std::max(1L, layers * family.weight / 1000));
  }
  long size() const { return ends_.back(); }
  std::pair<std::size_t, std::uint64_t> operator[](long i) const {
    std::size_t family = 0;
    while (i >= ends_[family])
      ++family;
    return {family,
            static_cast<std::uint64_t>(i - (family > 0 ? ends_[family - 1] : 0))};
  }

 private:
  std::vector<long> ends_;
};

Run run_all(long layers, long every, int threads) {
  const auto start = std::chrono::steady_clock::now();
  const Work work(layers);
  std::atomic<long> next = 0;
  std::vector<std::vector<FamilyTally>> parts(
      static_cast<std::size_t>(threads), std::vector<FamilyTally>(families().size()));
  std::vector<std::thread> workers;
  for (auto& part : parts)
    workers.emplace_back([&] {
      constexpr long portion = 16;
      for (long first = next.fetch_add(portion); first < work.size();
           first = next.fetch_add(portion))
        for (long i = first; i < std::min(first + portion, work.size()); ++i) {
          const auto [family, number] = work[i];
          examine(families()[family], number,
                  every > 0 && number % static_cast<std::uint64_t>(every) == 0,
                  part[family]);
        }
    });
  for (auto& worker : workers)
    worker.join();
  Run run;
  run.layers = work.size();
  run.every = every;
  run.threads = threads;
  run.families.resize(families().size());
  for (const auto& part : parts)
    for (std::size_t f = 0; f < part.size(); ++f)
      for (std::size_t g = 0; g < generators; ++g)
        run.families[f][g].add(part[f][g]);
  run.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return run;
}

// Makes one layer again and prints what each generator, the certificate and the judge
// say.
int replay(const std::string& which) {
  const auto colon = which.rfind(':');
  for (const Family& family : families()) {
    if (colon == which.npos || which.substr(0, colon) != family.name)
      continue;
    const std::uint64_t number = std::stoull(which.substr(colon + 1));
    const LayerRequest request = family.make(number);
    std::printf("%d blocks, corners", request.count);
    for (const Vec2& c : corners_of(request))
      std::printf(" (%.17g, %.17g)", c.x(), c.y());
    std::printf("\n");
    const char* const names[generators] = {"ours", "naive", "naive with check"};
    for (std::size_t g = 0; g < generators; ++g) {
      try {
        const auto mesh =
            g == 0 ? geometry::cut_layer(request).mesh : *make(request, g);
        const auto certificate = geometry::certify_tiling(mesh);
        const auto judgement = judge(mesh);
        std::printf("%s: %zu blocks; certificate: %s; judge: %s\n", names[g],
                    mesh.cells.size(),
                    certificate.holds ? "tiles" : certificate.fault.c_str(),
                    judgement.reason.empty() ? "tiles" : judgement.reason.c_str());
      } catch (const geometry::LayerError& error) {
        std::printf("%s: refused: %s (%s)\n", names[g], error.what(),
                    error.hint.c_str());
      }
    }
    return 0;
  }
  std::cerr << "blocks: error: no family in '" << which
            << "'; FAMILY:NUMBER, FAMILY is";
  for (const Family& family : families())
    std::cerr << " '" << family.name << "'";
  std::cerr << "\n";
  return 2;
}

bool write(const std::string& path, const std::string& text) {
  std::ofstream out(path);
  out << text;
  out.flush();
  if (!out)
    std::cerr << "blocks: error: cannot write " << path << "\n";
  return static_cast<bool>(out);
}

int run(int argc, char** argv) {
  CLI::App app{"random layers, made three ways and judged"};
  long layers = 100000;
  long every = 10;
  int threads = 2;
  std::string report;
  std::string again;
  app.add_option("--layers", layers, "number of layers")
      ->check(CLI::Range(1L, 100000000L));
  app.add_option("--every", every, "brute force on every K-th layer; 0: on none")
      ->check(CLI::Range(0L, 1000000000L));
  app.add_option("--threads", threads, "number of threads")->check(CLI::Range(1, 1024));
  app.add_option("--report", report, "write NAME.md and NAME.json");
  app.add_option("--replay", again,
                 "make the layer FAMILY:NUMBER again and print the verdicts");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  if (!again.empty())
    return replay(again);
  const Run result = run_all(layers, every, threads);
  std::cout << markdown(result);
  if (!report.empty() && !(write(report + ".md", markdown(result)) &&
                           write(report + ".json", json(result))))
    return 5;
  bool sound = true;
  for (std::size_t f = 0; f < result.families.size(); ++f) {
    for (const Tally& tally : result.families[f])
      sound = sound && tally.disagree == 0;
    const Tally& ours = result.families[f][0];
    sound = sound && ours.failures == 0;
  }
  return sound ? 0 : 4;
}

}  // namespace
}  // namespace blocks::validation

int main(int argc, char** argv) { return blocks::validation::run(argc, argv); }
