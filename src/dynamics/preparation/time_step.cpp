#include "dynamics/preparation/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <vector>

#include "dynamics/kernels/motion_kernel.hpp"
#include "dynamics/preparation/packed_contacts.hpp"
#include "geometry/polygon.hpp"
#include "model/safe_fraction.hpp"

namespace blocks::dynamics {
namespace {

/// The largest stiffness of a contact with this law on an edge of length `edge`, [F/L].
/// A contact stands for half of an edge at most; contacts without a face have STIFF.
double largest_stiffness(const JointLaw& law, const Settings& settings, double edge) {
  const double half = 0.5 * edge;
  double normal = std::max(settings.normal_stiffness, law.normal_stiffness * half);
  if (law.kind == LawKind::walton)
    normal /= law.restitution * law.restitution;
  if (law.kind == LawKind::barton)
    normal = std::max(normal, law.largest_stiffness * half);
  return std::max(normal, law.shear_stiffness * half);
}

/// Finds the largest stiffness of any contact of a block, [F/L].
class ContactStiffness {
 public:
  explicit ContactStiffness(const Model& model)
      : settings_(model.settings),
        constant_(std::max(settings_.normal_stiffness, settings_.shear_stiffness)) {
    const Settings& settings = model.settings;
    find_present(model);
    for (const auto& [materials, id] : settings.joint_of_materials)
      for (const int material : {materials.first, materials.second})
        of_material_[material].push_back(&settings.joint_laws.at(id));
  }

  double of(const Blocks& blocks, int b) const {
    if (settings_.joint_laws.empty())
      return constant_;
    double largest = std::max(constant_, present_[static_cast<std::size_t>(b)]);
    for (int c = blocks.first_corner[b]; c < blocks.first_corner[b + 1]; ++c) {
      const double edge =
          (blocks.corner.col(blocks.next[c]) - blocks.corner.col(c)).norm();
      include(blocks.joint[c], blocks.material[b], edge, largest);
    }
    if (const auto rule = settings_.crack_rules.find(blocks.material[b]);
        rule != settings_.crack_rules.end())
      include(rule->second.joint, blocks.material[b], extent(blocks, b).norm(),
              largest);  // no chord is longer
    return largest;
  }

 private:
  /// Includes the laws of an edge with this joint id and of this material.
  void include(int joint, int material, double edge, double& largest) const {
    const auto add = [&](const JointLaw& law) {
      largest = std::max(largest, largest_stiffness(law, settings_, edge));
    };
    if (const auto own = settings_.joint_laws.find(joint);
        own != settings_.joint_laws.end())
      add(own->second);
    if (const auto of_pairs = of_material_.find(material);
        of_pairs != of_material_.end())
      for (const JointLaw* law : of_pairs->second)
        add(*law);
  }
  /// Finds the stiffnesses of the contacts that act. They stay when a card replaces
  /// their law by a softer one.
  void find_present(const Model& model) {
    present_.assign(static_cast<std::size_t>(model.blocks.size()), 0.0);
    for (std::size_t i = 0; i < model.law_states.size(); ++i) {
      const LawState& state = model.law_states[i];
      if (state.law == 0)
        continue;
      const auto law = settings_.joint_laws.find(state.law);
      double largest = state.stiffness;
      if (law != settings_.joint_laws.end() && law->second.kind == LawKind::walton)
        largest /= law->second.restitution * law->second.restitution;
      if (law != settings_.joint_laws.end() && law->second.kind == LawKind::barton)
        largest *= law->second.largest_stiffness / law->second.initial_stiffness;
      largest = std::max(largest, state.shear_stiffness);
      const auto [low, high] = pair_of(model.blocks, model.contacts[i]);
      for (const int b : {low, high}) {
        double& stiffness = present_[static_cast<std::size_t>(b)];
        stiffness = std::max(stiffness, largest);
      }
    }
  }

  const Settings& settings_;
  double constant_;              ///< of STIFF
  std::vector<double> present_;  ///< (blocks) of the contacts that act
  std::map<int, std::vector<const JointLaw*>> of_material_;
};

/// The least area of a piece of block b; infinite if the block does not split.
double min_piece(const Settings& settings, const Blocks& blocks, int b) {
  const auto rule = settings.crack_rules.find(blocks.material[b]);
  return rule == settings.crack_rules.end() ? std::numeric_limits<double>::infinity()
                                            : rule->second.min_area;
}

/// A step that one block allows.
struct BlockStep {
  double dt = std::numeric_limits<double>::infinity();  ///< [T]
  bool of_piece = false;  ///< it is that of a piece into which the block may split
};

/// The steps that single blocks allow.
class BlockSteps {
 public:
  /// contact_share: see steps_of_blocks
  BlockSteps(const Model& model, const Eigen::VectorXd& contact_share)
      : settings_(model.settings), blocks_(model.blocks), shares_(contact_share),
        fraction_(fraction_in_force(model.settings)), stiffness_(model) {}

