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

#include "output/file_tools.hpp"
#include "output/results.hpp"
#include "run/run.hpp"

namespace blocks::sweep {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::int64_t largest_code = 255;  // of a process

std::string path_of(const std::string& run_folder) {
  return run_folder + "/outcome.json";
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
  std::ifstream in(path_of(run_folder), std::ios::binary);
  if (!in || in.peek() == std::ifstream::traits_type::eof())
    return std::nullopt;
  try {
    Json json = Json::parse(in);
    const auto code = json.at("code").get<std::int64_t>();
    if (code < 0 || code > largest_code || !json.at("code").is_number_integer())
      throw std::runtime_error("no exit code");
    Outcome outcome{static_cast<int>(code), json.at("status"), json.at("message")};
    for (const char* key : {"code", "status", "message"})
      json.erase(key);
    outcome.measured = std::move(json);
    return outcome;
  } catch (const std::exception&) {
    throw output::FileError(fmt::format(
        "{} is damaged\n  hint: remove it, and blocks sweep goes on with this run",
        path_of(run_folder)));
  }
}

std::optional<Outcome> read_outcome_or_damage(const std::string& run_folder) {
  try {
    return read_outcome(run_folder);
  } catch (const output::FileError&) {
    return Outcome{
        run::file_error, damaged_outcome,
        "outcome.json is damaged; remove it, or give --retry, and blocks sweep runs "
        "this run again"};
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
  output::replace_file(path_of(run_folder),
                       json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n');
}

void remove_outcome(const std::string& run_folder) {
  const std::string path = path_of(run_folder);
  if (::unlink(path.c_str()) != 0 && errno != ENOENT)
    output::throw_errno("remove", path);
}

}  // namespace blocks::sweep
