#include "run/cutting/cut_joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <variant>

#include "files/fnv1a.hpp"
#include "geometry/joint_sources.hpp"
#include "run/cutting/joint_files.hpp"
#include "run/cutting/set_start.hpp"
#include "run/cutting/snap_proposal.hpp"
#include "run/support/contact_memory.hpp"
#include "text/counted.hpp"

namespace blocks::run {
namespace {

using geometry::JointSegment;

// Measured with 100,000 traces that cross three others each: 192 MB.
constexpr double bytes_of_piece = 1900.0;

std::uint64_t stream(const std::string& text) {
  files::Fnv1a sum;
  sum.add(text.data(), text.size());
  return sum.value();
}

geometry::JointSet joint_set(const deck::Jset& card, geometry::StreamKey key) {
  using geometry::SpacingLaw;
  return {static_cast<int>(card.id.value),
          {card.dip.value, card.ddev.value},
          {card.space.value, card.sdev.value},
          {card.trace.value, card.tdev.value},
          {card.gap.value, card.gdev.value},
          {card.x0.value, card.y0.value},
          card.law.value == "NEGEXP"    ? SpacingLaw::negexp
          : card.law.value == "POISSON" ? SpacingLaw::poisson
                                        : SpacingLaw::uniform,
          key,
          card.until.given};
}

class Generator {
 public:
  Generator(const deck::Cut& card, const CutSurroundings& around,
            deck::Diagnostics& diagnostics)
      : card_(card), around_(around), diagnostics_(diagnostics), files_(around.folder) {
  }

  std::optional<CutJoints> joints() {
    warn_of_unit(card_.outline.file, "OUTLINE", card_.outline.file_unit);
    for (const auto& source : card_.joints)
      std::visit([this](const auto& one) { prepare(one); }, source);
    check_memory();
    if (!sound_)
      return {};
    for (const auto& source : card_.joints)
      std::visit([this](const auto& one) { generate(one); }, source);
    if (!sound_)
      return {};
    prolong();
    check_crossings();
    check_protected();
    return sound_ ? std::optional(std::move(made_)) : std::nullopt;
  }

 private:
  /// The segments of a TRACES card in made_.segments.
  struct Mapped {
    const deck::Traces* card;
    std::size_t first, end;
    double extent;  ///< [L] mean distance between the ends of a trace
  };

  void error(deck::SourceLocation where, const char* card, const std::string& message,
             const std::string& hint) {
    diagnostics_.error(where, card, message, hint);
    sound_ = false;
  }

  void fail() { sound_ = false; }

  /// Returns the key of the card's random numbers. It does not depend on the values of
  /// this or another card, except the id.
  geometry::StreamKey key(const char* card, long id, const std::string& more = {}) {
    const int nth = met_[{card, id}]++;
    return {around_.seed, stream(fmt::format("{} {} {} {}", card, id, nth, more))};
  }

  void prepare(const deck::Jset& card) {
    geometry::JointSet set = joint_set(card, key("JSET", card.id.value));
    if (!card.x0.given && !card.y0.given)
      if (const std::string why = start_nearby(set, around_.outline); !why.empty())
        diagnostics_.warning(
            card.where, "JSET",
            fmt::format("the set starts at the first corner of the outline, ({:.9g}, "
                        "{:.9g}), because {}",
                        set.start.x.value(), set.start.y.value(), why),
            "give x0 and y0 if it continues across outlines, or to choose another "
            "start");
    guarded(card.space.where, "JSET", [&] {
      expect(geometry::expected_pieces(set, around_.outline), card.space.where, "JSET");
    });
    sets_.emplace(&card, std::move(set));
  }
  void prepare(const deck::Voronoi& card) {
    std::string places;  // so that equal cards cut different outlines differently
    for (const geometry::DecimalPoint& corner : around_.outline)
      places += fmt::format(" {} {}", corner.x.value(), corner.y.value());
    geometry::VoronoiRequest request{static_cast<int>(card.id.value),
                                     static_cast<int>(card.n.value),
                                     {},
                                     static_cast<int>(card.lloyd.value),
                                     key("VORONOI", card.id.value, places)};
    if (card.file.given) {
      const auto file = points_of({"VORONOI", card.file, around_.folder}, diagnostics_);
      if (!file)
        return fail();
      for (const geometry::DecimalPoint& point : file->points)
        request.points.emplace_back(point.x.value(), point.y.value());
      note("VORONOI", card.file, file->found);
    }
    expect(3.0 * std::max(card.file.given ? static_cast<double>(request.points.size())
                                          : static_cast<double>(card.n.value),
                          1.0),
           card.n.where, "VORONOI");
    cells_.emplace(&card, std::move(request));
  }
  void prepare(const deck::Traces& card) {
    auto file = files_.of(card, diagnostics_);
    if (!file)
      return fail();
    warn_of_unit(card.file, "TRACES", file->unit);
    note("TRACES", card.file, file->found);
    for (const exchange::Trace& trace : file->traces)
      expected_ += static_cast<double>(trace.points.size());
    traces_.emplace(&card, std::move(file->traces));
  }

