#include "exchange/joint_lines.hpp"

#include <array>
#include <set>

namespace blocks::exchange {

std::map<int, std::vector<JointLine>>
joint_lines(const std::vector<BlockRecord>& blocks) {
  std::map<int, std::vector<JointLine>> lines;
  std::set<std::array<double, 4>> known;
  for (const BlockRecord& block : blocks)
    for (std::size_t i = 0; i < block.joints.size(); ++i) {
      if (block.joints[i] == 0)
        continue;
      const geometry::Vec2 &p = block.outline[i],
                           &q = block.outline[(i + 1) % block.outline.size()];
      known.insert({p.x(), p.y(), q.x(), q.y()});
      if (known.count({q.x(), q.y(), p.x(), p.y()}) == 0)
        lines[block.joints[i]].push_back({p, q});
    }
  return lines;
}

}  // namespace blocks::exchange
