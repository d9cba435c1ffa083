// What `blocks check` says of a deck without faults.
#pragma once

#include <string>

#include "model/model.hpp"

namespace blocks::run {

/// Blocks, layers with their certificates, merges and the time step, a line each.
std::string check_report(const std::string& file, const Model& model);

}  // namespace blocks::run
