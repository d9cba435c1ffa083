#include "run/cutting/cut_outcome.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "deck/points.hpp"
#include "geometry/cut.hpp"
#include "geometry/polygon.hpp"
#include "run/cutting/cut_joints.hpp"

namespace blocks::run {
namespace {

using geometry::CutError;
using geometry::CutReport;

/// Cuts one domain and reports faults at the cards of its group.
class DomainCutter {
 public:
  DomainCutter(const deck::Cut& card, deck::SourceLocation where,
               deck::Diagnostics& diagnostics)
      : card_(card), where_(where), diagnostics_(diagnostics) {}

  std::optional<CutOutcome> cut(const geometry::SharedCorners& corners,
                                const CutOptions& options) {
    geometry::CutRequest request = this->request(corners);
    if (!sound_)
      return {};
    std::optional<CutJoints> joints =
        cut_joints(card_,
                   {options.seed, options.folder, options.unit, request.outline,
                    options.max_new_blocks, options.progress},
                   diagnostics_);
    if (!joints)
      return {};
    request.joints = std::move(joints->segments);
    request.progress = options.progress;
    try {
      const geometry::CutResult result = geometry::cut_outline(request);
      warn_of_lost_joints(request, result.report);
      CutOutcome outcome = outcome_of(result);
      outcome.notes = std::move(joints->notes);
      return outcome;
    } catch (const CutError& fault) {
      tell(fault);
      return {};
    }
  }

 private:
  void error(deck::SourceLocation where, const char* card, const std::string& message,
             const std::string& hint) {
    diagnostics_.error(where, card, message, hint);
    sound_ = false;
  }

  geometry::CutRequest request(const geometry::SharedCorners& corners) {
    const deck::Outline& outline = card_.outline;
    geometry::CutRequest request;
    request.outline = deck::points_of(outline.x, outline.y);
    orient(request.outline);
    request.rounded.emplace();
    for (const geometry::DecimalPoint& corner : request.outline)
      request.rounded->push_back(corners.place({corner.x.value(), corner.y.value()}));
    request.emin = card_.emin.value.value();
    request.amin = card_.amin.value.value();
    for (const deck::Int& id : card_.protect)
      request.protected_joints.push_back(static_cast<int>(id.value));
    if (sound_)
      check_limits(*request.rounded);
    return request;
  }

  /// Checks the outline and makes it clockwise.
  void orient(std::vector<geometry::DecimalPoint>& corners) {
    const deck::Outline& outline = card_.outline;
    geometry::Polygon nearest;
    for (const geometry::DecimalPoint& corner : corners)
      nearest.emplace_back(corner.x.value(), corner.y.value());
    const geometry::OutlineCheck check = geometry::check_outline(nearest);
    if (check.fault != geometry::OutlineFault::none) {
      const auto at = static_cast<std::size_t>(std::max(check.first, 0));
      error(at < outline.x.size() ? outline.x[at].where : outline.where, "OUTLINE",
            geometry::describe(check),
            "give the corners in order around the domain, clockwise, each one once");
    } else if (check.anticlockwise) {
      diagnostics_.warning(outline.where, "OUTLINE", "the corners run anticlockwise",
                           "corner 1 is kept and the others are taken in the reverse "
                           "order");
      std::reverse(corners.begin() + 1, corners.end());
    }
  }

