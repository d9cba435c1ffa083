// The contact forces that the page of `blocks view` draws. The direction is within 1.5
// degrees and the size within 3 %.
#pragma once

#include <string>
#include <vector>

#include "post/page/view_shapes.hpp"
#include "post/page/view_store.hpp"
#include "post/read/results_reader.hpp"

namespace blocks::post {

class ViewForces {
 public:
  /// Adds the contacts of the last frame of the shapes. path: of the results, for the
  /// message. Throws files::FileError if a corner does not exist.
  void add_frame(const FrameContacts& contacts, const ViewShapes& shapes,
                 const std::string& path);
  /// Adds the arrays of the page. corners: number of corners of all shapes.
  void store(ViewStore& store, int corners) const;

  double largest() const { return largest_; }  ///< [F]
  std::vector<std::size_t> counts() const;     ///< forces of each frame

 private:
  struct Arrow {
    int corner = 0;               ///< index over all shapes
    unsigned char direction = 0;  ///< in units of 1/256 turn, from x towards y
    double size = 0.0;
  };
  std::vector<std::vector<Arrow>> arrows_;
  double largest_ = 0.0;
};

}  // namespace blocks::post
