#include "dynamics/contacts/contact_list.hpp"

#include <utility>

#include "model/contact_blocks.hpp"

namespace blocks::dynamics {

void read_list(const Blocks& blocks, const Contacts& list, const PairIndex& index,
               ContactsOfPairs& all) {
  all.clear();
  std::vector<PairContact> own;
  int p = 0;
  auto next = list.acting.begin();
  while (next != list.acting.end()) {
    const auto wanted = pair_of(blocks, list, next->record);
    own.clear();
    for (; next != list.acting.end() && pair_of(blocks, list, next->record) == wanted;
         ++next)
      own.push_back({.at = {list.corner[next->record], list.edge[next->record]},
                     .certain = true,
                     .touches = true,
                     .normal = next->normal_elastic,
                     .shear = next->shear_elastic});
    const auto blocks_of = [&] {
      return std::pair(index.pairs[p].low, index.pairs[p].high);
    };
    while (p < index.size() && blocks_of() < wanted)
      ++p;
    if (p < index.size() && blocks_of() == wanted)
      all.add(p, own);
  }
}

void write_list(const ContactArrays& arrays, Contacts& list) {
  const ContactBatches& batches = arrays.batches;
  list.corner.clear(), list.edge.clear();
  list.acting.clear();
  for (int p = 0; p < static_cast<int>(arrays.lane_of_pair.size()); ++p)
    arrays.each_slot(p, [&](int slot) {
      if (!batches.is(slot, &ContactBits::touches))
        return;
      ActingContact& contact = list.acting.emplace_back();
      contact.record = static_cast<int>(list.corner.size());
      contact.normal_elastic = batches.at(slot, &SpringRow::normal_elastic);
      contact.shear_elastic = batches.at(slot, &SpringRow::shear_elastic);
      list.corner.push_back(arrays.at(slot).corner);
      list.edge.push_back(arrays.at(slot).edge);
    });
  list.active.assign(list.corner.size(), true);
}

}  // namespace blocks::dynamics
