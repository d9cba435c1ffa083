// Longer descriptions of the commands, for their help pages and the man page.
#pragma once

#include <map>
#include <string>

namespace blocks::apps {

struct CommandPage {
  std::string example;      ///< a command line that works in the source tree
  std::string beforehand;   ///< command that must be run first; may be empty
  std::string description;  ///< full sentences
};

/// Returns the pages by name of the command.
const std::map<std::string, CommandPage>& command_pages();

}  // namespace blocks::apps
