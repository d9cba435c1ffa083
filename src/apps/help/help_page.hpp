// The form of `blocks --help` and `blocks NAME --help`: purpose, usage, example,
// options.
#pragma once

#include <CLI/Formatter.hpp>
#include <string>

namespace blocks::apps {

class HelpPage : public CLI::Formatter {
 public:
  std::string make_description(const CLI::App* app) const override;
  std::string make_usage(const CLI::App* app, std::string name) const override;
  std::string make_footer(const CLI::App* app) const override;
  std::string make_option_name(const CLI::Option* option,
                               bool is_positional) const override;
  std::string make_option_opts(const CLI::Option* option) const override;
  std::string make_option_desc(const CLI::Option* option) const override;
};

}  // namespace blocks::apps
