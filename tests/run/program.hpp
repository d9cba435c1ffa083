// Runs the program as a user does: in a fresh folder, through the shell, looking at
// exit code, printed text and files only.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace blocks::testing {

namespace fs = std::filesystem;

/// A folder of its own, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  fs::path operator/(const std::string& name) const { return path_ / name; }
  const fs::path& path() const { return path_; }
  /// Writes a file into the folder.
  void write(const std::string& name, const std::string& text) const;
  bool holds(const std::string& name) const { return fs::exists(path_ / name); }

 private:
  fs::path path_;
};

struct Outcome {
  int code = -1;
  std::string out, err;
};

/// Runs `blocks arguments` with this current folder; input goes to standard input.
/// Redirections and pipes among the arguments win.
Outcome blocks(const std::string& arguments, const fs::path& folder,
               const std::string& input = {});

/// Starts `blocks arguments`, sends it the signal so many seconds after the awaited
/// file is there, and returns its exit code, -1 when the signal ended it.
int killed(const std::string& arguments, const std::string& awaited, double seconds,
           int signal, const fs::path& folder);

/// The whole file; a failure of the test if it cannot be read.
std::string slurp(const fs::path& path);

/// NAME.summary.json of a run in this folder.
nlohmann::json summary(const TemporaryFolder& folder, const std::string& name);

/// Runs deck text as NAME.deck and expects exit code 0.
Outcome run_text(const TemporaryFolder& folder, const std::string& name,
                 const std::string& deck, const std::string& more = {});

/// All decks of a folder and the folders in it, in order.
std::vector<fs::path> decks_below(const std::string& folder);

/// Preliminary cards of a small rigid problem: domain -10..10, materials 1 and 2. The
/// time step of a unit square of material 1 is 0.0004.
std::string preliminary(const std::string& more = "RIGID\n");

/// CREATE of a clockwise rectangle.
std::string rectangle(double left, double bottom, double right, double top,
                      bool fixed = false);

/// A wall of 4160 bricks on a fixed floor, block 1, numbered at random: enough for an
/// order of its own. Left of it, block 4162, a free brick in the air.
std::string wall_at_random();

}  // namespace blocks::testing
