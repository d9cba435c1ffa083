// READ9 form (a): outlines in plain text (docs/mesh-formats.md). Also splits lines into
// fields, for the Gmsh reader as well.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "deck/mesh/mesh_forms.hpp"
#include "text/counted.hpp"

namespace blocks::deck::mesh {
namespace {

/// Returns a field as quoted in a message: shortened, without control characters.
std::string quoted(std::string_view field) {
  std::string text(field.substr(0, 40));
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 32 || c == 127)
      c = '?';
  return "'" + text + (field.size() > 40 ? "...'" : "'");
}

std::string upper(std::string_view word) {
  std::string text(word);
  for (char& c : text)
    if (c >= 'a' && c <= 'z')
      c = static_cast<char>(c - 'a' + 'A');
  return text;
}

}  // namespace

Lines::Lines(std::string_view file, std::string_view text, std::string_view comments,
             bool commas)
    : file_(file), text_(text), comments_(comments), commas_(commas) {}

bool Lines::next() {
  fields_.clear();
  while (fields_.empty() && position_ < text_.size()) {
    const auto end = std::min(text_.find('\n', position_), text_.size());
    std::string_view line = text_.substr(position_, end - position_);
    position_ = std::min(end + 1, text_.size());
    ++line_;
    if (!comments_.empty())
      line = line.substr(0, line.find_first_of(comments_));
    split(line);
  }
  return !fields_.empty();
}

void Lines::split(std::string_view line) {
  constexpr std::string_view blank = " \t\r\f\v";
  bool comma = false;  // after a comma another field must follow
  for (std::size_t i = 0; i < line.size();) {
    if (blank.find(line[i]) != blank.npos) {
      ++i;
    } else if (commas_ && line[i] == ',') {
      if (comma || fields_.empty())
        fail(place(), "a value is missing before the comma");
      comma = true;
      ++i;
    } else {
      const auto end = std::min(
          line.find_first_of(commas_ ? " \t\r\f\v," : " \t\r\f\v", i), line.size());
      fields_.push_back(line.substr(i, end - i));
      comma = false;
      i = end;
    }
  }
  if (comma)
    fail(place(), "a value is missing after the last comma");
}

void Lines::need(const std::string& expected) {
  if (!next())
    fail(place(), fmt::format("the file ends where {} should be", expected));
}

std::string_view Lines::field(std::size_t i, const std::string& what) const {
  if (i >= fields_.size())
    fail(place(), fmt::format("{} is missing: {} on this line", what,
                              counted(fields_.size(), "value")));
  std::string_view text = fields_[i];
  if (text.size() > 1 && text[0] == '+' && text[1] != '-')
    text.remove_prefix(1);
  return text;
}

long Lines::integer(std::size_t i, const std::string& what) const {
  const std::string_view text = field(i, what);
  long value = 0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    fail(place(), fmt::format("{} should be an integer, found {}", what, quoted(text)));
  return value;
}

int Lines::joint(std::size_t i, const std::string& what) const {
  const std::string_view text = field(i, what);
  int value = 0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 0)
    fail(place(),
         fmt::format("{} should be a whole number from 0 to {}, found {}", what,
                     std::numeric_limits<int>::max(), quoted(text)),
         "a joint id names the joint of the side that begins at the corner; 0 is none");
  return value;
}

double Lines::real(std::size_t i, const std::string& what) const {
  std::string text(field(i, what));
  std::replace(text.begin(), text.end(), 'D', 'E');  // exponents as in Fortran
  std::replace(text.begin(), text.end(), 'd', 'e');
  double value = 0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::invalid_argument || end != text.data() + text.size())
    fail(place(),
         fmt::format("{} should be a number, found {}", what, quoted(fields_[i])));
  if (error != std::errc() || !std::isfinite(value))
    fail(place(), fmt::format("{} {} is outside the range of numbers", what,
                              quoted(fields_[i])));
  return value;
}

std::size_t Lines::count(std::size_t i, const std::string& what) const {
  const long value = integer(i, what);
  if (value < 0)
    fail(place(), fmt::format("{} is negative: {}", what, value));
  const auto n = static_cast<std::size_t>(value);
  if (n > bytes_left() / 2 + 1)  // the last item needs no line end
    fail(place(), fmt::format("{} {} cannot be right: only {} of the file are left",
                              what, value, counted(bytes_left(), "byte")));
  return n;
}

// Reads BLOCKS [n], then for each block "nc, mat" and nc lines "x, y[, joint]".
MeshFile read_text(std::string_view file, std::string_view text) {
  Lines lines(file, text, "$!", true);
  lines.need("the word BLOCKS");
  if (upper(lines.fields()[0]) != "BLOCKS")
    throw UnknownMesh(fmt::format(
        "{}:{}: not a mesh that READ9 knows: the text form starts with BLOCKS, "
        "Gmsh with $MeshFormat; found {}",
        file, lines.place().line, quoted(lines.fields()[0])));
  if (lines.fields().size() > 2)
    fail(lines.place(), "expected BLOCKS and at most the number of blocks");
  const bool announced = lines.fields().size() == 2;
  const std::size_t expected = announced ? lines.count(1, "number of blocks") : 0;

  MeshFile mesh;
  while (lines.next()) {
    const std::string name = fmt::format("block {}", mesh.blocks.size() + 1);
    if (lines.fields().size() != 2)
      fail(lines.place(),
           fmt::format("{}: expected number of corners and material, found {}", name,
                       counted(lines.fields().size(), "value")));
    const std::size_t corners = lines.count(0, name + ": number of corners");
    if (corners < 3)
      fail(lines.place(), name + " needs at least 3 corners");
    MeshBlock block{{}, lines.integer(1, name + ": material"), lines.place().line};
    check_material(block.material, name, lines.place());
    for (std::size_t i = 1; i <= corners; ++i) {
      const std::string corner = fmt::format("{}: corner {} of {}", name, i, corners);
      lines.need(corner);
      const std::size_t values = lines.fields().size();
      if (values < 2)
        fail(lines.place(),
             fmt::format("{}: expected 2 coordinates, found {}", corner, values));
      if (values > 3)
        fail(lines.place(),
             fmt::format("{}: expected 2 coordinates and at most a joint id, found {}",
                         corner, counted(values, "value")),
             "put each corner on a line of its own: x, y or x, y, joint");
      block.outline.emplace_back(lines.real(0, corner + ": x"),
                                 lines.real(1, corner + ": y"));
      const int joint = values == 3 ? lines.joint(2, corner + ": joint id") : 0;
      if (joint != 0)
        block.joints.resize(i - 1, 0);
      if (joint != 0 || !block.joints.empty())
        block.joints.push_back(joint);
    }
    turn_clockwise(block);  // the model's check rejects one without area
    mesh.blocks.push_back(std::move(block));
  }
  if (announced && mesh.blocks.size() != expected)
    fail(lines.place(), fmt::format("BLOCKS announces {}, the file has {}", expected,
                                    mesh.blocks.size()));
  if (mesh.blocks.empty())
    fail(lines.place(), "no blocks after BLOCKS");
  mesh.form = MeshForm::text;
  mesh.found = "text form, " + counted(mesh.blocks.size(), "block");
  return mesh;
}

}  // namespace blocks::deck::mesh
