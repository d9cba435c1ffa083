#include "model/words/cut_report.hpp"

#include <fmt/format.h>

#include "text/counted.hpp"

namespace blocks {

std::string cut_report(const CutRecord& cut,
                       const std::vector<JointLengthRecord>& lengths) {
  const geometry::CutCounts& counts = cut.counts;
  std::string text = fmt::format(
      "cut {}: blocks {} to {}, tiling proved: {}, {}, {}, area {:.9g}\n", cut.number,
      cut.first_block + 1, cut.first_block + cut.blocks, counted(cut.cells, "cell"),
      counted(cut.interior_edges, "shared side"),
      counted(cut.outline_edges, "outline side"), cut.area);
  text += fmt::format("  joints and outline: {}, {}, {}, {}\n",
                      counted(counts.vertices, "point"), counted(counts.edges, "edge"),
                      counted(counts.faces, "face"),
                      counted(counts.components, "component"));
  text += fmt::format("  length per area {:.6g}, {:.6g} after pruning\n",
                      counts.p21_before, counts.p21_after);
  for (const JointLengthRecord& length : lengths)
    if (length.cut == cut.number)
      text += fmt::format("  joint {}: length {:.6g}, of which {:.6g} pruned\n",
                          length.joint, length.drawn, length.pruned);
  if (counts.islands > 0 || counts.pinched_loops > 0)
    text += fmt::format("  absorbed: {}, {}, with {} in all\n",
                        counted(counts.islands, "island"),
                        counted(counts.pinched_loops, "loop") + " joined at one point",
                        counted(counts.absorbed_faces, "face"));
  text += fmt::format("  vertices inside: {} T ({} moved off the side, {} kept as "
                      "corners), {} X\n",
                      counts.t_vertices, counts.moved_t_vertices,
                      counts.kept_t_vertices, counts.x_vertices);
  if (counts.contractions > 0 || counts.merges > 0 || counts.kept_short > 0 ||
      counts.kept_small > 0)
    text +=
        fmt::format("  cleaned: {} contracted, vertices moved by {:.4g} at most; {} "
                    "merged; not possible: {}, {}\n",
                    counted(counts.contractions, "edge"), counts.largest_move,
                    counted(counts.merges, "cell"), counted(counts.kept_short, "edge"),
                    counted(counts.kept_small, "cell"));
  if (counts.repaired_below > 0.0)
    text +=
        fmt::format("  repaired: joints coincide up to rounding; edges below {:.3g} "
                    "are contracted\n",
                    counts.repaired_below);
  return text;
}

}  // namespace blocks
