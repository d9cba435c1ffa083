#include "report/ensemble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "output/results/results.hpp"
#include "post/chart/history.hpp"
#include "report/name_list.hpp"
#include "report/outcome_labels.hpp"
#include "report/outcome_values.hpp"
#include "report/preview.hpp"
#include "report/statistics.hpp"
#include "run/run.hpp"
#include "sweep/outcome.hpp"

namespace blocks::report {
namespace {

namespace fs = std::filesystem;

constexpr const char* usual_measures[] = {"dy:min", "displacement:max", "overlap@max",
                                          "kinetic_energy", "contacts"};
/// Runs with the FOS card have these.
constexpr const char* safety_measures[] = {"fos", "fos<1"};
constexpr const char* sweep_parameter = "sweep";
constexpr const char* variant_parameter = "variant";

State state_of(int code) {
  return code == run::done          ? State::done
         : code == run::unsound_run ? State::unsound
         : code == run::time_limit  ? State::time_limit
                                    : State::failed;
}

/// Returns the ends of the profile [L]: of the line, or of the blocks at the surface.
std::pair<double, double> profile_ends(const post::Frame& first,
                                       const std::vector<post::ProfilePlace>& places,
                                       const ProfileQuestion& question) {
  if (question.line.segment) {
    const Eigen::Vector4d& line = *question.line.segment;
    return {0.0, (line.tail<2>() - line.head<2>()).norm()};
  }
  double begin = std::numeric_limits<double>::infinity(), end = -begin;
  for (const post::ProfilePlace& place : places)
    for (const auto& corner :
         first.outlines[static_cast<std::size_t>(place.block) - 1]) {
      begin = std::min(begin, corner.x());
      end = std::max(end, corner.x());
    }
  if (question.mirror)
    return {std::min(begin, 2.0 * *question.mirror - end),
            std::max(end, 2.0 * *question.mirror - begin)};
  return {begin, end};
}

/// Collects the runs of the sweeps in an Ensemble.
class Collector {
 public:
  explicit Collector(const Request& request)
      : request_(request), side_by_side_(request.pair || request.mixed) {
    all_.members = read_members(request.folders, request.pair, request.mixed);
    preview_ = look_ahead(all_.members, request.reading.units);
  }

  Ensemble collect() {
    all_.title = preview_.title;
    all_.units = preview_.units;
    choose_measures();
    set_parameters();
    for (std::size_t m = 0; m < all_.members.size(); ++m)
      for (std::size_t i = 0; i < all_.members[m].plan.runs.size(); ++i)
        add_run(m, i + 1);
    sort_groups();
    expect_values();
    return std::move(all_);
  }

 private:
  /// Returns the measures of a report for which the user names none.
  std::vector<std::string> default_measures() const {
    if (all_.kind() != sweep::Kind::run)
      return usual_names(preview_.outcome_names, all_.kind() == sweep::Kind::study);
    std::vector<std::string> names, recorded;
    if (all_.profile)
      names.emplace_back(all_.profile->quantity == "dy" ? "profile:min"
                                                        : "profile:max");
    names.insert(names.end(), std::begin(safety_measures), std::end(safety_measures));
    if (!preview_.first_results.empty() && !request_.reading.frames)
      for (const auto& curve :
           post::recorded_curves(post::ResultsReader(preview_.first_results)))
        recorded.push_back(curve.name());
    if (recorded.empty())
      recorded.assign(std::begin(usual_measures), std::end(usual_measures));
    names.insert(names.end(), recorded.begin(), recorded.end());
    return names;
  }

