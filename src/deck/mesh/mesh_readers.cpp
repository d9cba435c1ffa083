// Recognises which of READ9's four forms a file has and collects its elements (report
// A.2.3). The QMESH tape of 1973 is lost; docs/mesh-formats.md says what is read in its
// place.
#include "deck/mesh/mesh_readers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include "deck/mesh/mesh_forms.hpp"
#include "text/counted.hpp"

namespace blocks::deck {
namespace mesh {

void fail(const Place& place, const std::string& message, const std::string& hint) {
  if (place.line > 0)
    throw MeshError(fmt::format("{}:{}: {}", place.file, place.line, message), hint);
  if (place.record > 0)
    throw MeshError(fmt::format("{}: record {}: {}", place.file, place.record, message),
                    hint);
  throw MeshError(fmt::format("{}: {}", place.file, message), hint);
}

bool turn_clockwise(MeshBlock& block) {
  geometry::Polygon& outline = block.outline;
  double twice_area = 0;  // relative to the first corner, to lose no digits
  for (std::size_t i = 2; i < outline.size(); ++i)
    twice_area += geometry::cross(outline[i - 1] - outline[0], outline[i] - outline[0]);
  if (twice_area > 0) {
    std::reverse(outline.begin() + 1, outline.end());
    std::reverse(block.joints.begin(), block.joints.end());
  }
  return std::isfinite(twice_area) && twice_area != 0;
}

void Elements::add_node(long id, double x, double y, const Place& place, double z) {
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
    fail(place, fmt::format("node {} has a coordinate that is not finite", id));
  const Node node{{x, y}, z};
  const auto [known, added] = nodes_.emplace(id, node);
  if (!added && (known->second.position != node.position || known->second.z != z))
    fail(place, fmt::format("node {} is given twice, at different places", id));
}

void check_material(long material, const std::string& name, const Place& place) {
  if (material < 1)
    fail(place, fmt::format("{}: material {} is not positive", name, material));
  if (material > std::numeric_limits<int>::max())
    fail(place, fmt::format("{}: material {} is above {}", name, material,
                            std::numeric_limits<int>::max()));
}

geometry::Polygon Elements::outline_of(std::span<const long> corners,
                                       const std::string& name, const Place& place) {
  geometry::Polygon outline;
  for (const long id : corners) {
    const auto node = nodes_.find(id);
    if (node == nodes_.end())
      fail(place, fmt::format("{} refers to node {}, which is not there", name, id));
    outline.push_back(node->second.position);
    if (!level_)
      level_ = node->second.z;
    const double size = (outline.back() - outline.front()).norm();
    if (std::abs(node->second.z - *level_) > 1e-9 * (std::abs(*level_) + size))
      fail(place, fmt::format("{} leaves the plane of the mesh: node {} has z = {}, "
                              "others {}",
                              name, id, node->second.z, *level_));
  }
  return outline;
}

MeshBlock Elements::ring(std::span<const long> corners, std::vector<int> joints,
                         long material, const std::string& name, const Place& place) {
  check_material(material, name, place);
  MeshBlock block{outline_of(corners, name, place), material, place.line,
                  std::move(joints)};
  turn_clockwise(block);  // the model's check rejects one without area
  return block;
}

void Elements::add(std::span<const long> corners, long material,
                   const std::string& name, const Place& place) {
  check_material(material, name, place);
  std::vector<long> ids;
  for (const long id : corners)
    if (ids.empty() || ids.back() != id)
      ids.push_back(id);
  while (ids.size() > 1 && ids.back() == ids.front())
    ids.pop_back();

  std::array<long, 4> key{};
  key.fill(std::numeric_limits<long>::min());
  std::copy_n(ids.begin(), std::min(ids.size(), key.size()), key.begin());
  std::sort(key.begin(), key.end());
  const auto first = key.end() - static_cast<std::ptrdiff_t>(ids.size());
  if (ids.size() < 3 || std::adjacent_find(first, key.end()) != key.end())
    fail(place, fmt::format("{} repeats a node: {}", name, fmt::join(corners, ", ")));
  if (!taken_.insert(key).second)
    fail(place, fmt::format("{} has the nodes of an earlier element: {}", name,
                            fmt::join(corners, ", ")));

  MeshBlock block{outline_of(ids, name, place), material, place.line};
  if (!turn_clockwise(block))
    fail(place, name + " has no area in the x, y plane");
  ++(ids.size() == 3 ? triangles_ : quadrilaterals_);
  blocks.push_back(std::move(block));
}

std::string Elements::found() const {
  std::string text;
  if (quadrilaterals_ > 0)
    text = counted(quadrilaterals_, "quadrilateral");
  if (triangles_ > 0)
    text += (text.empty() ? "" : ", ") + counted(triangles_, "triangle");
  return text;
}

namespace {

std::string read_all(const std::string& path) {
  std::error_code ignored;
  // A device may have no end, and a pipe no writer. A run reads the mesh twice.
  if (std::filesystem::exists(path, ignored) &&
      !std::filesystem::is_directory(path, ignored) &&
      !std::filesystem::is_regular_file(path, ignored))
    fail({path}, "cannot read the mesh file: it is a device or a pipe");
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in)
    fail({path}, fmt::format("cannot open the mesh file: {}", std::strerror(errno)));
  std::string data;
  try {
    data.assign(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  } catch (const std::ios_base::failure&) {  // libstdc++ throws here for a folder
    fail({path}, "cannot read the mesh file: it is a folder, or reading failed");
  }
  if (in.bad())
    fail({path}, "cannot read the mesh file");
  return data;
}

/// Tests whether the text has a line whose first field is the word.
bool has_line(std::string_view text, std::string_view word) {
  for (auto at = text.find(word); at != text.npos; at = text.find(word, at + 1)) {
    const auto before = text.substr(0, at).find_last_not_of(" \t");
    const auto after = text.substr(at + word.size(), 1);
    if ((before == text.npos || text[before] == '\n' || text[before] == '\r') &&
        after.find_first_not_of(" \t\r\n") == after.npos)
      return true;
  }
  return false;
}

/// Returns why a file with bytes that no text contains is not read.
std::string binary_reason(std::string_view data) {
  if (data.starts_with("CDF") || data.starts_with("\x89HDF"))
    return "a netCDF or HDF5 file (Exodus II?), which READ9 does not read; save the "
           "mesh as Gmsh ASCII or as Fortran unformatted GENESIS";
  return "a binary file that is neither GENESIS nor region records: the first Fortran "
         "record should have 80, 28 or 56 bytes between 4-byte markers";
}

}  // namespace
}  // namespace mesh

MeshFile read_mesh(const std::string& path) {
  return parse_mesh(path, mesh::read_all(path));
}

MeshFile parse_mesh(const std::string& path, std::string_view text) {
  if (text.find_first_not_of(" \t\r\n") == text.npos)
    mesh::fail({path}, "the mesh file is empty");
  if (mesh::Records::recognise(text)) {
    const mesh::Records records(path, text);
    return records.length(0, "header") == 80 ? mesh::read_genesis(records)
                                             : mesh::read_regions(records);
  }
  if (text.starts_with("\xEF\xBB\xBF"))
    text.remove_prefix(3);
  if (mesh::has_line(text, "$MeshFormat"))
    return mesh::read_gmsh(path, text);
  if (mesh::has_line(text, "$NOD"))
    mesh::fail({path}, "a Gmsh 1 file; save it as Gmsh 2.2 or 4.1 ASCII");
  if (text.find('\0') != text.npos || text.starts_with("\x89HDF"))
    mesh::fail({path}, mesh::binary_reason(text));
  return mesh::read_text(path, text);
}

}  // namespace blocks::deck
