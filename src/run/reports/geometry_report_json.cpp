// The geometry report as JSON for scripts.
#include <nlohmann/json.hpp>

#include "output/cuts_json.hpp"
#include "run/reports/geometry_report.hpp"

namespace blocks::run {
namespace {

using Json = nlohmann::ordered_json;

Json vector(const Vec2& v) { return {v.x(), v.y()}; }

/// `where` is the JSON key of the corner or side number; it is null for a measure of
/// the whole block.
Json measure(const Measure& m, const char* where) {
  Json worst = Json::array();
  for (const auto& place : m.worst) {
    Json entry = {{"value", place.value}, {"block", place.block + 1}};
    if (where != nullptr)
      entry[where] = place.corner + 1;
    entry["place"] = vector(place.at);
    worst.push_back(entry);
  }
  return {{"smallest", m.smallest},
          {"median", m.median},
          {"largest", m.largest},
          {"classes", {{"limits", m.edges}, {"blocks", m.counts}}},
          {"worst", worst}};
}

Json layers(const GeometryReport& report) {
  Json list = Json::array();
  for (const LayerRecord& layer : report.layers)
    list.push_back({{"layer", layer.number},
                    {"first_block", layer.first_block + 1},
                    {"blocks", layer.blocks},
                    {"cells", layer.cells},
                    {"interior_edges", layer.interior_edges},
                    {"outline_edges", layer.outline_edges},
                    {"angles_redrawn", layer.redrawn},
                    {"sides_redrawn", layer.redrawn_sides},
                    {"sides_ruled", layer.ruled}});
  return list;
}

Json overlaps(const std::vector<geometry::BlockOverlap>& pairs) {
  Json list = Json::array();
  for (const geometry::BlockOverlap& pair : pairs)
    list.push_back({{"blocks", {pair.first + 1, pair.second + 1}},
                    {"area", pair.area},
                    {"place", vector(pair.place)}});
  return list;
}

}  // namespace

std::string json(const GeometryReport& report) {
  Json gaps = Json::array(), junctions = Json::array();
  for (const auto& junction : report.certificate.joints.t_junctions)
    junctions.push_back({{"block", junction.block + 1},
                         {"corner", junction.corner + 1},
                         {"inside_a_side_of", junction.other + 1},
                         {"place", vector(junction.place)}});
  for (std::size_t i = 0; i < report.certificate.gaps(); ++i) {
    const geometry::Slit& slit = report.certificate.joints.slits[i];
    gaps.push_back({{"blocks", {slit.first + 1, slit.second + 1}},
                    {"width", slit.width},
                    {"place", vector(slit.place)}});
  }
  Json all = {{"deck", report.file},
              {"blocks", report.blocks},
              {"corners", report.corners},
              {"area", measure(report.area, nullptr)},
              {"aspect_ratio", measure(report.aspect, nullptr)},
              {"shortest_side", measure(report.edge, "side")},
              {"smallest_angle", measure(report.angle, "corner")},
              {"layers", layers(report)},
              {"merges", output::merges_json(report.merges)},
              {"certificate",
               {{"holds", report.certificate.holds()},
                {"overlaps", overlaps(report.certificate.overlaps)},
                {"moved_blocks", report.certificate.moved},
                {"contacts", overlaps(report.certificate.contacts)},
                {"roundings", overlaps(report.certificate.roundings)},
                {"largest_rounding", report.certificate.largest_rounding}}},
              {"t_junctions", junctions},
              {"gaps", gaps},
              {"widest_gap", report.certificate.gaps() > 0
                                 ? report.certificate.joints.slits.front().width
                                 : 0.0},
              {"slits_by_rounding", report.certificate.rounding_slits},
              {"resolution",
               {{"ulp", report.certificate.ulp},
                {"ulp_over_shortest_side", report.resolution()},
                {"bound", coarsest_resolution},
                {"sufficient", report.resolved()}}}};
  if (!report.cuts.empty()) {
    all["cuts"] = output::cuts_json(report.cuts, report.joint_lengths);
    for (const auto& [sides, blocks] : report.sides)
      all["sides"].push_back({{"sides", sides}, {"blocks", blocks}});
  }
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace blocks::run
