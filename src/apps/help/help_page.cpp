#include "help_page.hpp"

#include <CLI/CLI.hpp>

#include "command_pages.hpp"
#include "option_text.hpp"

namespace blocks::apps {
namespace {

constexpr std::size_t page_width = 79;

/// Returns the page of a command, or of the command that it belongs to; null for the
/// program.
const CommandPage* page_of(const CLI::App* part) {
  for (; part->get_parent() != nullptr; part = part->get_parent())
    if (const auto page = command_pages().find(part->get_name());
        page != command_pages().end())
      return &page->second;
  return nullptr;
}

}  // namespace

std::string HelpPage::make_description(const CLI::App* app) const {
  const CommandPage* page = page_of(app);
  return wrapped(page == nullptr ? app->get_description() : page->description,
                 page_width) +
         "\n\n";
}

std::string HelpPage::make_usage(const CLI::App* app, std::string name) const {
  const CommandPage* page = page_of(app);
  const CommandPage& shown = page == nullptr ? command_pages().at("run") : *page;
  return CLI::Formatter::make_usage(app, std::move(name)) +
         "\nExample: " + shown.example + "\n" +
         (shown.beforehand.empty() ? "" : "(after " + shown.beforehand + ")\n");
}

std::string HelpPage::make_footer(const CLI::App* app) const {
  std::string footer;
  if (app->get_footer().empty())
    return footer;
  for (const std::string& line : CLI::detail::split(app->get_footer(), '\n'))
    footer += wrapped(line, page_width) + '\n';
  return footer;
}

std::string HelpPage::make_option_name(const CLI::Option* option,
                                       bool is_positional) const {
  const std::string name = CLI::Formatter::make_option_name(option, is_positional);
  return name.substr(0, name.find('{'));  // --audit{100}
}

std::string HelpPage::make_option_opts(const CLI::Option* option) const {
  const std::string value = value_name(*option);
  const bool many = option->get_expected_max() > 1;
  return (option->get_positional() || value.empty() ? "" : " " + value) +
         (many ? " ..." : "");
}

std::string HelpPage::make_option_desc(const CLI::Option* option) const {
  return wrapped(option_meaning(*option), page_width - get_column_width());
}

}  // namespace blocks::apps
