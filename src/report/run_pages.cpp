#include "report/run_pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "files/file_tools.hpp"
#include "post/page/view_page.hpp"
#include "report/html_text.hpp"
#include "report/page_files.hpp"
#include "report/pictures.hpp"

namespace blocks::report {
namespace {

namespace fs = std::filesystem;

/// The marks of all pages begin so, and those of pages that play the run.
const std::string any_mark = "<meta name=\"blocks-report\" content=\"",
                  plays_mark = any_mark + "plays";

/// A page has a mark with the options that it was written with, so that it is written
/// again if they change.
std::string mark(const std::string& content) {
  return any_mark + escaped(content) + "\">";
}

std::string units_words(const Ensemble& ensemble) {
  return ensemble.units ? "units " + post::names_of(*ensemble.units) : "no units";
}

std::optional<double> mirror_of(const Ensemble& ensemble) {
  return ensemble.profile ? ensemble.profile->mirror : std::nullopt;
}

/// Returns the mark of pages that play the run.
std::string view_mark(const Ensemble& ensemble) {
  const auto mirror = mirror_of(ensemble);
  return mark("plays; " + units_words(ensemble) +
              (mirror ? fmt::format("; mirror {}", *mirror) : ""));
}

/// Returns the mark of pages with the last picture and the log.
std::string summary_mark(const Ensemble& ensemble, const RunRow& row) {
  return mark("summary; " + units_words(ensemble) + "; " + row.status);
}

bool exists(const std::string& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

bool is_newer(const std::string& path, const std::string& than) {
  std::error_code fault;
  const auto time = fs::last_write_time(path, fault);
  return !fault && time >= fs::last_write_time(than, fault) && !fault;
}

/// Returns the beginning of a page, with its mark.
std::string head_of(const std::string& path) {
  constexpr std::streamsize head = 600;
  std::string begin(head, '\0');
  std::ifstream in(path, std::ios::binary);
  in.read(begin.data(), head);
  return begin;
}

bool has(const std::string& head, const std::string& part) {
  return head.find(part) != std::string::npos;
}

/// Whether the page of a run can remain. A page that plays the run may take the place
/// of one with the last picture; without results it could not be written again.
bool is_sound(const std::string& page, const Ensemble& ensemble, const RunRow& row,
              bool plays) {
  if (!exists(page) || !is_newer(page, ensemble.folder_of(row) + "/outcome.json"))
    return false;
  const std::string head = head_of(page);
  if (has(head, view_mark(ensemble)))
    return true;
  return !plays && (has(head, summary_mark(ensemble, row)) ||
                    (!row.has_results && has(head, plays_mark)));
}

/// Returns the file, or its last part if it is long.
std::string end_of_log(const std::string& path) {
  constexpr std::streamoff max = 20000;
  if (!exists(path))
    return {};
  std::ifstream in(path, std::ios::binary | std::ios::ate);
  if (!in)
    return {};
  const std::streamoff size = in.tellg();
  in.seekg(std::max<std::streamoff>(size - max, 0));
  std::string text{std::istreambuf_iterator<char>(in), {}};
  return size > max ? "...\n" + text.substr(text.find('\n') + 1) : text;
}

/// Returns the rows of the table of parameters and outcome.
std::string run_facts(const Ensemble& ensemble, const RunRow& row) {
  std::string rows;
  for (std::size_t p = 0; p < ensemble.parameters.size(); ++p)
    rows += fact_row(ensemble.parameters[p], ensemble.groups[row.group].values[p]);
  if (row.seed)
    rows += fact_row("seed", std::to_string(*row.seed));
  return rows +
         fact_row("outcome", row.state == State::done || !row.code
                                 ? row.status
                                 : fmt::format("{} (exit {})", row.status, *row.code));
}

std::string last_figure(const Ensemble& ensemble, const RunRow& row) {
  return fmt::format("<figure>{}<figcaption>The last state of the run. <code>blocks "
                     "view {}.vtkhdf</code> writes a page that plays "
                     "it.</figcaption></figure>\n",
                     unique_ids(last_picture(ensemble, row), "p"),
                     escaped(ensemble.members[row.member].plan.name));
}

std::string summary_page(const Ensemble& ensemble, const RunRow& row,
                         bool has_results) {
  const std::string& title =
      ensemble.title.empty() ? ensemble.members[row.member].plan.name : ensemble.title;
  const std::string name = row.seed ? fmt::format("Run {}, seed {}", row.id, *row.seed)
                                    : fmt::format("Run {}", row.id);
  const std::string log = end_of_log(ensemble.folder_of(row) + "/log.txt");
  const auto unless_empty = [](const std::string& text, const char* form) {
    return text.empty() ? text : fmt::format(fmt::runtime(form), escaped(text));
  };
  return fmt::format(
      fmt::runtime(run_html), fmt::arg("mark", summary_mark(ensemble, row)),
      fmt::arg("name", escaped(name)), fmt::arg("title", escaped(title)),
      fmt::arg("style", page_css),
      fmt::arg("message", unless_empty(row.message, "<p class=\"fault\">{}</p>\n")),
      fmt::arg("facts", run_facts(ensemble, row)),
      fmt::arg("picture", has_results ? last_figure(ensemble, row) : ""),
      fmt::arg("log", unless_empty(log, "<h2>Log</h2>\n<pre>{}</pre>\n")));
}

/// Writes a page of a run. A file that is no such page is kept as .bak, .bak2, ...
void replace_page(const std::string& path, const std::string& page) {
  if (exists(path) && !has(head_of(path), any_mark))
    files::set_aside(path);
  files::replace_file(path, page);
}

void write_view(const Ensemble& ensemble, const RunRow& row, const std::string& path) {
  post::ResultsReader results(ensemble.results_of(row));
  if (ensemble.units)
    results.show_in(*ensemble.units);
  std::string page = post::view_page(post::view_data(results, 1, mirror_of(ensemble)));
  const std::string head = "<head>\n";
  page.insert(page.find(head) + head.size(), view_mark(ensemble) + '\n');
  replace_page(path, page);
}

/// Returns the rows whose runs get a page that plays them.
std::set<std::size_t> played_rows(const Analysis& analysis,
                                  const std::vector<bool>& with_results,
                                  const std::vector<std::size_t>& chosen,
                                  std::size_t max) {
  std::set<std::size_t> rows;
  if (static_cast<std::size_t>(
          std::count(with_results.begin(), with_results.end(), true)) <= max) {
    for (std::size_t r = 0; r < with_results.size(); ++r)
      if (with_results[r])
        rows.insert(rows.end(), r);
    return rows;
  }
  for (const std::size_t r : chosen)
    if (rows.size() < max)
      rows.insert(r);
  for (const GroupStatistics& group : analysis.groups)
    for (const ColumnStatistics& column : group.columns)
      if (column.summary.n > 0 && rows.size() + 2 <= max)
        rows.insert({column.min_row, column.max_row});
  return rows;
}

}  // namespace

RunPages write_run_pages(const Ensemble& ensemble, const Analysis& analysis,
                         const std::vector<std::size_t>& chosen,
                         std::size_t max_played) {
  const bool runs = ensemble.kind() == sweep::Kind::run;
  const auto ended = [&](const RunRow& row) { return row.state != State::open; };
  std::vector<bool> with_results(ensemble.rows.size(), false);
  for (std::size_t r = 0; r < ensemble.rows.size(); ++r)
    with_results[r] = ensemble.rows[r].has_results;
  const std::set<std::size_t> played =
      played_rows(analysis, with_results, chosen, max_played);
  const bool summaries = runs && ensemble.rows.size() <= max_summary_pages;
  RunPages pages;
  pages.files.resize(ensemble.rows.size());
  for (std::size_t r = 0; r < ensemble.rows.size(); ++r) {
    const RunRow& row = ensemble.rows[r];
    const fs::path folder = ensemble.folder_of(row);
    const std::string page =
        (folder / (ensemble.members[row.member].plan.name + ".html")).string();
    const std::string log = (folder / "log.txt").string();
    const bool plays = played.contains(r), wanted = plays || (summaries && ended(row));
    if (wanted && pages.fault.empty() && !is_sound(page, ensemble, row, plays)) {
      try {
        if (plays)
          write_view(ensemble, row, page);
        else
          replace_page(page, summary_page(ensemble, row, with_results[r]));
      } catch (const files::FileError& fault) {
        pages.fault = fault.what();
      } catch (const std::runtime_error&) {
        // The results are damaged; the row of the table says so.
      }
    }
    if (wanted && exists(page))
      pages.files[r] = page;
    else if (exists(log))
      pages.files[r] = log;
  }
  return pages;
}

}  // namespace blocks::report
