// Which corners and edges are paired, and how pairs are grouped, in the variants.
#pragma once

#include "dynamics/contact_search.hpp"
#include "model/model.hpp"

namespace blocks::study {

enum class List {
  reach,  ///< ours: every corner an edge could act on before the next search
  near,   ///< corners within 2 CTOL of the edge, found anew at each search
  kept    ///< the report's (3.2): the same, and a pair once listed stays for ever
};

/// Brings list and groups up to date where a step of the time loop would. each_alone:
/// every record is decided by itself, so that several edges of a block may act on one
/// corner.
void find_contacts(Model& model, dynamics::SearchBuffers& buffers, List list,
                   bool each_alone);

}  // namespace blocks::study
