// PRIVATE to geometry/: CGAL's sweep of segments with reports of its progress. If a
// report throws, everything that the sweep has allocated is freed.
#pragma once

#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>

#include <cstddef>
#include <memory>

#include "geometry/step_progress.hpp"

namespace blocks::geometry::exact {

/// Counts the comparisons of a sweep over [low, high] in x.
class SweepWatch {
 public:
  SweepWatch(StepProgress& progress, double low, double high)
      : progress_(&progress), low_(low), width_(high - low) {}
  void count() {
    if (progress_->is_due())
      progress_->report((x_ - low_) / width_);
  }
  /// Counts a comparison at the sweep line.
  template <typename Point> void count_at(const Point& p) {
    x_ = p.approx().x().inf();
    count();
  }

 private:
  StepProgress* progress_;
  double low_, width_;
  double x_ = low_;  ///< of the sweep line
};

/// Traits of segments that count the comparisons of the sweep. Traits without a watch
/// count nothing.
template <typename Kernel>
class WatchedSegments : public CGAL::Arr_segment_traits_2<Kernel> {
  using Base = CGAL::Arr_segment_traits_2<Kernel>;
  using Curve = typename Base::X_monotone_curve_2;
  using Point = typename Base::Point_2;

 public:
  SweepWatch* watch = nullptr;

  class Compare_xy_2 {
   public:
    explicit Compare_xy_2(const WatchedSegments& traits)
        : compare_(traits.Base::compare_xy_2_object()), watch_(traits.watch) {}
    CGAL::Comparison_result operator()(const Point& p, const Point& q) const {
      if (watch_)
        watch_->count();
      return compare_(p, q);
    }

   private:
    typename Base::Compare_xy_2 compare_;
    SweepWatch* watch_;
  };
  Compare_xy_2 compare_xy_2_object() const { return Compare_xy_2(*this); }

  // Called where a curve begins.
  class Compare_y_at_x_2 {
   public:
    explicit Compare_y_at_x_2(const WatchedSegments& traits)
        : compare_(traits.Base::compare_y_at_x_2_object()), watch_(traits.watch) {}
    CGAL::Comparison_result operator()(const Point& p, const Curve& curve) const {
      if (watch_)
        watch_->count_at(p);
      return compare_(p, curve);
    }

   private:
    typename Base::Compare_y_at_x_2 compare_;
    SweepWatch* watch_;
  };
  Compare_y_at_x_2 compare_y_at_x_2_object() const { return Compare_y_at_x_2(*this); }

  // Called where several curves begin or go on.
  class Compare_y_at_x_right_2 {
   public:
    explicit Compare_y_at_x_right_2(const WatchedSegments& traits)
        : compare_(traits.Base::compare_y_at_x_right_2_object()), watch_(traits.watch) {
    }
    CGAL::Comparison_result operator()(const Curve& a, const Curve& b,
                                       const Point& p) const {
      if (watch_)
        watch_->count_at(p);
      return compare_(a, b, p);
    }

   private:
    typename Base::Compare_y_at_x_right_2 compare_;
    SweepWatch* watch_;
  };
  Compare_y_at_x_right_2 compare_y_at_x_right_2_object() const {
    return Compare_y_at_x_right_2(*this);
  }
};

/// Counts how often it is dereferenced. The sweep does this once for each curve, right
/// before it constructs the subcurve.
template <typename Iterator> class CountingIterator {
 public:
  using iterator_category = std::forward_iterator_tag;
  using value_type = typename std::iterator_traits<Iterator>::value_type;
  using difference_type = std::ptrdiff_t;
  using pointer = const value_type*;
  using reference = const value_type&;

  CountingIterator() = default;
  CountingIterator(Iterator at, std::size_t* count) : at_(at), count_(count) {}
  reference operator*() const {
    ++*count_;
    return *at_;
  }
  CountingIterator& operator++() {
    ++at_;
    return *this;
  }
  CountingIterator operator++(int) {
    CountingIterator before = *this;
    ++at_;
    return before;
  }
  bool operator==(const CountingIterator& other) const { return at_ == other.at_; }
  bool operator!=(const CountingIterator& other) const { return at_ != other.at_; }

 private:
  Iterator at_;
  std::size_t* count_ = nullptr;
};

/// CGAL's sweep frees its subcurves at its end only. This one also frees them if it is
/// left by an exception.
template <typename Visitor>
class FreeingSweep : public CGAL::Surface_sweep_2::Surface_sweep_2<Visitor> {
  using Base = CGAL::Surface_sweep_2::Surface_sweep_2<Visitor>;

 public:
  using Base::Base;
  template <typename Iterator> void run(Iterator begin, Iterator end) {
    std::size_t constructed = 0;
    try {
      this->sweep(CountingIterator(begin, &constructed),
                  CountingIterator(end, &constructed));
    } catch (...) {
      using Memory = std::allocator_traits<typename Base::Subcurve_alloc>;
      for (std::size_t i = constructed; i < this->m_num_of_subCurves; ++i)
        Memory::construct(this->m_subCurveAlloc, this->m_subCurves + i,
                          this->m_masterSubcurve);
      this->m_queue->clear();
      this->m_statusLine.clear();
      this->_complete_sweep();
      throw;
    }
  }
};

/// Inserts x-monotone curves into an empty arrangement, as CGAL::insert does.
template <typename Arrangement, typename Curves>
void insert_watched(Arrangement& arrangement, const Curves& curves) {
  using Traits = typename Arrangement::Geometry_traits_2;
  using Topology = typename Arrangement::Topology_traits;
  using Allocator = typename Arrangement::Allocator;
  using Event = CGAL::Arr_construction_event<Traits, Arrangement, Allocator>;
  using Subcurve = CGAL::Arr_construction_subcurve<Traits, Event, Allocator>;
  using Helper = typename Topology::template Construction_helper<Event, Subcurve>;
  using Visitor = CGAL::Arr_construction_ss_visitor<Helper>;
  Visitor visitor(&arrangement);
  FreeingSweep<Visitor> sweep(arrangement.geometry_traits(), &visitor);
  sweep.run(curves.begin(), curves.end());
}

}  // namespace blocks::geometry::exact
