#include "deck/cut_group.hpp"

#include <fmt/format.h>

#include <utility>

#include "deck/follow_on.hpp"

namespace blocks::deck {
namespace {

bool check_set(const Jset& set, Diagnostics& diagnostics) {
  bool sound = true;
  const auto expect = [&](bool holds, const Exact& at, const std::string& message,
                          const char* hint) {
    if (!holds)
      diagnostics.error(at.where, "JSET", message, hint);
    sound = sound && holds;
  };
  const auto value = [](const Exact& field) { return field.value.value(); };
  const bool uniform = set.law.value == "UNIFORM";
  expect(!uniform || value(set.sdev) < value(set.space), set.sdev,
         fmt::format("sdev must be less than space, found {:g} and {:g}",
                     value(set.sdev), value(set.space)),
         "spacings are drawn from space - sdev to space + sdev");
  expect(value(set.trace) == 0.0 || value(set.tdev) < value(set.trace), set.tdev,
         fmt::format("tdev must be less than trace, found {:g} and {:g}",
                     value(set.tdev), value(set.trace)),
         "lengths are drawn from trace - tdev to trace + tdev");
  expect(value(set.gdev) <= value(set.gap), set.gdev,
         fmt::format("gdev must not be greater than gap, found {:g} and {:g}",
                     value(set.gdev), value(set.gap)),
         "gaps are drawn from gap - gdev to gap + gdev");
  expect(set.law.value == "POISSON" || value(set.ddev) < 90.0 ||
             (value(set.trace) > 0.0 && value(set.ddev) == 90.0),
         set.ddev,
         fmt::format("ddev must be less than 90 degrees, or 90 for traces that end, "
                     "found {:g}",
                     value(set.ddev)),
         "directions repeat after 180 degrees; the law POISSON gives all of them");
  const auto unused = [&](const Exact& field, const char* name, const char* why) {
    if (field.given && value(field) != 0.0)
      diagnostics.warning(field.where, "JSET",
                          fmt::format("{} is ignored {}", name, why));
  };
  if (!uniform)
    unused(set.sdev, "sdev", "by the law NEGEXP or POISSON");
  if (set.law.value == "POISSON") {
    unused(set.dip, "dip", "by POISSON, whose lines have all directions");
    unused(set.ddev, "ddev", "by POISSON, whose lines have all directions");
  }
  expect(!set.until.given || value(set.trace) > 0.0, {{}, set.until.where, true},
         "until needs traces that end, and trace is 0",
         "a joint that runs through crosses the joints at which it would end; give "
         "trace");
  if (value(set.trace) == 0.0) {
    unused(set.tdev, "tdev", "where joints run through (trace is 0)");
    unused(set.gap, "gap", "where joints run through (trace is 0)");
    unused(set.gdev, "gdev", "where joints run through (trace is 0)");
  }
  return sound;
}

bool check_cells(const Voronoi& cells, Diagnostics& diagnostics) {
  if (cells.n.given == cells.file.given) {
    diagnostics.error(cells.file.given ? cells.file.where : cells.n.where, "VORONOI",
                      cells.n.given ? "both n and a file are given"
                                    : "no points are given",
                      "give n, the number of random points, or a file of points");
    return false;
  }
  return true;
}

/// The corners of an outline are either in the deck or in a file.
bool check_source(const Outline& outline, Diagnostics& diagnostics) {
  if (outline.nc.given == outline.file.given) {
    diagnostics.error(
        outline.file.given ? outline.file.where : outline.nc.where, "OUTLINE",
        outline.nc.given ? "both nc and a file are given" : "no corners are given",
        "give nc, the number of corners, or a file with a polygon");
    return false;
  }
  if (outline.layer.given && !outline.file.given) {
    diagnostics.error(outline.layer.where, "OUTLINE", "a layer is given without a file",
                      "layers are those of a file");
    return false;
  }
  return true;
}

/// Tests whether lines of values follow a card that has none, which is an error.
bool has_data(const CutGroup::Part& part, Diagnostics& diagnostics) {
  if (part.data.empty())
    return false;
  if (part.values.ok)  // otherwise the lines may be part of the same mistake
    diagnostics.error(part.data.front().fields.front().where, std::string(part.name),
                      "unexpected line of values after this card",
                      "syntax: " + find_card(part.name)->syntax());
  return true;
}

}  // namespace

bool CutGroup::has(std::string_view card) {
  return card == "OUTLINE" || card == "JSET" || card == "TRACES" || card == "VORONOI" ||
         card == "CUT";
}

std::optional<Cut> CutGroup::take(const Part& part, Diagnostics& diagnostics) {
  if (part.name == "OUTLINE") {
    end_before(part.name, diagnostics);
    state_ = State::open;
    cut_ = {};
    cut_.outline.where = part.where;
    sound_ = begin(part, diagnostics);
    return {};
  }
  if (state_ != State::open) {
    if (state_ == State::outside)
      diagnostics.error(part.where, std::string(part.name),
                        "must follow an OUTLINE card",
                        "OUTLINE gives the domain, then JSET, TRACES and VORONOI its "
                        "joints, and CUT cuts it");
    return {};
  }
  sound_ = add(part, diagnostics) && sound_;
  if (part.name != "CUT")
    return {};
  state_ = State::outside;
  if (cut_.joints.empty() && sound_) {
    diagnostics.error(part.where, "CUT", "nothing cuts the outline",
                      "put JSET, TRACES or VORONOI between OUTLINE and CUT, or make "
                      "one block with CREATE");
    sound_ = false;
  }
  return sound_ ? std::optional(std::move(cut_)) : std::nullopt;
}

bool CutGroup::begin(const Part& part, Diagnostics& diagnostics) {
  const std::vector<Value>& f = part.values.fields;
  if (f.empty() || !f[0].ok)
    return false;
  Outline& outline = cut_.outline;
  outline.nc = f[0].as_int();
  if (part.values.ok) {
    outline.mat = f[1].as_int();
    outline.file = f[2].as_word();
    outline.layer = f[3].as_word();
    if (!check_source(outline, diagnostics))
      return false;
    if (outline.file.given)
      return !has_data(part, diagnostics);
  } else if (!outline.nc.given) {
    return false;
  }
  TwoLists lists =
      read_two_lists({"OUTLINE", outline.nc.value, "x coordinates", "y coordinates",
                      FieldSpec{"coordinate ", Kind::exact, {}, {}, "[L]", ""}, false},
                     part.data, part.end, diagnostics);
  outline.x = std::move(lists.first);
  outline.y = std::move(lists.second);
  return part.values.ok && lists.ok;
}

bool CutGroup::add(const Part& part, Diagnostics& diagnostics) {
  if (has_data(part, diagnostics) || !part.values.ok)
    return false;
  const std::vector<Value>& f = part.values.fields;
  if (part.name == "JSET") {
    Jset set{part.where,      f[0].as_int(),   f[1].as_exact(), f[2].as_exact(),
             f[3].as_exact(), f[4].as_exact(), f[5].as_exact(), f[6].as_exact(),
             f[7].as_exact(), f[8].as_exact(), f[9].as_exact(), f[10].as_exact(),
             f[11].as_word(), f[12].as_int()};
    cut_.joints.emplace_back(set);
    return check_set(set, diagnostics);
  }
  if (part.name == "TRACES") {
    cut_.joints.emplace_back(Traces{part.where, f[0].as_word(), f[1].as_int(),
                                    f[2].as_exact(), f[3].as_word()});
    return true;
  }
  if (part.name == "VORONOI") {
    Voronoi cells{part.where, f[0].as_int(), f[1].as_int(), f[2].as_int(),
                  f[3].as_word()};
    cut_.joints.emplace_back(cells);
    return check_cells(cells, diagnostics);
  }
  cut_.emin = f[0].as_exact();
  cut_.amin = f[1].as_exact();
  for (const Value& value : part.values.repeated)
    cut_.protect.push_back(value.as_int());
  return true;
}

void CutGroup::end_before(std::string_view next, Diagnostics& diagnostics) {
  if (state_ != State::open)
    return;
  state_ = State::unfinished;
  diagnostics.error(cut_.outline.where, "OUTLINE",
                    next.empty() ? std::string("has no CUT card")
                                 : fmt::format("has no CUT card before {}", next),
                    "CUT, emin, amin ends the group; only JSET, TRACES and VORONOI "
                    "stand between OUTLINE and CUT");
}

}  // namespace blocks::deck
