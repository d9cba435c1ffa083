// What the commands say of themselves beyond their line in the list: help and man page.
#pragma once

#include <map>
#include <string>

namespace blocks::apps {

struct CommandPage {
  std::string example;      ///< a command line that works in the source tree
  std::string beforehand;   ///< command that it needs to have been run; may be empty
  std::string description;  ///< sentences
};

/// By name of the command.
const std::map<std::string, CommandPage>& command_pages();

/// The page as the head of `blocks NAME --help`.
std::string help_head(const CommandPage& page);

}  // namespace blocks::apps
