// The blocks of a deck or of results in the formats of `blocks export`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exchange/block_record.hpp"
#include "model/model.hpp"
#include "post/read/results_reader.hpp"

namespace blocks::convert {

using exchange::BlockRecord;

/// The blocks to export, and their time if they come from results.
struct ExportScene {
  std::vector<BlockRecord> blocks;
  std::optional<double> time;
  std::string unit;  ///< of length; empty: not named
  int removed = 0;   ///< number of removed blocks, which are not exported
};

ExportScene scene_of(const Model& model);
/// Takes the frame nearest to `time`; the last one if there is none.
ExportScene scene_of(const post::ResultsReader& results,
                     const std::optional<double>& time);

/// Returns the scale of a drawing. given: 0 chooses it. Units that are not known are
/// taken as metres.
exchange::SvgScale scale_of(const ExportScene& scene, double given);

/// Returns the blocks in a format: geojson, wkt, msh, dxf, svg or txt, the text form of
/// READ9, which begins with the comment. Throws std::invalid_argument if the format
/// cannot describe an outline.
std::string text_of(const ExportScene& scene, const std::string& format,
                    const exchange::SvgScale& scale, const std::string& comment);

/// Lists the data of the scene that the format cannot store.
std::string left_out(const ExportScene& scene, const std::string& format);

}  // namespace blocks::convert
