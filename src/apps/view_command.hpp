// `blocks view`: the command line of the page for the browser.
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>

namespace blocks::apps {

struct ViewOptions {
  std::string file;
  std::string output;            ///< empty: FILE's name with .html
  long every = 1;                ///< show every Nth frame
  std::optional<double> mirror;  ///< x of the symmetry plane of a half model [L]
  std::string units;             ///< "m,kg,s"
};

void add_view_options(CLI::App& command, ViewOptions& options);

/// Writes the page. Returns a code of run::ExitCode.
int view(ViewOptions options);

}  // namespace blocks::apps
