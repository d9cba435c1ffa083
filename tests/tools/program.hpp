// Runs the program as a user does, in a new folder and through the shell. Tests see its
// exit code, printed text and files only.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace blocks::testing {

namespace fs = std::filesystem;

/// A new temporary folder. The destructor removes it.
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
  /// Whether the folder has a file of this name.
  bool holds(const std::string& name) const { return fs::exists(path_ / name); }

 private:
  fs::path path_;
};

/// Exit code and printed text of a run.
struct Outcome {
  int code = -1;
  std::string out, err;
};

/// Runs `blocks arguments` with this current folder and `input` as standard input. The
/// arguments may have redirections and pipes.
Outcome blocks(const std::string& arguments, const fs::path& folder,
               const std::string& input = {});

/// Starts `blocks arguments` and sends it the signal `seconds` after the awaited file
/// exists. Returns its exit code, or -1 if the signal ended it.
int killed(const std::string& arguments, const std::string& awaited, double seconds,
           int signal, const fs::path& folder);

/// Returns the content of a file. The test fails if it cannot be read.
std::string slurp(const fs::path& path);

/// Returns the content of NAME.summary.json in this folder.
nlohmann::json summary(const TemporaryFolder& folder, const std::string& name);

/// Writes the deck to NAME.deck, runs it and expects exit code 0.
Outcome run_text(const TemporaryFolder& folder, const std::string& name,
                 const std::string& deck, const std::string& more = {});

/// Returns all decks in a folder and its subfolders, sorted.
std::vector<fs::path> decks_below(const std::string& folder);
/// Whether some line of a deck begins with this keyword.
bool has_card(const std::string& deck, const std::string& name);
/// Returns the options that limit each SOLVE card of a deck to 40 steps.
std::string fewer_solves(const std::string& deck);

/// Returns the preliminary cards of a small rigid problem with the domain -10..10 and
/// materials 1 and 2. The time step of a unit square of material 1 is 0.0004.
std::string preliminary(const std::string& more = "RIGID\n");

/// Returns the CREATE card of a clockwise rectangle.
std::string rectangle(double left, double bottom, double right, double top,
                      bool fixed = false);

/// Returns the deck of a wall of 4160 bricks on a fixed floor, block 1. Every third
/// column has bricks of five corners. The bricks are numbered at random, so that the
/// run uses an internal order. Block 4162 is a free brick in the air, left of the wall.
std::string wall_at_random();

}  // namespace blocks::testing
