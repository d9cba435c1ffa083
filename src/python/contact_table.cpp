#include "contact_table.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
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
struct CrackRow {
  std::int64_t step;
  double time;
  std::int32_t parent, child, cause;
  double stress, begin[2], end[2], parent_area, child_area, released;
};

void put(double (&to)[2], const Vec2& from) { to[0] = from.x(), to[1] = from.y(); }

ContactRow row_of(const ContactForce& contact, const Blocks& blocks) {
  ContactRow row{};
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

/// Returns the rows with the states of the laws of joints, which have the names of the
/// results in alphabetical order. Contacts with planes come last and have no law.
py::array with_states(const py::array& rows, const std::vector<LawState>& states) {
  std::map<std::string, py::array> columns;
  each_law_field([&]<class Member>(const LawField& field, Member LawState::*member) {
    py::array_t<ResultsType<Member>> values(rows.size());
    std::fill_n(values.mutable_data(), values.size(), ResultsType<Member>(0));
    for (std::size_t i = 0; i < states.size(); ++i)
      values.mutable_data()[i] = states[i].*member;
    columns.emplace(field.name_in_tables(), values);
  });
  py::list fields(rows.dtype().attr("descr"));
  for (const auto& [name, values] : columns)
    fields.append(py::make_tuple(name, values.dtype()));
  const py::module_ numpy = py::module_::import("numpy");
  py::array all = numpy.attr("empty")(rows.size(), numpy.attr("dtype")(fields, true));
  for (const auto& name : rows.dtype().attr("names"))
    all[name] = rows[name];
  for (const auto& [name, values] : columns)
    all[name.c_str()] = values;
  return all;
}

}  // namespace

py::array contact_table(const std::vector<ContactForce>& contacts, const Model& model) {
  std::vector<ContactRow> rows;
  for (const ContactForce& contact : contacts)
    rows.push_back(row_of(contact, model.blocks));
  const py::array plain = table(rows);
  return model.law_states.empty() ? plain : with_states(plain, model.law_states);
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

py::array water_forces(const Model& model) {
  Eigen::Matrix2Xd forces;
  WaterNow(model.loads.water, model.time).forces_on(model.blocks, forces);
  py::array_t<double> rows({static_cast<py::ssize_t>(forces.cols()), py::ssize_t{2}});
  std::copy_n(forces.data(), forces.size(), rows.mutable_data());
  return rows;
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
  PYBIND11_NUMPY_DTYPE(CrackRow, step, time, parent, child, cause, stress, begin, end,
                       parent_area, child_area, released);
}

}  // namespace blocks::python
