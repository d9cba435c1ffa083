#include "validation/long_run/long_run.hpp"

#include <CLI/CLI.hpp>
#include <fstream>

#include "files/check_outputs.hpp"
#include "files/file_error.hpp"
#include "geometry/numeric_environment.hpp"
#include "run/run.hpp"

namespace blocks::long_run {
namespace {

int refuse(int code, const std::string& message) {
  std::fprintf(stderr, "blocks: error: %s\n", message.c_str());
  return code;
}

/// Prints the text and appends it to the report.
void print_and_append(const std::string& text, std::string& report) {
  std::printf("%s", text.c_str());
  std::fflush(stdout);
  report += text;
}

/// Makes all steps and returns the exit code.
int make_steps(Model& model, long steps, const Study& study, Observer& observer,
               std::string& report) {
  dynamics::Workspace work;
  dynamics::prepare(model);
  observer.start(model);
  print_and_append(study.columns + "\n" + study.ruler + "\n", report);
  for (long i = 1; i <= steps; ++i) {
    const bool has_row = i * row_count / steps != (i - 1) * row_count / steps;
    const auto result = dynamics::advance(model, work, has_row);
    if (has_row)
      dynamics::catch_up(model, work);
    if (!result.finite) {
      print_and_append(format_text("\n**Step %ld: not a number.**\n", i), report);
      return run::unsound_run;
    }
    if (has_row)
      print_and_append(observer.make_row(i, model, result), report);
  }
  const Verdict verdict = observer.judge(steps, model);
  print_and_append("\n" + verdict.text, report);
  return verdict.passed ? run::done : run::unsound_run;
}

}  // namespace

int run(int argc, char** argv, const Study& study, Observer& observer) {
  CLI::App app{study.about};
  run::RunOptions options;
  options.deck = BLOCKS_SOURCE_DIR "/" + study.deck;
  std::string report;
  long steps = study.steps;
  app.add_option("--deck", options.deck,
                 "the deck; its MOTION and CYCLE cards are ignored");
  app.add_option("--steps", steps, "number of time steps")
      ->check(CLI::Range(row_count, 1000000000L));
  app.add_option("--report", report, "write NAME.md");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? run::done : run::usage_error;
  }
  if (const auto fault = geometry::check_numeric_environment(); !fault.empty())
    return refuse(run::internal_error, fault);
  const std::string file = report.empty() ? "" : report + ".md";
  try {
    files::check_outputs({file});  // Fails now rather than after hours of work.
  } catch (const files::FileError& error) {
    return refuse(run::file_error, error.what());
  }
  auto checked = run::build_checked(options);
  if (checked.code != run::done)
    return checked.code;

  std::string table;
  const int code = make_steps(checked.model, steps, study, observer, table);
  if (!report.empty()) {
    std::ofstream out(file);
    out << "# " << study.title << "\n\n" << study.remark << "\n\n" << table;
    out.flush();
    if (!out)
      return refuse(run::file_error, "cannot write " + file);
  }
  return code;
}

}  // namespace blocks::long_run
