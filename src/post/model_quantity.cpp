#include "post/model_quantity.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <vector>

namespace blocks::post {

using Eigen::VectorXd;

double reduce(Reduction how, const VectorXd& values) {
  if (how == Reduction::sum)  // same order of summation as in the run
    return std::accumulate(values.begin(), values.end(), 0.0);
  if (values.size() == 0)
    return 0.0;
  return how == Reduction::largest    ? values.maxCoeff()
         : how == Reduction::smallest ? values.minCoeff()
                                      : values.mean();
}

const std::map<std::string, OtherKind>& other_kinds() {
  constexpr Dimension force{0, 1, -2, "N/m", ""}, length{1, 0, 0, "m", ""}, pure{};
  static const std::map<std::string, OtherKind> kinds = {
      {"contacts",
       {"contacts",
        pure,
        Reduction::sum,
        [](const FrameContacts& c) -> VectorXd { return VectorXd::Ones(c.size()); },
        {}}},
      {"normal_force",
       {"normal contact force",
        force,
        Reduction::sum,
        [](const FrameContacts& c) { return c.normal_force; },
        {}}},
      {"shear_force",
       {"shear contact force",
        force,
        Reduction::sum,
        [](const FrameContacts& c) -> VectorXd { return c.shear_force.cwiseAbs(); },
        {}}},
      {"overlap",
       {"overlap",
        length,
        Reduction::largest,
        [](const FrameContacts& c) { return c.overlap; },
        {}}},
      {"step",
       {"step",
        pure,
        Reduction::sum,
        {},
        [](const Frame& f) { return static_cast<double>(f.step); }}},
      {"blocks",
       {"blocks",
        pure,
        Reduction::sum,
        {},
        [](const Frame& f) { return 1.0 * f.count_present(); }}},
      {"time", {"time", {0, 0, 1, "s", ""}, Reduction::sum, {}, [](const Frame& f) {
                  return f.time;
                }}}};
  return kinds;
}

const OtherKind* find_other(const std::string& name) {
  std::string lower = name;
  for (char& c : lower)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const auto found = other_kinds().find(lower);
  return found == other_kinds().end() ? nullptr : &found->second;
}

VectorXd per_block(const OtherKind& kind, const FrameContacts& contacts, int blocks) {
  const VectorXd rows = kind.rows(contacts);
  VectorXd values = VectorXd::Zero(blocks);
  for (int i = 0; i < contacts.size(); ++i)
    for (const auto* side : {&contacts.corner_block, &contacts.edge_block}) {
      const int block = (*side)[static_cast<std::size_t>(i)];  // 0: a plane
      if (block < 1 || block > blocks)
        continue;
      double& value = values[block - 1];
      value = kind.natural == Reduction::largest ? std::max(value, rows[i])
                                                 : value + rows[i];
    }
  return values;
}

}  // namespace blocks::post
