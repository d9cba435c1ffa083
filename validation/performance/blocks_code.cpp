#include "blocks_code.hpp"

#include <stdexcept>
#include <utility>

namespace blocks::bench {

int free_blocks(const Model& model) {
  int count = 0;
  for (int b = 0; b < model.blocks.size(); ++b)
    count += model.blocks.is_free(b) ? 1 : 0;
  return count;
}

BlocksCode::BlocksCode(Model start, std::string name, int threads)
    : model_(std::move(start)), work_(threads), name_(std::move(name)),
      free_(free_blocks(model_)) {
  dynamics::prepare(model_);
}

void BlocksCode::run(long steps) {
  for (long i = 0; i < steps; ++i) {
    const bool read = ++made_ % 64 == 0;  // A run reads as often.
    if (!dynamics::advance(model_, work_, read).finite)
      throw std::runtime_error(name_ + ": a corner is no longer a number");
    if (read)
      dynamics::catch_up(model_, work_);
  }
}

Phases BlocksCode::run_phases(long steps) {
  using dynamics::Profile;
  Profile profile;
  work_.profile = &profile;
  run(steps);
  work_.profile = nullptr;
  double all = 0.0;
  for (const double seconds : profile.seconds)
    all += seconds;
  return {.decisions = profile.seconds[Profile::decisions] / all,
          .forces = profile.seconds[Profile::forces] / all,
          .motion = profile.seconds[Profile::motion] / all,
          .search = profile.seconds[Profile::search] / all};
}

const Model& BlocksCode::model() {
  dynamics::catch_up(model_, work_);
  return model_;
}

}  // namespace blocks::bench
