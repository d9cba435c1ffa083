#include "option_text.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <set>

namespace blocks::apps {
namespace {

/// The words for the values of options that have the same meaning in every command.
const std::map<std::string, std::string> value_words = {
    {"against", "QUANTITY"},
    {"arrow-scale", "VALUE"},
    {"arrows", "QUANTITY"},
    {"block", "N"},
    {"checkpoint-every", "SECONDS"},
    {"colormap", "NAME"},
    {"colour", "QUANTITY"},
    {"csv", "FILE"},
    {"dblock", "FILE"},
    {"deck", "FILE"},
    {"engine", "ENGINE"},
    {"expect", "VARIANT"},
    {"figure", "FILE"},
    {"format", "FORMAT"},
    {"from", "TIME"},
    {"json", "FILE"},
    {"layer", "NAME=ID"},
    {"materials", "N=COLOUR"},
    {"mirror", "X"},
    {"outline", "FILE"},
    {"output", "FILE"},
    {"plot", "FILE"},
    {"precision", "PRECISION"},
    {"profile", "LINE"},
    {"profile-quantity", "QUANTITY"},
    {"quantity", "QUANTITY"},
    {"restart", "FILE"},
    {"run-table", "FILE"},
    {"runs", "N-N"},
    {"scale", "N"},
    {"seeds", "SEEDS"},
    {"sbatch", "OPTIONS"},
    {"set", "CARD.FIELD=VALUE"},
    {"size", "SIZE"},
    {"sobol", "CARD.FIELD=LOW..HIGH"},
    {"table", "FILE"},
    {"sshloginfile", "FILE"},
    {"tape9", "FILE"},
    {"time", "TIME"},
    {"time-limit", "SECONDS"},
    {"times", "TIME"},
    {"title", "TITLE"},
    {"to", "TIME"},
    {"units", "UNITS"},
    {"until", "TIME"},
    {"variants", "VARIANT"},
};

/// Rewrites a range of CLI11: "1 - 100]" becomes "1 to 100", and "1 -
/// 9223372036854775807]" becomes "from 1".
std::string limits_in_words(std::string limits) {
  limits = limits.substr(0, limits.find(']'));
  if (const auto dash = limits.find(" - "); dash != std::string::npos)
    limits.replace(dash, 3, " to ");
  const auto no_end = limits.find(" to 9223372036854775807");
  return no_end == std::string::npos ? CLI::detail::to_lower(limits)
                                     : "from " + limits.substr(0, no_end);
}

/// Returns the names in alphabetical order: "--from, --to".
std::string names_of(const std::set<CLI::Option*>& options) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options)
    names.push_back(option->get_name());
  std::sort(names.begin(), names.end());
  return CLI::detail::join(names, ", ");
}

}  // namespace

std::string value_name(const CLI::Option& option) {
  if (option.get_items_expected_max() == 0)
    return {};
  const std::string full = option.get_type_name();
  const std::string type = full.substr(0, full.find(':'));
  if (type == "TEXT" || type == "FLOAT")
    for (const std::string& name : option.get_lnames())
      if (const auto word = value_words.find(name); word != value_words.end())
        return word->second;
  return type == "INT" || type == "UINT" ? "N" : type == "FLOAT" ? "NUMBER" : type;
}

std::vector<std::string> choices(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const auto begin = type.find('{'), end = type.find('}');
  return begin == std::string::npos || end == std::string::npos
             ? std::vector<std::string>{}
             : CLI::detail::split(type.substr(begin + 1, end - begin - 1), ',');
}

std::string option_meaning(const CLI::Option& option) {
  std::string words = option.get_description();
  const std::string type = option.get_type_name();
  if (const auto names = choices(option); !names.empty())
    words += "; one of " + CLI::detail::join(names, ", ");
  else if (const auto limits = type.find_first_of("0123456789", type.find(':'));
           limits != std::string::npos)
    words += "; " + limits_in_words(type.substr(limits));
  if (!option.get_default_str().empty())
    words += "; default " + option.get_default_str();
  if (!option.get_needs().empty())
    words += "; only with " + names_of(option.get_needs());
  if (!option.get_excludes().empty())
    words += "; not with " + names_of(option.get_excludes());
  return words;
}

std::string wrapped(const std::string& text, std::size_t width) {
  std::string out;
  std::size_t column = 0;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = std::min(text.find(' ', from), text.size());
    if (column > 0 && column + 1 + to - from > width) {
      out += '\n';
      column = 0;
    } else if (column > 0) {
      out += ' ';
      ++column;
    }
    out += text.substr(from, to - from);
    column += to - from;
    from = to + 1;
  }
  return out;
}

}  // namespace blocks::apps
