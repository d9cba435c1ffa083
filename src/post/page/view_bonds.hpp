// The contacts with the law of a joint, as the page of `blocks view` stores them.
#pragma once

#include <string>
#include <vector>

#include "post/page/view_shapes.hpp"
#include "post/page/view_store.hpp"
#include "post/read/results_reader.hpp"

namespace blocks::post {

/// Collects the contacts of all frames of a page. Corners are indices over all shapes.
class ViewBonds {
 public:
  /// Adds the contacts of the last frame of the shapes. Contacts with planes and those
  /// without a law are left out.
  void add_frame(const FrameContacts& contacts, const ViewShapes& shapes);

  /// Whether some contact of some frame has a law.
  bool any() const { return !corner_.empty(); }
  /// Adds the arrays of the page: the number of contacts of each frame, then the
  /// corner, edge, state, slip, dilation, forces and length of each contact.
  void store(ViewStore& store) const;

  double largest_slip() const { return largest_slip_; }  ///< [L]

 private:
  std::vector<std::uint32_t> counts_, corner_, edge_;
  std::vector<unsigned char> bond_;  ///< quantities::Bond
  std::vector<float> slip_, dilation_, normal_, shear_, length_;
  double largest_slip_ = 0.0;
};

}  // namespace blocks::post
