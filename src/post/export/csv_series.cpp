#include <fmt/format.h>

#include <filesystem>
#include <iterator>
#include <type_traits>

#include "files/whole_file.hpp"
#include "post/export/time_series.hpp"
#include "post/read/crack_tracker.hpp"
#include "post/read/frame_quantity.hpp"
#include "quantities/bond.hpp"

namespace blocks::post {
namespace {

/// Returns the quantities that the frames have.
std::vector<QuantityKind> columns_of(const ResultsReader& results) {
  std::vector<QuantityKind> kinds = quantities::quantity_kinds();
  if (!results.has_unbalanced())
    std::erase_if(kinds, [](const QuantityKind& kind) {
      return quantities::is_of_equilibrium(kind.name);
    });
  return kinds;
}

std::string block_rows(const std::vector<QuantityKind>& kinds, const Frame& now,
                       const Frame& first, bool with_parents) {
  std::vector<Eigen::VectorXd> columns;
  columns.reserve(kinds.size());
  for (const QuantityKind& kind : kinds)
    columns.push_back(values_of(kind, now, first));
  std::string text;
  auto out = std::back_inserter(text);
  for (int b = 0; b < now.size(); ++b) {
    if (now.is_removed(b))
      continue;
    const auto k = static_cast<std::size_t>(b);
    fmt::format_to(out, "{},{},{},{},{}", now.time, now.step, now.number[k],
                   now.material[k], now.fixed[k]);
    if (with_parents)
      fmt::format_to(out, ",{}", now.parent.empty() ? 0 : now.parent[k]);
    for (const Eigen::VectorXd& values : columns)
      fmt::format_to(out, ",{}", values[b] + 0.0);
    text += '\n';
  }
  return text;
}

/// Removes the sign of a zero.
Eigen::Matrix2Xd plain(const Eigen::Matrix2Xd& values) { return values.array() + 0.0; }

/// Calls act(field, pointer to member) for the states that a row of a contact has after
/// `joint` and `bond`.
template <class Act> void each_state_column(const Act& act) {
  each_law_field([&](const LawField& field, auto member) {
    if constexpr (!std::is_same_v<decltype(member), int LawState::*>)
      act(field, member);
  });
}

std::string state_names() {
  std::string names = ",joint,bond";
  each_state_column(
      [&](const LawField& field, auto) { names += "," + field.name_in_tables(); });
  return names;
}

/// Returns the state of the law of a contact; `bond` is empty if it has no law.
std::string state_columns(const LawState& state) {
  std::string text = fmt::format(",{},{}", state.law,
                                 state.law == 0 ? ""
                                                : quantities::word(quantities::bond_of(
                                                      state.bonded, state.failed)));
  each_state_column([&](const LawField&, auto member) {
    fmt::format_to(std::back_inserter(text), ",{}", state.*member + 0.0);
  });
  return text;
}

std::string contact_rows(const Frame& now, const FrameContacts& contacts) {
  const Eigen::Matrix2Xd force = plain(contacts.force()),
                         normal = plain(contacts.normal);
  std::string text;
  for (int i = 0; i < contacts.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    fmt::format_to(std::back_inserter(text),
                   "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}", now.time, now.step,
                   contacts.corner_block[k], contacts.corner[k], contacts.edge_block[k],
                   contacts.edge[k], contacts.point(0, i), contacts.point(1, i),
                   normal(0, i), normal(1, i), force(0, i), force(1, i),
                   contacts.normal_force[i] + 0.0, contacts.shear_force[i] + 0.0,
                   contacts.overlap[i] + 0.0);
    text += (contacts.states.empty() ? "" : state_columns(contacts.states[k])) + "\n";
  }
  return text;
}

}  // namespace

SeriesFiles write_csv(const std::string& path, const ResultsReader& results,
                      const std::vector<long>& frames,
                      const std::function<void()>& may_stop) {
  const std::string name = std::filesystem::path(path).replace_extension().string();
  SeriesFiles files{{path, name + "_contacts.csv"}};
  files::WholeFile blocks(files.names[0]), contacts(files.names[1]);
  const bool with_parents = !results.cracks().empty();
  std::string head = "time,step,block,material,fixed";
  head += with_parents ? ",parent" : "";
  const std::vector<QuantityKind> kinds = columns_of(results);
  for (const QuantityKind& kind : kinds)
    head += "," + kind.name;
  blocks << head + "\n";
  contacts << "time,step,corner_block,corner,edge_block,edge,x,y,nx,ny,fx,fy,"
              "normal_force,shear_force,overlap"
           << (results.has_laws() ? state_names() + "\n" : "\n");
  ResultsTracker tracker(results);
  for (const long i : frames) {
    may_stop();
    const Frame now = results.frame(i);
    const FrameContacts acting = results.contacts(i);
    blocks << block_rows(kinds, now, tracker.at(i, now).first, with_parents);
    contacts << contact_rows(now, acting);
    files.blocks += now.count_present();
    files.contacts += acting.size();
  }
  blocks.close();
  contacts.close();
  return files;
}

}  // namespace blocks::post
