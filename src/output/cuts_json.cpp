#include "output/cuts_json.hpp"

namespace blocks::output {

nlohmann::ordered_json cuts_json(const std::vector<CutRecord>& cuts,
                                 const std::vector<JointLengthRecord>& lengths) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const CutRecord& cut : cuts) {
    Json joints = Json::array();
    for (const JointLengthRecord& length : lengths)
      if (length.cut == cut.number)
        joints.push_back({{"joint", length.joint},
                          {"length", length.drawn},
                          {"pruned", length.pruned}});
    list.push_back(
        {{"cut", cut.number},
         {"first_block", cut.first_block + 1},
         {"blocks", cut.blocks},
         {"area", cut.area},
         {"certificate",
          {{"cells", cut.cells},
           {"interior_edges", cut.interior_edges},
           {"outline_edges", cut.outline_edges}}},
         {"points", cut.vertices},
         {"edges", cut.edges},
         {"faces", cut.faces},
         {"components", cut.components},
         {"length_per_area", {{"before", cut.p21_before}, {"after", cut.p21_after}}},
         {"joints", joints},
         {"islands", cut.islands},
         {"pinched_loops", cut.pinched_loops},
         {"absorbed_faces", cut.absorbed_faces},
         {"straight_vertices", cut.straight_vertices},
         {"contractions", cut.contractions},
         {"largest_move", cut.largest_move},
         {"repaired_below", cut.repaired_below},
         {"short_edges_kept", cut.kept_short},
         {"merges", cut.merges},
         {"small_cells_kept", cut.kept_small},
         {"t_vertices", cut.t_vertices},
         {"t_vertices_moved", cut.moved_t_vertices},
         {"t_vertices_kept", cut.kept_t_vertices},
         {"x_vertices", cut.x_vertices}});
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
