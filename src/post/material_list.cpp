#include "post/material_list.hpp"

#include "post/figure_scales.hpp"

namespace blocks::post {

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
