#include "post/read/force_network.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace blocks::post {

std::vector<ForceLink> force_network(const FrameContacts& contacts) {
  struct Sum {
    Eigen::Vector2d point = Eigen::Vector2d::Zero(), force = Eigen::Vector2d::Zero();
    double weight = 0.0;
  };
  std::map<std::pair<int, int>, Sum> pairs;
  const Eigen::Matrix2Xd forces = contacts.force();
  for (int i = 0; i < contacts.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const int corner = contacts.corner_block[k], edge = contacts.edge_block[k];
    const Eigen::Vector2d f = forces.col(i);  // acts on the block of the corner
    Sum& sum = pairs[std::minmax(corner, edge)];
    sum.force += corner > edge ? f : Eigen::Vector2d(-f);
    sum.point += f.norm() * contacts.point.col(i);
    sum.weight += f.norm();
  }
  std::vector<ForceLink> links;
  for (const auto& [pair, sum] : pairs)
    if (sum.weight > 0.0)
      links.push_back(
          {pair.first - 1, pair.second - 1, sum.point / sum.weight, sum.force});
  std::stable_sort(links.begin(), links.end(),
                   [](const ForceLink& a, const ForceLink& b) {
                     return a.force.squaredNorm() < b.force.squaredNorm();
                   });
  return links;
}

}  // namespace blocks::post
