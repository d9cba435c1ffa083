// The numbers and names of the MATERIAL cards of a deck, which must differ.
#pragma once

#include <map>
#include <string>

#include "deck/commands.hpp"
#include "deck/diagnostics.hpp"

namespace blocks::deck {

class KnownMaterials {
 public:
  /// Reports faults of the number and the name. Returns false if another card has the
  /// number: with a faulty name, the blocks of the material are checked all the same.
  bool add(const Material& card, Diagnostics& diagnostics);

 private:
  std::map<long, int> numbers_;       ///< number -> line
  std::map<std::string, int> names_;  ///< name -> line
};

}  // namespace blocks::deck
