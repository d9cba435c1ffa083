#include "geometry/cut_cleaning.hpp"

#include "geometry/cut_cleaner.hpp"
#include "geometry/exact/line.hpp"

namespace blocks::geometry {

bool is_superfluous(const CutGraph& graph, const exact::Lines& lines, int vertex) {
  const CutGraph::Vertex& v = graph.vertices[CutGraph::at(vertex)];
  if (v.corner >= 0)
    return false;
  const CutGraph::Edge& a = graph.edge(v.half_edge);
  const CutGraph::Edge& b =
      graph.edge(graph.next[CutGraph::at(CutGraph::twin(v.half_edge))]);
  return a.joint == b.joint && a.outline == b.outline && a.line >= 0 && b.line >= 0 &&
         (a.line == b.line ||
          lines.are_parallel(CutGraph::at(a.line), CutGraph::at(b.line)));
}

void clean(CutGraph& graph, const exact::Lines& lines, const CleaningLimits& limits,
           CutReport& report, StepProgress progress) {
  CutCleaner cleaner(graph, lines, limits.repair, report, progress);
  // Edges whose contraction was not possible may be contracted after a merge. Each
  // round removes a vertex or a cell, so the loop ends.
  for (bool changed = true; changed;) {
    const long merges = report.merges;
    cleaner.contract_below(limits.emin);
    cleaner.merge_below(limits.amin);
    changed = cleaner.identify_coinciding_vertices() || report.merges > merges;
  }
  if (report.contractions > 0)
    cleaner.join_straight_edges();
}

}  // namespace blocks::geometry