  /// Warns if a drawing is in another unit of length than the deck.
  void warn_of_unit(const deck::Word& file, const char* card, const std::string& unit) {
    if (!unit.empty() && !around_.unit.empty() && unit != around_.unit)
      diagnostics_.warning(
          file.where, card,
          fmt::format("the drawing is in {} ($INSUNITS), the deck in {} (UNITS)", unit,
                      around_.unit),
          "coordinates are taken as they are: scale the drawing, or correct its unit");
  }

  void generate(const deck::Jset& card) {
    guarded(card.where, "JSET", [&] {
      const std::size_t first = made_.segments.size();
      std::vector<JointSegment> traces =
          geometry::joint_set(sets_.at(&card), around_.outline, around_.progress);
      add(card.until.given ? ended(card, traces) : std::move(traces));
      warn_if_far(first, card.where, "JSET", "no joint of this set meets the outline",
                  "reduce space, or move x0, y0");
    });
  }
  /// Ends the traces at the joints above that have the id.
  std::vector<JointSegment> ended(const deck::Jset& card,
                                  const std::vector<JointSegment>& traces) {
    std::vector<JointSegment> joints;
    std::copy_if(
        made_.segments.begin(), made_.segments.end(), std::back_inserter(joints),
        [&](const JointSegment& joint) { return joint.id == card.until.value; });
    if (joints.empty())
      error(card.until.where, "JSET",
            fmt::format("no joint above has the id {}", card.until.value),
            "JSET, TRACES or VORONOI with this id stand before this card in the group");
    return geometry::ended_at(traces, joints, around_.progress);
  }
  void generate(const deck::Voronoi& card) {
    guarded(card.where, "VORONOI", [&] {
      const auto& request = cells_.at(&card);
      add(geometry::voronoi_cells(request, around_.outline, around_.progress).edges);
    });
  }
  void generate(const deck::Traces& card) {
    const std::size_t first = made_.segments.size();
    const std::vector<exchange::Trace>& traces = traces_.at(&card);
    const std::size_t all = first + segments(traces);
    made_.segments.reserve(all);
    geometry::StepProgress taking(around_.progress, "take traces");
    for (const exchange::Trace& trace : traces) {
      taking.count(made_.segments.size(), all);
      const int id = trace.joint.value_or(static_cast<int>(card.id.value));
      geometry::ExactPoint from = trace.points.front();
      for (std::size_t i = 1; i < trace.points.size(); ++i) {
        geometry::ExactPoint to = trace.points[i];
        made_.segments.push_back({std::move(from), to, id});
        from = std::move(to);  // the segments of a polyline share their points
      }
    }
    const double extent = mean_extent(traces);
    traces_.erase(&card);
    warn_if_far(first, card.where, "TRACES", "no trace of this file meets the outline",
                "give the outline and the traces in the same coordinates");
    mapped_.push_back({&card, first, made_.segments.size(), extent});
  }

  static std::size_t segments(const std::vector<exchange::Trace>& traces) {
    std::size_t count = 0;
    for (const exchange::Trace& trace : traces)
      count += trace.points.size() - 1;
    return count;
  }

  /// Prolongs the ends of each file against all other joints as they are given, or
  /// proposes it if the card says nothing about its loose ends.
  void prolong() {
    if (mapped_.empty())
      return;
    const std::vector<JointSegment> given = made_.segments;
    for (const Mapped& part : mapped_) {
      const bool snaps = part.card->snap.value.value() > 0.0;
      if (part.card->snap.given && !snaps)
        continue;
      const auto begin = given.begin(), first = begin + static_cast<long>(part.first),
                 end = begin + static_cast<long>(part.end);
      std::vector<JointSegment> others(begin, first);
      others.insert(others.end(), end, given.end());
      if (!snaps) {
        propose(part, {first, end}, others);
        continue;
      }
      geometry::Prolongation moved =
          geometry::prolonged({first, end}, part.card->snap.value, others,
                              around_.outline, around_.progress);
      std::move(moved.traces.begin(), moved.traces.end(),
                made_.segments.begin() + static_cast<long>(part.first));
      note("TRACES", part.card->file,
           moved.ends == 0
               ? std::string("no loose end is prolonged")
               : fmt::format("{} prolonged, by {:.4g} at most",
                             counted(static_cast<long>(moved.ends), "loose end"),
                             moved.largest));
    }
  }

  /// Warns of ends that stop just short of another joint if they are many, and notes
  /// them otherwise.
  void propose(const Mapped& part, const std::vector<JointSegment>& traces,
               const std::vector<JointSegment>& others) {
    const auto found =
        propose_snap(traces, part.extent, others, around_.outline, around_.progress);
    if (found && found->is_common)
      diagnostics_.warning(part.card->where, "TRACES", found->message, found->hint);
    else if (found)
      note("TRACES", part.card->file, found->message + "; " + found->hint);
  }