  /// Returns the step (4) with the mass of block b or, if it may split, of its smallest
  /// piece. The strain of a piece when it split off does not count.
  BlockStep by_contacts(int b) const {
    const double min = min_piece(settings_, blocks_, b);
    double mass = blocks_.mass[b];
    if (blocks_.area[b] >= min)
      mass = settings_.materials.at(blocks_.material[b]).density * min;
    const double constant =
        std::max(settings_.normal_stiffness, settings_.shear_stiffness);
    const double k = std::max(shares_[b] * constant, stiffness_.of(blocks_, b));
    return {fraction_ * 2.0 * std::sqrt(mass / k), mass < blocks_.mass[b]};
  }
  /// Returns the step that the deformability of block b allows. Its thickness is that
  /// at creation or, if it may split, of its thinnest piece.
  BlockStep by_strain(int b) const {
    const auto moment = blocks_.second_moment.col(b);
    const double whole = thickness({moment[0], moment[1], moment[3]}, blocks_.mass[b]);
    const double piece = min_thickness_of_pieces(min_piece(settings_, blocks_, b));
    const Material& material = settings_.materials.at(blocks_.material[b]);
    const double z = material.damping;
    // The normal strains are stable while C dt^2 + 2 d dt <= 4 M, d = 2 z sqrt(C11 M),
    // where C is at most 2 C11. This factor keeps the left side below 2 M for all z;
    // the rest is for contacts.
    const double damped = std::sqrt(1.0 + z * z) - z;
    return {0.5 * damped * std::min(whole, piece) *
                std::sqrt(material.density / material.c11()),
            piece <= whole};
  }

 private:
  const Settings& settings_;
  const Blocks& blocks_;
  const Eigen::VectorXd& shares_;
  double fraction_;
  ContactStiffness stiffness_;
};

}  // namespace

Vec2 extent(const Blocks& blocks, int b) {
  const auto corners =
      blocks.corner.middleCols(blocks.first_corner[b], blocks.corners_of(b));
  return corners.rowwise().maxCoeff() - corners.rowwise().minCoeff();
}

double min_width(const Blocks& blocks, int b) {
  const auto corners =
      blocks.corner.middleCols(blocks.first_corner[b], blocks.corners_of(b));
  const Vec2 inside = blocks.centroid.col(b);
  const int n = static_cast<int>(corners.cols());
  // The least width is at right angles to a side of the convex hull, which joins two
  // corners.
  const int reach = blocks.convex[b] ? 1 : n - 1;
  double min = std::numeric_limits<double>::infinity();
  for (int i = 0; i < n; ++i)
    for (int k = 1; k <= reach; ++k) {
      const Vec2 along = (corners.col((i + k) % n) - corners.col(i)).normalized();
      const Vec2 normal(-along.y(), along.x());
      const Eigen::RowVectorXd across =
          normal.transpose() * (corners.colwise() - inside);
      min = std::min(min, across.maxCoeff() - across.minCoeff());
    }
  return min;
}

double thickness(const Eigen::Vector3d& second_moment, double mass) {
  return std::sqrt(12.0 * geometry::smaller_moment(second_moment, min_moment_share) /
                   mass);
}

double min_thickness_of_pieces(double min_area) { return 0.5 * std::sqrt(min_area); }

TimeStep choose_time_step(const Model& model) {
  const Blocks& blocks = model.blocks;
  const Eigen::VectorXd shares = chooses_fraction(model.settings)
                                     ? contact_shares(model)
                                     : Eigen::VectorXd::Ones(blocks.size());
  const BlockSteps steps(model, shares);
  TimeStep best{std::numeric_limits<double>::infinity(), -1, blocks.size()};
  const auto include = [&](int b, const BlockStep& step, bool elastic) {
    if (step.dt < best.dt)
      best = {step.dt, b, blocks.size(), elastic, step.of_piece};
  };
  for (int b = 0; b < blocks.size(); ++b)
    if (!blocks.is_removed(b))
      include(b, steps.by_contacts(b), false);
  for (int b = 0; b < blocks.size(); ++b)
    if (!model.settings.rigid && blocks.is_free(b))
      include(b, steps.by_strain(b), true);
  return best;
}

Eigen::VectorXd steps_of_blocks(const Model& model,
                                const Eigen::VectorXd& contact_share) {
  const Blocks& blocks = model.blocks;
  const BlockSteps steps(model, contact_share);
  Eigen::VectorXd found = Eigen::VectorXd::Zero(blocks.size());
  for (int b = 0; b < blocks.size(); ++b) {
    if (!blocks.is_free(b))
      continue;
    found[b] = steps.by_contacts(b).dt;
    if (!model.settings.rigid)
      found[b] = std::min(found[b], steps.by_strain(b).dt);
  }
  return found;
}

}  // namespace blocks::dynamics
