// What exact predicates cost in whole runs: the program against the same program with
// predicates of plain doubles (plain/), in pairs, on processor time.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

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

/// User seconds of one run, or -1 if it failed.
double run(const std::string& program, const std::string& deck, const std::string& set,
           const std::string& output) {
  std::vector<std::string> words{program, "run", deck, "--quiet", "-o", output};
  if (!set.empty())
    words.insert(words.end(), {"--set", set});
  std::vector<char*> arguments;
  for (std::string& word : words)
    arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  int status = 0;
  rusage used{};
  if (child < 0 || wait4(child, &status, 0, &used) < 0 || status != 0)
    return -1;
  return static_cast<double>(used.ru_utime.tv_sec) +
         1e-6 * static_cast<double>(used.ru_utime.tv_usec);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 ? values[half] : 0.5 * (values[half - 1] + values[half]);
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
  bool done = true;
  for (const Scene& scene : scenes) {
    std::vector<double> plain, ratio;
    const std::string deck = std::string(BLOCKS_SOURCE_DIR "/") + scene.deck;
    for (int i = 0; i < pairs; ++i) {
      // the first of a pair has no advantage over the whole
      double exact = 0.0, doubles = 0.0;
      for (const bool exactly : {i % 2 == 0, i % 2 != 0})
        (exactly ? exact : doubles) =
            run(exactly ? BLOCKS_PROGRAM : BLOCKS_PLAIN, deck, scene.set, output);
      if (exact < 0 || doubles <= 0) {
        std::fprintf(stderr, "blocks: error: a run of %s failed\n", scene.deck);
        done = false;
        break;
      }
      plain.push_back(doubles);
      ratio.push_back(exact / doubles);
    }
    if (ratio.empty())
      continue;
    std::printf("| %s | %.2f | %.3f | %.3f to %.3f |\n", scene.name, median(plain),
                median(ratio), *std::min_element(ratio.begin(), ratio.end()),
                *std::max_element(ratio.begin(), ratio.end()));
    std::fflush(stdout);
  }
  fs::remove_all(folder);
  return done ? 0 : 4;
}
