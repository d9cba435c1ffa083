#include "parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "dynamics/search/near_pairs.hpp"
#include "dynamics/step.hpp"
#include "generation.hpp"
#include "kernels.hpp"
#include "wall.hpp"

namespace blocks::bench {
namespace {

/// Repeats the search for near pairs of blocks in a wall.
class Search : public Contestant {
 public:
  explicit Search(int power) : model_(wall_of_power(power)) {
    dynamics::prepare(model_);
  }
  std::string name() const override { return "blocks"; }
  double work_per_step() const override { return model_.blocks.size() - 3; }
  void run(long searches) override {
    for (long i = 0; i < searches; ++i)
      dynamics::find_near_pairs(model_.blocks, model_.settings.contact_tolerance,
                                memory_, pairs_);
  }

 private:
  Model model_;
  dynamics::NearSearch memory_;
  std::vector<dynamics::NearPair> pairs_;
};

}  // namespace

const std::vector<Part>& parts() {
  static const std::vector<Part> all = {
      {"rock", "rock cut by joints, at rest, creeping and failing", run_rock, true},
      {"wall", "walls of bricks, calm and chattering, against other codes", run_wall,
       true},
      {"pile", "a settling pile of polygons, against other codes", run_pile, true},
      {"slope", "a sliding slope of bricks, against other codes", run_slope, true},
      {"crater", "the crater deck while the blast acts", run_crater, true},
      {"subsidence", "the subsidence deck in its cave-in", run_subsidence, true},
      {"decks", "whole runs of decks of cut rock, the subsidence and the crater", run_decks},
      {"search", "the search for near pairs of blocks alone", run_search},
      {"predicates", "contact predicates and contact law alone", run_predicates},
      {"generation", "random layers cut and certified", run_generation},
      {"cut", "a square cut by random traces, time and memory", run_cut},
      {"seeds", "random layers of many seeds, from the deck to their measures",
       run_seeds},
      {"sweeps", "what a sweep costs beside its runs, and its plan and report",
       run_sweeps}};
  return all;
}

void announce(const std::string& what) {
  std::fprintf(stderr, "%s ...\n", what.c_str());
}

void run_search(const Plan& plan, Report& report) {
  std::vector<std::unique_ptr<Search>> searches;
  std::vector<Contestant*> codes;
  for (int power = plan.smallest; power <= plan.largest; ++power) {
    announce(fmt::format("search, 10^{} bricks", power));
    searches.push_back(std::make_unique<Search>(power));
    codes.push_back(searches.back().get());
  }
  const auto times = take_turns(codes, plan.rounds, plan.seconds);
  for (std::size_t i = 0; i < codes.size(); ++i) {
    Row row{"search",
            grouped(std::lround(codes[i]->work_per_step())) + " bricks",
            "blocks",
            1,
            codes[i]->work_per_step(),
            "block",
            times[i].middle()};
    if (i > 0) {
      row.against = report.rows.back().scene;
      row.ratio = ratio(times[i - 1], times[i]);
    }
    report.rows.push_back(row);
  }
}

void run_predicates(const Plan& plan, Report& report) {
  announce("predicates");
  const auto rows = time_kernels(plan.rounds, 0.2 * plan.seconds);
  report.rows.insert(report.rows.end(), rows.begin(), rows.end());
}

void run_generation(const Plan& plan, Report& report) {
  double worst = 0.0;
  for (int power = plan.smallest; power <= plan.largest; ++power) {
    const int blocks = static_cast<int>(std::lround(std::pow(10.0, power)));
    announce("generation, " + grouped(blocks) + " blocks");
    for (const int in_layer :
         blocks > 1000 ? std::vector{1000, blocks} : std::vector{blocks})
      for (const bool slanted : {false, true}) {
        const int repetitions = std::clamp(100000 / blocks, 1, plan.rounds);
        std::vector<double> all, certificate;
        for (int i = 0; i < repetitions; ++i) {
          const GenerationCost cost =
              cost_of_layers(blocks / in_layer, in_layer, slanted);
          all.push_back(cost.all);
          certificate.push_back(cost.certificate);
        }
        const std::string scene =
            fmt::format("{} of {} blocks{}", grouped(blocks / in_layer),
                        grouped(in_layer), slanted ? ", slanted" : "");
        report.rows.push_back({"generation", scene, "all", 1,
                               static_cast<double>(blocks), "block", median(all)});
        report.rows.push_back({"generation", scene, "certificate alone", 1,
                               static_cast<double>(blocks), "block",
                               median(certificate)});
        worst = std::max(worst, median(all));
      }
  }
  report.targets.push_back({"random layers generated and certified, a block, dearest",
                            1e-3 * worst, 10, false, " µs"});
}

}  // namespace blocks::bench
