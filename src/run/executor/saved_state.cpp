#include "run/executor/saved_state.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <variant>

#include "files/file_tools.hpp"
#include "output/checkpoint/checkpoint.hpp"
#include "run/support/deck_file.hpp"

namespace blocks::run {
namespace {

namespace fs = std::filesystem;

bool is_there(const std::string& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

std::string with_ending(const std::string& name) {
  return name.ends_with(checkpoint_ending) ? name
                                           : name + std::string(checkpoint_ending);
}

bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  return fs::absolute(a, ignored).lexically_normal() ==
             fs::absolute(b, ignored).lexically_normal() ||
         fs::equivalent(a, b, ignored);
}

/// Whether a file is a checkpoint that the same deck with the same options wrote.
bool is_own(const std::string& path, const output::RunIdentity& identity) {
  try {
    output::CheckpointInfo info;
    output::read_checkpoint(path, info);
    return info.deck_text == identity.deck_text &&
           info.overrides == identity.overrides &&
           fs::path(info.deck_file).filename() ==
               fs::path(identity.deck_file).filename();
  } catch (const files::FileError&) {
    return false;
  }
}

/// Returns what is wrong with a name, or an empty text.
std::string fault_of(const std::string& name) {
  if (name.empty())
    return "the name is empty";
  if (name.find('/') != std::string::npos)
    return fmt::format("the name '{}' has a folder", name);
  return with_ending(name) == checkpoint_ending ? "the name is only an ending" : "";
}

}  // namespace

std::string saved_path(const std::string& output_name, const std::string& name) {
  return beside(fs::path(output_name).parent_path().string(), with_ending(name));
}

std::string checkpoint_named(const std::string& folder, const std::string& name,
                             const std::string& output_name) {
  const std::string plain = beside(folder, name);
  std::error_code ignored;
  if (is_there(plain) && !fs::is_directory(plain, ignored))
    return plain;
  if (const std::string saved = with_ending(plain); is_there(saved))
    return saved;
  if (!output_name.empty())
    if (const std::string saved = saved_path(output_name, name); is_there(saved))
      return saved;
  return plain;
}

void check_saves(const deck::Deck& deck, const std::string& output_name,
                 const std::string& restarts_from, deck::Diagnostics& diagnostics) {
  std::map<std::string, int> lines;
  for (const deck::Command& command : deck.commands) {
    const auto* save = std::get_if<deck::Save>(&command.card);
    if (save == nullptr)
      continue;
    const deck::Word& name = save->name;
    const auto refuse = [&](const std::string& message, const std::string& hint) {
      diagnostics.error(name.where, command.name, message, hint);
    };
    if (const std::string fault = fault_of(name.value); !fault.empty()) {
      refuse(fault, "give a name such as SAVE, excavated; the file is beside the other "
                    "files of the run");
      continue;
    }
    const std::string path = saved_path(output_name, name.value);
    const auto [first, is_new] = lines.emplace(path, command.where.line);
    if (!is_new)
      refuse(fmt::format("'{}' is already the name of the SAVE card in line {}",
                         name.value, first->second),
             "give each state a name of its own");
    else if (is_same_file(path, with_ending(output_name)))
      refuse(fmt::format("{} is the checkpoint of the run itself", path),
             "choose another name");
    else if (!restarts_from.empty() && is_same_file(path, restarts_from))
      refuse(fmt::format("{} is the checkpoint from which the deck continues", path),
             "choose another name");
  }
}

std::string put_aside_unless_own(const std::string& path,
                                 const output::RunIdentity& identity) {
  files::expect_replaceable(path);
  if (!is_there(path) || is_own(path, identity))
    return "";
  return fmt::format("{} was not written by this deck: the old file is kept with the "
                     "extension {}",
                     path, files::set_aside(path));
}

}  // namespace blocks::run
