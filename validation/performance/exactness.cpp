// What exact predicates cost in whole runs: the program against the same program with
// predicates of plain doubles (plain/), in pairs, on processor time.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "child_run.hpp"
#include "timing.hpp"

namespace {

namespace fs = std::filesystem;

struct Scene {
  const char* name;
  const char* deck;
  const char* set;  ///< a field of the deck to replace, or empty
};

constexpr Scene scenes[] = {{"crater", "decks/crater/crater.deck", ""},
                            {"wall of 1,000 bricks, 10,000 steps",
                             "validation/rest/wall.deck", "CYCLE.ncycle=10000"},
                            {"subsidence", "decks/subsidence/subsidence.deck", ""}};

double run(const std::string& program, const std::string& deck, const std::string& set,
           const std::string& output) {
  std::vector<std::string> words{program, "run", deck, "--quiet",
                                 "-j",    "1",   "-o", output};
  if (!set.empty())
    words.insert(words.end(), {"--set", set});
  return blocks::bench::run_child(words).user;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"cost of exact predicates in whole runs"};
  int pairs = 5;
  app.add_option("--pairs", pairs, "runs of each program and scene")
      ->check(CLI::Range(1, 1000));
  CLI11_PARSE(app, argc, argv);

  const fs::path folder =
      fs::temp_directory_path() / ("blocks_exactness_" + std::to_string(getpid()));
  fs::create_directories(folder);
  const std::string output = (folder / "run").string();
  std::printf("user seconds of whole runs, %d pairs\n\n"
              "| scene | plain doubles (median) | exact / plain (median) | range |\n"
              "|---|---|---|---|\n",
              pairs);
  int code = 0;
  try {
    for (const Scene& scene : scenes) {
      std::vector<double> plain, ratio;
      const std::string deck = std::string(BLOCKS_SOURCE_DIR "/") + scene.deck;
      for (int i = 0; i < pairs; ++i) {
        // the first of a pair has no advantage over the whole
        double exact = 0.0, doubles = 0.0;
        for (const bool exactly : {i % 2 == 0, i % 2 != 0})
          (exactly ? exact : doubles) =
              run(exactly ? BLOCKS_PROGRAM : BLOCKS_PLAIN, deck, scene.set, output);
        plain.push_back(doubles);
        ratio.push_back(exact / doubles);
      }
      std::printf("| %s | %.2f | %.3f | %.3f to %.3f |\n", scene.name,
                  blocks::bench::median(plain), blocks::bench::median(ratio),
                  *std::min_element(ratio.begin(), ratio.end()),
                  *std::max_element(ratio.begin(), ratio.end()));
      std::fflush(stdout);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "blocks: error: %s\n", error.what());
    code = 4;
  }
  fs::remove_all(folder);
  return code;
}
