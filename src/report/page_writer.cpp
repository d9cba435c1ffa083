#include "report/page_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "report/html_text.hpp"

namespace blocks::report {

std::string capital(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z')
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

std::string number_with_unit(const std::string& text, const std::string& unit) {
  return unit.empty() ? text : text + " " + unit;
}

std::string class_of(State state) {
  std::string name = name_of(state);
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

std::string PageWriter::column_caption(std::size_t c) const {
  return escaped(capital(all_.columns[c].label));
}

std::optional<std::size_t> PageWriter::parameter_index(const std::string& name) const {
  const auto& all = all_.parameters;
  const auto found = std::find(all.begin(), all.end(), name);
  return found == all.end() ? std::nullopt
                            : std::optional<std::size_t>(found - all.begin());
}

const char* PageWriter::seed_word() const {
  return all_.kind() == sweep::Kind::study ? "frame" : "seed";
}

std::string PageWriter::seed_link(std::size_t row) const {
  const RunRow& run = all_.rows[row];
  return run_link(row, run.seed ? fmt::format("{} {}", seed_word(), *run.seed)
                                : fmt::format("run {}", run.id));
}

std::string PageWriter::run_link(std::size_t row, const std::string& words) const {
  const std::string& file = runs_.files[row];
  if (file.empty())
    return escaped(words);
  return fmt::format("<a href=\"{}\">{}</a>", link_to(file), escaped(words));
}

std::string PageWriter::link_to(const std::string& file) const {
  const std::filesystem::path from =
      std::filesystem::absolute(options_.folder).lexically_normal();
  const std::filesystem::path to = std::filesystem::absolute(file).lexically_normal();
  return url_of(to.lexically_relative(from).generic_string());
}

}  // namespace blocks::report
