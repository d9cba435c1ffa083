// READ9 form (b): Gmsh .msh, ASCII, versions 2 to 2.2 and 4.1 (docs/mesh-formats.md).
// Triangles and quadrilaterals of any order are read by their corners; z must be the
// same for all. Files of `blocks export` may have a section $Blocks, which replaces the
// elements.
#include <fmt/format.h>

#include <algorithm>

#include "deck/mesh/mesh_forms.hpp"
#include "text/counted.hpp"

namespace blocks::deck::mesh {
namespace {

// Element types by their Gmsh numbers. The corner nodes always come first.
struct ElementType {
  long number;
  std::size_t corners;  // 0: a point or a line, which is skipped
  std::size_t nodes;
};
constexpr std::array element_types{
    ElementType{15, 0, 1},  ElementType{1, 0, 2},   ElementType{8, 0, 3},
    ElementType{26, 0, 4},  ElementType{27, 0, 5},  ElementType{28, 0, 6},
    ElementType{2, 3, 3},   ElementType{9, 3, 6},   ElementType{20, 3, 9},
    ElementType{21, 3, 10}, ElementType{22, 3, 12}, ElementType{23, 3, 15},
    ElementType{24, 3, 15}, ElementType{25, 3, 21}, ElementType{3, 4, 4},
    ElementType{16, 4, 8},  ElementType{10, 4, 9},  ElementType{39, 4, 12},
    ElementType{36, 4, 16}, ElementType{40, 4, 16}, ElementType{41, 4, 20},
    ElementType{37, 4, 25}, ElementType{38, 4, 36}};

class Reader {
 public:
  Reader(std::string_view file, std::string_view text)
      : lines_(file, text, "", false) {}

  MeshFile read();

 private:
  Lines lines_;
  std::string version_;
  Elements elements_;
  std::unordered_map<long, long> physical_of_surface_;  // version 4.1 only
  std::map<long, std::string> names_;
  std::size_t passed_over_ = 0, higher_order_ = 0;
  bool nodes_seen_ = false, elements_seen_ = false, rings_seen_ = false;

