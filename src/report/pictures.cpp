#include "report/pictures.hpp"

#include <fmt/format.h>

#include "post/figure/figure.hpp"
#include "report/html_text.hpp"

namespace blocks::report {
namespace {

/// Blocks of one picture that is drawn as lines; a larger model is an image.
constexpr int max_drawn_blocks = 5000;

draw::PageSize whole_width() { return draw::PageSize::in_print("240mm"); }

/// Returns the number of blocks, or how it grows: "12 to 15 blocks".
std::string blocks_text(const post::ResultsReader& results) {
  const int first = results.frame(0).size(),
            last = results.frame(results.frames() - 1).size();
  return first == last ? fmt::format("{} blocks", first)
                       : fmt::format("{} to {} blocks", first, last);
}

std::string picture(const Ensemble& ensemble, const RunRow& row,
                    post::FigureOptions options, bool with_first) {
  post::ResultsReader results(ensemble.results_of(row));
  if (ensemble.units)
    results.show_in(*ensemble.units);
  const long last = results.frames() - 1;
  const std::vector<long> frames =
      with_first && last > 0 ? std::vector<long>{0, last} : std::vector<long>{last};
  options.units = ensemble.units;
  options.material_names = results.material_names();
  options.title = "";
  options.subtitle = blocks_text(results);
  if (!with_first)
    options.subtitle =
        post::time_text(results.frame(last).time, std::nullopt, ensemble.units) +
        "    " + options.subtitle;
  if (results.frame(last).size() <= max_drawn_blocks)
    return post::figure_svg(results, frames, options);
  return fmt::format("<img alt=\"the blocks\" src=\"data:image/png;base64,{}\">",
                     base64(post::figure_png(results, frames, options)));
}

}  // namespace

std::string first_and_last(const Ensemble& ensemble, const RunRow& row,
                           const std::optional<double>& mirror) {
  post::FigureOptions options;
  options.page = whole_width();
  options.mirror = mirror.has_value();
  options.mirror_x = mirror.value_or(0.0);
  return picture(ensemble, row, options, true);
}

std::string last_picture(const Ensemble& ensemble, const RunRow& row) {
  post::FigureOptions options;
  options.page = whole_width();
  return picture(ensemble, row, options, false);
}

}  // namespace blocks::report
