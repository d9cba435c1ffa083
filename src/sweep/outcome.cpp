#include "sweep/outcome.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "files/file_tools.hpp"
#include "run/run.hpp"
#include "sweep/json_fields.hpp"

namespace blocks::sweep {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t largest_code = 255;  // of a process

std::string path_of(const std::string& run_folder) {
  return run_folder + "/outcome.json";
}

/// Returns the outcome that the file has. Throws std::runtime_error if it is damaged.
Outcome outcome_of(Json json) {
  Outcome outcome;
  outcome.code = static_cast<int>(read_whole_number(json, "code", largest_code));
  outcome.status = read_text(json, "status");
  outcome.message = read_text(json, "message");
  for (const char* key : {"code", "status", "message"})
    json.erase(key);
  outcome.measured = std::move(json);
  return outcome;
}

Json number_or_null(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number() ? *found : Json();
}

}  // namespace

std::string status_of(int code) {
  switch (code) {
  case run::done:
    return "done";
  case run::internal_error:
    return "internal error";
  case run::usage_error:
    return "usage error";
  case run::deck_error:
    return "deck error";
  case run::unsound_run:
    return "unsound";
  case run::file_error:
    return "file error";
  case run::time_limit:
    return "time limit";
  case run::interrupted:
    return "interrupted";
  default:
    return code > 128 ? fmt::format("crash, {}", strsignal(code - 128))
                      : fmt::format("exit code {}", code);
  }
}

bool is_final(int code) { return code != run::interrupted && code != run::file_error; }

std::optional<Outcome> read_outcome(const std::string& run_folder) {
  files::expect_regular(path_of(run_folder));
  std::ifstream in(path_of(run_folder), std::ios::binary);
  if (!in || in.peek() == std::ifstream::traits_type::eof())
    return std::nullopt;
  try {
    return outcome_of(Json::parse(in, nullptr, false));
  } catch (const std::exception& fault) {
    throw files::FileError(
        fmt::format("{} is damaged: {}\n  hint: remove it, and blocks sweep goes on "
                    "with this run",
                    path_of(run_folder), fault.what()));
  }
}

std::optional<Outcome> read_outcome_or_damage(const std::string& run_folder) {
  try {
    return read_outcome(run_folder);
  } catch (const files::FileError& fault) {
    // Reports must not depend on where the sweep is.
    const std::string message = fault.what(), path = path_of(run_folder);
    std::string reason = message.substr(0, message.find('\n'));
    if (const auto at = reason.find(path); at != std::string::npos)
      reason.replace(at, path.size(), "outcome.json");
    return Outcome{
        run::file_error, damaged_outcome,
        reason + "; remove it, or give --retry, and blocks sweep runs this run again"};
  }
}

bool has_outcome(const std::string& run_folder) {
  struct stat file {};
  return ::stat(path_of(run_folder).c_str(), &file) == 0 && file.st_size > 0;
}

void write_outcome(const std::string& run_folder, const Outcome& outcome) {
  Json json = {
      {"code", outcome.code}, {"status", outcome.status}, {"message", outcome.message}};
  json.update(outcome.measured);
  files::replace_file(path_of(run_folder),
                      json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n');
}

void remove_outcome(const std::string& run_folder) {
  const std::string path = path_of(run_folder);
  if (::unlink(path.c_str()) != 0 && errno != ENOENT)
    files::throw_errno("remove", path);
}

Json safety_outcome(const Json& summary) {
  const auto proved = summary.find("factor_of_safety");
  if (proved == summary.end() || !proved->is_object())
    return {};
  return {{"lower", number_or_null(*proved, "lower")},
          {"upper", number_or_null(*proved, "upper")}};
}

}  // namespace blocks::sweep
