#include "deck/cards/law_cards.hpp"

#include <fmt/format.h>

#include "deck/ranges.hpp"
#include "geometry/angle.hpp"

namespace blocks::deck {
namespace {

constexpr Range material{1, 2147483647, false, false, false};
constexpr Range law_id{1, 1e9, false, false, false};
constexpr Range id_or_all{0, 1e9, false, false, false};
constexpr Range dilation_angle{0, 89, false, false, false};
constexpr Range restitution{0, 1, true, false, false};
// Barton's profiles have JRC up to 20.
constexpr Range roughness{0, 20, true, false, false};
// The angle of roughness and phir together is limited to 70 degrees.
constexpr Range residual_angle{0, 70, true, true, false};

CardSpec joint() {
  using enum Kind;
  return {
      .name = "JOINT",
      .section = "ours",
      .summary = "strength and stiffness of the joints with an id",
      .fields =
          {{"id", integer, {}, law_id, "[-]", "joint id"},
           {"fric", real, "0", not_negative, "[-]", "coefficient of friction"},
           {"coh", real, "0", not_negative, "[F/L^2]", "cohesion"},
           {"ten", real, "0", not_negative, "[F/L^2]", "tensile strength"},
           {"fricr", real, "", not_negative, "[-]",
            "residual coefficient of friction, <= fric; blank: fric"},
           {"cohr", real, "0", not_negative, "[F/L^2]",
            "residual cohesion, <= coh; blank: 0"},
           {"tenr", real, "0", not_negative, "[F/L^2]",
            "residual tensile strength, <= ten; blank: 0"},
           {"dil", exact, "0", dilation_angle, "[degrees]",
            "dilation angle, tan(dil) <= fricr"},
           {"zdil", real, "", positive, "[L]",
            "slip beyond which the joint opens no further; blank: unlimited"},
           {"kn", real, "", positive, "[F/L^3]",
            "normal stiffness per area; blank: stifn of STIFF per contact"},
           {"ks", real, "", positive, "[F/L^3]",
            "shear stiffness per area; blank: kn, or stifs of STIFF per contact"}},
      .notes =
          "The law acts where two sides with this joint id meet, and between the "
          "materials of JPAIR. All other contacts have STIFF and FRICTN. A contact "
          "that "
          "has failed has the residual values. Only contacts that BOND has bonded are "
          "intact. ten is lowered to coh / fric, the apex of the strength. The card "
          "acts at its place in the deck. After a MOTION, CYCLE or SOLVE, another "
          "JOINT card "
          "with this id replaces the values, except those of WALTON and BARTON.",
      .example = "JOINT, 4, .7, 2.D5, 5.D4, .6, , , 5., .01",
      .continue_below = 11};
}

CardSpec barton() {
  using enum Kind;
  return {
      .name = "BARTON",
      .section = "ours",
      .summary = "rough joints with Barton's shear strength and Bandis' closure",
      .fields =
          {{"id", integer, {}, law_id, "[-]", "joint id of a JOINT card above"},
           {"jrc", real, {}, roughness, "[-]", "joint roughness coefficient, JRC"},
           {"jcs",
            real,
            {},
            positive,
            "[F/L^2]",
            "compressive strength of the joint wall, JCS"},
           {"phir", real, {}, residual_angle, "[degrees]", "residual friction angle"},
           {"upeak", real, {}, positive, "[L]", "slip at peak strength"},
           {"kni",
            real,
            {},
            positive,
            "[F/L^3]",
            "normal stiffness of the unloaded joint"},
           {"vm", real, {}, positive, "[L]", "largest closure"},
           {"knmax",
            real,
            {},
            positive,
            "[F/L^3]",
            "largest normal stiffness, >= kni: the closure is linear beyond it"}},
      .notes = "Of its JOINT card only ks acts, or kn if ks is blank; fric, coh, ten "
               "and dil are 0. Must come before the first MOTION, CYCLE or SOLVE. For "
               "a joint "
               "of length L metres, upeak is about L/500 (JRC/L)^0.33 metres.",
      .example = "JOINT, 8, , , , , , , , , , 1.D9\n"
                 "BARTON, 8, 10., 1.D8, 30., .004, 1.D9, .0005, 1.D10",
      .continue_below = 8};
}

}  // namespace

std::vector<CardSpec> law_cards() {
  using enum Kind;
  return {
      joint(),
      {.name = "WALTON",
       .section = "ours",
       .summary = "Walton's normal law: unloading is stiffer than loading",
       .fields = {{"id", integer, {}, law_id, "[-]", "joint id of a JOINT card above"},
                  {"e", real, "1", restitution, "[-]",
                   "coefficient of restitution; unloading has the stiffness kn / e^2"}},
       .notes =
           "ten and dil of its JOINT card are 0. Must come before the first MOTION "
           "or CYCLE.",
       .example = "JOINT, 7, .5\nWALTON, 7, .6"},
      barton(),
      {.name = "JPAIR",
       .section = "ours",
       .summary = "joint id between the blocks of two materials",
       .fields = {{"mat1", integer, {}, material, "[-]", "material number"},
                  {"mat2",
                   integer,
                   {},
                   material,
                   "[-]",
                   "material number; may be that of mat1"},
                  {"id", integer, {}, law_id, "[-]", "joint id of a JOINT card above"}},
       .notes = "Does not act where two sides with the same joint id and a JOINT card "
                "of that id meet. The card acts at its place in the deck, for blocks "
                "that are made later too. After a MOTION, CYCLE or SOLVE, another "
                "JPAIR card "
                "may replace the id; ids of WALTON and BARTON stay.",
       .example = "JPAIR, 1, 1, 4"},
      {.name = "BOND",
       .section = "ours",
       .summary = "bond the flush faces of joints: intact contacts with peak strength",
       .fields = {{"id", integer, "0", id_or_all, "[-]",
                   "joint id of a JOINT card above; 0: all joints with a law"},
                  {"tol", real, "", not_negative, "[L]",
                   "largest gap or overlap of a flush face, <= ctol; blank: a "
                   "hundredth of ctol"}},
       .notes = "Acts at its place in the deck, on the faces that are flush there. The "
                "run tells how many contacts it has bonded. Contacts that form later "
                "have residual strength. Two fixed blocks have no contacts; in a shear "
                "box DRIVE stands before BOND.",
       .example = "BOND, 4"},
      {.name = "DRIVE",
       .section = "ours",
       .summary = "move a fixed block at a given velocity",
       .fields = {{"nb",
                   block,
                   {},
                   from_one,
                   "[-]",
                   "number of a fixed block, or selector of one or more"},
                  {"vx", real, "0", any, "[L/T]", "velocity of the centroid in x"},
                  {"vy", real, "0", any, "[L/T]", "velocity of the centroid in y"},
                  {"tdot", real, "0", any, "[1/T]",
                   "spin, radians per time, anticlockwise positive"}},
       .notes = "No force changes this motion. It lasts until the next DRIVE card of "
                "the block; all three values 0 stop it. FIX, REMOVE and FREE end it. A "
                "freed block keeps its velocity.",
       .example = "DRIVE, 1, .001, 0., 0."}};
}

namespace {

/// Reports values of JOINT that contradict each other.
class JointCheck {
 public:
  JointCheck(const Joint& card, Diagnostics& diagnostics)
      : card_(card), diagnostics_(diagnostics) {}

