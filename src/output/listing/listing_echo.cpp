// The input echo (LISTI): the deck as it was read, with the report's names.
#include "output/listing/listing.hpp"
#include "output/listing/listing_text.hpp"

#include <algorithm>

#include "model/safe_fraction.hpp"
#include "model/words/crack_report.hpp"
#include "model/words/cut_report.hpp"
#include "model/words/law_report.hpp"
#include "model/words/merge_reason.hpp"
#include "model/words/time_step_text.hpp"

namespace blocks::output {
namespace {

std::string setting(const char* what, const char* name, const std::string& value) {
  return fmt::format("  {:<34}{:<8}{:>17}\n", what, name, value);
}
std::string setting(const char* what, const char* name, double value) {
  return setting(what, name, fmt::format("{:.9g}", value));
}
std::string setting(const char* what, const char* name, long value) {
  return setting(what, name, fmt::format("{}", value));
}
std::string setting(const char* what, const char* name, int value) {
  return setting(what, name, static_cast<long>(value));
}

/// The ramp of gravity, and damping that only statics needs; empty without them.
std::string damping_echo(const Settings& s) {
  std::string text;
  const GravityRamp& ramp = s.gravity_ramp;
  if (ramp.duration > 0.0)
    text += setting("ramp of gravity, begin", "TBEGIN", ramp.begin) +
            setting("ramp of gravity, duration", "TRAMP", ramp.duration) +
            setting("gravity before it in x", "GRAVX0", ramp.from.x()) +
            setting("gravity before it in y", "GRAVY0", ramp.from.y());
  if (s.local_damping > 0.0)
    text += setting("local damping", "ALPHA", s.local_damping);
  if (s.kinetic_damping)
    text += setting("kinetic damping", "KINDAMP", std::string("on"));
  if (s.mass_scaling)
    text += setting("mass scaling in SOLVE", "MSCALE", std::string("on"));
  return text;
}

std::string settings_echo(const Model& model) {
  const Settings& s = model.settings;
  const TimeStep& step = model.time_step;
  std::string text =
      setting("largest number of blocks", "NBLOKM", s.max_blocks) +
      setting("most corners of a block", "NCMAX", s.max_corners) +
      setting("domain, left", "XL", s.lower.x()) +
      setting("domain, bottom", "YL", s.lower.y()) +
      setting("domain, right", "XU", s.upper.x()) +
      setting("domain, top", "YU", s.upper.y()) +
      setting("boxes in x", "IBOXES", s.boxes_x) +
      setting("boxes in y", "JBOXES", s.boxes_y) +
      setting("contact tolerance", "CTOL", s.contact_tolerance) +
      setting("normal stiffness", "STIFN", s.normal_stiffness) +
      setting("shear stiffness", "STIFS", s.shear_stiffness) +
      setting("coefficient of friction", "FRIC", s.friction) +
      setting("fraction of critical damping", "BETA", s.damping) +
      setting("gravity in x", "GRAVX", s.gravity.x()) +
      setting("gravity in y", "GRAVY", s.gravity.y()) + damping_echo(s) +
      setting("blocks", "IRIGID", std::string(s.rigid ? "rigid" : "deformable")) +
      setting("random seed", "ISEED", fmt::format("{}", s.seed)) +
      setting("least angle of sides, degrees", "ANGM", s.angle_min.value()) +
      setting("largest angle of sides, degrees", "ANGP", s.angle_max.value()) +
      setting("least width/height kept (MERGE)", "ARATIO",
              s.merge_ratio ? fmt::format("{:.9g}", s.merge_ratio->value())
                            : std::string("none")) +
      setting("interval of printed output", "DTOUT", model.output.interval) +
      setting("interval of plot frames", "DTPLOT", model.plots.interval) +
      (model.history.interval > 0.0
           ? setting("interval of histories", "DTHIST", model.history.interval)
           : "") +
      (chooses_fraction(s)
           ? setting("fraction of critical time step", "TFRAC", std::string("safe"))
           : setting("fraction of critical time step", "TFRAC", s.fraction)) +
      setting("time step", "TDEL", step.dt);
  if (s.units.known())
    text += setting("units of length, mass, time", "UNITS",
                    s.units.length + ", " + s.units.mass + ", " + s.units.time);
  if (step.block >= 0)
    text += fmt::format("  the time step is set by block {} ({})\n", step.block + 1,
                        limit_in_words(step, "elasticity"));
  return text;
}

std::string materials_echo(const Settings& settings) {
  std::string text = heading("MATERIALS") + over_whole("MAT") + over_number("E") +
                     over_number("G") + over_number("RHO");
  if (!settings.rigid)
    text += over_number("C11") + over_number("C12");
  const auto& materials = settings.materials;
  const bool named =
      std::any_of(materials.begin(), materials.end(),
                  [](const auto& one) { return !one.second.name.empty(); });
  text += named ? "  name\n" : "\n";
  for (const auto& [mat, material] : materials) {
    text += whole(mat) + number(material.youngs_modulus) +
            number(material.shear_modulus) + number(material.density);
    if (!settings.rigid)
      text += number(material.c11()) + number(material.c12());
    text += (material.name.empty() ? "" : "  " + material.name) + "\n";
  }
  return text;
}

std::string laws_echo(const Model& model) {
  const std::string text = law_report(model);
  return text.empty() ? text : heading("LAWS OF JOINTS, DRIVEN BLOCKS") + text;
}

std::string cracks_echo(const Settings& settings) {
  const std::string text = crack_report(settings);
  return text.empty() ? text : heading("CRACKS, DAMPING OF VIBRATION") + text;
}

std::string water_echo(const Water& water) {
  std::string text;
  const WaterTable& table = water.table;
  if (!table.none()) {
    text +=
        heading("WATER TABLE") + setting("weight of the water", "GAMMA", table.gamma);
    if (table.duration > 0.0)
      text += setting("change of the table, begin", "TBEGIN", table.begin) +
              setting("change of the table, duration", "TRAMP", table.duration);
    text += over_whole("point") + over_number("X") + over_number("Y") +
            over_number("Y BEFORE") + "\n";
    for (std::size_t i = 0; i < table.place.size(); ++i) {
      const Vec2 after = table.place[i] * table.across() + table.to[i] * table.up;
      const Vec2 before = table.place[i] * table.across() + table.from[i] * table.up;
      text += whole(static_cast<long>(i) + 1) + number(after.x()) + number(after.y()) +
              number(before.y()) + "\n";
    }
  }
  if (!water.joints.empty()) {
    text += heading("WATER IN JOINTS") + over_whole("joint") + over_number("X1") +
            over_number("Y1") + over_number("P1") + over_number("X2") +
            over_number("Y2") + over_number("P2") + over_number("REACH") +
            over_number("TBEGIN") + over_number("TRAMP") + "\n";
    for (const JointWater& one : water.joints)
      text += whole(one.joint) + number(one.a.x()) + number(one.a.y()) +
              number(one.p1) + number(one.b.x()) + number(one.b.y()) + number(one.p2) +
              number(one.reach) + number(one.begin) + number(one.duration) + "\n";
  }
  return text;
}

std::string loads_echo(const Model& model) {
  const Loads& loads = model.loads;
  std::string text;
  if (!loads.function.empty()) {
    text += heading("TIME FUNCTION") + over_whole("point") + over_number("T") +
            over_number("P") + "\n";
    for (std::size_t i = 0; i < loads.function.t.size(); ++i)
      text += whole(static_cast<long>(i) + 1) + number(loads.function.t[i]) +
              number(loads.function.p[i]) + "\n";
  }
  if (!loads.pressures.empty()) {
    text += heading("PRESSURES") + over_whole("block") + over_whole("side") +
            over_number("P1") + over_number("P2") + over_number("TARRIV") + "\n";
    for (const Pressure& load : loads.pressures)
      text += whole(load.block + 1) + whole(load.side + 1) + number(load.p1) +
              number(load.p2) + number(load.arrival) + "\n";
  }
  if (!loads.forces.empty()) {
    text += heading("FORCES") + over_whole("block") + over_number("FX") +
            over_number("FY") + over_number("TARRIV") + "\n";
    for (const CentroidForce& load : loads.forces)
      text += whole(load.block + 1) + number(load.force.x()) + number(load.force.y()) +
              number(load.arrival) + "\n";
  }
  text += water_echo(loads.water);
  if (!loads.quiet_sides.empty()) {
    text += heading("QUIET SIDES, FORCES AT THEIR CORNERS") + over_whole("block") +
            over_whole("side") + over_number("CP") + over_number("CS") +
            over_number("FX1") + over_number("FY1") + over_number("FX2") +
            over_number("FY2") + "\n";
    for (const QuietSide& quiet : loads.quiet_sides)
      text += whole(quiet.block + 1) + whole(quiet.side + 1) + number(quiet.cp) +
              number(quiet.cs) + number(quiet.first.x()) + number(quiet.first.y()) +
              number(quiet.second.x()) + number(quiet.second.y()) + "\n";
  }
  if (!model.settings.planes.empty()) {
    text += heading("SYMMETRY PLANES") + over_whole("plane") + over_number("X1") +
            over_number("Y1") + over_number("X2") + over_number("Y2") + "\n";
    long i = 0;
    for (const Plane& plane : model.settings.planes)
      text += whole(++i) + number(plane.a.x()) + number(plane.a.y()) +
              number(plane.b.x()) + number(plane.b.y()) + "\n";
  }
  return text;
}

std::string layers_echo(const Model& model) {
  std::string text;
  if (!model.layers.empty()) {
    text += heading("LAYERS") + over_whole("layer") + over_whole("first") +
            over_whole("blocks") + over_whole("cells") + over_whole("interior") +
            over_whole("outline") + over_whole("redrawn") + over_whole("redrawn") +
            over_whole("ruled") + "\n" + over_whole("") + over_whole("block") +
            over_whole("") + over_whole("") + over_whole("edges") +
            over_whole("edges") + over_whole("angles") + over_whole("sides") +
            over_whole("sides") + "\n";
    for (const LayerRecord& layer : model.layers)
      text += whole(layer.number) + whole(layer.first_block + 1) + whole(layer.blocks) +
              whole(layer.cells) + whole(layer.interior_edges) +
              whole(layer.outline_edges) + whole(layer.redrawn) +
              whole(layer.redrawn_sides) + whole(layer.ruled) + "\n";
    text +=
        "  cells: simple and clockwise; interior edges: in pairs; outline edges: the "
        "others\n";
  }
  if (!model.merges.empty()) {
    text += heading("MERGED BLOCKS (numbers within the layer before MERGE; "
                    "width/height equal to "
                    "ARATIO is kept)") +
            over_whole("layer") + over_whole("block") + over_whole("into") +
            over_number("width/height") + over_number("ARATIO") + "\n";
    for (const MergeRecord& merge : model.merges)
      text += whole(merge.layer) + whole(merge.absorbed) + whole(merge.into) +
              number(merge.width_to_height) + number(merge.limit) +
              (number(merge.width_to_height) == number(merge.limit)
                   ? "  " + merge_reason(merge)
                   : std::string()) +
              "\n";
  }
  return text;
}

std::string cuts_echo(const Model& model) {
  std::string text;
  for (const CutRecord& cut : model.cuts)
    text += cut_report(cut, model.joint_lengths);
  return text.empty() ? text : heading("BLOCKS CUT ALONG JOINTS") + text;
}

std::string blocks_echo(const Blocks& blocks) {
  std::string text = heading("BLOCKS") + over_whole("block") + over_whole("") +
                     over_whole("MAT") + over_whole("layer") + over_whole("corners") +
                     over_number("x") + over_number("y") + over_number("area") +
                     over_number("mass") + over_number("inertia") + "\n";
  for (int b = 0; b < blocks.size(); ++b) {
    const auto i = static_cast<std::size_t>(b);
    text += whole(b + 1) + fixity_word(blocks.fixity[i]) + whole(blocks.material[i]) +
            whole(blocks.layer[i]) + whole(blocks.corners_of(b)) +
            number(blocks.centroid(0, b)) + number(blocks.centroid(1, b)) +
            number(blocks.area[b]) + number(blocks.mass[b]) +
            number(blocks.inertia[b]) + "\n";
  }
  return text;
}

}  // namespace

void Listing::input_echo(const Model& model) {
  out_ << heading("INPUT") << settings_echo(model) << materials_echo(model.settings)
       << laws_echo(model) << cracks_echo(model.settings) << loads_echo(model)
       << layers_echo(model) << cuts_echo(model) << blocks_echo(model.blocks);
  flush();
}

}  // namespace blocks::output
