#include "post/read/joint_ids.hpp"

namespace blocks::post {

std::set<int> joints_of(const Frame& frame) {
  std::set<int> found;
  for (const auto& sides : frame.joints)
    found.insert(sides.begin(), sides.end());
  found.erase(0);
  return found;
}

std::string no_joints_text() {
  return "no side of a block has a joint id at the times drawn\n  hint: blocks get "
         "joint "
         "ids from JSET, TRACES and VORONOI by the card CUT; results of older versions "
         "have none";
}

}  // namespace blocks::post