  void choose_measures() {
    const bool runs = all_.kind() == sweep::Kind::run;
    if (!preview_.first_results.empty())
      set_profile();
    const std::vector<std::string> names =
        request_.measures.empty() ? default_measures() : request_.measures;
    std::set<std::string> outcome_names = preview_.outcome_names;
    if (runs)
      outcome_names.insert(safety_names().begin(), safety_names().end());
    for (const std::string& name : names) {
      Column column;
      column.measure = parse_measure(name, outcome_names, !runs);
      if (column.measure.from == Measure::From::profile && !all_.profile &&
          !preview_.first_results.empty())
        throw std::runtime_error(fmt::format(
            "{} needs a profile\n  hint: --profile top, or --profile x0,y0,x1,y1",
            name));
      column.is_share = column.measure.limit.has_value() ||
                        (column.measure.from == Measure::From::outcome &&
                         preview_.outcome_shares.contains(column.measure.key));
      column.label = column.measure.name;
      measures_.push_back(column.measure);
      all_.columns.push_back(std::move(column));
    }
    faults_.resize(measures_.size());
    labelled_.resize(measures_.size(), false);
    scales_.assign(all_.members.size(), std::vector<double>(measures_.size(), 1.0));
    for (std::size_t i = 0; i < measures_.size(); ++i)
      if (measures_[i].from == Measure::From::outcome) {
        const MeasureLabel label = label_of_outcome(measures_[i].key);
        set_label(i, label);
        for (std::size_t m = 0; m < all_.members.size(); ++m)
          if (const auto& own = preview_.own_units[m];
              own && all_.units && !(*own == *all_.units))
            scales_[m][i] =
                post::UnitScale::between(*own, *all_.units).of(label.dimension);
      }
  }

  /// Sets the positions of the profile from the first results. Without --profile,
  /// there is none if it meets no block, or if all blocks are fixed.
  void set_profile() {
    if (!request_.with_profile)
      return;
    const bool is_requested = request_.profile.has_value();
    const ProfileQuestion question = request_.profile.value_or(ProfileQuestion{});
    post::ResultsReader results(preview_.first_results);
    if (all_.units)
      results.show_in(*all_.units);
    const post::Frame first = results.frame(0);
    if (!is_requested && std::none_of(first.fixed.begin(), first.fixed.end(),
                                      [](int fixed) { return fixed == 0; }))
      return;
    std::vector<post::ProfilePlace> places;
    try {
      places = post::profile_places(first, question.line);
    } catch (const std::runtime_error&) {
      if (is_requested)
        throw;
      return;
    }
    const auto [begin, end] = profile_ends(first, places, question);
    all_.profile = question;
    grid_.emplace(begin, end);
    all_.positions = grid_->positions();
  }

  /// The parameters are the fields that any of the sweeps sets, then the variant of a
  /// study, then the sweep.
  void set_parameters() {
    for (const Member& one : all_.members)
      for (const std::string& axis : one.plan.axes)
        if (one.plan.sobol && one.plan.sobol->has(axis))
          add_once(all_.sampled, axis);
        else if (axis != "seed")
          add_once(all_.parameters, axis);
    fields_ = all_.parameters.size();
    if (all_.kind() == sweep::Kind::study)
      all_.parameters.emplace_back(variant_parameter);
    if (side_by_side_)
      all_.parameters.emplace_back(sweep_parameter);
  }

  std::size_t group_of(std::size_t member, const sweep::Variation& run,
                       const std::string& variant) {
    std::vector<std::string> values(fields_);
    for (const std::string& set : run.sets) {
      const std::string field = sweep::field_of(set);
      const auto& sobol = all_.members[member].plan.sobol;
      for (std::size_t p = 0; p < fields_; ++p)
        if (all_.parameters[p] == field)
          values[p] = sobol && sobol->has(field) ? "sampled" : sweep::value_of(set);
    }
    if (all_.kind() == sweep::Kind::study)
      values.push_back(variant);
    if (side_by_side_)
      values.push_back(all_.members[member].label);
    const auto [found, is_new] = group_index_.try_emplace(values, all_.groups.size());
    if (is_new)
      all_.groups.push_back({values, {}});
    return found->second;
  }

