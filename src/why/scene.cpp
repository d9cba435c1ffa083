#include "why/scene.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

#include "geometry/polygon.hpp"
#include <algorithm>

#include "files/file_error.hpp"
#include "output/checkpoint/checkpoint.hpp"
#include "post/read/results_nearby.hpp"
#include "post/read/results_reader.hpp"

namespace blocks::why {
namespace {

/// Returns the first bytes of a file. Throws files::FileError.
std::string head_of(const std::string& path) {
  if (!std::filesystem::is_regular_file(path) && std::filesystem::exists(path))
    throw files::FileError("cannot read " + path + ": it is not a regular file");
  std::ifstream in(path, std::ios::binary);
  if (!in)
    throw files::FileError("cannot read " + path + ": " +
                           std::generic_category().message(errno));
  std::string head(8, '\0');
  in.read(head.data(), 8);
  return head;
}

/// Returns for each of n blocks the number of cracks after which it has its present
/// corners, with the first `count` cracks of the results.
std::vector<long> last_cracks(const post::ResultsReader& results, std::size_t n,
                              long count) {
  std::vector<long> last(n, 0);
  const std::vector<post::Crack> cracks = results.cracks();
  for (long i = 0; i < std::min(count, static_cast<long>(cracks.size())); ++i)
    for (const int block : {cracks[static_cast<std::size_t>(i)].parent,
                            cracks[static_cast<std::size_t>(i)].child})
      if (block <= static_cast<int>(n))
        last[static_cast<std::size_t>(block) - 1] = i + 1;
  return last;
}

/// Restores whether blocks are convex, and their convex parts, from the first frame of
/// each block, or the first one after its last crack. In later frames, rounding may
/// move three corners off a common line. shown: the frame of the blocks.
void restore_shapes(const post::ResultsReader& results, const post::Frame& shown,
                    Blocks& blocks) {
  const std::size_t n = blocks.convex.size();
  const std::vector<long> since = last_cracks(results, n, shown.cracks);
  std::vector<char> known(n, 0);
  std::size_t missing = n;
  blocks.cuts.clear();
  for (long i = 0; missing > 0 && i < results.frames(); ++i) {
    const post::Frame frame = results.frame(i);
    for (std::size_t b = 0; b < std::min(frame.outlines.size(), n); ++b) {
      if (known[b] != 0 || frame.cracks < since[b])
        continue;
      known[b] = 1;
      --missing;
      blocks.convex[b] = geometry::check_outline(frame.outlines[b]).convex ? 1 : 0;
      if (blocks.convex[b] == 0)
        blocks.cut(static_cast<int>(b), frame.outlines[b]);
    }
  }
}

/// Any outline, for a block that was removed before the first frame.
const geometry::Polygon never_shown = {{0, 0}, {0, 1}, {1, 0}};

Scene from_results(const std::string& path, const std::optional<double>& time) {
  const post::ResultsReader results(path);
  Scene scene;
  scene.times = results.times();
  scene.frame = time ? results.nearest(*time) : results.frames() - 1;
  const post::Frame frame = results.frame(scene.frame);
  scene.time = frame.time, scene.step = frame.step;

  Blocks& blocks = scene.blocks;
  std::vector<NewBlock> outlines;
  const auto shown = results.last_outlines(scene.frame);
  for (std::size_t b = 0; b < shown.size(); ++b)
    outlines.push_back({shown[b].empty() ? never_shown : shown[b], frame.material[b],
                        1.0, static_cast<Fixity>(frame.fixed[b]), 0});
  try {
    blocks.append(outlines);
  } catch (const std::invalid_argument& fault) {
    throw files::FileError(fmt::format("cannot read {}: Points of frame {} are no "
                                       "blocks: {}",
                                       path, scene.frame, fault.what()));
  }
  // copied exactly as stored; append would round them again
  for (int b = 0; b < blocks.size(); ++b) {
    if (blocks.is_removed(b))
      continue;
    for (int k = 0; k < blocks.corners_of(b); ++k)
      blocks.corner.col(blocks.first_corner[b] + k) = frame.outlines[b][k];
    blocks.centroid.col(b) = frame.centroid.col(b);
  }
  restore_shapes(results, frame, blocks);

  const post::FrameContacts stored = results.contacts(scene.frame);
  for (int i = 0; i < stored.size(); ++i)
    if (stored.edge_block[i] != 0)  // 0: a symmetry plane
      scene.contacts.push_back(
          {blocks.first_corner[stored.corner_block[i] - 1] + stored.corner[i] - 1,
           blocks.first_corner[stored.edge_block[i] - 1] + stored.edge[i] - 1,
           stored.normal_force[i], stored.shear_force[i], stored.overlap[i],
           stored.states.empty() ? LawState{} : stored.states[i]});
  return scene;
}

Scene from_checkpoint(const std::string& path) {
  output::CheckpointInfo info;
  const Model model = output::read_checkpoint(path, info);
  Scene scene;
  scene.blocks = model.blocks;
  scene.time = model.time, scene.step = model.steps;
  scene.times = {model.time};
  scene.order = model.order;
  for (std::size_t i = 0; i < model.contacts.size(); ++i) {
    const Contact& contact = model.contacts[i];
    scene.contacts.push_back(
        {contact.corner, contact.edge, contact.normal_force, contact.shear_force,
         contact.overlap,
         i < model.law_states.size() ? model.law_states[i] : LawState{}});
  }
  return scene;
}

}  // namespace

std::optional<double> first_time_with(const std::string& path, int blocks) {
  if (!post::fault_of_head(path).empty())
    return {};
  const post::ResultsReader results(path);
  for (long i = 0; i < results.frames(); ++i)
    if (const post::Frame frame = results.frame(i); frame.size() >= blocks)
      return frame.time;
  return {};
}

std::string removal_text(const std::string& path, int block) {
  if (!post::fault_of_head(path).empty())
    return "it was removed before this checkpoint was written";
  const post::ResultsReader results(path);
  std::optional<double> last;
  for (long i = 0; i < results.frames(); ++i) {
    const post::Frame frame = results.frame(i);
    if (block >= frame.size())
      continue;
    if (frame.is_removed(block))
      return last ? fmt::format("it was removed between times {:g} and {:g}", *last,
                                frame.time)
                  : fmt::format("it was removed at time {:g} or before", frame.time);
    last = frame.time;
  }
  return "";
}

Scene read_scene(const std::string& path, const std::optional<double>& time) {
  const std::string head = head_of(path);
  if (post::fault_of_head(path).empty())
    return from_results(path, time);
  if (head == "BLOCKS c")
    return from_checkpoint(path);
  throw files::FileError("cannot read " + path +
                         ": it is neither results (NAME.vtkhdf) nor a checkpoint "
                         "(NAME.ckpt.h5) of BLOCKS");
}

}  // namespace blocks::why
