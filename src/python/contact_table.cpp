#include "contact_table.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace blocks::python {
namespace {

namespace py = pybind11;
using geometry::Vec2;

// The rows that Python sees. Blocks and corners are counted from 0.
struct ContactRow {
  std::int32_t corner_block, corner, edge_block, edge;
  double point[2], normal[2], force[2];
  double normal_force, shear_force, overlap;
};
/// With the state of the law of the joint. The names are those of the results.
struct LawRow {
  std::int32_t corner_block, corner, edge_block, edge;
  double point[2], normal[2], force[2];
  double normal_force, shear_force, overlap;
  std::int32_t bonded;
  double closure, dilation;
  std::int32_t failed, law;
  double length, normal_stiffness, plastic_closure, shear_stiffness, slip, slip_path;
};
struct CrackRow {
  std::int64_t step;
  double time;
  std::int32_t parent, child, cause;
  double stress, begin[2], end[2], parent_area, child_area, released;
};

void put(double (&to)[2], const Vec2& from) { to[0] = from.x(), to[1] = from.y(); }

/// Returns the row of a contact. The columns of a law are 0.
template <class Row> Row row_of(const ContactForce& contact, const Blocks& blocks) {
  Row row{};
  const bool on_plane = contact.edge_block == 0;
  row.corner_block = contact.corner_block - 1;
  row.corner = blocks.first_corner[row.corner_block] + contact.corner - 1;
  row.edge_block = contact.edge_block - 1;
  row.edge = (on_plane ? 0 : blocks.first_corner[row.edge_block]) + contact.edge - 1;
  put(row.point, contact.point);
  put(row.normal, contact.normal);
  put(row.force, contact.force());
  row.normal_force = contact.normal_force;
  row.shear_force = contact.shear_force;
  row.overlap = contact.overlap;
  return row;
}

template <class Row> py::array table(const std::vector<Row>& rows) {
  return py::array_t<Row>(static_cast<py::ssize_t>(rows.size()), rows.data());
}

}  // namespace

py::array contact_table(const std::vector<ContactForce>& contacts, const Model& model) {
  const Blocks& blocks = model.blocks;
  const std::vector<JointState>& states = model.joint_states;
  if (states.empty()) {
    std::vector<ContactRow> rows;
    for (const ContactForce& contact : contacts)
      rows.push_back(row_of<ContactRow>(contact, blocks));
    return table(rows);
  }
  std::vector<LawRow> rows;
  for (const ContactForce& contact : contacts) {
    LawRow& row = rows.emplace_back(row_of<LawRow>(contact, blocks));
    if (rows.size() > states.size())
      continue;  // contacts with planes come last and have no law
    const JointState& state = states[rows.size() - 1];
    row.law = state.law, row.bonded = state.bonded, row.failed = state.failed;
    row.slip = state.slip, row.slip_path = state.path, row.length = state.length;
    row.closure = state.closure, row.plastic_closure = state.plastic;
    row.dilation = state.offset;
    row.normal_stiffness = state.stiffness, row.shear_stiffness = state.shear_stiffness;
  }
  return table(rows);
}

py::array contact_forces(const std::vector<ContactForce>& contacts,
                         const Blocks& blocks) {
  py::array_t<double> sums({static_cast<py::ssize_t>(blocks.size()), py::ssize_t{2}});
  std::fill_n(sums.mutable_data(), sums.size(), 0.0);
  auto sum = sums.mutable_unchecked<2>();
  for (const ContactForce& contact : contacts) {
    const Vec2 force = contact.force();
    for (int i = 0; i < 2; ++i) {
      sum(contact.corner_block - 1, i) += force[i];
      if (contact.edge_block > 0)
        sum(contact.edge_block - 1, i) -= force[i];
    }
  }
  return sums;
}

py::array crack_table(const Model& model) {
  std::vector<CrackRow> rows;
  for (const CrackRecord& crack : model.cracks) {
    CrackRow row{crack.step,
                 crack.time,
                 crack.parent,
                 crack.child,
                 static_cast<std::int32_t>(crack.cause),
                 crack.stress,
                 {},
                 {},
                 crack.parent_area,
                 crack.child_area,
                 crack.released()};
    put(row.begin, crack.from);
    put(row.end, crack.to);
    rows.push_back(row);
  }
  return table(rows);
}

void register_tables() {
  PYBIND11_NUMPY_DTYPE(ContactRow, corner_block, corner, edge_block, edge, point,
                       normal, force, normal_force, shear_force, overlap);
  PYBIND11_NUMPY_DTYPE(LawRow, corner_block, corner, edge_block, edge, point, normal,
                       force, normal_force, shear_force, overlap, bonded, closure,
                       dilation, failed, law, length, normal_stiffness, plastic_closure,
                       shear_stiffness, slip, slip_path);
  PYBIND11_NUMPY_DTYPE(CrackRow, step, time, parent, child, cause, stress, begin, end,
                       parent_area, child_area, released);
}

}  // namespace blocks::python
