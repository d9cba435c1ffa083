// The deck as data: an ordered list of plain structs named after the cards (report
// Appendix A). They hold values only and are independent of the model. The card table
// defines defaults and ranges.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "deck/selector.hpp"
#include "deck/source_location.hpp"
#include "geometry/decimal.hpp"

namespace blocks::deck {

/// A value and its location in the deck. `given` is false if the default was used.
template <class T> struct Given {
  T value{};
  SourceLocation where;
  bool given = false;
};

using Int = Given<long>;
using Real = Given<double>;
using Exact = Given<geometry::Decimal>;  ///< a number that describes geometry
using Word = Given<std::string>;

/// A block or a side that a field names by its number or by a selector.
struct NumberOrSelector {
  Int number;  ///< its value is 0 if there is a selector
  std::optional<Selector> selector = {};

  bool given() const { return number.given; }
  SourceLocation where() const { return number.where; }
};

// Preliminary data, A.1
struct Start {
  Int nblok, ncmx;
  std::string title;
};
struct XLimits {
  Real xmin, xmax;
};
struct YLimits {
  Real ymin, ymax;
};
struct Boxes {
  Int iboxes, jboxes;
  Real ctol;
};
struct Stiff {
  Real stifn, stifs;
};
struct Fraction {
  Real tfrac;
};
struct Material {
  Int mat;
  Real e, g, rho;
  Word name;  ///< not in the report
};
struct Function {
  Int ntimep;
  std::vector<Real> t, p;
};
struct Rigid {};
struct Seed {
  Int seed;
};  ///< not in the report
struct Units {
  Word length, mass, time;
};  ///< not in the report
struct End {};
struct Restart {
  Word file;
};  ///< the file name is not in the report

// Problem definition data, A.2
struct Cloop {
  Int nloop;
  Exact radd, zadd;
};
struct Create {
  Int nc, mat, ifix;
  std::vector<Exact> x, y;
  std::optional<Cloop> loop;  ///< the CLOOP card directly before, if any
};
/// Joint ids of faces of blocks, 0: none; not in the report.
struct FaceIds {
  Int bottom, top, side;

  bool given() const { return bottom.given || top.given || side.given; }
};
struct Read9 {
  Word file;  ///< not in the report
  FaceIds joints = {};
};
struct Layer {
  Int ns, mat;
  std::array<Exact, 8> corners;    ///< x1, y1, ..., x4, y4
  Word rcommand;                   ///< RANDOM or blank
  std::vector<Exact> bottom, top;  ///< if ns > 0: ns widths each, short lists completed
  FaceIds joints = {};
};
// A group OUTLINE ... CUT, which the parser joins into the command CUT; not in the
// report
struct Outline {
  SourceLocation where = {};
  Int nc, mat;
  Word file, layer;            ///< file is given if nc is not
  std::vector<Exact> x, y;     ///< [L] corners; empty until the file is read
  std::string file_unit = {};  ///< of length, if the file states one: "mm"
};
struct Jset {
  SourceLocation where;
  Int id;
  Exact dip, ddev, space, sdev, trace, tdev, gap, gdev, x0, y0;
  Word law;   ///< UNIFORM, NEGEXP or POISSON
  Int until;  ///< traces end at joints of this id, if `given`
};
struct Traces {
  SourceLocation where;
  Word file;
  Int id;
  Exact snap;
  Word layer;  ///< if `given`, only its traces, and all of them have the id
};
struct Voronoi {
  SourceLocation where;
  Int n, lloyd, id;
  Word file;  ///< given if n is not
};
struct Cut {
  Outline outline;
  std::vector<std::variant<Jset, Traces, Voronoi>> joints;  ///< at least one
  Exact emin, amin;
  std::vector<Int> protect = {};  ///< joint ids whose corners cleaning does not move
};
struct Orient {
  Exact angmin, angplus;
};
struct Merge {
  Exact aratio;
};
struct Splane {
  Real x1, y1, x2, y2;
};
struct Gravity {
  Real gravx, gravy;
  Real tramp;  ///< not in the report
};
struct Fix {
  NumberOrSelector nblok;
};
/// The blocks that REMOVE and FREE name: a range of numbers, a selector, a material, or
/// all blocks inside an outline. Exactly one of nb1, mat and nc is given.
struct Selection {
  NumberOrSelector nb1;
  Int nb2;  ///< 0 for nb1 alone, negative for all from nb1 on
  Int mat;
  Int nc;
  Word rule;                ///< for an outline: INSIDE, also if blank, or CENTROID
  std::vector<Exact> x, y;  ///< [L] (nc) corners of the outline

  bool is_by_centroid() const { return rule.value == "CENTROID"; }
};
struct Remove {
  Selection blocks;
};  ///< not in the report
struct Free {
  Selection blocks;
};  ///< not in the report
struct PressBc {
  NumberOrSelector nblok, nside;  ///< nblok may be blank if nside is a selector
  Real p1, p2, tarriv;
};
struct Force {
  NumberOrSelector nblok;
  Real fx, fy, tarriv;
};
// Water (docs/water.md); not in the report
struct Water {
  Real gamma;
  Int n;
  Real tramp;
  std::vector<Real> x, y;  ///< [L] (n) points of the table
};
struct Jwater {
  Int id;
  Real x1, y1, p1, x2, y2, p2, reach, tramp;

