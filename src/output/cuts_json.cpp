#include "output/cuts_json.hpp"

namespace blocks::output {

nlohmann::ordered_json cuts_json(const std::vector<CutRecord>& cuts,
                                 const std::vector<JointLengthRecord>& lengths) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const CutRecord& cut : cuts) {
    const geometry::CutCounts& counts = cut.counts;
    Json joints = Json::array();
    for (const JointLengthRecord& length : lengths)
      if (length.cut == cut.number)
        joints.push_back({{"joint", length.joint},
                          {"length", length.drawn},
                          {"pruned", length.pruned}});
    list.push_back({{"cut", cut.number},
                    {"first_block", cut.first_block + 1},
                    {"blocks", cut.blocks},
                    {"area", cut.area},
                    {"certificate",
                     {{"cells", cut.cells},
                      {"interior_edges", cut.interior_edges},
                      {"outline_edges", cut.outline_edges}}},
                    {"points", counts.vertices},
                    {"edges", counts.edges},
                    {"faces", counts.faces},
                    {"components", counts.components},
                    {"length_per_area",
                     {{"before", counts.p21_before}, {"after", counts.p21_after}}},
                    {"joints", joints},
                    {"islands", counts.islands},
                    {"pinched_loops", counts.pinched_loops},
                    {"absorbed_faces", counts.absorbed_faces},
                    {"straight_vertices", counts.straight_vertices},
                    {"contractions", counts.contractions},
                    {"largest_move", counts.largest_move},
                    {"repaired_below", counts.repaired_below},
                    {"short_edges_kept", counts.kept_short},
                    {"merges", counts.merges},
                    {"small_cells_kept", counts.kept_small},
                    {"t_vertices", counts.t_vertices},
                    {"t_vertices_moved", counts.moved_t_vertices},
                    {"t_vertices_kept", counts.kept_t_vertices},
                    {"x_vertices", counts.x_vertices}});
  }
  return list;
}

nlohmann::ordered_json merges_json(const std::vector<MergeRecord>& merges) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const MergeRecord& merge : merges)
    list.push_back({{"layer", merge.layer},
                    {"absorbed", merge.absorbed},
                    {"into", merge.into},
                    {"width_to_height", merge.width_to_height},
                    {"limit", merge.limit}});
  return list;
}

}  // namespace blocks::output
