// The constants of the contact rule
// (docs/contact-rule.md#constants-of-the-contact-rule). This header has no functions,
// so that code for several instruction sets may include it.
#pragma once

namespace blocks::geometry {

/// A corner that is outside of an edge or beyond one of its ends by at most this part
/// of the length of the edge may still act on it. The number is exact (3.8e-6). Without
/// a slack, corners in line slip through each other's gaps and contacts flicker in
/// turned frames. With 1e-6, rounding moves a corner by the slack at 1e9 block sizes
/// from the origin; with 1e-5, the slack moves blocks by more than small overlaps do.
/// From 1e-2 on, blocks that only pass are caught.
inline constexpr double contact_slack = 0x1p-18;

/// Two sides face each other if their directions are opposite within this angle, in
/// degrees (20). A smaller angle loses contacts of bowed faces; a larger one takes a
/// tip for a face. The exact predicates use the polynomial of this angle
/// (at_most_ten_degrees in geometry/exact), so it is changed in both places.
inline constexpr double facing_angle = 10.0;
inline constexpr double facing_sine = 0.17364817766693033;
inline constexpr double facing_sine_squared = 0.030153689607045807973;
inline constexpr double facing_cosine_squared = 0.969846310392954192027;

/// A contact is far if it is deeper than this factor times the region that the two
/// parts have in common, and than this factor times every shift that separates the two,
/// or one of them from a third part.
inline constexpr double deepest_share = 2.0;

/// A joint is closed if its gap is at most this factor times the deeper overlap there.
inline constexpr double joint_width = 2.0;

/// But no joint is wider than this part of the longest side of own or of other,
/// whichever is shorter. So a part that is farther away certainly hides nothing.
inline constexpr double widest_joint = 1.0 / 32.0;

/// A third part counts if its bounding box meets that of the part that it may block,
/// grown by this part of the sum of its extents. The length has to exceed the depth of
/// contacts, because a third part may be reached after a shift by that depth.
inline constexpr double third_reach = 1.0 / 128.0;

/// A slide along a side is no way out of a third part if it is longer than this factor
/// times the slide the other way.
inline constexpr double longest_way = 4.0;

/// A third part hides an axis only if the part that is shifted out through the axis
/// overlaps the third one by at least this share of the shift. Flush sides may
/// overlap by rounding only.
inline constexpr double remaining_share = 0.02;

/// And only if the two overlap then by at least this share of their present overlap. A
/// shift that frees a part of both is a way out, not into a closed joint. Without it,
/// blocks of a pile hide each other's sides and sink in.
inline constexpr double remaining_overlap = 0.125;

/// A released spring passes to another contact of the same pair only if the angle
/// between the two edges has a larger cosine (18 degrees). Any value gives the same
/// result in all scenes of the study; above 1 nothing passes between the two faces of a
/// pair.
inline constexpr double successor_cosine = 0.95;

/// Two sides form a face, whose length a contact stands for, if their directions are
/// opposite within the angle of this cosine (18 degrees).
inline constexpr double face_cosine = 0.95;

/// A decision of the exact rule is kept until its blocks and their neighbours have
/// moved against each other by this part of the shorter one of the two longest arms, or
/// until the least depth has changed by a share of itself or of the slack
/// (docs/kept-decisions.md#renewal).
inline constexpr double renewal_of_arm = 1e-3;
inline constexpr double renewal_share = 0.125;

/// Within the slack, the least depth may change by this factor.
inline constexpr double renewal_factor = 2.0;

/// A corner that was inside is outside again only beyond this part of the length of the
/// side. Corners that meet exactly would be decided in every step without it.
inline constexpr double renewal_of_sign = 0x1p-28;

/// The constants that decide how long a decision is kept without a test. The guards
/// follow from the section of docs/kept-decisions.md that each of them names, so they
/// change only with its proof. The choices affect only the time that a run takes.
struct Certainty {
  // Guards
  /// #margins: error of a depth or position, as a part of the largest coordinate.
  static constexpr double depth_rounding = 0x1p-46;
  /// #margins: error of the sine between two sides.
  static constexpr double sine_rounding = 1e-12;
  /// #margins: [L] there is no margin if a side is shorter or a coordinate larger,
  /// because the square of a length might underflow or overflow.
  static constexpr double min_length = 1e-140, max_coordinate = 1e140;
  /// #deformable-blocks: the share of a slowness that counts.
  static constexpr double strain_share = 0.25;
  /// #motion-of-a-pair: largest validity distance, in shorter longest arms.
  static constexpr double max_validity = 0.125;
  /// #motion-of-a-pair: margin of the sine of two sides that do not run against each
  /// other. No validity distance is larger.
  static constexpr double opposite_sine = 0.5;
  /// #certain-decisions: a side is short if it is shorter than this part of the other.
  static constexpr double short_side = 0.2;
  /// #certain-decisions: the end of a long side reaches as far, in slacks.
  static constexpr double end_slacks = 2.0;
  /// #certain-decisions: two sides may be in line, now or by strain, if the far corner
  /// of each is at most so many slacks of the shorter one off the line of the other.
  static constexpr double in_line_slacks = 4.0;
  /// #third-parts: what the reach gets from the depth |h| and from a sin^2 t.
  static constexpr double reach_per_depth = 1.25, reach_per_half = 1.05;
  /// #third-parts: growth of the longest path, per clearance of a third part.
  static constexpr double growth_per_clearance = 0.15;
  /// #motion-of-a-pair: growth of the motion of a pair, per growth of its two paths.
  static constexpr double motion_per_path = 1.000001;
  /// #motion-of-a-pair: the motion of a centroid, and twice the turn of a unit arm,
  /// rounded up.
  static constexpr double shift_factor = 1.0000001, turn_factor = 2.0000001;
  /// #motion-of-a-pair: the longest arm, rounded up with its gradient.
  static constexpr double arm_factor = 1.0001;
  /// #motion-of-a-pair: error of a corner in a step, as a part of its coordinates, and
  /// of a sum of paths, as a part of the sum.
  static constexpr double corner_rounding = 0x1p-50, path_rounding = 0x1p-52;

  // Choices
  /// #third-parts: smallest clearance of a third part, in shorter longest arms.
  static constexpr double min_clearance = 0x1p-9;
  /// #third-parts: [L] growth without third parts. It is finite, because a new
  /// neighbour may be one.
  static constexpr double growth_alone = 0x1p1000;
  /// #certain-decisions: two parts count as apart if that holds for more than this
  /// share of the validity distance of their contacts.
  static constexpr double apart_share = 0.25;
  /// #certain-decisions: a contact that is beyond an end by more than this share of
  /// the validity distance is not listed.
  static constexpr double beyond_share = 0.25;
};

}  // namespace blocks::geometry
