// The scales that all pictures of a sheet or a movie share, so that they can be
// compared: the view, the range of the colours, the sizes of forces and arrows.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "draw/value_range.hpp"
#include "post/figure/figure.hpp"
#include "post/read/crack_tracker.hpp"
#include "quantities/bond.hpp"

namespace blocks::post {

/// The model at one time.
struct Picture {
  const Frame& now;
  const Frame& first;  ///< where the blocks of `now` were (CrackedBlocks::first)
  const FrameContacts& contacts;
  const Frame* original = nullptr;         ///< the first frame as it was; null: `first`
  const CrackedBlocks* cracked = nullptr;  ///< null: cracks are not known

  const Frame& original_frame() const {
    return original != nullptr ? *original : first;
  }
};

struct FigureScales {
  Eigen::Vector4d view{0, 1, 0, 1};  ///< xmin, xmax, ymin, ymax [L]
  draw::ValueRange colours;
  bool cuts_low = false, cuts_high = false;  ///< values lie beyond the range asked for
  bool is_zero = false;  ///< the quantity is 0 in all blocks and pictures
  double force =
      0.0;  ///< [F] drawn at full width: the median of the largest of each picture
  /// Drawn at full length: the median of the largest of each picture, or what the
  /// options say
  double arrow = 0.0;
  bool cuts_arrows = false;  ///< longer arrows are drawn at full length
  double block_size = 1.0;   ///< [L] root of the median area
  std::set<int> materials;
  std::set<int> joints;              ///< ids other than 0, if the figure shows joints
  std::set<quantities::Bond> bonds;  ///< of the contacts, if the figure shows bonds
  double slip = 0.0;                 ///< [L] the largest, if the figure shows bonds
  bool fixed = false;                ///< true if some block is fixed
  bool cracks = false;               ///< true if some picture shows faces of cracks
  bool water = false;                ///< true if some picture has a water table
  std::set<int> block_counts;        ///< numbers of blocks of the pictures

  /// Returns the length on the page that is a share of the size of blocks, but not
  /// below `min` nor above `max` [units].
  double on_page(const draw::Axes& axes, double share, double min, double max) const {
    return std::clamp(share * block_size * axes.scale(), min, max);
  }
};

class ScaleSurvey {
 public:
  explicit ScaleSurvey(const FigureOptions& options) : options_(options) {}
  void include(const Picture& picture);
  /// Throws std::runtime_error if the ends of the zoom or the range are in the wrong
  /// order, every stress is 0, or the figure shows joints or bonds and there is none.
  FigureScales scales() const;

 private:
  void include_corners(const Frame& frame);
  /// Includes the lengths of one picture that are not 0.
  void include_arrows(std::vector<double> lengths);
  draw::ValueRange colours() const;

  const FigureOptions& options_;
  Eigen::Vector2d low_ = Eigen::Vector2d::Constant(1e300), high_ = -low_;
  double min_ = 1e300, max_ = -1e300;
  bool logarithmic_ = false;
  bool centred_ = false;        ///< the colours are centred on 0
  std::vector<double> forces_;  ///< the largest of each picture
  std::vector<double> arrows_;  ///< the largest or the percentile of each picture
  double longest_arrow_ = 0.0;
  FigureScales found_;  ///< all but view, colours, force and arrow
};

/// Returns the scales of these frames, reading one at a time. Throws std::runtime_error
/// if there are none.
FigureScales survey_scales(const ResultsReader& results,
                           const std::vector<long>& frames,
                           const FigureOptions& options);

/// Returns the colour map of the options, or the usual one for the quantity.
draw::ColourMap map_of(const FigureOptions& options, draw::Zero zero);
/// Returns the part of that map that shows this range.
draw::ColourMap map_of(const FigureOptions& options, draw::Zero zero,
                       const draw::ValueRange& range);

/// Reads frames one at a time, and calls action(k, picture) for each, k from 0. In
/// figures of families, the materials of blocks are their families (families.hpp).
void for_each_picture(const ResultsReader& results, const std::vector<long>& frames,
                      const FigureOptions& options,
                      const std::function<void(std::size_t, const Picture&)>& action);

/// Returns the vectors of the arrows with that name, (2, n): velocity, displacement or
/// force. Throws std::runtime_error that lists the names.
Eigen::Matrix2Xd arrow_vectors(const std::string& name, const Picture& picture);

/// Returns the names of arrows, for help and messages.
std::vector<std::string> arrow_names();

/// Throws std::runtime_error if no block of these frames is inside the zoom; the
/// message says where the blocks are.
void require_blocks_in_zoom(const ResultsReader& results,
                            const std::vector<long>& frames,
                            const FigureOptions& options);

}  // namespace blocks::post
