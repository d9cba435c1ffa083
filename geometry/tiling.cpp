#include "geometry/tiling.hpp"

#include <algorithm>
#include <initializer_list>
#include <optional>

#include "geometry/numeric_environment.hpp"
#include "geometry/polygon.hpp"

namespace blocks::geometry {
namespace {

struct Edge {
  int from;
  int to;
  int cell;
};

bool before(const Edge& a, const Edge& b) {
  return a.from != b.from ? a.from < b.from
         : a.to != b.to   ? a.to < b.to
                          : a.cell < b.cell;
}

bool same_ends(const Edge& a, const Edge& b) {
  return a.from == b.from && a.to == b.to;
}

std::string name(const Edge& e) {
  return std::to_string(e.from) + " -> " + std::to_string(e.to);
}

void refuse(TilingCertificate& certificate, const std::string& fault,
            std::initializer_list<int> cells = {}) {
  if (certificate.fault.empty())
    certificate.fault = fault;
  for (const int cell : cells) {
    auto& list = certificate.offending_cells;
    if (cell >= 0 && std::find(list.begin(), list.end(), cell) == list.end()) {
      list.push_back(cell);
    }
  }
}

// Returns the corners of a loop of indices, or nothing if an index is out of range.
std::optional<Polygon> corners(const Mesh& mesh, const std::vector<int>& loop) {
  Polygon polygon;
  polygon.reserve(loop.size());
  for (const int v : loop) {
    if (v < 0 || static_cast<std::size_t>(v) >= mesh.vertices.size()) {
      return std::nullopt;
    }
    polygon.push_back(mesh.vertices[static_cast<std::size_t>(v)]);
  }
  return polygon;
}

// Returns what is wrong with one loop, or an empty string if it is simple and
// clockwise.
std::string loop_fault(const Mesh& mesh, const std::vector<int>& loop) {
  const auto polygon = corners(mesh, loop);
  if (!polygon)
    return "a vertex index is out of range";
  const OutlineCheck check = check_outline(*polygon);
  if (check.fault != OutlineFault::none || check.anticlockwise)
    return describe(check);
  return {};
}

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Directed edges in their order, with an index of their first vertices: a search in all
// edges would take most of the time of a large mesh.
class Edges {
 public:
  explicit Edges(std::size_t vertices) : begin_(vertices + 1, 0) {}

  /// Adds the edges of all loops. Call it once.
  void add(const std::vector<std::vector<int>>& loops, bool are_cells,
           StepProgress& progress) {
    for (const std::vector<int>& loop : loops)
      for (const int from : loop)
        ++begin_[at(from) + 1];
    for (std::size_t v = 1; v < begin_.size(); ++v)
      begin_[v] += begin_[v - 1];
    edges_.resize(begin_.back());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t c = 0; c < loops.size(); ++c) {
      progress.count(1, 1);
      const std::vector<int>& loop = loops[c];
      for (std::size_t i = 0; i < loop.size(); ++i)
        edges_[next[at(loop[i])]++] = {loop[i], loop[(i + 1) % loop.size()],
                                       are_cells ? static_cast<int>(c) : -1};
    }
    for (std::size_t v = 0; v + 1 < begin_.size(); ++v) {
      progress.count(1, 1);
      std::sort(first(v), first(v + 1), before);
    }
  }
  bool contains(int from, int to) const {
    return std::any_of(first(at(from)), first(at(from) + 1),
                       [to](const Edge& edge) { return edge.to == to; });
  }
  auto begin() const { return edges_.begin(); }
  auto end() const { return edges_.end(); }

 private:
  std::vector<Edge>::iterator first(std::size_t vertex) {
    return edges_.begin() + static_cast<std::ptrdiff_t>(begin_[vertex]);
  }
  std::vector<Edge>::const_iterator first(std::size_t vertex) const {
    return edges_.begin() + static_cast<std::ptrdiff_t>(begin_[vertex]);
  }
  std::vector<Edge> edges_;
  std::vector<std::size_t> begin_;  ///< first edge of each vertex
};

// Checks (b) and (c): every cell, and the outline, is simple and clockwise.
void check_loops(const Mesh& mesh, TilingCertificate& certificate,
                 StepProgress& progress) {
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    progress.count(c, mesh.cells.size());
    const int cell = static_cast<int>(c);
    const std::string fault = loop_fault(mesh, mesh.cells[c]);
    if (fault.empty()) {
      ++certificate.cells;
    } else {
      refuse(certificate, "cell " + std::to_string(cell + 1) + ": " + fault, {cell});
    }
  }
  const std::string fault = loop_fault(mesh, mesh.outline);
  if (!fault.empty())
    refuse(certificate, "outline: " + fault);
}

bool is_in_range(const Mesh& mesh) {
  const auto in_range = [&mesh](const std::vector<int>& loop) {
    return std::all_of(loop.begin(), loop.end(), [&mesh](int v) {
      return v >= 0 && at(v) < mesh.vertices.size();
    });
  };
  return in_range(mesh.outline) &&
         std::all_of(mesh.cells.begin(), mesh.cells.end(), in_range);
}

// Checks (a): directed edges cancel in pairs, and the remaining ones are the outline.
void check_edges(const Mesh& mesh, TilingCertificate& certificate,
                 StepProgress& progress) {
  Edges edges(mesh.vertices.size()), outline(mesh.vertices.size());
  edges.add(mesh.cells, true, progress);
  outline.add({mesh.outline}, false, progress);
  const Edge* last = nullptr;
  for (const Edge& edge : edges) {
    if (last && same_ends(*last, edge))
      refuse(certificate, "two cells lie on the same side of edge " + name(edge),
             {last->cell, edge.cell});
    last = &edge;
  }
  std::vector<const Edge*> single;
  for (const Edge& edge : edges) {
    progress.count(1, 1);
    if (!edges.contains(edge.to, edge.from))
      single.push_back(&edge);
    else if (edge.from < edge.to)
      ++certificate.interior_edges;
  }
  certificate.outline_edges = static_cast<int>(single.size());
  for (const Edge* edge : single)
    if (!outline.contains(edge->from, edge->to))
      refuse(certificate, "edge " + name(*edge) + " has no neighbour", {edge->cell});
  for (const Edge& edge : outline)
    if (!edges.contains(edge.from, edge.to) || edges.contains(edge.to, edge.from))
      refuse(certificate, "no cell along outline edge " + name(edge));
}

}  // namespace

TilingCertificate certify_tiling(const Mesh& mesh, StepProgress* progress) {
  const RoundToNearest mode;  // required by the proofs of the predicates' filters
  TilingCertificate certificate;
  if (mesh.cells.empty())
    refuse(certificate, "no cells");
  const ProgressFunction none;
  StepProgress unseen(none, "");
  StepProgress& seen = progress ? *progress : unseen;
  check_loops(mesh, certificate, seen);
  if (is_in_range(mesh))
    check_edges(mesh, certificate, seen);
  certificate.holds = certificate.fault.empty();
  return certificate;
}

}  // namespace blocks::geometry
