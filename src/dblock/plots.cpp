#include "dblock/plots.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <set>
#include <stdexcept>

#include "dblock/cards.hpp"
#include "post/figure/figure_scales.hpp"
#include "post/figure/movie.hpp"
#include "post/read/material_list.hpp"
#include "run/run.hpp"
#include "run/support/deck_file.hpp"
#include "text/counted.hpp"

namespace blocks::dblock {
namespace {

/// Returns the frames at the chosen times without duplicates.
std::vector<long> frames(const Cards& cards, const post::ResultsReader& results) {
  std::vector<long> chosen;
  for (const double time : cards.chosen(results.times()))
    if (const long frame = results.at(time); chosen.empty() || chosen.back() != frame)
      chosen.push_back(frame);
  return chosen;
}

/// Reports an error for each colour card whose material is not in the results.
void check_materials(const Cards& cards, const post::ResultsReader& results,
                     deck::Diagnostics& faults) {
  if (cards.painted.empty())
    return;
  const std::set<int> present = post::materials_of(results);
  for (const auto& [material, card] : cards.painted)
    if (!present.contains(material))
      faults.error(card.first, card.second,
                   fmt::format("there is no material {}; the results have {}", material,
                               post::material_list(results)));
}

/// Throws std::runtime_error if an option and a card set the same thing.
void check_options(const Cards& cards, const post::FigureOptions& figure) {
  const auto refuse = [](bool both, const std::string& option,
                         const std::string& card) {
    if (both)
      throw std::runtime_error(fmt::format(
          "{} and the card {} exclude each other: remove one of them", option, card));
  };
  refuse(figure.zoom && cards.zoom, "--zoom", "ZOOM");
  refuse(figure.mirror && cards.flip, "--mirror", "FLIP");
  for (const auto& [material, card] : cards.painted) {
    refuse(figure.colour != "material", "--colour " + figure.colour, card.second);
    refuse(figure.material_colours.contains(material),
           fmt::format("--materials {}=...", material), card.second);
  }
}

void print_corners(const post::Frame& frame) {
  fmt::print("time {:.9g}\n{:>8}{:>8}{:>18}{:>18}\n", frame.time, "block", "corner",
             "x", "y");
  for (std::size_t b = 0; b < frame.outlines.size(); ++b)
    for (std::size_t c = 0; c < frame.outlines[b].size(); ++c)
      fmt::print("{:>8}{:>8}{:>18.9g}{:>18.9g}\n", frame.number[b], c + 1,
                 frame.outlines[b][c].x(), frame.outlines[b][c].y());
}

}  // namespace

int plot(const std::string& cards_file, const post::ResultsReader& results,
         const std::string& output, double rate, post::FigureOptions figure) {
  const std::string text = run::read_deck(cards_file);
  deck::Diagnostics faults(cards_file, text);
  const Cards cards = read_cards(text, faults);
  check_materials(cards, results, faults);
  fmt::print(stderr, "{}", faults.format_all());
  if (faults.has_errors())
    return run::deck_error;

  check_options(cards, figure);
  constexpr double widths[] = {1200, 800, 640};  // FRAMESIZE
  figure.page = draw::PageSize::on_screen(widths[cards.frame_size - 1]);
  for (const auto& [material, colour] : cards.materials)
    figure.material_colours[material] = colour;
  if (cards.zoom)
    figure.zoom = cards.zoom;
  if (cards.flip) {
    figure.mirror = true;
    figure.mirror_x = 0.0;
  }
  const std::vector<long> chosen = frames(cards, results);
  if (chosen.empty()) {
    fmt::print(stderr,
               "blocks: error: {}: no picture between TMIN and TMAX; the results have "
               "times {:g} to {:g}\n",
               cards_file, results.times().front(), results.times().back());
    return run::deck_error;
  }
  post::require_blocks_in_zoom(results, chosen, figure);
  if (post::is_movie(output)) {
    post::draw_movie(output, results, chosen, rate, figure);
    if (cards.print)
      for (const long frame : chosen)
        print_corners(results.frame(frame));
    else
      fmt::print("{}: {}, {:.3g} s\n", output, counted(chosen.size(), "picture"),
                 static_cast<double>(chosen.size()) / rate);
    return run::done;
  }
  if (cards.movie && !figure.zoom)  // all pictures need the same view
    figure.zoom = post::survey_scales(results, chosen, figure).view;

  const std::filesystem::path name(output);
  const auto digits = std::max<std::size_t>(2, std::to_string(chosen.size()).size());
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    const std::string path =
        chosen.size() == 1 ? output
                           : (name.parent_path() /
                              fmt::format("{}_{:0{}}{}", name.stem().string(), k + 1,
                                          digits, name.extension().string()))
                                 .string();
    post::draw_figure(path, results, {chosen[k]}, figure);
    if (cards.print)
      print_corners(results.frame(chosen[k]));
    else
      fmt::print("{} time {:g}\n", path,
                 results.times()[static_cast<std::size_t>(chosen[k])]);
  }
  return run::done;
}

}  // namespace blocks::dblock
