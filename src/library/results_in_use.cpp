#include "library/results_in_use.hpp"

#include <mutex>
#include <set>

#include "files/file_error.hpp"
#include "model/equilibrium.hpp"

namespace blocks::library {
namespace {

struct Claims {
  std::mutex guard;
  std::set<std::filesystem::path> files;
};

/// Shared by the whole program, because two Simulations may write from two threads.
Claims& claims() {
  static Claims all;
  return all;
}

}  // namespace

std::filesystem::path file_of(const std::string& path) {
  std::error_code unknown;  // on failure, the path is used as given
  const auto given = std::filesystem::absolute(path, unknown);
  const auto folder = std::filesystem::weakly_canonical(given.parent_path(), unknown);
  return unknown ? std::filesystem::path(path) : folder / given.filename();
}

std::string name_of(const std::string& path) {
  const std::string ending = ".vtkhdf";
  return path.ends_with(ending) ? path.substr(0, path.size() - ending.size()) : path;
}

FileClaim::FileClaim(const std::string& path) : file_(file_of(path)) {
  Claims& all = claims();
  const std::lock_guard lock(all.guard);
  if (!all.files.insert(file_).second)
    throw files::FileError("cannot write " + path +
                           ": another Simulation writes its frames there");
}

FileClaim::~FileClaim() {
  Claims& all = claims();
  const std::lock_guard lock(all.guard);
  all.files.erase(file_);
}

void ResultsInUse::write(const Model& model, long changes) {
  if (is_damped_to_rest(model.settings) || !model.solves.empty())
    writer_.include_unbalanced();
  writer_.write(model, changes != written_changes_);
  written_changes_ = changes;
}

}  // namespace blocks::library
