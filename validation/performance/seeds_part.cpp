// Times the layers of many seeds without time steps, as `blocks sweep DECK --check`
// makes them: the deck is read, and its blocks are generated, certified and measured.
#include <algorithm>
#include <cstdint>
#include <stdexcept>

#include "parts.hpp"
#include "run/run.hpp"
#include "sweep/layer_measures.hpp"

namespace blocks::bench {
namespace {

const char* const deck = BLOCKS_SOURCE_DIR "/validation/geometry/layer.deck";

class Seeds : public Contestant {
 public:
  explicit Seeds(bool measured) : measured_(measured) {}
  std::string name() const override {
    return measured_ ? "generated, certified, measured" : "generated, certified";
  }
  double work_per_step() const override { return 1.0; }
  void run(long seeds) override {
    for (long i = 0; i < seeds; ++i) {
      run::RunOptions options;
      options.deck = deck;
      options.seed = seed_++;
      const run::CheckedDeck checked = run::build_checked(options);
      if (checked.code != run::done || !checked.certificate->holds())
        throw std::runtime_error("a certificate of a random layer does not hold");
      if (measured_)
        worst_aspect_ = std::max(
            worst_aspect_,
            sweep::measure_layers(checked.model, checked.certificate).aspect.max);
    }
  }

 private:
  bool measured_;
  std::uint64_t seed_ = 1;
  double worst_aspect_ = 0.0;
};

}  // namespace

void run_seeds(const Plan& plan, Report& report) {
  announce("seeds, layers of 100 blocks");
  Seeds plain(false), measured(true);
  const auto times = take_turns({&plain, &measured}, plan.rounds, plan.seconds);
  report.rows.push_back({"seeds", "a layer of 100 blocks", plain.name(), 1, 100, "seed",
                         times[0].middle()});
  report.rows.push_back({"seeds", "a layer of 100 blocks", measured.name(), 1, 100,
                         "seed", times[1].middle(), ratio(times[0], times[1]),
                         plain.name()});
  report.targets.push_back(
      {"10,000 layers of 100 blocks generated, certified and measured",
       1e4 * 1e-9 * times[1].middle(), 60, false, " s"});
}

}  // namespace blocks::bench
