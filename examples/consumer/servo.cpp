// A plate is pressed onto a wall of bricks by a servo: it moves as fast as the force on
// it differs from the one that is wanted, until the two are equal. The plate is of a
// heavy material, so that it moves as it is told, and FORCE holds its weight.
//   servo [force in N] [results.vtkhdf]      exit code 1: the force was not reached
#include <blocks/simulation.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

namespace {

const char* const cards = R"($ Units: m, kg, s. Block 1 is the floor, 12 the plate.
START, 12, 4
A PLATE ON A WALL
XLIMITS, -2, 8
YLIMITS, -2, 8
BOXES, 10, 10, 0.05
STIFF, 1.E8, 1.E8
FRACTION, 0.03
MATERIAL, 1, 1.E9, 4.E8, 2500
MATERIAL, 2, 1.E9, 4.E8, 1.E12
FUNCTION, 1
0, 1
RIGID
END
CREATE, 4, 1, 1
-1, -1, 7, 7
-1, 0, 0, -1
LAYER, -3, 1, 0,0, 0,1, 6,1, 6,0
LAYER, 4, 1, 0,1, 0,2, 6,2, 6,1
1, 2, 2, 1
1, 2, 2, 1
LAYER, -3, 1, 0,2, 0,3, 6,3, 6,2
CREATE, 4, 2
-0.5, -0.5, 6.5, 6.5
3, 3.5, 3.5, 3
GRAVITY, 0, -9.81
FORCE, 12, 0, 3.43350E13
FRICTN, 0.6
DAMPING, 0.3
)";

constexpr int floor_block = 1, plate = 12;
constexpr double fastest = 0.05;  // m/s
constexpr double close = 1e-3;    // of a force, to what is wanted

/// Tells a force [N] and the one that should be; whether they are close.
bool compare(const char* what, double force, double expected) {
  const double off = force / expected - 1.0;
  std::printf("%s %.1f N, expected %.1f N: off by %+.3f %%\n", what, force, expected,
              100.0 * off);
  return std::abs(off) <= close;
}

/// Whether the force was reached.
bool run(double wanted, const std::string& results) {
  blocks::Simulation wall(cards);
  const double stiffness = 6.0 * 1e8;  // of its contacts with three bricks, N/m
  const double gain = 0.005 / (stiffness * wall.time_step());  // m/s per N

  std::printf("    t [s]  plate at y [m]  force on it [N]  on the floor [N]\n");
  const long every = std::lround(0.1 / wall.time_step());
  for (long i = 0; i <= 15 * every; ++i) {
    const double force = wall.contact_force(plate).y();
    if (i % every == 0) {
      std::printf("%9.3f  %14.6f  %15.1f  %16.1f\n", wall.time(),
                  wall.centroid(plate).y(), force,
                  -wall.contact_force(floor_block).y());
      if (!results.empty())
        wall.write_frame(results);
    }
    const double down = std::clamp(gain * (wanted - force), -fastest, fastest);
    wall.set_velocity(plate, {0.0, -down});
    wall.step();
  }

  double bricks = 0.0;
  for (int block = floor_block + 1; block < plate; ++block)
    bricks += 9.81 * wall.mass(block);
  const bool pressed = compare("on the plate", wall.contact_force(plate).y(), wanted);
  const bool carried =
      compare("on the floor", -wall.contact_force(floor_block).y(), wanted + bricks);
  return pressed && carried;
}

}  // namespace

int main(int count, char** words) {
  const double wanted = count > 1 ? std::atof(words[1]) : 1e6;
  if (!(wanted > 0.0)) {
    std::fprintf(stderr, "usage: servo [force in N] [results.vtkhdf]\n");
    return 2;
  }
  try {
    return run(wanted, count > 2 ? words[2] : "") ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
