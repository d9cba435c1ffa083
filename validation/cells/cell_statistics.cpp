// Compares cells of random networks with what is known exactly: README.md.
#include <CLI/CLI.hpp>
#include <exception>
#include <fstream>
#include <iostream>
#include <thread>

#include "validation/cells/figures.hpp"
#include "validation/cells/study.hpp"

int main(int argc, char** argv) {
  using namespace blocks::validation;
  constexpr int full = 4000;
  CLI::App app{"cells of random networks against exact answers"};
  int networks = full;
  int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  std::string report;
  app.add_option("--networks", networks,
                 "networks of Poisson lines; the others in proportion (default 4000)")
      ->check(CLI::Range(1, full));
  app.add_option("--threads", threads, "threads; the results do not depend on them")
      ->check(CLI::Range(1, 256));
  app.add_option("--report", report,
                 "write FOLDER/REPORT.md and the figures beside it");
  CLI11_PARSE(app, argc, argv);
  try {
    const Study study =
        run_study(static_cast<double>(networks) / static_cast<double>(full), threads);
    const std::string text = markdown(study);
    std::cout << text;
    if (!report.empty()) {
      draw_intervals(study, report + "/intervals.svg");
      draw_distributions(study, report);
      draw_pictures(report);
      std::ofstream out(report + "/REPORT.md");
      out << text;
      out.flush();
      if (!out) {
        std::cerr << "blocks: error: cannot write " << report << "/REPORT.md\n";
        return 5;
      }
    }
    return study.passed() ? 0 : 4;
  } catch (const std::exception& error) {
    std::cerr << "blocks: error: " << error.what() << '\n';
    return 1;
  }
}
