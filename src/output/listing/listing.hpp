// The listing NAME.out: the input echo (LISTI), OUTPUT tables (OUT) and DUMP.
#pragma once

#include <fstream>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "output/results/results.hpp"

namespace blocks::output {

class Listing {
 public:
  /// Creates the file or, if `append` is set, continues it. Throws FileError.
  Listing(const std::string& path, bool append);

  /// Writes the title, the version and the numbered lines of the deck.
  void deck_echo(const RunIdentity& identity);
  /// LISTI: writes settings, materials, function, loads, planes, layers, merges and
  /// blocks.
  void input_echo(const Model& model);
  /// Writes a line, such as a warning or a domain exit.
  void message(const std::string& line);
  /// OUT: writes position, velocity and stress of the chosen blocks.
  void table(const Model& model);
  /// DUMP: writes blocks, boxes and contacts.
  void dump(const Model& model);
  /// Writes the totals at the end.
  void closing(const Model& model);
  /// The number of bytes written so far.
  long size();

 private:
  void flush();  ///< throws FileError if the disk is full
  std::ofstream out_;
  std::string path_;
};

}  // namespace blocks::output
