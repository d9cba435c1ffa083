#include "output/checkpoint_plane_validation.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "output/checkpoint_expectations.hpp"

namespace blocks::output {

using namespace expectations;

void expect_plane_contacts(const Model& model) {
  const std::vector<PlaneContact>& list = model.plane_contacts;
  const auto planes = static_cast<int>(model.settings.planes.size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    const PlaneContact& contact = list[i];
    const auto expect = [&](bool holds, const char* what) {
      if (!holds)
        reject_checkpoint(fmt::format("plane contact {} {}", i + 1, what));
    };
    expect(contact.plane >= 0 && contact.plane < planes, "has no plane");
    expect(contact.corner >= 0 && contact.corner < model.blocks.corners(),
           "has no corner");
    for (const double value : {contact.normal_elastic, contact.normal_force,
                               contact.overlap, contact.offset})
      expect(std::isfinite(value) && value >= 0.0, "has values out of range");
    expect(i == 0 || std::pair(list[i - 1].plane, list[i - 1].corner) <
                         std::pair(contact.plane, contact.corner),
           "is out of order");
  }
}

}  // namespace blocks::output
