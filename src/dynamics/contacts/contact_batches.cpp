#include "dynamics/contacts/contact_batches.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>

#include "dynamics/support/memory_pages.hpp"

namespace blocks::dynamics {

void ContactBatches::reserve(int batches, int rows) {
  const auto make = []<class Part>(int count, std::unique_ptr<Part[]>& own,
                                   Part*& part) {
    own.reset();  // the old memory and the new one do not exist together
    own = std::make_unique_for_overwrite<Part[]>(static_cast<std::size_t>(count));
    part = own.get();
  };
  if (batches > room_for_batches_) {
    make(batches, own_pairs_, pairs);
    make(batches * lane_count, own_forces_, forces);
    prefer_huge_pages(forces, sizeof(PairForce) * batches * lane_count);
    make(batches * lane_count, own_stresses_, stresses);
    room_for_batches_ = batches;
  }
  if (rows > room_for_rows_) {
    make(rows, own_contacts_, contacts);
    make(rows, own_bits_, bits);
    make(rows, own_springs_, springs);
    make(rows, own_advanced_, advanced);
    make(rows, own_readings_, readings);
    room_for_rows_ = rows;
  }
}

int ContactBatches::add_batch(int rows) {
  pairs[batches_] = BatchPairs{};
  pairs[batches_].first_row = rows_;
  pairs[batches_].rows = rows;
  std::fill_n(forces + batches_ * lane_count, lane_count, PairForce{});
  std::fill_n(contacts + rows_, rows, ContactRow{});
  std::fill_n(bits + rows_, rows, ContactBits{});
  std::fill_n(springs + rows_, rows, SpringRow{});
  rows_ += rows;
  return batches_++;
}

}  // namespace blocks::dynamics
