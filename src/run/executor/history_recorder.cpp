#include "run/executor/history_recorder.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/equilibrium.hpp"
#include "model/local_ratio.hpp"

namespace blocks::run {

using quantities::Curve;

namespace {

/// Whether the quantity is a number of things, which jumps from one step to the next.
bool is_count(const Curve& curve) {
  return curve.subject == Curve::Subject::model &&
         (curve.quantity == "cracks" || curve.quantity == "blocks");
}

bool same(const HistoryRequest& a, const HistoryRequest& b) {
  return a.interval == b.interval && a.quantities == b.quantities;
}

}  // namespace

void HistoryRecorder::begin(const Model& model) {
  if (model.history.interval == 0.0)
    return;
  if (!same(request_, model.history)) {
    request_ = model.history;
    std::vector<Curve> curves;
    is_count_.clear();
    for (const std::string& quantity : request_.quantities) {
      curves.push_back(quantities::parse_curve(quantity));
      is_count_.push_back(is_count(curves.back()));
    }
    values_of_ =
        quantities::CurveValues(curves, quantities::material_numbers(model.settings));
    for (std::vector<double>* values : {&before_, &now_, &sample_})
      values->resize(curves.size());
    if (values_of_.has_displacements())
      first_ = results_->first_positions();
    first_blocks_ = static_cast<int>(first_.outlines.size());
    multiples_ = quantities::Multiples(request_.interval);
    const std::optional<double> last = results_->begin_history(request_);
    const long first = multiples_.first_from(model.time);
    set_next(last ? std::max(std::lround(*last / request_.interval) + 1, first)
                  : first);
  }
  time_before_ = model.time;
  read(model, before_);
  if (multiples_.has_come(next_, model.time)) {
    now_ = before_;
    take_samples(model.time);
  }
}

void HistoryRecorder::record(const Model& model) {
  read(model, now_);
  take_samples(model.time);
  std::swap(before_, now_);
  time_before_ = model.time;
}

/// Adds the samples up to this time, to which now_ belongs.
void HistoryRecorder::take_samples(double time) {
  for (; multiples_.has_come(next_, time); set_next(next_ + 1)) {
    const double at = multiples_.at(next_), step = time - time_before_;
    const double part = step > 0.0 ? std::min((at - time_before_) / step, 1.0) : 1.0;
    for (std::size_t i = 0; i < sample_.size(); ++i)
      sample_[i] = part == 1.0    ? now_[i]
                   : is_count_[i] ? before_[i]
                                  : std::lerp(before_[i], now_[i], part);
    results_->add_sample(at, sample_);
  }
}

void HistoryRecorder::set_next(long next) {
  next_ = next;
  due_ = multiples_.at(next) - multiples_.slack();
}

/// The material of pieces was in the block that has split, but where is not in the
/// checkpoint. So they have no first position. Other blocks that were made later have
/// the present one, and so no displacement.
void HistoryRecorder::follow_blocks(const Model& model) {
  const Blocks& blocks = model.blocks;
  first_.centroid.conservativeResize(2, blocks.size());
  first_.outlines.resize(static_cast<std::size_t>(blocks.size()));
  for (int b = first_blocks_; b < blocks.size(); ++b) {
    first_.centroid.col(b) = blocks.centroid.col(b);
    first_.outlines[static_cast<std::size_t>(b)] = blocks.outline(b);
  }
  for (const CrackRecord& crack : model.cracks)
    if (crack.child >= first_blocks_)
      for (const int b : {crack.parent, crack.child}) {
        first_.centroid.col(b).setConstant(std::numeric_limits<double>::quiet_NaN());
        first_.outlines[static_cast<std::size_t>(b)].clear();
      }
}

void HistoryRecorder::read(const Model& model, std::vector<double>& values) {
  contacts_.clear();
  if (values_of_.has_contacts())
    quantities::list_contacts(model, contacts_);
  if (values_of_.has_displacements() && !model.cracks.empty())
    follow_blocks(model);
  quantities::BlockStates blocks = quantities::states_of(model.blocks);
  double ratio = std::numeric_limits<double>::quiet_NaN();
  if (values_of_.has_unbalanced()) {
    unbalanced_forces(model, unbalanced_);
    blocks.unbalanced = &unbalanced_;
    ratio = unbalanced_ratio(model);
  }
  if (values_of_.has_local_ratios()) {
    local_ratios(model, local_ratios_);
    blocks.local_ratio = &local_ratios_;
  }
  if (values_of_.has_water() && !model.loads.water.none()) {
    WaterNow(model.loads.water, model.time).forces_on(model.blocks, water_);
    blocks.water = &water_;
  }
  const quantities::Positions first{first_.centroid,
                                    quantities::Corners(first_.outlines)};
  values_of_.evaluate({model.time, model.steps, blocks, contacts_, &model.energy, ratio,
                       model.cracks.size()},
                      first, values);
}

}  // namespace blocks::run
