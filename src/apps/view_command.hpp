// `blocks view`: command line of the page for the browser.
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>

namespace blocks::apps {

struct ViewOptions {
  std::string file;
  std::string output;            ///< empty: FILE's stem with .html
  long every = 1;                ///< frames
  std::optional<double> mirror;  ///< x of the plane of a half model [L]
  std::string units;             ///< "m,kg,s"
};

void add_view_options(CLI::App& command, ViewOptions& options);

/// Writes the page. Returns an exit code of run::ExitCode.
int view(ViewOptions options);

}  // namespace blocks::apps
