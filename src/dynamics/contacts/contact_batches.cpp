#include "dynamics/contacts/contact_batches.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>

#include "dynamics/support/memory_pages.hpp"

namespace blocks::dynamics {

void ContactBatches::reserve(int batches, int rows, bool with_laws) {
  const auto make = []<class Part>(int count, std::unique_ptr<Part[]>& own,
                                   Part*& part) {
    own.reset();  // release the old memory before the new one is allocated
    own = std::make_unique_for_overwrite<Part[]>(static_cast<std::size_t>(count));
    part = own.get();
  };
  const auto with_spare = [](int count) { return count + count / 16; };
  batches_ = rows_ = 0;
  with_laws_ = with_laws;
  if (batches > capacity_) {
    capacity_ = with_spare(batches);
    make(capacity_, own_pairs_, pairs);
    make(capacity_, own_marks_, marks);
    make(capacity_ * lane_count, own_forces_, forces);
    prefer_huge_pages(forces, sizeof(PairForce) * capacity_ * lane_count);
    make(capacity_ * lane_count, own_stresses_, stresses);
    make(capacity_ * lane_count, own_works_, works);
  }
  if (rows > row_capacity_) {
    row_capacity_ = with_spare(rows);
    make(row_capacity_, own_contacts_, contacts);
    make(row_capacity_, own_tests_, tests);
    make(row_capacity_, own_states_, states);
    make(row_capacity_, own_springs_, springs);
    make(row_capacity_, own_advanced_, advanced);
    make(row_capacity_, own_readings_, readings);
  }
  if (with_laws && rows > law_capacity_) {
    law_capacity_ = with_spare(rows);
    make(law_capacity_, own_faces_, faces);
    make(law_capacity_, own_dashpots_, dashpots);
    make(law_capacity_, own_law_states_, law_states);
    make(law_capacity_, own_advanced_law_states_, advanced_law_states);
  }
}

int ContactBatches::add_batch(int rows) {
  pairs[batches_] = BatchPairs{};
  marks[batches_] = BatchMarks{};
  pairs[batches_].first_row = rows_;
  pairs[batches_].rows = rows;
  std::fill_n(forces + batches_ * lane_count, lane_count, PairForce{});
  std::fill_n(contacts + rows_, rows, ContactRow{});
  std::fill_n(tests + rows_, rows, ContactTests{});
  std::fill_n(states + rows_, rows, ContactStates{});
  std::fill_n(springs + rows_, rows, SpringRow{});
  if (with_laws_) {
    std::fill_n(faces + rows_, rows, FaceRow{});
    std::fill_n(dashpots + rows_, rows, DashpotRow{});
    std::fill_n(law_states + rows_, rows, LawRow{});
    std::fill_n(advanced_law_states + rows_, rows, LawRow{});
  }
  rows_ += rows;
  return batches_++;
}

void ContactBatches::find_shared_ends(int batch, int k) {
  const BatchPairs& own = pairs[batch];
  const auto acts = [&](int row) {
    return row >= 0 && is((own.first_row + row) * lane_count + k, &ContactStates::acts);
  };
  for (int row = own.first_row; row < own.first_row + own.rows; ++row) {
    const int slot = row * lane_count + k;
    set(slot, &FaceRow::shared_before, acts(faces[row].partner_before[k]));
    set(slot, &FaceRow::shared_after, acts(faces[row].partner_after[k]));
  }
}

}  // namespace blocks::dynamics
