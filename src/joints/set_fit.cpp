#include "joints/set_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "joints/direction_fit.hpp"
#include "joints/mean_length.hpp"
#include "joints/spacing_fit.hpp"
#include "joints/track_search.hpp"
#include "joints/uniform_fit.hpp"
#include "joints/window.hpp"

namespace blocks::joints {
namespace {

using geometry::SpacingLaw;
using geometry::Vec2;

Estimate exactly(double value) { return {value, value, value}; }

Estimate scaled(const Estimate& one, double factor) {
  return {one.value * factor, one.low * factor, one.high * factor};
}

class SetFitter {
 public:
  SetFitter(const Network& network, double shortest, std::vector<char> chosen)
      : network_(network), shortest_(shortest), chosen_(std::move(chosen)) {
    for (std::size_t i = 0; i < network.pieces.size(); ++i)
      if (chosen_[i] != 0)
        pieces_.push_back(network.pieces[i]);
    sample_ = length_sample(pieces_, network.window);
    truncated_ = length_sample(pieces_, network.window, shortest);
    density_ = trace_density(pieces_, network.window);
    fit_.pieces = pieces_.size();
    fit_.p21 = density_.p21.value;
  }

  /// until: the id of the set at which the traces end; 0: none.
  SetFit family(int id, const Family& family, int until) {
    fit_.id = id;
    fit_.family = family;
    const DirectionFit directions = fit_directions(pieces_, family.mean);
    fit_.dip = directions.mean;
    fit_.ddev = directions.half_range;
    constexpr double max_deviation = 89.0;  // JSET takes less than 90
    if (fit_.ddev.value > max_deviation)
      fit_.ddev.value = max_deviation;
    if (until > 0)
      fit_until(until);
    else if (runs_through())
      fit_through();
    else
      fit_traces();
    place_start();
    return std::move(fit_);
  }

  /// Joints in all directions: POISSON if they run through, otherwise traces that each
  /// have their own direction.
  SetFit scattered(int id) {
    fit_.id = id;
    note("these traces have no preferred direction");
    fit_.dip = fit_.ddev = fit_.sdev = exactly(0.0);
    if (runs_through()) {
      fit_.law = SpacingLaw::poisson;
      fit_.trace = fit_.tdev = fit_.gap = fit_.gdev = exactly(0.0);
      fit_.space = {1.0 / density_.p21.value, 1.0 / density_.p21.high,
                    1.0 / density_.p21.low};
      fit_.start = middle_of(network_.window);
    } else {
      fit_.ddev = exactly(90.0);
      note_connected();
      fit_lengths();
      fit_gaps_by_density();
      place_start();
    }
    return std::move(fit_);
  }

 private:
  void note(const std::string& words) { fit_.notes.push_back(words); }

  /// Whether joints are much longer than the window, so that it does not tell their
  /// length.
  bool runs_through() const {
    double hidden = 0.0, visible = 0.0;
    for (const Piece& piece : pieces_) {
      hidden += piece.hidden;
      visible += 2 - piece.hidden;
    }
    constexpr double much = 10.0;  // mean length over mean chord
    return hidden > much * visible;
  }

  void fit_through() {
    fit_.trace = fit_.tdev = fit_.gap = fit_.gdev = exactly(0.0);
    const double size = std::sqrt(network_.area);
    const SpacingSample sample =
        spacings_across(network_, chosen_, fit_.dip.value, 1e-6 * size);
    if (sample.tracks == 0) {
      // All joints pass beside the middle of the window.
      fit_.space = {1.0 / density_.p21.value, 1.0 / density_.p21.high,
                    1.0 / density_.p21.low};
      fit_.sdev = exactly(0.0);
      note("no joint crosses the middle of the window: space is 1 / P21");
      return;
    }
    take(fit_spacing(sample));
    if (sample.spacings.size() < 5)
      note(fmt::format("only {} spacings were seen", sample.spacings.size()));
  }

  /// Traces from one joint of another set to the next one. A trace that is longer than
  /// these are apart makes one such joint about its middle, which lies in a wide
  /// interval more often than in a narrow one. So the mean length of the joints is that
  /// of the map weighted with length, and space keeps P21.
  void fit_until(int until) {
    fit_.until = until;
    double sum = 0.0, squares = 0.0, longest = 0.0;
    for (const Piece& piece : pieces_) {
      longest = std::max(longest, piece.length);
      if (piece.hidden > 0)
        continue;
      sum += piece.length;
      squares += piece.length * piece.length;
    }
    const double mean = sum > 0.0 ? squares / sum : longest;
    constexpr double surely_longer = 2.5;
    const double trace = surely_longer * longest;
    fit_.trace = exactly(trace);
    fit_.tdev = fit_.gap = fit_.gdev = fit_.sdev = exactly(0.0);
    fit_.law = SpacingLaw::negexp;
    fit_.space = {mean / (density_.p21.value * trace),
                  mean / (density_.p21.high * trace),
                  mean / (density_.p21.low * trace)};
    note(fmt::format("most traces end at set {}: those of JSET do too; trace is longer "
                     "than its joints are apart, and space follows from P21",
                     until));
  }

