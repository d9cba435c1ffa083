// Compares the certificate of geometry/tiling with brute force on meshes that are
// spoilt in many ways. The certificate must hold if and only if the cells tile the
// outline corner to corner.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <limits>
#include <numeric>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/random.hpp"
#include "validation/geometry/exact_judge.hpp"
#include "validation/geometry/families.hpp"

namespace blocks::validation {
namespace {

using geometry::Mesh;
using geometry::Vec2;

class Draw {
 public:
  explicit Draw(std::uint64_t number) : number_(number) {}
  /// 0 <= result < end
  std::size_t below(std::size_t end) {
    return geometry::random_53_bits({12, number_}, next_++, 0, 7) % end;
  }
  double uniform() {
    return std::ldexp(
        static_cast<double>(geometry::random_53_bits({12, number_}, next_++, 0, 7)),
        -53);
  }
  template <class T> T& any(std::vector<T>& list) { return list[below(list.size())]; }

 private:
  std::uint64_t number_;
  std::uint64_t next_ = 0;
};

// Makes a mesh of columns by rows unit squares.
Mesh wall(int columns, int rows) {
  Mesh mesh;
  const auto at = [columns](int i, int j) { return j * (columns + 1) + i; };
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i)
      mesh.vertices.emplace_back(i, j);
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      mesh.cells.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
  for (int j = 0; j < rows; ++j)
    mesh.outline.push_back(at(0, j));
  for (int i = 0; i < columns; ++i)
    mesh.outline.push_back(at(i, rows));
  for (int j = rows; j > 0; --j)
    mesh.outline.push_back(at(columns, j));
  for (int i = columns; i > 0; --i)
    mesh.outline.push_back(at(i, 0));
  return mesh;
}

// Makes a wall, a wall with displaced vertices, or a layer of any family.
Mesh sound_mesh(Draw& draw) {
  const std::size_t kind = draw.below(4);
  if (kind < 2) {
    Mesh mesh =
        wall(static_cast<int>(1 + draw.below(4)), static_cast<int>(1 + draw.below(3)));
    if (kind == 1)
      for (Vec2& v : mesh.vertices)
        v += 0.4 * Vec2(draw.uniform() - 0.5, draw.uniform() - 0.5);
    return mesh;
  }
  for (;;) {
    const Family& family = families()[draw.below(families().size())];
    if (family.weight < 10)
      continue;
    geometry::LayerRequest request = family.make(draw.below(100000));
    try {
      const Mesh layer = geometry::cut_layer(request).mesh;
      if (layer.cells.size() <= 16)
        return layer;
    } catch (const geometry::LayerError&) {
    }
  }
}

double size_of(const Mesh& mesh) {
  double size = 0.0;
  const auto& cell = mesh.cells.front();
  for (const int v : cell)
    size = std::max(size, (mesh.vertices[static_cast<std::size_t>(v)] -
                           mesh.vertices[static_cast<std::size_t>(cell[0])])
                              .norm());
  return size;
}

double some_ulps(double x, Draw& draw) {
  const double to =
      (draw.below(2) == 0 ? 1.0 : -1.0) * std::numeric_limits<double>::infinity();
  for (std::size_t k = draw.below(4); k > 0; --k)
    x = std::nextafter(x, to);
  return x;
}

void move_by(Mesh& mesh, Draw& draw, double part) {
  draw.any(mesh.vertices) +=
      part * size_of(mesh) * Vec2(2 * draw.uniform() - 1, 2 * draw.uniform() - 1);
}

// Inserts a vertex in the middle of a random edge of the loop. Returns its index, and
// the edge in `edge`.
int split(Mesh& mesh, std::vector<int>& loop, Draw& draw, std::pair<int, int>& edge) {
  const std::size_t i = draw.below(loop.size());
  edge = {loop[i], loop[(i + 1) % loop.size()]};
  const int middle = static_cast<int>(mesh.vertices.size());
  mesh.vertices.push_back(0.5 * (mesh.vertices[static_cast<std::size_t>(edge.first)] +
                                 mesh.vertices[static_cast<std::size_t>(edge.second)]));
  loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(i + 1), middle);
  return middle;
}

struct Spoiling {
  const char* name;
  void (*apply)(Mesh&, Draw&);
};

