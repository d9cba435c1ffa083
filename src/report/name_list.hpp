// Lists of names without repetition.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace blocks::report {

inline void add_once(std::vector<std::string>& list, const std::string& name) {
  if (std::find(list.begin(), list.end(), name) == list.end())
    list.push_back(name);
}

}  // namespace blocks::report
