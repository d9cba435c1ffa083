// The cards of DBLOCK (report Appendix E, tables E.1 and E.2), the plotting program of
// 1982, for `blocks plot --dblock`.
#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "deck/diagnostics.hpp"
#include "draw/colour_map.hpp"

namespace blocks::dblock {

struct Cards {
  bool first_only = false;                ///< BLOCKS
  std::optional<Eigen::Vector4d> zoom;    ///< ZOOM: xmin, xmax, ymin, ymax [L]
  int frame_size = 1;                     ///< FRAMESIZE 1, 2, 3; MOVIE takes 3
  bool print = false;                     ///< PRINT
  std::optional<int> count;               ///< NTIMES
  bool all_times = false;                 ///< ALLTIMES
  std::optional<double> from, to, every;  ///< TMIN, TMAX, DELTIME [T]
  std::vector<double> times;              ///< TIMES [T]
  bool movie = false;                     ///< MOVIE
  bool flip = false;                      ///< FLIP
  std::map<int, draw::Colour> materials;  ///< CLEARC, BLUE, ...
  std::map<int, std::pair<deck::SourceLocation, std::string>>
      painted;  ///< place and name of the card that painted a material

  /// Returns the times to be plotted, increasing and without duplicates. `all` are the
  /// times of the file. If no card gives times, there are ten from TMIN to TMAX, as in
  /// 1982.
  std::vector<double> chosen(const std::vector<double>& all) const;
};

/// Returns a colour by its name in Table E.2, in upper or lower case, or by #rrggbb.
std::optional<draw::Colour> named_colour(const std::string& name);
/// Lists the names, "BLUE, CLEARC, ..." and #rrggbb.
std::string colour_names();

/// Reads the cards up to ENDDATA and adds all errors to `faults`.
Cards read_cards(const std::string& text, deck::Diagnostics& faults);

}  // namespace blocks::dblock
