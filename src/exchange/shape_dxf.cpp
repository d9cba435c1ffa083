// The lines of a drawing as traces, and its closed lines as blocks.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>

#include "exchange/block_record.hpp"
#include "exchange/dxf_reader.hpp"
#include "exchange/shape_collector.hpp"

namespace blocks::exchange {
namespace {

/// The points as written numbers, whose texts this holds.
class WrittenLine {
 public:
  WrittenLine(const DxfLine& line, bool closes) : at_(line.at) {
    for (const geometry::Vec2& point : line.points)
      texts_.push_back({shortest(point.x()), shortest(point.y())});
    if (closes && !texts_.empty())
      texts_.push_back(texts_.front());
  }
  std::vector<Position> positions() const {
    std::vector<Position> all;
    for (const WrittenCorner& text : texts_)
      all.push_back({WrittenNumber{text[0], at_}, WrittenNumber{text[1], at_}});
    return all;
  }

 private:
  std::size_t at_;
  std::vector<WrittenCorner> texts_;
};

/// Returns the material of each layer that blocks are on, and gives new ones names.
std::map<std::size_t, long> materials_of(const std::vector<std::string>& layers,
                                         const std::set<std::size_t>& used,
                                         std::map<long, std::string>& names) {
  std::map<std::size_t, long> materials;
  std::set<long> taken;
  for (const std::size_t i : used)
    if (const LayerName layer = parse_layer(layers[i]); layer.number) {
      materials[i] = *layer.number;
      taken.insert(*layer.number);
      if (!layer.name.empty() && layer.name != "material")
        names.emplace(*layer.number, layer.name);
    }
  long next = 1;
  for (const std::size_t i : used) {
    if (materials.count(i) > 0 || layers[i] == "0")
      continue;
    while (!taken.insert(next).second)
      ++next;
    materials[i] = next;
    names.emplace(next, layers[i]);
  }
  return materials;
}

}  // namespace

LayerName parse_layer(const std::string& name) {
  const auto number_of = [](std::string_view text) {
    int number = 0;
    const char* end = text.data() + text.size();
    const auto [rest, fault] = std::from_chars(text.data(), end, number);
    return fault == std::errc() && rest == end && number > 0 ? number : 0;
  };
  constexpr const char* separators = " _";
  const std::size_t first = name.find_first_of(separators);
  if (const int number = number_of(name.substr(0, first)); number > 0)
    return {number, first == name.npos ? std::string() : name.substr(first + 1)};
  const std::size_t last = name.find_last_of(separators);
  if (last != name.npos)
    if (const int number = number_of(name.substr(last + 1)); number > 0)
      return {number, name.substr(0, last)};
  return {std::nullopt, name};
}

void collect_dxf(std::string_view text, ShapeCollector& shapes) {
  DxfDrawing drawing = read_drawing(text);
  for (Message& message : drawing.messages)
    shapes.add(std::move(message));
  if (shapes.wanted() == Shapes::points) {
    shapes.error(nowhere, "points of cells are not read from a drawing",
                 "give them as CSV with x, y");
    return;
  }
  std::vector<std::optional<int>> joints;
  for (const std::string& layer : drawing.layers)
    joints.push_back(parse_layer(layer).number);
  for (const DxfLine& line : drawing.lines)
    shapes.add_line(WrittenLine(line, line.is_closed).positions(), joints[line.layer],
                    line.at, drawing.layers[line.layer]);
  shapes.note_drawing(drawing.unit, describe_chords(drawing));
}

OutlineFile read_dxf(std::string_view text) {
  DxfDrawing drawing = read_drawing(text);
  std::vector<const DxfLine*> closed;
  std::set<std::size_t> used;
  OpenLines open;
  for (const DxfLine& line : drawing.lines)
    if (line.is_closed ||
        (line.points.size() > 3 && line.points.front() == line.points.back())) {
      closed.push_back(&line);
      used.insert(line.layer);
    } else if (open.n++ == 0) {
      open.first = line.at;
    }
  std::map<long, std::string> names;
  auto materials = materials_of(drawing.layers, used, names);
  RingReader rings;
  for (Message& message : drawing.messages)
    rings.add(std::move(message));
  for (const DxfLine* line : closed)
    rings.add(WrittenLine(*line, line->is_closed).positions(),
              {materials[line->layer], false, {}, drawing.layers[line->layer]},
              line->at);
  const std::string chords = describe_chords(drawing);
  OutlineFile file = rings.finish("DXF");
  if (!chords.empty())
    file.found += "; " + chords;
  file.material_names = std::move(names);
  file.unit = drawing.unit;
  file.open = open;
  return file;
}

}  // namespace blocks::exchange
