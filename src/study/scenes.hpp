// The functions that make the scenes of the study. Scenes with Draws differ from frame
// to frame.
#pragma once

#include "study/draws.hpp"
#include "study/scene.hpp"

namespace blocks::study::scenes {

// scenes_falling.cpp
Scene figure4b();
Scene diagonal();
Scene wedge();
Scene tee();
Scene shaft();
Scene bricks();
Scene slot();
Scene slab();

// scenes_sliding.cpp
Scene floor_of_boxes();
Scene soft_floor();
Scene soft_floor_4();
Scene soft_floor_8();
Scene nose();
Scene bow();
Scene roller(Draws& draw);

// scenes_striking.cpp
Scene needle();
Scene plate();
Scene tip();
Scene stake(Draws& draw);
Scene toe(Draws& draw);
Scene triangles(Draws& draw);

// scenes_resting.cpp
Scene stack();
Scene wall();
Scene terrain(Draws& draw);
Scene undercut(Draws& draw);

// scenes_notches.cpp
Scene notch(Draws& draw);

// scenes_toppling.cpp
Scene step_notch(Draws& draw);
Scene step_flush(Draws& draw);
Scene step_slabs(Draws& draw);

// scene_cut.cpp
Scene cut(Draws& draw);
/// The same with pieces that are free and bonded to each other.
Scene bonded(Draws& draw);
/// `cut` with so many joints, if the domain has space for them.
Scene cut_by(Draws& draw, int joints);

}  // namespace blocks::study::scenes
