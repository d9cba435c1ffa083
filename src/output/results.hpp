// The plot tape's heir: NAME.vtkhdf, a transient unstructured grid of polygons that
// ParaView reads, with all block quantities as cell data (report A.2.18, Appendix G.1).
#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "model/model.hpp"

namespace blocks::output {

/// A file that cannot be written or read: exit code 5.
class FileError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Written once, at the head of the file.
struct RunIdentity {
  std::string deck_file, deck_text, title, version;
  unsigned long long seed = 0;
  std::string overrides = {};  ///< --set options and sums of meshes, a line each

  /// The deck as a person knows it: name of its file, title.
  std::string deck_name() const;
  /// The same deck, letter for letter, with the same options and seed.
  bool same_deck(const RunIdentity& other) const;
};

/// Appends frames; readable by others at any moment.
class ResultsWriter {
 public:
  /// Creates the file as PATH.tmp. It takes its name when its first frame is in it; an
  /// existing one of that name is moved to PATH + `aside` then.
  ResultsWriter(const std::string& path, const RunIdentity& identity,
                std::string aside = ".bak");
  /// Opens an existing file, keeps its first `frames` frames and goes on after them.
  static ResultsWriter reopen(const std::string& path, long frames);
  ~ResultsWriter();
  ResultsWriter(ResultsWriter&&) noexcept;
  ResultsWriter& operator=(ResultsWriter&&) noexcept;

  /// Drawn when a file is made, so that a checkpoint knows the results it belongs to.
  std::string run_id() const;
  /// That of a file; empty when it cannot be read or is none of ours.
  static std::string run_id_of(const std::string& path);
  /// Of the run that wrote a file; nothing when it cannot be read or is none of ours.
  static std::optional<RunIdentity> identity_of(const std::string& path);

  /// Appends the state; does nothing if a frame of this step is already the last one,
  /// unless the state has `changed` since.
  void write(const Model& model, bool changed = false);
  long frames() const;

 private:
  struct File;
  explicit ResultsWriter(std::unique_ptr<File> file);
  std::unique_ptr<File> file_;
};

}  // namespace blocks::output