  void check_limits(const geometry::Polygon& corners) {
    Vec2 low = corners[0], high = corners[0];
    for (const Vec2& corner : corners) {
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
    if (std::max(-low.minCoeff(), high.maxCoeff()) > geometry::largest_coordinate)
      return error(card_.outline.where, "OUTLINE",
                   "a corner is too far away to calculate with",
                   "choose another unit of length");
    area_ = geometry::section_properties(corners).area;
    if (!(area_ > 0.0) || !std::isfinite(area_))
      return error(card_.outline.where, "OUTLINE",
                   fmt::format("its area is too {} to calculate with",
                               area_ > 0.0 ? "large" : "small"),
                   "choose another unit of length");
    const double size = (high - low).maxCoeff();
    if (const double emin = card_.emin.value.value(); emin > 0.0 && emin >= size)
      error(card_.emin.where, "CUT",
            fmt::format("emin is {:g}, and the outline measures only {:g}", emin, size),
            "give a small part of the size of a block");
    if (const double amin = card_.amin.value.value(); amin > 0.0 && amin >= area_)
      error(card_.amin.where, "CUT",
            fmt::format("amin is {:g}, and the area of the outline only {:g}", amin,
                        area_),
            "give a small part of the area of a block");
  }

  void tell(const CutError& fault) {
    const std::string message = fmt::format("{}, at ({:.6g}, {:.6g})", fault.what(),
                                            fault.place.x(), fault.place.y());
    switch (fault.kind) {
    case CutError::Kind::outline:
      return error(card_.outline.where, "OUTLINE", message, fault.hint);
    case CutError::Kind::cleaning:
      return error(card_.emin.where, "CUT", message, fault.hint);
    case CutError::Kind::joint:
    case CutError::Kind::generator:
    case CutError::Kind::certificate:
      return error(where_, "CUT", message, fault.hint);
    }
  }

  /// Warns of joint ids that no side can have, because the smallest id counts where
  /// joints coincide.
  void warn_of_lost_joints(const geometry::CutRequest& request,
                           const CutReport& report) {
    Eigen::AlignedBox2d domain;
    for (const Vec2& corner : *request.rounded)
      domain.extend(corner);
    std::map<int, Vec2> lost;  // with the middle of the first joint
    for (const geometry::JointSegment& joint : request.joints) {
      const Vec2 middle = 0.5 * joint.from.nearest() + 0.5 * joint.to.nearest();
      if (joint.id > 0 && !report.lengths.contains(joint.id) &&
          (domain.min().array() < middle.array()).all() &&
          (middle.array() < domain.max().array()).all())
        lost.emplace(joint.id, middle);
    }
    for (const auto& [id, middle] : lost)
      diagnostics_.warning(
          where_, "CUT",
          fmt::format("no side has the joint id {}: its joints coincide with others of "
                      "a smaller id, as at ({:.6g}, {:.6g}), or with the outline",
                      id, middle.x(), middle.y()),
          "remove them, or give them the smaller id");
  }

  CutOutcome outcome_of(const geometry::CutResult& result) {
    const CutReport& report = result.report;
    CutOutcome outcome;
    for (const geometry::CutBlock& block : result.blocks) {
      NewBlock& made = outcome.blocks.emplace_back();
      made.material = static_cast<int>(card_.outline.mat.value);
      made.joints = block.joints;
      for (const int corner : block.corners)
        made.outline.push_back(result.mesh.vertices[static_cast<std::size_t>(corner)]);
    }
    CutRecord& record = outcome.record;
    record.blocks = static_cast<int>(outcome.blocks.size());
    record.cells = result.certificate.cells;
    record.interior_edges = result.certificate.interior_edges;
    record.outline_edges = result.certificate.outline_edges;
    record.area = area_;
    record.counts = report;
    for (const auto& [joint, length] : report.lengths)
      outcome.lengths.push_back({0, joint, length.drawn, length.pruned});
    return outcome;
  }

  const deck::Cut& card_;
  deck::SourceLocation where_;
  deck::Diagnostics& diagnostics_;
  double area_ = 0.0;  ///< [L^2] of the outline
  bool sound_ = true;
};

}  // namespace

std::optional<CutOutcome> cut_domain(const deck::Cut& card, deck::SourceLocation where,
                                     const geometry::SharedCorners& corners,
                                     const CutOptions& options,
                                     deck::Diagnostics& diagnostics) {
  return DomainCutter(card, where, diagnostics).cut(corners, options);
}

}  // namespace blocks::run
