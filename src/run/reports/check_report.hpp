// The report of `blocks check` on a deck without errors.
#pragma once

#include <string>

#include "model/assembly_certificate.hpp"
#include "model/model.hpp"

namespace blocks::run {

/// Lists blocks, layers with their certificates, merges, overlaps and the time step,
/// one per line.
std::string check_report(const std::string& file, const Model& model,
                         const SharedCertificate& certificate);

}  // namespace blocks::run
