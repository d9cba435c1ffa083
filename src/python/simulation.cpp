// blocks.Simulation: a model that Python advances step by step.
#include "blocks/simulation.hpp"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <vector>

#include "bindings.hpp"
#include "contact_table.hpp"
#include "driven_model.hpp"
#include "names.hpp"
#include "selectors.hpp"
#include "text.hpp"

namespace blocks::python {
namespace {

using Row = std::vector<py::ssize_t>;

}  // namespace

void bind_simulation(py::module_& module) {
  register_tables();
  py::class_<DrivenModel> simulation(module, "Simulation", "See blocks.Simulation.");
  simulation
      .def(py::init<const std::string&, const std::optional<std::string>&, int, bool>(),
           py::arg("name"), py::arg("text"), py::arg("threads"), py::arg("moves"))
      .def("cards", &DrivenModel::cards, py::arg("text"))
      .def("_step", &DrivenModel::step, py::arg("count"), py::arg("read"),
           py::arg("every"), py::arg("callback"))
      .def("_steps_until", &DrivenModel::steps_until, py::arg("time"))
      .def("set_velocity", &DrivenModel::set_velocity, py::arg("block"),
           py::arg("velocity"), py::arg("spin") = py::none())
      .def("set_force", &DrivenModel::set_force, py::arg("block"), py::arg("force"))
      .def(
          "write_frame",
          [](DrivenModel& self, const std::string& path) {
            self.take_changes();
            self.simulation().write_frame(path);
          },
          py::arg("path"))
      .def(
          "write_checkpoint",
          [](DrivenModel& self, const std::string& path) {
            self.take_changes();
            self.simulation().write_checkpoint(path);
          },
          py::arg("path"));

  bind_selectors(simulation,
                 [](DrivenModel& self) -> const Blocks& { return self.blocks(); });

  const auto value = [&](const char* name, auto read) {
    simulation.def_property_readonly(name, read);
  };
  value("time", [](DrivenModel& self) { return self.simulation().time(); });
  value("steps", [](DrivenModel& self) { return self.simulation().steps(); });
  value("time_step", [](DrivenModel& self) { return self.simulation().time_step(); });
  value("warnings", [](DrivenModel& self) {
    py::list warnings;
    for (const std::string& warning : self.simulation().warnings())
      warnings.append(text_of(warning));
    return warnings;
  });
  value("title",
        [](DrivenModel& self) { return text_of(self.model().settings.title); });
  value("_units",
        [](DrivenModel& self) { return unit_names(self.model().settings.units); });
  value("materials", [](DrivenModel& self) {
    return material_names(self.model().settings.materials);
  });
  value("is_rigid", [](DrivenModel& self) { return self.model().settings.rigid; });
  value("is_read", [](DrivenModel& self) { return self.simulation().is_read(); });
  value("kinetic_energy",
        [](DrivenModel& self) { return self.simulation().kinetic_energy(); });
  value("worst_overlap",
        [](DrivenModel& self) { return self.simulation().worst_overlap(); });
  value("_solves", [](DrivenModel& self) {
    py::list solves;
    for (const SolveRecord& solve : self.model().solves)
      solves.append(py::make_tuple(solve.steps, solve.reached, solve.converged,
                                   solve.wanted, solve.time, solve.reached_local,
                                   solve.wanted_local, solve.local_block));
    return solves;
  });
  value("_factors_of_safety", [](DrivenModel& self) {
    const Model& model = self.model();
    py::list found;
    for (int search = 0; search < static_cast<int>(model.safety_factors.size());
         ++search) {
      py::list trials;
      const std::vector<SafetyTrial> own = trials_of(model.safety_trials, search);
      for (const SafetyTrial& trial : own)
        trials.append(py::make_tuple(trial.factor, describe(trial.outcome), trial.steps,
                                     trial.ratio, trial.local, trial.speed, trial.block,
                                     trial.moved));
      const SafetyBracket bracket = bracket_of(own);
      found.append(py::make_tuple(bracket.stable, bracket.failing, trials));
    }
    return found;
  });
  value("unbalanced_ratio",
        [](DrivenModel& self) { return self.simulation().unbalanced_ratio(); });
  simulation.def("__len__",
                 [](DrivenModel& self) { return self.simulation().blocks(); });

  // Columns. Each is a view of the memory of the model.
  const auto column = [&](const char* name, auto member, Row (*shape)(const Blocks&)) {
    simulation.def_property_readonly(name, [member, shape](DrivenModel& self) {
      const Blocks& all = self.blocks();
      return self.views().read_only((all.*member).data(), shape(all));
    });
  };
  constexpr auto n = [](const Blocks& all) { return Row{all.size()}; };
  constexpr auto n_2 = [](const Blocks& all) { return Row{all.size(), 2}; };
  constexpr auto n_2_2 = [](const Blocks& all) { return Row{all.size(), 2, 2}; };
  constexpr auto m = [](const Blocks& all) { return Row{all.corners()}; };
  constexpr auto m_2 = [](const Blocks& all) { return Row{all.corners(), 2}; };
  column("corners", &Blocks::corner, m_2);
  column("corner_block", &Blocks::corner_block, m);
  column("joint", &Blocks::joint, m);
  column("first_corner", &Blocks::first_corner,
         [](const Blocks& all) { return Row{all.size() + 1}; });
  column("centroid", &Blocks::centroid, n_2);
  column("angle", &Blocks::angle, n);
  column("gradient", &Blocks::gradient, n_2_2);
  column("stress", &Blocks::stress, n_2_2);
  column("strain_rate", &Blocks::strain_rate, n_2_2);
  column("force", &Blocks::force, n_2);
  column("moment", &Blocks::moment, n);
  column("mass", &Blocks::mass, n);
  column("inertia", &Blocks::inertia, n);
  column("area", &Blocks::area, n);
  column("material", &Blocks::material, n);
  const auto flags = [&](const char* name, bool (Blocks::*is)(int) const) {
    simulation.def_property_readonly(
        name, [is](DrivenModel& self) { return flags_of(self.blocks(), is); });
  };
  flags("is_free", &Blocks::is_free);
  flags("is_removed", &Blocks::is_removed);
  simulation.def_property("velocity", &DrivenModel::velocity,
                          &DrivenModel::set_velocities);
  simulation.def_property("spin", &DrivenModel::spin, &DrivenModel::set_spins);
  value("contacts",
        [](DrivenModel& self) { return contact_table(self.contacts(), self.model()); });
  value("contact_force", [](DrivenModel& self) {
    return contact_forces(self.contacts(), self.blocks());
  });
  value("water_force", [](DrivenModel& self) { return water_forces(self.model()); });
  value("cracks", [](DrivenModel& self) { return crack_table(self.model()); });
}

}  // namespace blocks::python
