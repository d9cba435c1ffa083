// The printed output: NAME.out with the input echo (LISTI), OUTPUT tables (OUT) and
// DUMP.
#pragma once

#include <fstream>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "output/results.hpp"

namespace blocks::output {

class Listing {
 public:
  /// Creates (or, to continue, appends to) the file. Throws FileError.
  Listing(const std::string& path, bool append);

  void deck_echo(
      const RunIdentity& identity);       ///< title, version, the deck's lines numbered
  void input_echo(const Model& model);    ///< LISTI: settings, materials, function,
                                          ///< loads, planes, layers, merges, blocks
  void message(const std::string& line);  ///< warnings, domain exits
  void
  table(const Model& model);  ///< OUT: position, velocity, stress of the chosen blocks
  void dump(const Model& model);     ///< DUMP: blocks, boxes, contacts
  void closing(const Model& model);  ///< totals at the end
  long size();                       ///< bytes written so far

 private:
  void flush();  ///< throws FileError when the disk is full
  std::ofstream out_;
  std::string path_;
};

}  // namespace blocks::output