  void take(const SpacingFit& spacing) {
    fit_.law = spacing.exponential ? SpacingLaw::negexp : SpacingLaw::uniform;
    fit_.space = spacing.mean;
    fit_.sdev = spacing.half_range;
  }

  /// Says how many traces end at others, which the law of the set cannot reproduce.
  void note_connected() {
    double connected = 0.0, visible = 0.0;
    for (const Piece& piece : pieces_) {
      connected += piece.connected;
      visible += 2 - piece.hidden;
    }
    constexpr double notable = 0.1;
    if (connected > notable * visible)
      note(fmt::format("{:.0f} % of the ends are at other traces; those of JSET are in "
                       "the rock, unless `until` is given",
                       100.0 * connected / visible));
  }

  void fit_traces() {
    note_connected();
    fit_lengths();
    const Tracks tracks = find_tracks(pieces_, network_.window, fit_.dip.value,
                                      fit_.ddev.value / std::numbers::sqrt3);
    if (!tracks.found) {
      fit_gaps_by_density();
      return;
    }
    take(fit_spacing(tracks.spacing));
    const UniformFit gaps = fit_gaps(tracks.gaps);
    if (std::isfinite(gaps.mean.value)) {
      fit_.gap = gaps.mean;
      fit_.gdev = gaps.half_range;
      return;
    }
    // Too few gaps: what the density leaves.
    const double gap =
        std::max(1.0 / (density_.p20.value * fit_.space.value) - fit_.trace.value, 0.0);
    fit_.gap = {gap, unknown, unknown};
    fit_.gdev = exactly(0.0);
    note("too few gaps were seen: gap follows from P20, and gdev is 0");
  }

  UniformFit fit_gaps(const LengthSample& seen) const {
    UniformSample gaps;
    gaps.values = seen.complete;
    gaps.resolution = 1e-6 * fit_.trace.value;
    LengthSample others;
    others.one_hidden = seen.one_hidden;
    const std::size_t n = seen.complete.size() + seen.one_hidden.size();
    gaps.other_factors = [&, n, others](double a, double b) {
      return cut_factors(others, n, a, b, sample_.area, sample_.width);
    };
    return fit_uniform(gaps);
  }

  /// The factors of the likelihood of a uniform law of n lengths besides those of the
  /// complete ones.
  static double cut_factors(const LengthSample& cut, std::size_t n, double a, double b,
                            double area, double width, double shortest = 0.0) {
    const LengthLaw law{LengthForm::uniform, 0.5 * (a + b), 0.5 * (b - a)};
    double sum = 0.0;
    for (const double y : cut.one_hidden)
      sum += law.log_survival(y);
    for (const double z : cut.both_hidden)
      sum += law.log_excess(z);
    return sum - static_cast<double>(n) *
                     std::log(std::exp(law.log_survival(shortest)) * area +
                              std::exp(law.log_excess(shortest)) * width);
  }

  /// The evidence of exponential lengths, as fit_uniform defines it.
  double exponential_evidence(const FittedLaw& fitted) const {
    constexpr int cells = 400;
    constexpr double reach = 3.0;  // powers of e about the best mean
    double sum = 0.0;
    for (int k = 0; k < cells; ++k) {
      const double power = reach * (2.0 * (k + 0.5) / cells - 1.0);
      const LengthLaw law{LengthForm::exponential, fitted.law.mean * std::exp(power),
                          0.0};
      sum += std::exp(truncated_.log_likelihood(law) - fitted.log_likelihood);
    }
    return fitted.log_likelihood + std::log(sum * 2.0 * reach / cells);
  }