  void add_run(std::size_t member, std::size_t id) {
    const Member& one = all_.members[member];
    const sweep::Variation& run = one.plan.runs[id - 1];
    const std::string folder = sweep::run_folder(one.folder, id);
    const auto outcome = sweep::read_outcome_or_damage(folder);
    RunRow row;
    row.member = member;
    row.id = id;
    row.seed = run.seed;
    row.values.assign(measures_.size(), no_number);
    row.status = "not finished";
    constexpr std::size_t independent = 2;  // the points a and b of each row
    if (one.plan.sobol)
      row.in_sample = (id - 1) % one.plan.sobol->runs_per_row() < independent;
    if (outcome) {
      row.state = state_of(outcome->code);
      row.status = outcome->status;
      if (row.status != sweep::damaged_outcome)
        row.code = outcome->code;
      row.message = outcome->message;
      row.safety = safety_bracket(*outcome);
      if (one.plan.kind == sweep::Kind::run)
        find_results(results_path(one, id), row);
    }
    std::vector<std::string> variants = {no_variant};
    if (one.plan.kind == sweep::Kind::study)
      variants = outcome && row.state == State::done ? measured_variants(*outcome)
                                                     : one.plan.variants;
    for (const std::string& variant : variants) {
      RunRow of_variant = row;
      of_variant.group = group_of(member, run, variant);
      if (outcome)
        for (std::size_t i = 0; i < measures_.size(); ++i)
          if (measures_[i].from == Measure::From::outcome)
            of_variant.values[i] =
                value_of(measures_[i], *outcome, variant, scales_[member][i]);
      all_.groups[of_variant.group].rows.push_back(all_.rows.size());
      all_.rows.push_back(std::move(of_variant));
    }
  }

  /// Reads the results if they are those of this run. Otherwise a run that is done has
  /// failed if any measure needs them.
  void find_results(const std::string& path, RunRow& row) {
    const std::string name = fs::path(path).filename().string();
    std::string status, message;
    if (!fs::exists(path)) {
      status = "results missing", message = name + " is missing";
    } else if (const auto identity = output::ResultsWriter::identity_of(path);
               row.seed && identity && identity->seed != *row.seed) {
      status = "results of another run";
      message = fmt::format("{} is of a run with seed {}, not {}", name, identity->seed,
                            *row.seed);
    } else {
      row.has_results = true;
      read_results(path, row);
      return;
    }
    const auto needs_results = [](const Measure& measure) {
      return measure.from != Measure::From::outcome;
    };
    if (row.state != State::done ||
        std::none_of(measures_.begin(), measures_.end(), needs_results))
      return;
    row.state = State::failed;
    row.status = status;
    row.message = message;
  }

  void read_results(const std::string& path, RunRow& row) {
    ReadingOptions reading = request_.reading;
    reading.units = all_.units;
    try {
      const RunReader reader(path, reading);
      RunValues read = reader.read(measures_, all_.profile);
      for (std::size_t i = 0; i < measures_.size(); ++i) {
        if (measures_[i].from == Measure::From::outcome)
          continue;
        row.values[i] = measures_[i].with_limit(read.values[i]);
        if (faults_[i].empty())
          faults_[i] = read.faults[i];
        if (!labelled_[i] && !read.labels[i].label.empty())
          set_label(i, read.labels[i]);
      }
      if (read.profile && all_.counts(row))
        row.profile = grid_->resampled(*read.profile);
      any_profile_ = any_profile_ || !row.profile.empty();
      if (request_.profile && row.state == State::done && row.message.empty())
        row.message = read.profile_fault;
      if (profile_fault_.empty() && row.state == State::done)
        profile_fault_ = read.profile_fault;
    } catch (const std::runtime_error& fault) {
      if (row.message.empty())
        row.message = fault.what();
      if (any_fault_.empty())
        any_fault_ = fault.what();
    }
  }

