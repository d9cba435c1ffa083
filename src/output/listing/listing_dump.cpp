// DUMP: what Appendix D of the report stores. These are the blocks with their corners
// and states, the pressures, the boxes and the whole contact list (report A.2.16).
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>

#include "output/listing/listing.hpp"
#include "output/listing/listing_text.hpp"
#include "quantities/bond.hpp"

namespace blocks::output {
namespace {

/// The index, from 0, of the box that holds x, out of `boxes` boxes between lower and
/// upper. A point outside gets the nearest box; NaN gets the first one.
int box_index(double x, double lower, double upper, int boxes) {
  const double along = (x - lower) * (boxes / (upper - lower));
  return along > 0.0 ? static_cast<int>(std::min(along, boxes - 1.0)) : 0;
}

/// The corners in each box that is not empty; removed blocks are left out. Boxes are
/// numbered row by row from the bottom left.
std::map<long, std::vector<int>> filled_boxes(const Model& model) {
  const Settings& s = model.settings;
  std::map<long, std::vector<int>> boxes;
  for (int c = 0; c < model.blocks.corners(); ++c) {
    if (model.blocks.is_removed(model.blocks.corner_block[c]))
      continue;
    const Vec2 p = model.blocks.corner.col(c);
    const long column = box_index(p.x(), s.lower.x(), s.upper.x(), s.boxes_x);
    const long row = box_index(p.y(), s.lower.y(), s.upper.y(), s.boxes_y);
    boxes[row * s.boxes_x + column].push_back(c);
  }
  return boxes;
}

std::string blocks_dump(const Blocks& blocks) {
  const bool with_joints = std::any_of(blocks.joint.begin(), blocks.joint.end(),
                                       [](int joint) { return joint != 0; });
  std::string text = over_whole("block") + over_whole("") + over_whole("MAT") +
                     over_whole("corner") + over_number("x") + over_number("y") +
                     (with_joints ? over_whole("joint") : "") + "\n";
  for (int b = 0; b < blocks.size(); ++b) {
    const auto i = static_cast<std::size_t>(b);
    for (int c = blocks.first_corner[i]; c < blocks.first_corner[i + 1]; ++c) {
      const bool first = c == blocks.first_corner[i];
      text += first ? whole(b + 1) + fixity_word(blocks.fixity[i]) +
                          whole(blocks.material[i])
                    : fmt::format("{:27}", "");
      text += whole(c - blocks.first_corner[i] + 1) + number(blocks.corner(0, c)) +
              number(blocks.corner(1, c)) +
              (with_joints
                   ? fmt::format(" {:>8}", blocks.joint[static_cast<std::size_t>(c)])
                   : "") +
              "\n";
    }
  }
  return text;
}

/// Appendix D: what the report stores of each block, with its names there.
std::string states_dump(const Blocks& blocks) {
  const auto rows = [&](const std::string& titles, const auto& values) {
    std::string text = "\n" + over_whole("block") + titles + "\n";
    for (int b = 0; b < blocks.size(); ++b)
      text += whole(b + 1) + values(b) + "\n";
    return text;
  };
  const auto titles = [](std::initializer_list<const char*> names) {
    std::string text;
    for (const char* name : names)
      text += over_number(name);
    return text;
  };
  std::string text =
      rows(over_whole("NC") + titles({"XC", "YC", "MASS", "RMOI"}), [&](int b) {
        return whole(blocks.corners_of(b)) + number(blocks.centroid(0, b)) +
               number(blocks.centroid(1, b)) + number(blocks.mass[b]) +
               number(blocks.inertia[b]);
      });
  text += rows(titles({"VX", "VY", "TDOT", "FX", "FY", "MOM"}), [&](int b) {
    return number(blocks.velocity(0, b)) + number(blocks.velocity(1, b)) +
           number(blocks.spin[b]) + number(blocks.force(0, b)) +
           number(blocks.force(1, b)) + number(blocks.moment[b]);
  });
  const auto tensors = [&](std::initializer_list<const char*> names,
                           const Eigen::Matrix4Xd& tensor) {
    text += rows(titles(names), [&](int b) {
      std::string row;
      for (int i = 0; i < 4; ++i)
        row += number(tensor(i, b));
      return row;
    });
  };
  tensors({"TAUA11", "TAUA12", "TAUA21", "TAUA22"}, blocks.applied);
  tensors({"TAUI11", "TAUI12", "TAUI21", "TAUI22"}, blocks.stress);
  tensors({"EDOT11", "EDOT12", "EDOT21", "EDOT22"}, blocks.strain_rate);
  return text;
}

/// Appendix D: the boundary conditions of PRESSBC.
std::string pressures_dump(const std::vector<Pressure>& pressures) {
  std::string text = over_whole("NB") + over_whole("NSIDE") + over_number("P1") +
                     over_number("P2") + over_number("TARRIV") + "\n";
  for (const Pressure& one : pressures)
    text += whole(one.block + 1) + whole(one.side + 1) + number(one.p1) +
            number(one.p2) + number(one.arrival) + "\n";
  return text;
}

std::string corner_name(const Blocks& blocks, int c) {
  const int b = blocks.corner_block[static_cast<std::size_t>(c)];
  return fmt::format(" {}:{}", b + 1,
                     c - blocks.first_corner[static_cast<std::size_t>(b)] + 1);
}

std::string boxes_dump(const Model& model) {
  std::string text = over_whole("box") + over_whole("column") + over_whole("row") +
                     "   block:corner\n";
  for (const auto& [box, corners] : filled_boxes(model)) {
    text += whole(box + 1) + whole(box % model.settings.boxes_x + 1) +
            whole(box / model.settings.boxes_x + 1) + "  ";
    std::size_t in_line = 0;
    for (const int c : corners) {
      const std::string name = corner_name(model.blocks, c);
      if (in_line + name.size() > 100) {
        text += fmt::format("\n{:29}", "");
        in_line = 0;
      }
      text += name;
      in_line += name.size();
    }
    text += "\n";
  }
  return text;
}

/// The number of a corner's block, and that of the corner within it.
std::string named(const Blocks& blocks, int c) {
  const int b = blocks.corner_block[static_cast<std::size_t>(c)];
  return whole(b + 1) + whole(c - blocks.first_corner[static_cast<std::size_t>(b)] + 1);
}

std::string contacts_dump(const Model& model) {
  const Blocks& blocks = model.blocks;
  std::string text = over_whole("block") + over_whole("corner") + over_whole("block") +
                     over_whole("edge") + over_whole("active") + over_number("FN") +
                     over_number("FS") + over_number("normal force") +
                     over_number("shear force") + over_number("overlap") + "\n";
  for (const Contact& contact : model.contacts)
    text += named(blocks, contact.corner) + named(blocks, contact.edge) +
            over_whole("yes") + number(contact.normal_elastic) +
            number(contact.shear_elastic) + number(contact.normal_force) +
            number(contact.shear_force) + number(contact.overlap) + "\n";
  return text;
}

/// Appendix D: the direction of each contact's edge and its point, the corner.
std::string contact_places_dump(const Model& model) {
  const Blocks& blocks = model.blocks;
  std::string text = over_whole("block") + over_whole("corner") + over_whole("block") +
                     over_whole("edge") + over_number("SIN") + over_number("COS") +
                     over_number("XCP") + over_number("YCP") + "\n";
  for (const Contact& contact : model.contacts) {
    const Vec2 along =
        (blocks.corner.col(blocks.next[static_cast<std::size_t>(contact.edge)]) -
         blocks.corner.col(contact.edge))
            .normalized();
    const Vec2 point = blocks.corner.col(contact.corner);
    text += named(blocks, contact.corner) + named(blocks, contact.edge) +
            number(along.y()) + number(along.x()) + number(point.x()) +
            number(point.y()) + "\n";
  }
  return text;
}

/// The contacts that have the law of a joint, in the order of the list.
std::string law_states_dump(const Model& model) {
  std::string text = over_whole("block") + over_whole("corner") + over_whole("block") +
                     over_whole("edge") + over_whole("joint") + over_whole("bond") +
                     over_number("slip") + over_number("dilation") + over_number("a0") +
                     over_number("length") + "\n";
  for (std::size_t i = 0; i < model.law_states.size(); ++i) {
    const Contact& contact = model.contacts[i];
    const LawState& state = model.law_states[i];
    if (state.law != 0)
      text += named(model.blocks, contact.corner) + named(model.blocks, contact.edge) +
              whole(state.law) +
              over_whole(word(quantities::bond_of(state.bonded, state.failed))) +
              number(state.slip) + number(state.offset) + number(state.plastic) +
              number(state.length) + "\n";
  }
  return text;
}

std::string plane_contacts_dump(const Model& model) {
  std::string text = over_whole("block") + over_whole("corner") + over_whole("plane") +
                     over_whole("active") + over_number("FN") +
                     over_number("normal force") + over_number("overlap") +
                     over_number("offset") + "\n";
  for (const PlaneContact& contact : model.plane_contacts) {
    const auto corner = static_cast<std::size_t>(contact.corner);
    const int b = model.blocks.corner_block[corner];
    text += whole(b + 1) +
            whole(contact.corner -
                  model.blocks.first_corner[static_cast<std::size_t>(b)] + 1) +
            whole(contact.plane + 1) + over_whole(contact.active ? "yes" : "no") +
            number(contact.normal_elastic) + number(contact.normal_force) +
            number(contact.overlap) + number(contact.offset) + "\n";
  }
  return text;
}

}  // namespace

void Listing::dump(const Model& model) {
  out_ << heading(
              fmt::format("DUMP    time {:.9g}    step {}", model.time, model.steps))
       << blocks_dump(model.blocks) << states_dump(model.blocks);
  if (!model.loads.pressures.empty())
    out_ << heading("PRESSURES") << pressures_dump(model.loads.pressures);
  out_ << heading("BOXES THAT HOLD CORNERS") << boxes_dump(model)
       << heading(fmt::format("CONTACTS, {} listed", model.contacts.size()))
       << contacts_dump(model) << "\n"
       << contact_places_dump(model);
  if (!model.law_states.empty())
    out_ << heading("CONTACTS OF JOINTS WITH A LAW") << law_states_dump(model);
  if (!model.plane_contacts.empty())
    out_ << heading(fmt::format("CORNERS AT PLANES, {} listed",
                                model.plane_contacts.size()))
         << plane_contacts_dump(model);
  flush();
}

}  // namespace blocks::output
