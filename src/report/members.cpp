#include "report/members.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <set>
#include <stdexcept>

namespace blocks::report {
namespace {

namespace fs = std::filesystem;

/// Returns the absolute path of a folder, without a slash at its end.
fs::path without_slash(const std::string& folder) {
  fs::path path = fs::absolute(folder).lexically_normal();
  return path.has_filename() ? path : path.parent_path();
}

/// Gives each sweep the shortest end of its path that no other one has.
void set_labels(std::vector<Member>& members) {
  for (std::size_t parts = 1;; ++parts) {
    std::set<std::string> labels;
    bool complete = true;
    for (Member& one : members) {
      fs::path rest = without_slash(one.folder), label;
      for (std::size_t i = 0; i < parts && rest.has_filename(); ++i) {
        label = label.empty() ? rest.filename() : rest.filename() / label;
        rest = rest.parent_path();
      }
      complete = complete && !rest.has_filename();
      one.label = label.generic_string();
      labels.insert(one.label);
    }
    if (labels.size() == members.size() || complete)
      return;
  }
}

/// Throws if two sweeps do not belong together.
void expect_alike(const Member& one, const Member& other, bool any_deck) {
  if (one.plan.kind != other.plan.kind)
    throw std::runtime_error(
        fmt::format("{} and {} are sweeps of different kinds\n  hint: make a report of "
                    "each of them",
                    one.folder, other.folder));
  const auto refuse = [&](const std::string& what) {
    throw std::runtime_error(fmt::format(
        "{} and {} have {}\n  hint: --pair compares two sweeps by seed, --mixed "
        "shows any sweeps side by side",
        one.folder, other.folder, what));
  };
  if (any_deck)
    return;
  if (one.plan.deck_hash != other.plan.deck_hash)
    refuse("different decks");
  if (one.plan.version != other.plan.version)
    refuse(
        fmt::format("runs of BLOCKS {} and {}", one.plan.version, other.plan.version));
  if (one.plan.numerics != other.plan.numerics)
    refuse(fmt::format("different numerics, {} and {}", one.plan.numerics,
                       other.plan.numerics));
  if (one.plan.until != other.plan.until)
    refuse("runs with different ends (--until)");
}

}  // namespace

std::string results_path(const Member& member, std::size_t id) {
  return sweep::run_folder(member.folder, id) + "/" + member.plan.name + ".vtkhdf";
}

std::vector<Member> read_members(const std::vector<std::string>& folders, bool pair,
                                 bool mixed) {
  std::vector<Member> members;
  std::set<fs::path> seen;
  for (const std::string& folder : folders) {
    if (!seen.insert(without_slash(folder)).second)
      throw std::runtime_error(folder + " is named twice");
    members.push_back({folder, {}, sweep::read_plan(folder)});
    expect_alike(members.front(), members.back(), pair || mixed);
  }
  if (pair && members.size() != 2)
    throw std::runtime_error(
        fmt::format("--pair compares two sweeps, found {}\n  hint: --mixed shows any "
                    "number of them side by side",
                    members.size()));
  set_labels(members);
  return members;
}

}  // namespace blocks::report
