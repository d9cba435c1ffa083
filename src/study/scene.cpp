#include "study/scene.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

#include "study/scenes.hpp"

namespace blocks::study {
namespace {

using namespace scenes;

struct Named {
  std::string_view name;
  Scene (*make)();
  Scene (*make_varied)(Draws&);  ///< for a scene that differs from frame to frame
  bool must_pass;
};
constexpr Named same(std::string_view name, Scene (*make)(), bool must_pass = true) {
  return {name, make, nullptr, must_pass};
}
constexpr Named varied(std::string_view name, Scene (*make)(Draws&),
                       bool must_pass = true) {
  return {name, nullptr, make, must_pass};
}
/// The default rules are known to fail in some frames.
constexpr bool may_fail = false;

constexpr std::array all_scenes = {same("figure4b", figure4b),
                                   same("diagonal", diagonal),
                                   same("stack", stack),
                                   same("wall", wall),
                                   same("floor", floor_of_boxes),
                                   same("wedge", wedge),
                                   same("tee", tee),
                                   same("shaft", shaft),
                                   same("slab", slab),
                                   same("soft", soft_floor),
                                   same("needle", needle),
                                   same("slot", slot),
                                   same("plate", plate),
                                   same("nose", nose),
                                   same("tip", tip),
                                   varied("stake", stake, may_fail),
                                   varied("triangles", triangles, may_fail),
                                   same("soft4", soft_floor_4),
                                   same("soft8", soft_floor_8),
                                   varied("roller", roller),
                                   same("bow", bow),
                                   varied("toe", toe, may_fail),
                                   same("bricks", bricks, may_fail),
                                   varied("step-notch", step_notch),
                                   varied("step-flush", step_flush),
                                   varied("step-slabs", step_slabs),
                                   varied("terrain", terrain),
                                   varied("undercut", undercut),
                                   varied("notch", notch),
                                   varied("cut", cut, may_fail),
                                   varied("bonded", bonded, may_fail)};

Scene make(const Named& named, std::uint64_t seed, int number) {
  Draws draw(seed, number, 1);
  Scene scene = named.make ? named.make() : named.make_varied(draw);
  scene.must_pass = named.must_pass;
  return scene;
}

}  // namespace

const std::vector<std::string_view>& scene_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> all;
    for (const Named& scene : all_scenes)
      all.push_back(scene.name);
    return all;
  }();
  return names;
}

Scene make_scene(std::string_view name) {
  for (const Named& named : all_scenes)
    if (named.name == name) {
      Scene scene = make(named, FrameChoice().seed, 0);
      if (named.make_varied)
        scene.vary = [&named](std::uint64_t seed, int number) {
          return make(named, seed, number);
        };
      return scene;
    }
  throw std::out_of_range("there is no scene " + std::string(name));
}

const Scene& scene_in_frame(const Scene& scene, std::uint64_t seed, int number,
                            Scene& varied) {
  if (!scene.vary)
    return scene;
  varied = scene.vary(seed, number);
  return varied;
}

Scene scene_of_deck(const std::string& name, const Model& model) {
  Scene scene;
  scene.name = name;
  scene.what = model.settings.title;
  scene.model = model;
  scene.steps = 2000;
  double area = 0.0;
  int count = 0;
  for (int b = 0; b < model.blocks.size(); ++b)
    if (model.blocks.is_free(b))
      area += model.blocks.area[b], ++count;
  scene.size = count > 0 ? std::sqrt(area / count) : 1.0;
  scene.known_motion = false;
  scene.min_share = 0.5, scene.min_way = 0.5;
  scene.max_sinking = 0.5;
  scene.conservative = false;
  return scene;
}

}  // namespace blocks::study
