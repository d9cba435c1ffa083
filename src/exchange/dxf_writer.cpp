#include <dxflib/dl_writer_ascii.h>
#include <fmt/format.h>

#include <array>
#include <set>

#include "exchange/block_record.hpp"
#include "exchange/dxf_units.hpp"
#include "exchange/joint_lines.hpp"

namespace blocks::exchange {
namespace {

using geometry::Vec2;

/// The library's writer of R12, which every program reads, into a text. Numbers are the
/// shortest decimals; the library's own have 16 digits.
class TextWriter : public DL_WriterA {
 public:
  TextWriter() : DL_WriterA("", DL_Codes::AC1009) {}

  mutable std::string text;

  void dxfReal(int code, double value) const override { put(code, shortest(value)); }
  void dxfInt(int code, int value) const override { put(code, std::to_string(value)); }
  void dxfHex(int code, int value) const override {
    put(code, fmt::format("{:X}", value));
  }
  void dxfString(int code, const char* value) const override { put(code, value); }
  void dxfString(int code, const std::string& value) const override {
    put(code, value);
  }

 private:
  void put(int code, const std::string& value) const {
    text += fmt::format("{:>3}\n{}\n", code, value);
  }
};

/// A name as R12 has them: letters, digits, $, - and _.
std::string layer_name(const std::string& name) {
  std::string layer = name;
  for (char& c : layer)
    if (!(std::isalnum(static_cast<unsigned char>(c)) || c == '$' || c == '-' ||
          (static_cast<unsigned char>(c) & 0x80) != 0))
      c = '_';
  return layer;
}

std::string layer_of(const BlockRecord& block) {
  return block.material_name.empty()
             ? fmt::format("material_{}", block.material)
             : fmt::format("{}_{}", block.material, layer_name(block.material_name));
}

std::string layer_of_joint(int id) { return fmt::format("joint_{}", id); }

void write_header(const TextWriter& out, const std::vector<BlockRecord>& blocks,
                  const std::string& unit) {
  Vec2 low = Vec2::Constant(HUGE_VAL), high = -low;
  for (const BlockRecord& block : blocks)
    for (const Vec2& corner : block.outline) {
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
  out.sectionHeader();
  out.dxfString(9, "$ACADVER");
  out.dxfString(1, "AC1009");
  if (const int code = dxf_code_of(unit); code > 0) {
    out.dxfString(9, "$INSUNITS");
    out.dxfInt(70, code);
  }
  out.dxfString(9, "$EXTMIN");
  out.coord(10, low.x(), low.y());
  out.dxfString(9, "$EXTMAX");
  out.coord(10, high.x(), high.y());
  out.sectionEnd();
}

/// The layers, with colours of the drawing program's palette: white or black for
/// blocks, 1 (red) to 6 for joints.
void write_layers(const TextWriter& out, const std::set<std::string>& of_blocks,
                  const std::map<int, std::vector<JointLine>>& joints) {
  out.sectionTables();
  out.tableLayers(static_cast<int>(1 + of_blocks.size() + joints.size()));
  const auto layer = [&out](const std::string& name, int colour) {
    out.tableLayerEntry();
    out.dxfString(2, name);
    out.dxfInt(70, 0);
    out.dxfInt(62, colour);
    out.dxfString(6, "CONTINUOUS");
  };
  layer("0", 7);
  for (const std::string& name : of_blocks)
    layer(name, 7);
  for (const auto& joint : joints)
    layer(layer_of_joint(joint.first), 1 + (joint.first - 1) % 6);
  out.tableEnd();
  out.sectionEnd();
}

void write_block(const TextWriter& out, const BlockRecord& block) {
  const std::string layer = layer_of(block);
  out.entity("POLYLINE");
  out.dxfString(8, layer);
  out.dxfInt(66, 1);  // vertices follow
  out.dxfInt(70, 1);  // closed
  out.coord(10, 0.0, 0.0);
  for (const Vec2& corner : block.outline) {
    out.entity("VERTEX");
    out.dxfString(8, layer);
    out.coord(10, corner.x(), corner.y());
  }
  out.entity("SEQEND");
  out.dxfString(8, layer);
}

void write_line(const TextWriter& out, const JointLine& line, int id) {
  out.entity("LINE");
  out.dxfString(8, layer_of_joint(id));
  out.coord(10, line.from.x(), line.from.y());
  out.coord(11, line.to.x(), line.to.y());
}

}  // namespace

std::string write_dxf(const std::vector<BlockRecord>& blocks, const std::string& unit) {
  const auto joints = joint_lines(blocks);
  std::set<std::string> layers;
  for (const BlockRecord& block : blocks)
    layers.insert(layer_of(block));
  TextWriter out;
  write_header(out, blocks, unit);
  write_layers(out, layers, joints);
  out.sectionEntities();
  for (const BlockRecord& block : blocks)
    write_block(out, block);
  for (const auto& [id, lines] : joints)
    for (const JointLine& line : lines)
      write_line(out, line, id);
  out.sectionEnd();
  out.dxfEOF();
  return std::move(out.text);
}

}  // namespace blocks::exchange