const std::array<Spoiling, 19> spoilings = {{
    {"none", [](Mesh&, Draw&) {}},
    {"one vertex moved by up to 3 ulps",
     [](Mesh& m, Draw& d) {
       Vec2& v = d.any(m.vertices);
       v = {some_ulps(v.x(), d), some_ulps(v.y(), d)};
     }},
    {"all vertices moved by up to 3 ulps",
     [](Mesh& m, Draw& d) {
       for (Vec2& v : m.vertices)
         v = {some_ulps(v.x(), d), some_ulps(v.y(), d)};
     }},
    {"one vertex moved by 1e-9 of a cell",
     [](Mesh& m, Draw& d) { move_by(m, d, 1e-9); }},
    {"one vertex moved by up to half a cell",
     [](Mesh& m, Draw& d) { move_by(m, d, 0.5); }},
    {"one vertex moved by up to two cells",
     [](Mesh& m, Draw& d) { move_by(m, d, 2.0); }},
    {"one vertex moved onto another",
     [](Mesh& m, Draw& d) { d.any(m.vertices) = Vec2(d.any(m.vertices)); }},
    {"one vertex moved onto the middle of two others",
     [](Mesh& m, Draw& d) {
       const Vec2 middle = 0.5 * (d.any(m.vertices) + d.any(m.vertices));
       d.any(m.vertices) = middle;
     }},
    {"a cell dropped",
     [](Mesh& m, Draw& d) {
       m.cells.erase(m.cells.begin() +
                     static_cast<std::ptrdiff_t>(d.below(m.cells.size())));
     }},
    {"a cell twice",
     [](Mesh& m, Draw& d) {
       const std::vector<int> cell = d.any(m.cells);
       m.cells.push_back(cell);
     }},
    {"a cell reversed",
     [](Mesh& m, Draw& d) {
       auto& cell = d.any(m.cells);
       std::reverse(cell.begin(), cell.end());
     }},
    {"two corners of a cell swapped",
     [](Mesh& m, Draw& d) {
       auto& cell = d.any(m.cells);
       std::swap(d.any(cell), d.any(cell));
     }},
    {"a corner of a cell replaced by another vertex",
     [](Mesh& m, Draw& d) {
       d.any(d.any(m.cells)) = static_cast<int>(d.below(m.vertices.size() + 1));
     }},
    {"a corner in the middle of an edge of one cell (T-junction)",
     [](Mesh& m, Draw& d) {
       std::pair<int, int> edge;
       split(m, d.any(m.cells), d, edge);
     }},
    {"a corner in the middle of an edge, on both its sides",
     [](Mesh& m, Draw& d) {
       std::pair<int, int> edge;
       auto& first = d.any(m.cells);
       const int middle = split(m, first, d, edge);
       for (auto* loop : [&] {
              std::vector<std::vector<int>*> loops;
              for (auto& cell : m.cells)
                loops.push_back(&cell);
              loops.push_back(&m.outline);
              return loops;
            }()) {
         const bool is_outline = loop == &m.outline;
         for (std::size_t i = 0; i < loop->size(); ++i) {
           const int a = (*loop)[i];
           const int b = (*loop)[(i + 1) % loop->size()];
           if (is_outline ? a == edge.first && b == edge.second
                          : a == edge.second && b == edge.first) {
             loop->insert(loop->begin() + static_cast<std::ptrdiff_t>(i + 1), middle);
             break;
           }
         }
       }
     }},
    {"a second vertex at the same place in one cell",
     [](Mesh& m, Draw& d) {
       int& corner = d.any(d.any(m.cells));
       const Vec2 place = m.vertices[static_cast<std::size_t>(corner)];
       corner = static_cast<int>(m.vertices.size());
       m.vertices.push_back(place);
     }},
    {"a corner of the outline dropped",
     [](Mesh& m, Draw& d) {
       m.outline.erase(m.outline.begin() +
                       static_cast<std::ptrdiff_t>(d.below(m.outline.size())));
     }},
    {"the outline reversed, or begun elsewhere",
     [](Mesh& m, Draw& d) {
       if (d.below(2) == 0)
         std::reverse(m.outline.begin(), m.outline.end());
       else
         std::rotate(m.outline.begin(),
                     m.outline.begin() +
                         static_cast<std::ptrdiff_t>(d.below(m.outline.size())),
                     m.outline.end());
     }},
    {"numbers of the vertices changed throughout",
     [](Mesh& m, Draw& d) {
       std::vector<int> number(m.vertices.size());
       std::iota(number.begin(), number.end(), 0);
       for (std::size_t i = number.size(); i > 1; --i)
         std::swap(number[i - 1], number[d.below(i)]);
       std::vector<Vec2> moved(m.vertices.size());
       for (std::size_t i = 0; i < number.size(); ++i)
         moved[static_cast<std::size_t>(number[i])] = m.vertices[i];
       m.vertices = moved;
       for (auto& cell : m.cells)
         for (int& v : cell)
           v = number[static_cast<std::size_t>(v)];
       for (int& v : m.outline)
         v = number[static_cast<std::size_t>(v)];
     }},
}};