  /// Whether there is a pressure: all other sides of the id are dry.
  bool presses() const { return p1.value != 0.0 || p2.value != 0.0; }
};
struct Frictn {
  Real fric;
};
struct SetVel {
  NumberOrSelector nb1;
  Int nb2;
  Real vx, vy, tdot;
};
struct SetVelM {
  Int mat;
  Real vx, vy, tdot;
};
struct Damping {
  Real beta;
};
// Joints with strength and driven blocks (docs/laws.md); not in the report
/// Blank fields have their defaults, except zdil, kn and ks: `given` is then false.
struct Joint {
  Int id;
  Real fric, coh, ten, fricr, cohr, tenr;
  Exact dil;  ///< degrees
  /// ks has the value of kn if it is blank.
  Real zdil, kn, ks;
};
struct Walton {
  Int id;
  Real e;
};
struct Barton {
  Int id;
  Real jrc, jcs, phir, upeak, kni, vm, knmax;
};
struct Jpair {
  Int mat1, mat2, id;
};
struct Bond {
  Int id;
  Real tol;
};
struct Drive {
  NumberOrSelector nb;
  Real vx, vy, tdot;
};
// Rest and waves (docs/rest.md, docs/waves.md); not in the report
struct Locdamp {
  Real alpha;
};
struct Kindamp {
  Int on;
};
struct Mscale {
  Int on;
};
struct Insitu {
  Real sxx, syy, sxy, dxx, dyy, dxy;
};
struct Servo {
  NumberOrSelector nb, nside;
  Real s, vmax;
};
struct Quiet {
  NumberOrSelector nb, nside;
  Real cp, cs;  ///< `given` is false if the elastic constants give them
};
// Blocks that split (docs/cracks.md); CRACK is lost from the report
struct Crack {
  Int mat;
  Real ten, amin;
  Real tenp;  ///< `given` is false without the rule of point loads
  Int id;
};
struct Mdamp {
  Int mat;
  Real z;
};
struct Dump {};
struct Output {
  Real dtout;
  std::vector<NumberOrSelector> blocks;
};
struct Plots {
  Real dtplot;              ///< `given` is false if `steps` is
  std::vector<Real> times;  ///< not in the report
  Int steps = {};           ///< between frames, if `given`; not in the report
};
struct History {
  Real dthist;
  std::vector<Word> quantities;
};  ///< not in the report
struct Motion {
  Real dt;
};
struct Cycle {
  Int ncycle;
};
struct Solve {  // not in the report
  Real ratio;
  Int nmax;
  Real local = {};  ///< `given` is false if the ratio tells; see local_ratio()

  /// Returns the local ratio that is wanted: `local`, or 100 times `ratio`, but at most
  /// .01, if that is blank.
  double local_ratio() const {
    constexpr double times_ratio = 100.0, at_most = 0.01;
    return local.given ? local.value : std::min(times_ratio * ratio.value, at_most);
  }

  /// Steps between two tests of the ratio. Each test reads the model, which takes
  /// longer than a step; a longer interval makes more steps than needed.
  static constexpr long test_interval = 10;
  /// The least nmax: equilibrium needs two successive tests.
  static constexpr long fewest_steps = 2 * test_interval;
};
struct Fos {  // not in the report
  Real width, ratio;
  Int ncycle = {};  ///< `given` is false if the response of the model tells
  Real lower = {}, upper = {};

  /// Returns the largest number of steps of a trial that is ever made.
  long max_steps() const {
    constexpr long unless_given = 200'000;
    return ncycle.given ? ncycle.value : unless_given;
  }
  /// Returns the SOLVE card whose ratios a stable trial reaches.
  Solve as_solve() const { return {ratio, {max_steps(), ncycle.where, true}}; }
};
struct Save {
  Word name;
};  ///< not in the report
struct Stop {};

using Card =
    std::variant<Start, XLimits, YLimits, Boxes, Stiff, Fraction, Material, Function,
                 Rigid, Seed, Units, End, Restart, Create, Read9, Layer, Cut, Orient,
                 Merge, Splane, Gravity, Fix, Remove, Free, PressBc, Force, Water,
                 Jwater, Frictn, SetVel, SetVelM, Damping, Joint, Walton, Barton, Jpair,
                 Bond, Drive, Locdamp, Kindamp, Mscale, Insitu, Servo, Quiet, Crack,
                 Mdamp, Dump, Output, Plots, History, Motion, Cycle, Solve, Fos, Save,
                 Stop>;

struct Command {
  SourceLocation where;  ///< the keyword
  std::string name;      ///< the keyword in capitals
  Card card;
};

/// Whether the card is MOTION, CYCLE, SOLVE or FOS.
inline bool passes_time(const Command& command) {
  return std::holds_alternative<Motion>(command.card) ||
         std::holds_alternative<Cycle>(command.card) ||
         std::holds_alternative<Solve>(command.card) ||
         std::holds_alternative<Fos>(command.card);
}

/// A card with a fault. It is not among the commands.
struct UnreadCard {
  SourceLocation where;        ///< the keyword
  std::string name;            ///< in capitals; empty: the card is unknown
  std::optional<long> number;  ///< its first value, if that is a whole number
  long blocks = 0;             ///< how many blocks it may have made at most
  static constexpr long any_number_of_blocks = 1'000'000'000'000;
};

struct Deck {
  std::string file;               ///< as named by the user; "-" for standard input
  std::string text;               ///< the whole deck
  std::vector<Command> commands;  ///< in the order of the deck
  std::vector<UnreadCard> unread = {};  ///< cards with faults, in that order
};

}  // namespace blocks::deck
