// Writes the seeds of fuzz_results and fuzz_checkpoint into FOLDER/results/ and
// FOLDER/checkpoint/. The seeds are files of the present format.
#include <filesystem>

#include "output/checkpoint/checkpoint.hpp"
#include "output/sample_model.hpp"

int main(int argc, char** argv) {
  using namespace blocks;
  namespace fs = std::filesystem;
  const fs::path folder = argc > 1 ? argv[1] : "seeds";
  fs::create_directories(folder / "results");
  fs::create_directories(folder / "checkpoint");
  Model model = samples::two_blocks();
  {
    output::ResultsWriter results(folder / "results/two_blocks.vtkhdf",
                                  {"a.deck", "START\n", "TWO BLOCKS", "1", 1982});
    results.write(model);
    ++model.steps;
    samples::add_triangle(model, 4, 4);
    results.write(model);
    ++model.steps;
    model.blocks.joint.back() = 7;
    results.write(model);
  }
  output::write_checkpoint(folder / "checkpoint/empty.ckpt.h5", samples::no_blocks(),
                           {});
  output::CheckpointInfo info;
  info.deck_file = "a.deck";
  info.deck_text = "START\n";
  info.results = "a.vtkhdf";
  Model with_laws = samples::two_blocks();
  with_laws.contacts.push_back({7, 1});
  samples::add_laws(with_laws);
  output::write_checkpoint(folder / "checkpoint/laws.ckpt.h5", with_laws, {});
  output::write_checkpoint(folder / "checkpoint/three_blocks.ckpt.h5", model, info);
}