  bool passes() {
    not_above(card_.fricr, "fricr", card_.fric, "fric", "friction");
    not_above(card_.cohr, "cohr", card_.coh, "coh", "cohesion");
    not_above(card_.tenr, "tenr", card_.ten, "ten", "tensile strength");
    if (const double slope = geometry::tangent_of_degrees(card_.dil.value);
        slope > card_.fricr.value)
      fault(card_.dil,
            fmt::format("the tangent of dil must not exceed fricr, found {:.6g} and "
                        "{:g}",
                        slope, card_.fricr.value),
            "the joint would slide up its asperities without a shear force; reduce dil "
            "or raise fricr");
    return ok_;
  }

 private:
  template <class Field>
  void fault(const Field& at, const std::string& message, const std::string& hint) {
    diagnostics_.error(at.where, "JOINT", message, hint);
    ok_ = false;
  }
  void not_above(const Real& residual, const char* its_name, const Real& peak,
                 const char* peak_name, const char* what) {
    if (residual.value > peak.value)
      fault(residual,
            fmt::format("{} must not exceed {}, found {:g} and {:g}", its_name,
                        peak_name, residual.value, peak.value),
            fmt::format("a joint that has failed has no more {} than an intact one",
                        what));
  }

  const Joint& card_;
  Diagnostics& diagnostics_;
  bool ok_ = true;
};

/// Lowers a tensile strength to the apex of the envelope coh + fric Fn.
void limit_tension(Real& tension, const char* name, double cohesion,
                   const char* cohesion_name, double friction,
                   const char* friction_name, Diagnostics& diagnostics) {
  if (!(friction > 0.0) || !(tension.value > cohesion / friction))
    return;
  const double max = cohesion / friction;
  diagnostics.warning(tension.where, "JOINT",
                      fmt::format("{} = {:g} is lowered to {} / {} = {:.6g}", name,
                                  tension.value, cohesion_name, friction_name, max),
                      "under more tension the joint would have no shear strength");
  tension.value = max;
}

}  // namespace

std::optional<Card> build_joint(const std::vector<Value>& f, Diagnostics& diagnostics) {
  Joint card{f[0].as_int(),  f[1].as_real(), f[2].as_real(), f[3].as_real(),
             f[4].as_real(), f[5].as_real(), f[6].as_real(), f[7].as_exact(),
             f[8].as_real(), f[9].as_real(), f[10].as_real()};
  if (!card.fricr.given)
    card.fricr.value = card.fric.value;
  if (!card.ks.given)
    card.ks.value = card.kn.value;
  if (!JointCheck(card, diagnostics).passes())
    return {};
  limit_tension(card.ten, "ten", card.coh.value, "coh", card.fric.value, "fric",
                diagnostics);
  // A lowered peak value lowers the residual one without another message.
  if (card.tenr.value > card.ten.value)
    card.tenr.value = card.ten.value;
  limit_tension(card.tenr, "tenr", card.cohr.value, "cohr", card.fricr.value, "fricr",
                diagnostics);
  return card;
}

std::optional<Card> build_barton(const std::vector<Value>& f,
                                 Diagnostics& diagnostics) {
  const Barton card{f[0].as_int(),  f[1].as_real(), f[2].as_real(), f[3].as_real(),
                    f[4].as_real(), f[5].as_real(), f[6].as_real(), f[7].as_real()};
  if (card.knmax.value < card.kni.value) {
    diagnostics.error(
        card.knmax.where, "BARTON",
        fmt::format("knmax must not be less than kni, found {:g} and {:g}",
                    card.knmax.value, card.kni.value),
        "a joint becomes stiffer as it closes");
    return {};
  }
  return card;
}

}  // namespace blocks::deck