  void format();
  void entities();
  void physical_names();
  void nodes_2();
  void nodes_4();
  void elements_2();
  void elements_4();
  void rings();
  void skip(const std::string& section);
  void end(const std::string& section);
  void expect(std::size_t fields, const std::string& what);
  void plane_element(const ElementType& type, std::size_t first_node, long material);
  const ElementType& type(std::size_t field) const;
  void node(long id, std::size_t x_field, std::size_t fields);
};

void Reader::expect(std::size_t fields, const std::string& what) {
  if (lines_.fields().size() != fields)
    fail(lines_.place(), fmt::format("{}: expected {}, found {}", what,
                                     counted(fields, "value"), lines_.fields().size()));
}

void Reader::end(const std::string& section) {
  lines_.need("$End" + section);
  if (lines_.fields()[0] != "$End" + section)
    fail(lines_.place(),
         fmt::format(
             "expected $End{} after the entries announced by ${}, found another line",
             section, section));
}

void Reader::skip(const std::string& section) {
  do {
    lines_.need("$End" + section);
  } while (lines_.fields()[0] != "$End" + section);
}

void Reader::format() {
  lines_.need("the Gmsh version");
  expect(3, "$MeshFormat");
  version_ = std::string(lines_.fields()[0]);
  if (version_ != "2" && version_ != "2.0" && version_ != "2.1" && version_ != "2.2" &&
      version_ != "4.1")
    fail(lines_.place(),
         fmt::format("Gmsh version '{}' is not read; save it as 2.2 or 4.1 ASCII",
                     version_.substr(0, 20)));
  if (lines_.integer(1, "file type") != 0)
    fail(lines_.place(), "a binary Gmsh file; save it as ASCII (Mesh.Binary = 0)");
  end("MeshFormat");
}

// Version 4.1: surfaces have the physical groups, and elements refer to their surface.
void Reader::entities() {
  lines_.need("the numbers of entities");
  expect(4, "$Entities");
  const std::size_t points = lines_.count(0, "number of points");
  const std::size_t curves = lines_.count(1, "number of curves");
  const std::size_t surfaces = lines_.count(2, "number of surfaces");
  for (std::size_t i = 0; i < points + curves; ++i)
    lines_.need("a point or curve");
  for (std::size_t i = 0; i < surfaces; ++i) {
    lines_.need("a surface");  // tag, bounding box (6), number of groups, groups, ...
    const long tag = lines_.integer(0, "surface tag");
    const std::size_t groups = lines_.count(7, "number of physical groups");
    if (groups > 1)
      fail(lines_.place(), fmt::format("surface {} is in {} physical groups; a block "
                                       "has one material",
                                       tag, groups));
    // The sign of the group is the orientation of the surface.
    physical_of_surface_[tag] =
        groups == 0 ? tag : magnitude(lines_.integer(8, "physical group"));
  }
  skip("Entities");  // skips the volumes
}

// Lines of dimension, number and "name". Only surfaces are blocks.
void Reader::physical_names() {
  lines_.need("the number of physical names");
  const std::size_t count = lines_.count(0, "number of physical names");
  for (std::size_t i = 0; i < count; ++i) {
    lines_.need(fmt::format("physical name {} of {}", i + 1, count));
    const auto& fields = lines_.fields();
    const long dimension = lines_.integer(0, "dimension");
    const long number = magnitude(lines_.integer(1, "physical group"));
    std::string name = fields.size() < 3
                           ? ""
                           : std::string(fields[2].data(),
                                         fields.back().data() + fields.back().size());
    if (name.size() < 2 || name.front() != '"' || name.back() != '"')
      fail(lines_.place(),
           fmt::format("physical group {}: expected a name in quotes", number));
    if (dimension == 2 && name.size() > 2)
      names_.emplace(number, name.substr(1, name.size() - 2));
  }
  end("PhysicalNames");
}

void Reader::node(long id, std::size_t x_field, std::size_t fields) {
  if (lines_.fields().size() < fields)
    fail(lines_.place(), fmt::format("node {}: expected x, y, z", id));
  elements_.add_node(id, lines_.real(x_field, "x"), lines_.real(x_field + 1, "y"),
                     lines_.place(), lines_.real(x_field + 2, "z"));
}

void Reader::nodes_2() {
  lines_.need("the number of nodes");
  const std::size_t count = lines_.count(0, "number of nodes");
  for (std::size_t i = 0; i < count; ++i) {
    lines_.need(fmt::format("node {} of {}", i + 1, count));
    node(lines_.integer(0, "node id"), 1, 4);
  }
  end("Nodes");
}

void Reader::nodes_4() {
  lines_.need("the numbers of nodes");
  expect(4, "$Nodes");
  const std::size_t entity_blocks = lines_.count(0, "number of entity blocks");
  const std::size_t total = lines_.count(1, "number of nodes");
  std::size_t seen = 0;
  std::vector<long> ids;
  for (std::size_t b = 0; b < entity_blocks; ++b) {
    lines_.need(fmt::format("entity block {} of {}", b + 1, entity_blocks));
    expect(4, "entity block of nodes");
    const std::size_t count = lines_.count(3, "number of nodes");
    ids.clear();
    for (std::size_t i = 0; i < count; ++i) {
      lines_.need("a node id");
      ids.push_back(lines_.integer(0, "node id"));
    }
    for (const long id : ids) {
      lines_.need(fmt::format("the coordinates of node {}", id));
      node(id, 0, 3);
    }
    seen += count;
  }
  if (seen != total)
    fail(lines_.place(),
         fmt::format("$Nodes announces {}, its blocks have {}", total, seen));
  end("Nodes");
}

const ElementType& Reader::type(std::size_t field) const {
  const long number = lines_.integer(field, "element type");
  const auto found = std::find_if(
      element_types.begin(), element_types.end(),
      [&](const ElementType& candidate) { return candidate.number == number; });
  if (found == element_types.end())
    fail(lines_.place(), fmt::format("Gmsh element type {} is not read; READ9 reads "
                                     "plane triangles and quadrilaterals up to order 5",
                                     number));
  return *found;
}

void Reader::plane_element(const ElementType& element, std::size_t first_node,
                           long material) {
  const std::string name =
      fmt::format("element {}", lines_.integer(0, "element number"));
  if (lines_.fields().size() != first_node + element.nodes)
    fail(lines_.place(),
         fmt::format("{}: expected {}, found {}", name, counted(element.nodes, "node"),
                     lines_.fields().size() -
                         std::min(first_node, lines_.fields().size())));
  if (element.corners == 0) {
    ++passed_over_;
    return;
  }
  std::array<long, 4> corners{};
  for (std::size_t c = 0; c < element.corners; ++c)
    corners[c] = lines_.integer(first_node + c, name + ": node");
  elements_.add(std::span(corners).first(element.corners), material, name,
                lines_.place());
  if (element.nodes > element.corners)
    ++higher_order_;
}

// Reads lines of element number, type, number of tags, tags (physical group, elementary
// tag, ...), nodes.
void Reader::elements_2() {
  lines_.need("the number of elements");
  const std::size_t count = lines_.count(0, "number of elements");
  for (std::size_t i = 0; i < count; ++i) {
    lines_.need(fmt::format("element {} of {}", i + 1, count));
    const ElementType& element = type(1);
    const long tags = lines_.integer(2, "number of tags");
    if (tags < 0 || static_cast<std::size_t>(tags) > lines_.fields().size())
      fail(lines_.place(), fmt::format("{} tags do not fit the line", tags));
    long material = tags > 0 ? magnitude(lines_.integer(3, "physical group")) : 0;
    if (material == 0 && tags > 1)
      material = lines_.integer(4, "elementary tag");
    if (material == 0)
      material = 1;
    plane_element(element, 3 + static_cast<std::size_t>(tags), material);
  }
  end("Elements");
}

// Reads entity blocks: dimension, entity tag, type and number of elements; then, for
// each element, its number and nodes.
void Reader::elements_4() {
  lines_.need("the numbers of elements");
  expect(4, "$Elements");
  const std::size_t entity_blocks = lines_.count(0, "number of entity blocks");
  const std::size_t total = lines_.count(1, "number of elements");
  std::size_t seen = 0;
  for (std::size_t b = 0; b < entity_blocks; ++b) {
    lines_.need(fmt::format("entity block {} of {}", b + 1, entity_blocks));
    expect(4, "entity block of elements");
    const long tag = lines_.integer(1, "entity tag");
    const ElementType& element = type(2);
    const std::size_t count = lines_.count(3, "number of elements");
    const auto physical = physical_of_surface_.find(tag);
    const long material =
        physical == physical_of_surface_.end() ? tag : physical->second;
    for (std::size_t i = 0; i < count; ++i) {
      lines_.need(fmt::format("element {} of {}", i + 1, count));
      plane_element(element, 1, material);
    }
    seen += count;
  }
  if (seen != total)
    fail(lines_.place(),
         fmt::format("$Elements announces {}, its blocks have {}", total, seen));
  end("Elements");
}

void Reader::rings() {
  lines_.need("the number of blocks");
  const std::size_t count = lines_.count(0, "number of blocks");
  for (std::size_t i = 0; i < count; ++i) {
    const std::string name = fmt::format("block {}", i + 1);
    lines_.need(fmt::format("{} of {}", name, count));
    elements_.blocks.push_back(read_ring(lines_, elements_, name));
  }
  end("Blocks");
}

MeshFile Reader::read() {
  while (lines_.next()) {
    const std::string_view word = lines_.fields()[0];
    if (word.size() < 2 || word[0] != '$' || word.starts_with("$End"))
      fail(lines_.place(), "expected a Gmsh section such as $Nodes");
    const std::string section(word.substr(1));
    if (section == "MeshFormat") {
      format();
    } else if (version_.empty() && section != "Comments") {
      fail(lines_.place(), "$MeshFormat must come first");
    } else if (section == "PartitionedEntities") {
      fail(lines_.place(), "a partitioned Gmsh mesh; save it without partitions");
    } else if (section == "PhysicalNames") {
      physical_names();
    } else if (section == "Entities") {
      entities();
    } else if (section == "Nodes") {
      version_ == "4.1" ? nodes_4() : nodes_2();
      nodes_seen_ = true;
    } else if (section == "Blocks") {
      if (!nodes_seen_ || elements_seen_)
        fail(lines_.place(), "$Blocks should be between $Nodes and $Elements");
      if (rings_seen_)
        fail(lines_.place(), "$Blocks is given twice");
      rings();
      rings_seen_ = true;
    } else if (section == "Elements" && rings_seen_) {
      skip(section);  // triangles of the same blocks, and their sides
      elements_seen_ = true;
    } else if (section == "Elements") {
      if (!nodes_seen_)
        fail(lines_.place(), "$Elements comes before $Nodes");
      version_ == "4.1" ? elements_4() : elements_2();
      elements_seen_ = true;
    } else {
      skip(section);
    }
  }
  if (!elements_seen_)
    fail(lines_.place(), "the file ends without an $Elements section");
  if (elements_.blocks.empty())
    fail(lines_.place(), rings_seen_
                             ? "no blocks in $Blocks"
                             : "no triangles or quadrilaterals in the Gmsh file");
  MeshFile mesh;
  mesh.form = MeshForm::gmsh;
  mesh.found = fmt::format("Gmsh {} ASCII, {}", version_,
                           rings_seen_ ? counted(elements_.blocks.size(), "block") +
                                             " of $Blocks"
                                       : elements_.found());
  if (higher_order_ > 0)
    mesh.found +=
        fmt::format(" ({} of higher order, reduced to corners)", higher_order_);
  if (passed_over_ > 0)
    mesh.found += fmt::format(" (points and lines skipped: {})", passed_over_);
  mesh.blocks = std::move(elements_.blocks);
  mesh.names = std::move(names_);
  return mesh;
}

}  // namespace

MeshFile read_gmsh(std::string_view file, std::string_view text) {
  return Reader(file, text).read();
}

}  // namespace blocks::deck::mesh
