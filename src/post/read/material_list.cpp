#include "post/read/material_list.hpp"

namespace blocks::post {

std::set<int> materials_of(const ResultsReader& results) {
  const Frame last = results.frame(results.frames() - 1);  // it has all blocks
  return {last.material.begin(), last.material.end()};
}

std::string material_list(const ResultsReader& results) {
  const auto& names = results.material_names();
  std::string list;
  for (const int material : materials_of(results)) {
    const auto name = names.find(material);
    list += (list.empty() ? "" : ", ") + std::to_string(material) +
            (name == names.end() ? "" : " (" + name->second + ")");
  }
  return list;
}

}  // namespace blocks::post