  void set_label(std::size_t i, const MeasureLabel& label) {
    labelled_[i] = true;
    Column& column = all_.columns[i];
    column.label = label.label;
    const std::string unit = post::unit_text(label.dimension, all_.units);
    if (const auto& limit = column.measure.limit)
      column.label += fmt::format(" {} {}{}{}", limit->above ? "above" : "below",
                                  limit->value < 0.0 ? "−" : "", std::abs(limit->value),
                                  unit.empty() ? "" : " " + unit);
    else
      column.unit = unit;
  }

  void sort_groups() {
    for (Group& group : all_.groups) {
      std::stable_sort(group.rows.begin(), group.rows.end(),
                       [&](std::size_t a, std::size_t b) {
                         return all_.rows[a].seed < all_.rows[b].seed;
                       });
      for (std::size_t k = 1; k < group.rows.size(); ++k) {
        const RunRow &a = all_.rows[group.rows[k - 1]], &b = all_.rows[group.rows[k]];
        if (a.seed == b.seed && a.member != b.member)
          throw std::runtime_error(fmt::format(
              "{} and {} both have a run of the same deck with {}, which would count "
              "twice\n  hint: make a report of one of them, or compare them with "
              "--pair",
              all_.members[a.member].folder, all_.members[b.member].folder,
              a.seed ? fmt::format("seed {}", *a.seed) : "the deck's seed"));
      }
    }
  }

  /// If runs are done, but none of them has a measure, leaves it out, or throws if the
  /// user asked for it. Also throws if none of them has the profile that the user asked
  /// for.
  void expect_values() {
    bool any_done = false;
    std::vector<bool> has(measures_.size(), false);
    for (const RunRow& row : all_.rows)
      if (row.state == State::done) {
        any_done = true;
        for (std::size_t i = 0; i < measures_.size(); ++i)
          has[i] = has[i] || std::isfinite(row.values[i]);
      }
    if (any_done && request_.profile && !any_profile_ && !profile_fault_.empty())
      throw std::runtime_error(
          "no run has the profile: " + profile_fault_ +
          (request_.profile->time ? "\n  hint: choose a --time in this range" : ""));
    // The columns of F remain even if no run decides it.
    const bool has_safety = std::any_of(all_.rows.begin(), all_.rows.end(),
                                        [](const RunRow& r) { return !!r.safety; });
    for (std::size_t i = measures_.size(); i-- > 0;) {
      const bool of_safety = safety_names().contains(measures_[i].key);
      if (has[i] || (of_safety && has_safety) || (!any_done && !of_safety))
        continue;
      if (!request_.measures.empty()) {
        if (!any_done)
          continue;
        tell_missing(i);
      }
      const auto at = static_cast<std::ptrdiff_t>(i);
      all_.columns.erase(all_.columns.begin() + at);
      for (RunRow& row : all_.rows)
        row.values.erase(row.values.begin() + at);
    }
  }

  /// Throws: no run has the measure that the user named.
  [[noreturn]] void tell_missing(std::size_t measure) const {
    const std::string text = "no run has " + measures_[measure].name;
    if (safety_names().contains(measures_[measure].key))
      throw std::runtime_error(text + "\n  hint: the FOS card of a deck computes it");
    const std::string why = faults_[measure].empty() ? any_fault_ : faults_[measure];
    throw std::runtime_error(text + (why.empty() ? "" : ": " + why));
  }

  const Request& request_;
  Ensemble all_;
  bool side_by_side_;
  Preview preview_;
  std::vector<std::vector<double>> scales_;  ///< (members, measures) of outcomes
  std::vector<Measure> measures_;
  std::vector<std::string> faults_;  ///< (measures) the first ones
  std::string any_fault_, profile_fault_;
  bool any_profile_ = false;
  std::vector<bool> labelled_;
  std::optional<ProfileGrid> grid_;
  std::size_t fields_ = 0;
  std::map<std::vector<std::string>, std::size_t> group_index_;
};

}  // namespace

Ensemble read_ensemble(const Request& request) { return Collector(request).collect(); }

}  // namespace blocks::report
