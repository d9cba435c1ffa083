#include "post/export/vtu_file.hpp"

#include <fmt/format.h>

#include <bit>

#include "files/whole_file.hpp"

namespace blocks::post {
namespace {

static_assert(std::endian::native == std::endian::little);

/// Writes the descriptions of arrays in the head of the file, and keeps their bytes for
/// its end.
class Appended {
 public:
  template <class T>
  std::string array(const std::string& name, const char* type, int components,
                    const std::vector<T>& values, const std::string& more = "") {
    std::string line =
        fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"{} "
                    "format=\"appended\" offset=\"{}\"/>\n",
                    type, name, components, more, bytes_.size());
    const std::uint64_t size = values.size() * sizeof(T);
    bytes_.append(reinterpret_cast<const char*>(&size), sizeof size);
    bytes_.append(reinterpret_cast<const char*>(values.data()), size);
    return line;
  }
  std::string array(const VtuArray& one) {
    if (const auto* real = std::get_if<std::vector<double>>(&one.values))
      return array(one.name, "Float64", one.components, *real);
    return array(one.name, "Int32", one.components,
                 std::get<std::vector<int>>(one.values));
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

}  // namespace

std::vector<double> in_space(const Eigen::Matrix2Xd& plane) {
  std::vector<double> rows;
  rows.reserve(static_cast<std::size_t>(plane.cols()) * 3);
  for (const auto column : plane.colwise())
    rows.insert(rows.end(), {column.x(), column.y(), 0.0});
  return rows;
}

void write_vtu(const std::string& path, const VtuGrid& grid) {
  std::vector<unsigned char> types;
  for (std::size_t k = 0; k < grid.ends.size(); ++k) {
    const bool is_empty = grid.ends[k] == (k == 0 ? 0 : grid.ends[k - 1]);
    types.push_back(static_cast<unsigned char>(is_empty ? 0 : grid.cell_type));
  }
  const std::string one_tuple = " NumberOfTuples=\"1\"";
  Appended data;
  std::string head =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
      "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n"
      "<FieldData>\n";
  head += data.array("TimeValue", "Float64", 1, std::vector{grid.time}, one_tuple);
  head += data.array("Step", "Int64", 1, std::vector{grid.step}, one_tuple);
  head += fmt::format("</FieldData>\n<Piece NumberOfPoints=\"{}\" "
                      "NumberOfCells=\"{}\">\n<Points>\n",
                      grid.points.cols(), grid.ends.size());
  head += data.array("Points", "Float64", 3, in_space(grid.points));
  head += "</Points>\n<Cells>\n";
  head += data.array("connectivity", "Int64", 1, grid.connectivity);
  head += data.array("offsets", "Int64", 1, grid.ends);
  head += data.array("types", "UInt8", 1, types);
  head += "</Cells>\n<CellData>\n";
  for (const VtuArray& one : grid.cell_data)
    head += data.array(one);
  head += "</CellData>\n</Piece>\n</UnstructuredGrid>\n<AppendedData "
          "encoding=\"raw\">\n_";
  files::WholeFile file(path);
  file << head << data.bytes() << "\n</AppendedData>\n</VTKFile>\n";
  file.close();
}

}  // namespace blocks::post