struct Row {
  long meshes = 0, tile = 0, apart = 0, broken = 0, holds = 0;
  std::vector<std::uint64_t> disagree;
};

std::string markdown(const std::vector<Row>& rows) {
  std::ostringstream out;
  out << R"(# The certificate against brute force

Written by `./go validate layers`; do not edit. Walls, walls with displaced vertices and
generated layers are spoilt in one way (one in five twice). Brute force on whole numbers
and the certificate judge them. The certificate must hold exactly if the cells tile the
outline corner to corner. If they tile it with a corner inside an edge or with two
vertices at one place, it refuses, because such neighbours share no vertex.

| spoilt | meshes | tile | tile, not corner to corner | do not tile | certificate holds | disagreements |
|---|---|---|---|---|---|---|
)";
  Row total;
  const auto line = [&out](const char* name, const Row& r) {
    out << "| " << name << " | " << r.meshes << " | " << r.tile << " | " << r.apart
        << " | " << r.broken << " | " << r.holds << " | " << r.disagree.size()
        << " |\n";
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& r = rows[i];
    line(spoilings[i].name, r);
    total.meshes += r.meshes;
    total.tile += r.tile;
    total.apart += r.apart;
    total.broken += r.broken;
    total.holds += r.holds;
    total.disagree.insert(total.disagree.end(), r.disagree.begin(), r.disagree.end());
  }
  line("**all**", total);
  for (const std::uint64_t number : total.disagree)
    out << "\ndisagreement: mesh " << number << "\n";
  return out.str();
}

int run(int argc, char** argv) {
  CLI::App app{"the certificate against brute force on spoilt meshes"};
  std::uint64_t meshes = 20000;
  std::string report;
  app.add_option("--meshes", meshes, "number of meshes")
      ->check(CLI::Range(1, 100000000));
  app.add_option("--report", report, "write NAME.md");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  std::vector<Row> rows(spoilings.size());
  bool agreed = true;
  for (std::uint64_t number = 0; number < meshes; ++number) {
    Draw draw(number);
    Mesh mesh = sound_mesh(draw);
    const std::size_t kind = number % spoilings.size();
    spoilings[kind].apply(mesh, draw);
    if (draw.below(5) == 0 && kind != 0 && !mesh.cells.empty() && !mesh.outline.empty())
      spoilings[1 + draw.below(7)].apply(mesh, draw);
    const Judgement truth = judge(mesh);
    const bool expected = truth.tiles && truth.conforming;
    const bool holds = certify_tiling(mesh).holds;
    Row& row = rows[kind];
    ++row.meshes;
    ++(expected ? row.tile : truth.tiles ? row.apart : row.broken);
    row.holds += holds ? 1 : 0;
    if (holds != expected) {
      row.disagree.push_back(number);
      agreed = false;
      std::cerr << "mesh " << number << " (" << spoilings[kind].name
                << "): certificate '" << certify_tiling(mesh).fault << "', judge '"
                << truth.reason << "'\n";
    }
  }
  std::cout << markdown(rows);
  if (!report.empty()) {
    std::ofstream out(report + ".md");
    out << markdown(rows);
    out.flush();
    if (!out) {
      std::cerr << "blocks: error: cannot write " << report << ".md\n";
      return 5;
    }
  }
  return agreed ? 0 : 4;
}

}  // namespace
}  // namespace blocks::validation

int main(int argc, char** argv) { return blocks::validation::run(argc, argv); }
