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
  return a.from != b.from ? a.from < b.from : a.to < b.to;
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

void append_edges(const std::vector<int>& loop, int cell, std::vector<Edge>& edges) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    edges.push_back({loop[i], loop[(i + 1) % loop.size()], cell});
  }
}

// Checks (b) and (c): every cell, and the outline, is simple and clockwise.
void check_loops(const Mesh& mesh, TilingCertificate& certificate,
                 StepProgress* progress) {
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    if (progress)
      progress->count(c, mesh.cells.size());
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

// Checks (a): directed edges cancel in pairs, and the remaining ones are the outline.
void check_edges(const Mesh& mesh, TilingCertificate& certificate) {
  std::vector<Edge> edges;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    append_edges(mesh.cells[c], static_cast<int>(c), edges);
  }
  std::sort(edges.begin(), edges.end(), before);
  for (std::size_t i = 1; i < edges.size(); ++i) {
    if (same_ends(edges[i - 1], edges[i])) {
      refuse(certificate, "two cells lie on the same side of edge " + name(edges[i]),
             {edges[i - 1].cell, edges[i].cell});
    }
  }
  std::vector<Edge> outline;
  append_edges(mesh.outline, -1, outline);
  std::sort(outline.begin(), outline.end(), before);

  std::vector<Edge> single;
  for (const Edge& edge : edges) {
    const Edge twin{edge.to, edge.from, -1};
    if (std::binary_search(edges.begin(), edges.end(), twin, before)) {
      if (edge.from < edge.to)
        ++certificate.interior_edges;
    } else {
      single.push_back(edge);
    }
  }
  certificate.outline_edges = static_cast<int>(single.size());
  for (const Edge& edge : single) {
    if (!std::binary_search(outline.begin(), outline.end(), edge, before)) {
      refuse(certificate, "edge " + name(edge) + " has no neighbour", {edge.cell});
    }
  }
  for (const Edge& edge : outline) {
    if (!std::binary_search(single.begin(), single.end(), edge, before)) {
      refuse(certificate, "no cell along outline edge " + name(edge));
    }
  }
}

}  // namespace

TilingCertificate certify_tiling(const Mesh& mesh, StepProgress* progress) {
  const RoundToNearest mode;  // required by the proofs of the predicates' filters
  TilingCertificate certificate;
  if (mesh.cells.empty())
    refuse(certificate, "no cells");
  check_loops(mesh, certificate, progress);
  check_edges(mesh, certificate);
  certificate.holds = certificate.fault.empty();
  return certificate;
}

}  // namespace blocks::geometry
