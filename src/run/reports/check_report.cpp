#include "run/reports/check_report.hpp"

#include <fmt/format.h>

#include "dynamics/preparation/time_step.hpp"
#include "model/words/certificate_text.hpp"
#include "model/words/crack_report.hpp"
#include "model/words/cut_report.hpp"
#include "model/words/law_report.hpp"
#include "model/words/merge_reason.hpp"
#include "model/words/time_step_text.hpp"
#include "text/counted.hpp"

namespace blocks::run {

std::string check_report(const std::string& file, const Model& model,
                         const SharedCertificate& certificate) {
  const Blocks& blocks = model.blocks;
  const int present = blocks.count_present(), removed = blocks.size() - present;
  int fixed = 0, corners = 0;
  double area = 0.0;
  for (int b = 0; b < blocks.size(); ++b) {
    if (blocks.is_removed(b))
      continue;
    fixed += blocks.is_free(b) ? 0 : 1;
    corners += blocks.corners_of(b);
    area += blocks.area[b];
  }
  std::string text = fmt::format(
      "{}: no errors\n{} ({} fixed{}), {} corners, area {:.9g}\n", file,
      counted(present, "block"), fixed,
      removed > 0 ? "; " + counted(removed, "other") + " removed" : "", corners, area);
  for (const LayerRecord& layer : model.layers)
    text += fmt::format(
        "layer {}: blocks {} to {}, tiling proved: {} cells, {} shared sides, "
        "{} outline sides\n  {} angles of {} sides redrawn, {} sides ruled\n",
        layer.number, layer.first_block + 1, layer.first_block + layer.blocks,
        layer.cells, layer.interior_edges, layer.outline_edges, layer.redrawn,
        layer.redrawn_sides, layer.ruled);
  for (const MergeRecord& merge : model.merges)
    text += fmt::format(
        "layer {}: block {} absorbed by {} (counted within the layer before MERGE): "
        "width/height {}\n",
        merge.layer, merge.absorbed, merge.into, merge_reason(merge));
  for (const CutRecord& cut : model.cuts)
    text += cut_report(cut, model.joint_lengths);
  text += law_report(model);
  text += crack_report(model.settings);
  if (certificate)
    text += verdict(*certificate) + "\n" + joints_line(*certificate) + "\n";
  if (present > 0) {
    const TimeStep step = dynamics::choose_time_step(model);
    text += fmt::format("time step {:.6g}, set by block {} ({})\n", step.dt,
                        step.block + 1, limit_in_words(step, model.settings));
  }
  return text;
}

}  // namespace blocks::run
