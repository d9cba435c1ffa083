#include "convert/export_scene.hpp"

#include "draw/joint_colours.hpp"
#include "exchange/mesh_writer.hpp"
#include "geometry/polygon.hpp"
#include "post/read/crack_tracker.hpp"
#include "post/read/frame_quantity.hpp"
#include "quantities/units.hpp"

namespace blocks::convert {
namespace {

std::string write_drawing(const ExportScene& scene, const exchange::SvgScale& scale) {
  return exchange::write_svg(scene.blocks, scale, [](int joint) {
    return draw::css(draw::joint_colour(joint));
  });
}

/// Writes the text form of READ9.
std::string mesh_text(const ExportScene& scene, const std::string& comment) {
  std::vector<exchange::Outline> outlines;
  for (const BlockRecord& block : scene.blocks) {
    exchange::Outline outline;
    outline.corners = block.outline;
    outline.material = block.material;
    outline.joints = block.joints;
    outlines.push_back(std::move(outline));
  }
  return exchange::write_mesh(outlines, comment);
}

}  // namespace

ExportScene scene_of(const Model& model) {
  ExportScene scene;
  const Blocks& blocks = model.blocks;
  for (int b = 0; b < blocks.size(); ++b) {
    if (blocks.is_removed(b))
      continue;
    const auto joint = blocks.joint.begin();
    scene.blocks.push_back(
        {b + 1,
         blocks.material[b],
         model.settings.materials.at(blocks.material[b]).name,
         !blocks.is_free(b),
         blocks.area[b],
         blocks.outline(b),
         {joint + blocks.first_corner[b], joint + blocks.first_corner[b + 1]},
         {}});
  }
  scene.unit = model.settings.units.length;
  scene.removed = blocks.size() - blocks.count_present();
  return scene;
}

ExportScene scene_of(const post::ResultsReader& results,
                     const std::optional<double>& time) {
  const long shown_frame = time ? results.at(*time) : results.frames() - 1;
  const post::Frame frame = results.frame(shown_frame);
  post::ResultsTracker tracker(results);
  const post::Frame& first = tracker.at(shown_frame, frame).first;
  const auto name_of = [&names = results.material_names()](int material) {
    const auto name = names.find(material);
    return name == names.end() ? std::string() : name->second;
  };
  ExportScene scene;
  scene.time = frame.time;
  if (const auto& units = results.units())
    scene.unit = units->length;
  std::vector<Eigen::Index> shown;
  for (int b = 0; b < frame.size(); ++b)
    if (!frame.is_removed(b))
      shown.push_back(b);
  scene.removed = frame.size() - frame.count_present();
  for (const auto b : shown)
    scene.blocks.push_back({frame.number[b],
                            frame.material[b],
                            name_of(frame.material[b]),
                            frame.fixed[b] != 0,
                            geometry::section_properties(frame.outlines[b]).area,
                            frame.outlines[b],
                            frame.joints.empty() ? std::vector<int>() : frame.joints[b],
                            {}});
  if (!tracker.cracks().empty() && !frame.parent.empty())
    for (std::size_t k = 0; k < shown.size(); ++k)
      scene.blocks[k].results.emplace_back(
          "parent", frame.parent[static_cast<std::size_t>(shown[k])]);
  for (const char* name :
       {"speed", "displacement", "rotation", "s11", "s12", "s22", "p1", "p2"}) {
    const Eigen::VectorXd values = post::quantity(name, frame, first).values;
    for (std::size_t k = 0; k < shown.size(); ++k)
      scene.blocks[k].results.emplace_back(name, values[shown[k]]);
  }
  return scene;
}

exchange::SvgScale scale_of(const ExportScene& scene, double given) {
  const auto unit = quantities::known_lengths().size_of(scene.unit);
  const double unit_in_m = unit.value_or(1.0);
  return {given > 0.0 ? given : exchange::default_scale(scene.blocks, unit_in_m),
          unit_in_m, unit ? scene.unit : std::string()};
}

std::string text_of(const ExportScene& scene, const std::string& format,
                    const exchange::SvgScale& scale, const std::string& comment) {
  return format == "geojson" ? exchange::write_geojson(scene.blocks, scene.time)
         : format == "wkt"   ? exchange::write_wkt(scene.blocks)
         : format == "msh"   ? exchange::write_gmsh(scene.blocks)
         : format == "dxf"   ? exchange::write_dxf(scene.blocks, scene.unit)
         : format == "svg"   ? write_drawing(scene, scale)
                             : mesh_text(scene, comment);
}

std::string left_out(const ExportScene& scene, const std::string& format) {
  if (format == "svg")
    return {};  // a picture
  std::string text;
  if (format == "wkt")
    text = "materials";
  bool fixed = false, named = false;
  for (const BlockRecord& block : scene.blocks) {
    fixed = fixed || block.fixed;
    named = named || !block.material_name.empty();
  }
  if (format == "txt" && named)
    text = "names of materials";
  const bool keeps_fixed =
      format == "geojson" || (format == "msh" && exchange::needs_rings(scene.blocks));
  if (!keeps_fixed && fixed)
    text += (text.empty() ? "" : ", ") + std::string("which blocks are fixed");
  if (format != "geojson" && scene.time)
    text += (text.empty() ? "" : ", ") + std::string("results");
  return text;
}

}  // namespace blocks::convert
