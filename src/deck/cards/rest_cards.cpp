#include "deck/cards/rest_cards.hpp"

#include "deck/commands.hpp"
#include "deck/ranges.hpp"

namespace blocks::deck {
namespace {

constexpr Range off_or_on{0, 1, false, false, false};
constexpr Range below_one{0, 1, false, true, false};
constexpr Range ratio{0, 1, true, true, false};
constexpr Range bracket_width{1e-9, infinity, false, false, false};
constexpr Range two_tests{Solve::fewest_steps, infinity, false, false, false};

}  // namespace

std::vector<CardSpec> rest_cards() {
  using enum Kind;
  return {
      {.name = "LOCDAMP",
       .section = "ours",
       .summary = "local damping, for statics",
       .fields = {{"alpha", real, ".8", below_one, "[-]",
                   "part of the unbalanced force that opposes the motion; 0: none"}},
       .notes = "A block is slowed down by alpha times its unbalanced force, gravity "
                "included; its spin and its strain rates likewise. A block in free "
                "flight falls at (1 - alpha) times gravity.",
       .example = "LOCDAMP, .2"},
      {.name = "KINDAMP",
       .section = "ours",
       .summary = "kinetic damping, for statics",
       .fields = {{"on", integer, "1", off_or_on, "[-]", "0 ends kinetic damping"}},
       .notes = "All free blocks are stopped whenever the kinetic energy of the model "
                "has passed a peak.",
       .example = "KINDAMP, 0"},
      {.name = "MSCALE",
       .section = "ours",
       .summary = "scale masses during SOLVE and FOS, for statics",
       .fields = {{"on", integer, "1", off_or_on, "[-]", "0 ends mass scaling"}},
       .notes =
           "During SOLVE and FOS, the inertial masses of free blocks are such that all "
           "have the same critical time step. Weights and forces stay as they "
           "are. Outside SOLVE and FOS, blocks have their true masses.",
       .example = "MSCALE, 0"},
      {.name = "INSITU",
       .section = "ours",
       .summary = "stress in the ground at the start",
       .fields = {{"sxx", real, "0", any, "[F/L^2]",
                   "stress at y = 0, tension positive"},
                  {"syy", real, "0", any, "[F/L^2]",
                   "stress at y = 0, tension positive"},
                  {"sxy", real, "0", any, "[F/L^2]", "shear stress at y = 0"},
                  {"dxx", real, "0", any, "[F/L^3]", "gradient of sxx in y"},
                  {"dyy", real, "0", any, "[F/L^3]", "gradient of syy in y"},
                  {"dxy", real, "0", any, "[F/L^3]", "gradient of sxy in y"}},
       .notes = "Loads the flush faces of all blocks and the sides on symmetry planes "
                "at its place in the deck, and gives deformable blocks the stress at "
                "their centroids.",
       .example = "INSITU, -1.D4, -2.D4"},
      {.name = "SERVO",
       .section = "ours",
       .summary = "drive a fixed block so that its side holds a normal stress",
       .fields = {{"nb", block, "", from_one, "[-]",
                   "number of a fixed block, or selector of one; may be blank if "
                   "nside is a selector"},
                  {"nside",
                   side,
                   {},
                   from_one,
                   "[-]",
                   "number of its side, or selector of one"},
                  {"s", real, {}, any, "[F/L^2]", "normal stress, tension positive"},
                  {"vmax", real, {}, positive, "[L/T]", "largest speed"}},
       .notes =
           "The block moves along the normal of the side. The stress is the force "
           "of the springs of all contacts of the block in that direction, divided "
           "by the length of the side. DRIVE, FIX, REMOVE and FREE end the servo.",
       .example = "SERVO, 1, 2, -1.D5, .01"},
      {.name = "QUIET",
       .section = "ours",
       .summary = "let waves leave through a side",
       .fields = {{"nb", block, "", from_one, "[-]",
                   "block number or selector; blank: all blocks, if nside is a "
                   "selector"},
                  {"nside",
                   side,
                   {},
                   from_one,
                   "[-]",
                   "number of its side, or selector of one or more"},
                  {"cp", real, "", positive, "[L/T]",
                   "speed of compression waves; blank: from the elastic constants"},
                  {"cs", real, "", positive, "[L/T]",
                   "speed of shear waves; blank: from the elastic constants"}},
       .notes =
           "Dashpots at the two corners of the side carry off the energy of waves. "
           "A fixed block is freed; the reaction that held it stays as a constant "
           "force on the side. With RIGID, cp must be given; a blank cs is then "
           "half of cp.",
       .example = "QUIET, 3, 4, 200., 100."},
      {.name = "SOLVE",
       .section = "ours",
       .summary = "run until the forces are balanced",
       .fields = {{"ratio", real, "1.D-5", ratio, "[-]",
                   "sum of the unbalanced forces over that of all forces"},
                  {"nmax", integer, "100000", two_tests, "[-]",
                   "largest number of time steps"},
                  {"local", real, "", positive, "[-]",
                   "largest local ratio; blank: 100 times the ratio, at most .01"}},
       .notes =
           "The local ratio is that of one block: its unbalanced force over the sum "
           "of the sizes of all forces on it. Both ratios are tested every 10 steps. "
           "The card ends when two successive tests find at most those given. If "
           "nmax steps do not reach them, there is a warning, and the deck continues. "
           "Needs damping: DAMPING, LOCDAMP or KINDAMP.",
       .example = "SOLVE, 1.D-5, 20000"},
      {.name = "FOS",
       .section = "ours",
       .summary = "factor of safety by reduction of strength",
       .fields = {{"width", real, ".01", bracket_width, "[-]",
                   "wanted width of the bracket"},
                  {"ratio", real, "1.D-5", ratio, "[-]",
                   "of the unbalanced forces in a stable trial, as in SOLVE"},
                  {"ncycle", integer, "", two_tests, "[-]",
                   "largest number of steps of a trial; blank: 500 times the response "
                   "of the model, 2000 to 200000"},
                  {"lower", real, "", positive, "[-]",
                   "factor at which the model is stable; blank: is looked for"},
                  {"upper", real, "", positive, "[-]",
                   "factor at which it fails; blank: is looked for"}},
       .notes =
           "Each trial starts from the present state, with the strength of all joints "
           "divided by a factor: friction, cohesion and tension, FRICTN too. It is "
           "stable if the forces balance and the fastest block slows down, failing if "
           "the motion goes on. The factor of safety is between the "
           "largest stable factor and the smallest failing one. Afterwards the model "
           "is as it was. Needs SOLVE or INSITU before it, and damping.",
       .example = "FOS, .02, 1.D-4, 5000"},
      {.name = "SAVE",
       .section = "ours",
       .summary = "write a checkpoint under a name",
       .fields = {{"name",
                   word,
                   {},
                   any,
                   "",
                   "name of the checkpoint, without a folder; the file is "
                   "name.ckpt.h5, beside the other files of the run"}},
       .notes = "Another deck continues from here with RESTART, name. A run of the "
                "same deck replaces the file and keeps the old one as .prev. A file of "
                "another deck gets the ending .bak, with a warning.",
       .example = "SAVE, excavated"},
  };
}

}  // namespace blocks::deck
