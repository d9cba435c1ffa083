#include "dynamics/contact_lanes.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace blocks::dynamics {

namespace {

constexpr int* LaneRows::*int_rows[] = {&LaneRows::corner, &LaneRows::edge,
                                        &LaneRows::edge_end, &LaneRows::corner_block,
                                        &LaneRows::edge_block};
constexpr double* LaneRows::*double_rows[] = {&LaneRows::rule,
                                              &LaneRows::damping,
                                              &LaneRows::normal_elastic,
                                              &LaneRows::shear_elastic,
                                              &LaneRows::touch,
                                              &LaneRows::fx,
                                              &LaneRows::fy,
                                              &LaneRows::moment_low,
                                              &LaneRows::moment_high,
                                              &LaneRows::arm_ax,
                                              &LaneRows::arm_ay,
                                              &LaneRows::arm_bx,
                                              &LaneRows::arm_by,
                                              &LaneRows::overlap,
                                              &LaneRows::normal_force,
                                              &LaneRows::shear_force};
constexpr std::size_t alignment = 64;

}  // namespace

void ContactLanes::reserve(int lanes) {
  if (lanes <= room_)
    return;
  const std::size_t sets =
      (static_cast<std::size_t>(lanes) + lane_count - 1) / lane_count;
  const std::size_t room = sets * lane_count;
  const std::size_t bytes = room * (std::size(double_rows) * sizeof(double) +
                                    std::size(int_rows) * sizeof(int)) +
                            sets;
  memory_ = std::make_unique_for_overwrite<char[]>(bytes + alignment);
  void* at = memory_.get();
  std::size_t space = bytes + alignment;
  std::align(alignment, bytes, at, space);
  double* d = static_cast<double*>(at);
  for (const auto row : double_rows)
    this->*row = d, d += room;
  int* i = reinterpret_cast<int*>(d);
  for (const auto row : int_rows)
    this->*row = i, i += room;
  look = reinterpret_cast<char*>(i);
  room_ = static_cast<int>(room);
  size_ = 0;
}

void ContactLanes::resize(int size) {
  reserve(size);
  size_ = size;
  const std::size_t lanes = static_cast<std::size_t>(sets()) * lane_count;
  for (const auto row : int_rows)
    std::fill_n(this->*row, lanes, 0);
  for (const auto row : double_rows)
    std::fill_n(this->*row, lanes, 0.0);
}

#define BLOCKS_DECLARE_LANES(name)                                                     \
  namespace name {                                                                     \
  void find_touching(const LaneRows&, const BlockRows&, int, int);                     \
  LaneExtremes act(const LaneRows&, const BlockRows&, const ContactLaw&, bool, int,    \
                   int);                                                               \
  constexpr LaneArithmetic arithmetic = {#name, find_touching, act};                   \
  }
BLOCKS_DECLARE_LANES(baseline)
#ifdef BLOCKS_X86_LANES
BLOCKS_DECLARE_LANES(avx2)
BLOCKS_DECLARE_LANES(avx512)
#endif

const std::vector<LaneArithmetic>& all_lane_arithmetic() {
  static const std::vector<LaneArithmetic> all = [] {
    std::vector<LaneArithmetic> found = {baseline::arithmetic};
#ifdef BLOCKS_X86_LANES
    if (__builtin_cpu_supports("avx2"))
      found.push_back(avx2::arithmetic);
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl"))
      found.push_back(avx512::arithmetic);
#endif
    return found;
  }();
  return all;
}

const LaneArithmetic& lane_arithmetic() {
  static const LaneArithmetic chosen = [] {
    const char* name = std::getenv("BLOCKS_SIMD");
    if (name == nullptr)
      return all_lane_arithmetic().back();
    std::string there;
    for (const LaneArithmetic& arithmetic : all_lane_arithmetic()) {
      if (arithmetic.name == name)
        return arithmetic;
      there += (there.empty() ? "" : ", ") + std::string(arithmetic.name);
    }
    throw std::invalid_argument("BLOCKS_SIMD=" + std::string(name) +
                                " is no instruction set of this machine; there are " +
                                there);
  }();
  return chosen;
}

}  // namespace blocks::dynamics