  void fit_lengths() {
    constexpr std::size_t fewest = 3;
    if (truncated_.complete.size() < fewest) {
      fit_.trace = density_.by_ends;
      fit_.tdev = exactly(0.0);
      note("fewer than three traces are complete: trace is P21 / P20, and tdev is 0");
      return;
    }
    const FittedLaw exponential = fit_length_law(LengthForm::exponential, truncated_);
    UniformSample lengths;
    lengths.values = truncated_.complete;
    lengths.resolution = 1e-6 * exponential.law.mean;
    lengths.other_factors = [&](double a, double b) {
      return cut_factors(truncated_, truncated_.size(), a, b, truncated_.area,
                         truncated_.width, shortest_);
    };
    const UniformFit uniform = fit_uniform(lengths);
    if (uniform.log_evidence > exponential_evidence(exponential)) {
      fit_.trace = uniform.mean;
      fit_.tdev = uniform.half_range;
      return;
    }
    constexpr double widest = 0.95;  // JSET takes less than 1
    fit_.trace = exponential.mean;
    fit_.tdev = scaled(exponential.mean, widest);
    note("lengths look exponential, and JSET's are uniform: mean and P21 are kept");
  }

  /// Without tracks, the map tells only how many traces there are per area.
  void fit_gaps_by_density() {
    fit_.gap = fit_.gdev = {fit_.trace.value, unknown, unknown};
    const Estimate& p20 = density_.p20;
    fit_.law = SpacingLaw::negexp;
    fit_.sdev = exactly(0.0);
    const double period = 2.0 * fit_.trace.value;
    fit_.space = {1.0 / (p20.value * period), unknown, unknown};
    note("traces do not lie on tracks: gap is chosen like trace, and space follows "
         "from P20");
  }

  /// The start is beside the window, so that the first track is random inside, and at
  /// its middle along the tracks, because lines turn about the start.
  void place_start() {
    const Vec2 along = unit_vector(fit_.dip.value), across(-along.y(), along.x());
    const Vec2 middle = middle_of(network_.window);
    double beside = 0.0;
    for (const Vec2& corner : network_.window)
      beside = std::max(beside, across.dot(corner - middle));
    fit_.start = middle + (beside + fit_.space.value) * across;
  }

  const Network& network_;
  double shortest_;
  std::vector<char> chosen_;
  std::vector<Piece> pieces_;
  LengthSample sample_, truncated_;
  TraceDensity density_;
  SetFit fit_;
};

}  // namespace

namespace {

/// Returns the family at which most visible ends of the traces of each family are; -1:
/// none, or it ends at another one itself.
std::vector<int> families_at_ends(const Network& network, const Mixture& mixture) {
  const std::size_t n = mixture.families.size();
  std::map<int, int> family_of;  // of a trace
  for (std::size_t i = 0; i < network.pieces.size(); ++i)
    family_of.emplace(network.pieces[i].trace, mixture.member[i]);
  std::vector<std::vector<double>> at(n, std::vector<double>(n, 0.0));
  std::vector<double> visible(n, 0.0);
  for (std::size_t i = 0; i < network.pieces.size(); ++i) {
    if (mixture.member[i] < 0)
      continue;
    const auto k = static_cast<std::size_t>(mixture.member[i]);
    visible[k] += 2 - network.pieces[i].hidden;
    for (const int host : network.pieces[i].hosts)
      if (host > 0 && family_of.at(host) >= 0)
        ++at[k][static_cast<std::size_t>(family_of.at(host))];
  }
  constexpr double max = 0.75;
  std::vector<int> until(n, -1);
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t j = 0; j < n; ++j)
      if (j != k && visible[k] > 0.0 && at[k][j] >= max * visible[k])
        until[k] = static_cast<int>(j);
  std::vector<int> result = until;
  for (std::size_t k = 0; k < n; ++k)
    if (until[k] >= 0 && until[static_cast<std::size_t>(until[k])] >= 0)
      result[k] = -1;
  return result;
}

}  // namespace

NetworkFit fit_sets(const Network& network, double shortest, int max) {
  NetworkFit fit;
  std::vector<double> directions;
  for (const Piece& piece : network.pieces)
    directions.push_back(piece.direction);
  const Mixture mixture = find_families(directions, max);
  fit.components = mixture.components;
  const auto chosen = [&](int k) {
    std::vector<char> members;
    for (const int member : mixture.member)
      members.push_back(member == k ? 1 : 0);
    return members;
  };
  const std::vector<int> until = families_at_ends(network, mixture);
  int id = 0;
  for (const Family& family : mixture.families) {
    SetFitter fitter(network, shortest, chosen(id));
    fit.sets.push_back(
        fitter.family(id + 1, family, until[static_cast<std::size_t>(id)] + 1));
    ++id;
  }
  constexpr long fewest = 3;
  if (std::count(mixture.member.begin(), mixture.member.end(), -1) >= fewest)
    fit.sets.push_back(SetFitter(network, shortest, chosen(-1)).scattered(id + 1));
  return fit;
}

}  // namespace blocks::joints
