// A random layer sinks onto a floor. Which of its blocks carry how much?
#include <blocks/simulation.hpp>

#include <cstdio>
#include <exception>

namespace {

const char* const cards = R"($ Units: m, kg, s
START, 20, 4
A LAYER ON A FLOOR
XLIMITS, -5, 15
YLIMITS, -2, 10
BOXES, 20, 12, 0.05
STIFF, 1.E8, 1.E8
FRACTION, 0.03
MATERIAL, 1, 1.E9, 4.E8, 2500
SEED, 4
RIGID
END
CREATE, 4, 1, 1
-4, -4, 14, 14
-1, 0, 0, -1
ORIENT, -10, 10
MERGE, 0.4
LAYER, -12, 1, 0,0, 0,1, 10,1, 10,0, RANDOM
GRAVITY, 0, -9.81
FRICTN, 0.6
DAMPING, 0.3
)";

void run() {
  blocks::Simulation rock(cards);
  while (rock.time() < 1.0)
    rock.step();

  double weight = 0.0, carried = 0.0;
  for (int block = 2; block <= rock.blocks(); ++block)
    weight += 9.81 * rock.mass(block);
  std::printf("block  corner  on block      x [m]    normal [N]     shear [N]\n");
  for (const blocks::ContactForce& contact : rock.contacts()) {
    std::printf("%5d  %6d  %8d  %9.4f  %12.1f  %12.1f\n", contact.corner_block,
                contact.corner, contact.edge_block, contact.point.x(),
                contact.normal_force, contact.shear_force);
    if (contact.edge_block == 1)
      carried += contact.force().y();
  }
  std::printf("the floor carries %.0f N of %.0f N\n", carried, weight);
}

}  // namespace

int main() {
  try {
    run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
