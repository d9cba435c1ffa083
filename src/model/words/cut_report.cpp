#include "model/words/cut_report.hpp"

#include <fmt/format.h>

#include "text/counted.hpp"

namespace blocks {

std::string cut_report(const CutRecord& cut,
                       const std::vector<JointLengthRecord>& lengths) {
  std::string text = fmt::format(
      "cut {}: blocks {} to {}, tiling proved: {}, {}, {}, area {:.9g}\n", cut.number,
      cut.first_block + 1, cut.first_block + cut.blocks, counted(cut.cells, "cell"),
      counted(cut.interior_edges, "shared side"),
      counted(cut.outline_edges, "outline side"), cut.area);
  text += fmt::format("  joints and outline: {}, {}, {}, {}\n",
                      counted(cut.vertices, "point"), counted(cut.edges, "edge"),
                      counted(cut.faces, "face"), counted(cut.components, "component"));
  text += fmt::format("  length per area {:.6g}, {:.6g} after pruning\n",
                      cut.p21_before, cut.p21_after);
  for (const JointLengthRecord& length : lengths)
    if (length.cut == cut.number)
      text += fmt::format("  joint {}: length {:.6g}, of which {:.6g} pruned\n",
                          length.joint, length.drawn, length.pruned);
  if (cut.islands > 0 || cut.pinched_loops > 0)
    text += fmt::format("  absorbed: {}, {}, with {} in all\n",
                        counted(cut.islands, "island"),
                        counted(cut.pinched_loops, "loop") + " joined at one point",
                        counted(cut.absorbed_faces, "face"));
  text += fmt::format("  vertices inside: {} T ({} moved off the side, {} kept as "
                      "corners), {} X\n",
                      cut.t_vertices, cut.moved_t_vertices, cut.kept_t_vertices,
                      cut.x_vertices);
  if (cut.contractions > 0 || cut.merges > 0 || cut.kept_short > 0 ||
      cut.kept_small > 0)
    text +=
        fmt::format("  cleaned: {} contracted, vertices moved by {:.4g} at most; {} "
                    "merged; not possible: {}, {}\n",
                    counted(cut.contractions, "edge"), cut.largest_move,
                    counted(cut.merges, "cell"), counted(cut.kept_short, "edge"),
                    counted(cut.kept_small, "cell"));
  if (cut.repaired_below > 0.0)
    text +=
        fmt::format("  repaired: joints coincide up to rounding; edges below {:.3g} "
                    "are contracted\n",
                    cut.repaired_below);
  return text;
}

}  // namespace blocks