  void add(std::vector<JointSegment> segments) {
    std::move(segments.begin(), segments.end(), std::back_inserter(made_.segments));
  }
  /// Warns if none of the segments from `first` on is near the outline.
  void warn_if_far(std::size_t first, deck::SourceLocation where, const char* card,
                   const char* message, const char* hint) {
    if (std::none_of(made_.segments.begin() + static_cast<long>(first),
                     made_.segments.end(),
                     [this](const JointSegment& one) { return is_near(one); }))
      diagnostics_.warning(where, card, message, hint);
  }
  /// The box of the outline, [L].
  std::pair<Vec2, Vec2> box() const {
    Vec2 low = Vec2::Constant(HUGE_VAL), high = -low;
    for (const geometry::DecimalPoint& corner : around_.outline) {
      const Vec2 p(corner.x.value(), corner.y.value());
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    return {low, high};
  }
  /// Whether the boxes of the segment and of the outline meet.
  bool is_near(const JointSegment& segment) const {
    const Vec2 &a = segment.from.nearest(), &b = segment.to.nearest();
    const auto [low, high] = box();
    return (a.cwiseMin(b).array() <= high.array()).all() &&
           (a.cwiseMax(b).array() >= low.array()).all();
  }

  template <class Act>
  void guarded(deck::SourceLocation where, const char* card, const Act& act) {
    try {
      act();
    } catch (const geometry::CutError& fault) {
      error(where, card, fault.what(), fault.hint);
    }
  }

  void expect(double pieces, deck::SourceLocation where, const char* card) {
    expected_ += pieces;
    if (pieces > geometry::max_joint_pieces)
      error(where, card,
            fmt::format("about {:.2g} pieces of joints are expected", pieces),
            fmt::format("one card may make {:g}: {}", geometry::max_joint_pieces,
                        std::string_view(card) == "JSET"
                            ? "increase space, or move x0, y0 to the outline"
                            : "reduce the number of points"));
  }
  /// Refuses joints that certainly make too many blocks for START or the memory, before
  /// they are cut. The crossings are estimated from those of some joints.
  void check_crossings() {
    constexpr double bytes_of_block = 2700.0;  // measured with 260,000 blocks
    const auto [low, high] = box();
    const double crossings =
        geometry::likely_crossings(made_.segments, low, high, around_.progress);
    const double memory = physical_memory() / bytes_of_block;
    // Traces that end may cross without cutting a block, and amin merges cells.
    const double allowed = card_.amin.value.value() > 0.0 || has_ends()
                               ? memory
                               : std::min(memory, 2.0 * around_.max_new_blocks + 1e4);
    if (crossings > allowed)
      error(
          card_.outline.where, "OUTLINE",
          fmt::format("about {:.2g} crossings of joints, and so as many blocks, are "
                      "expected",
                      crossings),
          allowed < memory
              ? fmt::format("START allows {:.0f} more blocks: increase space, or raise "
                            "nblok",
                            around_.max_new_blocks)
              : fmt::format("this machine has memory for about {:.2g}: increase space",
                            memory));
  }
  /// Warns of protected ids that no joint has.
  void check_protected() {
    for (const deck::Int& id : card_.protect)
      if (std::none_of(made_.segments.begin(), made_.segments.end(),
                       [&](const JointSegment& joint) { return joint.id == id.value; }))
        diagnostics_.warning(id.where, "CUT",
                             fmt::format("no joint of the group has the id {}, so "
                                         "nothing is protected",
                                         id.value),
                             "give the id of a JSET, TRACES or VORONOI card");
  }
  bool has_ends() const {
    return std::any_of(card_.joints.begin(), card_.joints.end(), [](const auto& one) {
      const auto* set = std::get_if<deck::Jset>(&one);
      return std::holds_alternative<deck::Traces>(one) ||
             (set != nullptr && set->trace.value.value() > 0.0);
    });
  }
  void check_memory() {
    const double memory = physical_memory();
    if (sound_ && expected_ * bytes_of_piece > memory)
      error(card_.outline.where, "OUTLINE",
            fmt::format("about {:.2g} pieces of joints are expected", expected_),
            fmt::format("this machine has memory for about {:.2g}",
                        memory / bytes_of_piece));
  }

  void note(const char* card, const deck::Word& file, const std::string& text) {
    made_.notes.push_back(fmt::format("{}: {}: {}", card, file.value, text));
  }

  const deck::Cut& card_;
  const CutSurroundings& around_;
  deck::Diagnostics& diagnostics_;
  TraceFiles files_;
  CutJoints made_;
  std::map<std::pair<std::string, long>, int> met_;
  std::map<const deck::Jset*, geometry::JointSet> sets_;
  std::map<const deck::Voronoi*, geometry::VoronoiRequest> cells_;
  std::map<const deck::Traces*, std::vector<exchange::Trace>> traces_;
  std::vector<Mapped> mapped_;
  double expected_ = 0.0;  ///< number of pieces
  bool sound_ = true;
};

}  // namespace

std::optional<CutJoints> cut_joints(const deck::Cut& card,
                                    const CutSurroundings& around,
                                    deck::Diagnostics& diagnostics) {
  return Generator(card, around, diagnostics).joints();
}

}  // namespace blocks::run
