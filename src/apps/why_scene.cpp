#include "why_scene.hpp"

#include <cerrno>
#include <fstream>
#include <string_view>
#include <system_error>

#include "geometry/polygon.hpp"
#include "output/checkpoint.hpp"
#include "post/results_nearby.hpp"
#include "post/results_reader.hpp"

namespace blocks::apps {
namespace {

/// The first bytes of a file. Throws output::FileError.
std::string head_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in)
    throw output::FileError("cannot read " + path + ": " +
                            std::generic_category().message(errno));
  std::string head(8, '\0');
  in.read(head.data(), 8);
  return head;
}

/// Convex is what a block was at its creation: turned and rounded, three corners on a
/// line need not be on it any more. Here: in the first frame that holds it.
std::vector<char> convexity(const post::ResultsReader& results, std::size_t blocks) {
  std::vector<char> convex;
  for (long i = 0; convex.size() < blocks; ++i) {
    const post::Frame frame = results.frame(i);
    for (std::size_t b = convex.size(); b < frame.outlines.size(); ++b)
      convex.push_back(geometry::check_outline(frame.outlines[b]).convex);
  }
  return convex;
}

WhyScene from_results(const std::string& path, const std::optional<double>& time) {
  const post::ResultsReader results(path);
  WhyScene scene;
  scene.times = results.times();
  scene.frame = time ? results.nearest(*time) : results.frames() - 1;
  const post::Frame frame = results.frame(scene.frame);
  scene.time = frame.time, scene.step = frame.step;

  Blocks& blocks = scene.blocks;
  std::vector<NewBlock> outlines;
  for (std::size_t b = 0; b < frame.outlines.size(); ++b)
    outlines.push_back({frame.outlines[b], frame.material[b], 1.0,
                        static_cast<Fixity>(frame.fixed[b]), 0});
  try {
    blocks.append(outlines);
  } catch (const std::invalid_argument& fault) {
    throw output::FileError("cannot read " + path + ": " + fault.what());
  }
  // bit for bit as stored, where append would round anew
  for (int b = 0; b < blocks.size(); ++b)
    for (int k = 0; k < blocks.corners_of(b); ++k)
      blocks.corner.col(blocks.first_corner[b] + k) = frame.outlines[b][k];
  blocks.centroid = frame.centroid;
  blocks.convex = convexity(results, frame.outlines.size());
  blocks.convex.resize(frame.outlines.size());

  const post::FrameContacts stored = results.contacts(scene.frame);
  for (int i = 0; i < stored.size(); ++i)
    if (stored.edge_block[i] != 0)  // 0: a symmetry plane
      scene.contacts.push_back(
          {blocks.first_corner[stored.corner_block[i] - 1] + stored.corner[i] - 1,
           blocks.first_corner[stored.edge_block[i] - 1] + stored.edge[i] - 1, true,
           stored.normal_force[i], stored.shear_force[i], stored.overlap[i]});
  return scene;
}

WhyScene from_checkpoint(const std::string& path) {
  output::CheckpointInfo info;
  const Model model = output::read_checkpoint(path, info);
  WhyScene scene;
  scene.blocks = model.blocks;
  scene.time = model.time, scene.step = model.steps;
  scene.times = {model.time};
  scene.listed = model.search.current;
  scene.reach = 2.0 * model.settings.contact_tolerance;
  const Contacts& list = model.contacts;
  for (int i = 0; i < list.size(); ++i) {
    const ActingContact forces = list.at(i);
    scene.contacts.push_back({list.corner[i], list.edge[i], list.active[i] != 0,
                              forces.normal_force, forces.shear_force, forces.overlap});
  }
  return scene;
}

}  // namespace

const RememberedContact* WhyScene::find(int corner, int edge) const {
  for (const RememberedContact& contact : contacts)
    if (contact.corner == corner && contact.edge == edge)
      return &contact;
  return nullptr;
}

std::optional<double> first_time_with(const std::string& path, int blocks) {
  if (!post::fault_of_head(path).empty())
    return {};
  const post::ResultsReader results(path);
  for (long i = 0; i < results.frames(); ++i)
    if (const post::Frame frame = results.frame(i); frame.size() >= blocks)
      return frame.time;
  return {};
}

WhyScene read_scene(const std::string& path, const std::optional<double>& time) {
  const std::string head = head_of(path);
  if (post::fault_of_head(path).empty())
    return from_results(path, time);
  if (head == "BLOCKS c")
    return from_checkpoint(path);
  throw output::FileError("cannot read " + path +
                          ": it is neither results (NAME.vtkhdf) nor a checkpoint "
                          "(NAME.ckpt.h5) of BLOCKS");
}

}  // namespace blocks::apps
