// blocks.study: the study of contact detection (docs/robustness.md).
#include <pybind11/stl.h>

#include <algorithm>
#include <string>
#include <vector>

#include "bindings.hpp"
#include "study/scene.hpp"
#include "study/study.hpp"

namespace blocks::python {
namespace {

using study::Estimate;

py::dict dict_of(const study::Study& made, const study::Row& row) {
  py::dict one;
  one["scene"] = made.scene;
  one["variant"] = std::string(row.variant->name);
  one["frames"] = row.frames;
  const auto estimate = [&](const char* name, const Estimate& value) {
    one[name] = value.value;
    one[py::str(std::string(name) + "_low")] = value.low;
    one[py::str(std::string(name) + "_high")] = value.high;
  };
  one["hung"] = row.hung;
  one["fell"] = row.fell;
  estimate("hang_ups", row.hang_ups);
  estimate("fall_throughs", row.fall_throughs);
  estimate("wrong_signs", row.wrong_signs);
  estimate("wrong_tangents", row.wrong_tangents);
  estimate("phantom", row.phantom);
  estimate("missed", row.missed);
  estimate("speed_lost", row.speed_lost);
  estimate("energy_error", row.energy);
  one["refused"] = row.refused;
  return one;
}

py::list run(const std::vector<std::string>& scenes,
             const std::vector<std::string>& variants, int frames, int first,
             std::uint64_t seed, long steps, int threads) {
  if (frames < 1 || first < 0 || steps < 0 || threads < 1 || threads > 1024)
    throw py::value_error("frames is below 1, first or steps is below 0, or threads is "
                          "not in range 1 to 1024");
  study::StudyChoice choice;
  choice.frames.seed = seed;
  choice.first = first, choice.count = frames, choice.steps = steps;
  choice.threads = threads;
  for (const std::string& name : variants) {
    choice.variants.push_back(study::find_variant(name));
    if (choice.variants.back() == nullptr)
      throw py::value_error("there is no variant '" + name +
                            "'; blocks.study_variants() lists them");
  }
  py::list rows;
  for (const std::string& name : scenes) {
    const auto& names = study::scene_names();
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw py::value_error("there is no scene '" + name +
                            "'; blocks.study_scenes() lists them");
    study::Study made;
    {
      const py::gil_scoped_release released;
      made = study::run_study(study::make_scene(name), choice);
    }
    for (const study::Row& row : made.rows)
      rows.append(dict_of(made, row));
    if (PyErr_CheckSignals() != 0)
      throw py::error_already_set();
  }
  return rows;
}

}  // namespace

void bind_study(py::module_& module) {
  module.def(
      "study_scenes",
      [] {
        return std::vector<std::string>(study::scene_names().begin(),
                                        study::scene_names().end());
      },
      "study_scenes()\n--\n\nReturns the names of the scenes of `study`.");
  module.def(
      "study_variants",
      [] {
        std::vector<std::string> names;
        for (const study::Variant& variant : study::all_variants())
          names.emplace_back(variant.name);
        return names;
      },
      "study_variants()\n--\n\nReturns the names of the variants of the contact rule; "
      "the first one is the "
      "rule of runs.");
  module.def("_study", &run, py::arg("scenes"), py::arg("variants"), py::arg("frames"),
             py::arg("first"), py::arg("seed"), py::arg("steps"), py::arg("threads"));
}

}  // namespace blocks::python
