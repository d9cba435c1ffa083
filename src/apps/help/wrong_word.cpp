#include "wrong_word.hpp"

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "text/suggest.hpp"

namespace blocks::apps {
namespace {

std::string message(const std::string& fault, const std::string& near,
                    const std::string& command) {
  return fmt::format("blocks: error: {}\n  hint: {}{} --help shows what is possible\n",
                     fault, near.empty() ? "" : "did you mean " + near + "? ", command);
}

std::string tell_wrong_command(const CLI::App& app, const std::string& word,
                               const std::string& path) {
  std::vector<std::string_view> names;
  for (const CLI::App* command : app.get_subcommands({}))
    names.emplace_back(command->get_name());
  return message("there is no command " + word, text::suggest(word, names), path);
}

std::string tell_wrong_option(const CLI::App& app, const std::string& word,
                              const std::string& path) {
  std::vector<std::string_view> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames())
      names.emplace_back(name);
  const std::string near = text::suggest(std::string_view(word).substr(2), names);
  return message(fmt::format("{} has no option {}", path, word),
                 near.empty() ? near : "--" + near, path);
}

}  // namespace

std::string tell_wrong_word(const CLI::App& app, int argc, const char* const* argv) {
  const CLI::App* command = &app;
  std::string path = "blocks";
  for (int i = 1; i < argc; ++i) {
    const std::string given = argv[i], word = given.substr(0, given.find('='));
    if (given == "--")
      break;
    if (given.starts_with("--")) {
      if (command->get_option_no_throw(word) == nullptr)
        return tell_wrong_option(*command, word, path);
    } else if (!given.starts_with("-") && !command->get_subcommands({}).empty()) {
      const CLI::App* next = nullptr;
      for (const CLI::App* one : command->get_subcommands({}))
        if (one->get_name() == given)
          next = one;
      if (next == nullptr && command != &app)
        break;  // the command reports it
      if (next == nullptr)
        return tell_wrong_command(app, given, path);
      command = next;
      path += ' ' + given;
    }
  }
  return {};
}

}  // namespace blocks::apps
