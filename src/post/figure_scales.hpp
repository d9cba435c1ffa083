// What the pictures of a sheet or a movie have in common, so that they can be compared:
// the view, the range of the colours, the sizes of forces and arrows.
#pragma once

#include <Eigen/Core>
#include <set>
#include <string>
#include <vector>

#include "post/figure.hpp"

namespace blocks::post {

/// One time of the model.
struct Picture {
  const Frame& now;
  const Frame& first;
  const FrameContacts& contacts;
};

struct FigureScales {
  Eigen::Vector4d view{0, 1, 0, 1};  ///< xmin, xmax, ymin, ymax [L]
  double low = 0.0, high = 1.0;      ///< of the colours
  double force = 0.0;                ///< [F] drawn at full width, the usual largest
  double arrow = 0.0;                ///< drawn at full length, the usual largest
  double block_size = 1.0;           ///< [L] root of the median area
  std::set<int> materials;
  bool fixed = false;  ///< some block is
};

class ScaleSurvey {
 public:
  explicit ScaleSurvey(const FigureOptions& options) : options_(options) {}
  void include(const Picture& picture);
  /// Throws std::runtime_error for a zoom or range upside down.
  FigureScales scales() const;

 private:
  void include_corners(const Frame& frame);

  const FigureOptions& options_;
  Eigen::Vector2d low_ = Eigen::Vector2d::Constant(1e300), high_ = -low_;
  double least_ = 1e300, most_ = -1e300;
  bool is_signed_ = false;
  std::vector<double> forces_, arrows_;  ///< the largest of each picture
  double block_size_ = 1.0;
  std::set<int> materials_;
  bool fixed_ = false;
};

/// Of these frames, read one at a time. Throws std::runtime_error when there are none.
FigureScales survey_scales(const ResultsReader& results,
                           const std::vector<long>& frames,
                           const FigureOptions& options);

/// Those of all blocks.
std::set<int> materials_of(const ResultsReader& results);

/// The contacts of a frame, read only if the figure shows something of them.
FrameContacts contacts_for(const FigureOptions& options, const ResultsReader& results,
                           long frame);

/// (2, n) what the arrows of that name show: velocity, displacement, force. Throws
/// std::runtime_error listing the names.
Eigen::Matrix2Xd arrow_vectors(const std::string& name, const Picture& picture);

/// Names of arrows for help and messages.
std::vector<std::string> arrow_names();

/// Throws std::runtime_error when the zoom lies beside all blocks of all these frames,
/// and says where they lie.
void require_blocks_in_zoom(const ResultsReader& results,
                            const std::vector<long>& frames,
                            const FigureOptions& options);

}  // namespace blocks::post
