// The faces between blocks for the page of `blocks view`, with their opening and shear
// displacement in all frames.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "post/page/view_shapes.hpp"
#include "post/page/view_store.hpp"
#include "post/read/face_motion.hpp"

namespace blocks::post {

class ViewFaces {
 public:
  /// Adds the next frame; its shapes must have been added.
  void add_frame(const Frame& now, const CrackedBlocks& cracked,
                 const ViewShapes& shapes);

  /// Whether any frame has a face.
  bool any() const { return !parts_.empty(); }

  /// Adds the sides of all faces, as indices over the corners of all shapes, the ends
  /// of their parts, and both values at both ends; NaN where there is no face.
  void store(ViewStore& store) const;

 private:
  /// Of both ends of a face, with four digits.
  struct Values {
    std::uint32_t face;
    std::array<float, 2> opening, shear;  ///< [L]
  };
  std::vector<Face> known_;                             ///< of the last frame
  long cracks_ = -1;                                    ///< number of cracks up to it
  std::map<std::pair<int, int>, std::uint32_t> faces_;  ///< by both sides
  std::vector<std::uint32_t> sides_;                    ///< 2 for each face
  std::vector<float> parts_;                            ///< 4 for each face
  std::vector<std::vector<Values>> frames_;
};

}  // namespace blocks::post
