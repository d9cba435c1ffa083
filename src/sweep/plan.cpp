#include "sweep/plan.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "files/file_tools.hpp"
#include "files/fnv1a.hpp"
#include "run/support/deck_file.hpp"
#include "sweep/json_fields.hpp"

namespace blocks::sweep {

NLOHMANN_JSON_SERIALIZE_ENUM(Kind, {{Kind::run, "run"},
                                    {Kind::check, "check"},
                                    {Kind::study, "study"}})

namespace {

using Json = nlohmann::ordered_json;

constexpr int plan_form = 1;

Json json_of(const Variation& run, std::size_t id) {
  Json json = {{"id", id}};
  if (run.seed)
    json["seed"] = *run.seed;
  if (!run.sets.empty())
    json["set"] = run.sets;
  return json;
}

Variation variation_of(const Json& json, Kind kind) {
  Variation run;
  if (json.contains("seed"))
    run.seed = read_whole_number(json, "seed", largest_seed);
  if (json.contains("set"))
    run.sets = read_texts(json, "set");
  if (kind != Kind::study)
    for (const std::string& set : run.sets)
      if (!deck::parse_override(set))
        throw std::runtime_error(fmt::format("\"{}\" is not CARD.field=value", set));
  return run;
}

Json json_of(const SobolDesign& design) {
  Json ranges = Json::array();
  for (const SobolRange& one : design.ranges)
    ranges.push_back({{"field", one.field}, {"low", one.low}, {"high", one.high}});
  return {{"rows", design.rows}, {"seed", design.seed}, {"ranges", ranges}};
}

SobolDesign design_of(const Json& json) {
  SobolDesign design;
  design.rows = read_whole_number(json, "rows", max_runs);
  design.seed = read_whole_number(json, "seed", largest_seed);
  for (const Json& one : read_list(json, "ranges"))
    design.ranges.push_back(
        {read_text(one, "field"), read_number(one, "low"), read_number(one, "high")});
  if (design.rows < 2 || design.ranges.empty() ||
      design.ranges.size() > max_sobol_parameters)
    throw std::runtime_error("\"sobol\" is no design");
  return design;
}

Json head_of(const Plan& plan) {
  Json head = {
      {"blocks_sweep", plan_form}, {"kind", plan.kind},
      {"deck", plan.deck},         {"deck_hash", plan.deck_hash},
      {"version", plan.version},   {"numerics", plan.numerics},
      {"name", plan.name},         {"until", plan.until ? Json(*plan.until) : Json()},
      {"audit", plan.audit_every}, {"variants", plan.variants},
      {"axes", plan.axes},         {"number", plan.runs.size()}};
  if (plan.sobol)
    head["sobol"] = json_of(*plan.sobol);
  return head;
}

Plan plan_of(const Json& head) {
  if (find_field(head, "blocks_sweep") != plan_form)
    throw std::runtime_error("another version of BLOCKS wrote it");
  Plan plan;
  plan.kind = find_field(head, "kind").get<Kind>();
  if (Json(plan.kind) != head.at("kind"))
    throw std::runtime_error("there is no kind " + head.at("kind").dump());
  plan.deck = read_text(head, "deck");
  plan.deck_hash = read_text(head, "deck_hash");
  plan.version = read_text(head, "version");
  plan.numerics = read_text(head, "numerics");
  plan.name = read_text(head, "name");
  // The runs write files of this name in their folders.
  constexpr std::size_t longest_name = 200;  // with endings it is a name of a file
  if (plan.name.empty() || plan.name == "." || plan.name == ".." ||
      plan.name.find_first_of(std::string_view("/\0", 2)) != std::string::npos ||
      plan.name.size() > longest_name)
    throw std::runtime_error("\"name\" is " +
                             head.at("name").dump().substr(0, longest_name) +
                             ", which cannot be the name of files");
  if (!find_field(head, "until").is_null())
    plan.until = read_number(head, "until");
  if (plan.until && !(*plan.until > 0.0 && std::isfinite(*plan.until)))
    throw std::runtime_error("\"until\" is " + head.at("until").dump());
  plan.audit_every = static_cast<long>(
      read_whole_number(head, "audit", std::numeric_limits<int>::max()));
  plan.variants = read_texts(head, "variants");
  plan.axes = read_texts(head, "axes");
  if (head.contains("sobol"))
    plan.sobol = design_of(head.at("sobol"));
  return plan;
}

/// Reads the lines that write_plan writes.
Plan read_lines(std::istream& in) {
  std::string line;
  std::getline(in, line);
  // The head ends with the open list of runs.
  const std::string end = ", \"runs\": [";
  if (!line.ends_with(end))
    throw std::runtime_error("it is no sweep, or its first line is damaged");
  const Json head =
      Json::parse(line.substr(0, line.size() - end.size()) + "}", nullptr, false);
  Plan plan = plan_of(head);
  const std::size_t number = read_whole_number(head, "number", max_runs);
  if (plan.sobol && plan.sobol->runs() != number)
    throw std::runtime_error("its Sobol design has another number of runs");
  plan.runs.reserve(number);
  while (std::getline(in, line) && line != "]}") {
    if (line.ends_with(','))
      line.pop_back();
    const Json run = Json::parse(line, nullptr, false);
    if (find_field(run, "id") != plan.runs.size() + 1)
      throw std::runtime_error(
          fmt::format("run {} is not in its place", plan.runs.size() + 1));
    plan.runs.push_back(variation_of(run, plan.kind));
    if (axes_of(plan.runs.back()) != plan.axes)
      throw std::runtime_error(
          fmt::format("run {} does not set what \"axes\" names", plan.runs.size()));
  }
  if (plan.sobol && !plan.runs.empty()) {
    Variation common = plan.runs.front();
    std::erase_if(common.sets, [&](const std::string& set) {
      return plan.sobol->has(field_of(set));
    });
    if (plan.runs != sobol_runs(*plan.sobol, common))
      throw std::runtime_error("its runs are not those of its Sobol design");
  }
  if (line != "]}" || plan.runs.size() != number)
    throw std::runtime_error(
        fmt::format("it has {} of {} runs", plan.runs.size(), number));
  return plan;
}

/// Returns the first run that differs, in words.
std::string different_runs(const Plan& there, const Plan& wanted) {
  if (there.runs.size() != wanted.runs.size())
    return fmt::format("it has {} runs instead of {}", there.runs.size(),
                       wanted.runs.size());
  for (std::size_t i = 0; i < there.runs.size(); ++i)
    if (there.runs[i] != wanted.runs[i])
      return fmt::format("its run {} has {} instead of {}", i + 1,
                         words_of(there.runs[i]), words_of(wanted.runs[i]));
  return {};
}

}  // namespace

std::string numerics() {
  return
#if defined(__x86_64__)
      "binary64, x86-64"
#elif defined(__aarch64__)
      "binary64, AArch64"
#else
      "binary64"
#endif
      ;
}

std::string plan_path(const std::string& folder) {
  return (std::filesystem::path(folder) / "sweep.json").string();
}

bool has_plan(const std::string& folder) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(plan_path(folder), ignored);
}

void write_plan(const std::string& folder, const Plan& plan) {
  const std::string path = plan_path(folder);
  files::create_folder_of(path);
  files::TemporaryFile temporary(path);
  std::ofstream file(temporary.path(), std::ios::binary);
  std::string head = head_of(plan).dump(-1, ' ', false, Json::error_handler_t::replace);
  head.pop_back();  // the closing brace
  file << head << ", \"runs\": [\n";
  for (std::size_t i = 0; i < plan.runs.size(); ++i)
    file << json_of(plan.runs[i], i + 1).dump()
         << (i + 1 < plan.runs.size() ? ",\n" : "\n");
  file << "]}\n";
  file.close();
  if (!file)
    files::throw_errno("write", path);
  files::sync_file(temporary.path(), path);
  temporary.take_name();
}

Plan read_plan(const std::string& folder) {
  const std::string path = plan_path(folder);
  files::expect_regular(path);
  std::ifstream in(path, std::ios::binary);
  if (!in)
    throw files::FileError(fmt::format(
        "{} is not the folder of a sweep: it has no sweep.json\n  hint: blocks sweep "
        "DECK --seeds 1-20 -o FOLDER makes one",
        folder));
  try {
    return read_lines(in);
  } catch (const std::exception& fault) {
    throw files::FileError(fmt::format(
        "cannot read {}: {}\n  hint: the command that made the sweep writes it again, "
        "in a folder without it",
        path, fault.what()));
  }
}

std::string difference(const Plan& there, const Plan& wanted) {
  if (there.kind != wanted.kind)
    return fmt::format("it is a sweep of kind {} instead of {}",
                       Json(there.kind).get<std::string>(),
                       Json(wanted.kind).get<std::string>());
  if (there.deck != wanted.deck)
    return fmt::format("it sweeps {}", there.deck);
  if (there.deck_hash != wanted.deck_hash)
    return fmt::format("the deck {}, or a mesh that it reads, has changed since then",
                       there.deck);
  if (there.version != wanted.version)
    return fmt::format("BLOCKS {} made it, this is {}", there.version, wanted.version);
  if (there.numerics != wanted.numerics)
    return fmt::format("its numbers are {}, here they are {}", there.numerics,
                       wanted.numerics);
  if (there.until != wanted.until)
    return there.until ? fmt::format("its runs end at --until {}", *there.until)
                       : "its runs end with the deck";
  if (there.audit_every != wanted.audit_every)
    return fmt::format("its runs have --audit={}", there.audit_every);
  if (there.variants != wanted.variants)
    return fmt::format("its variants are {}", fmt::join(there.variants, ","));
  if (there.sobol.has_value() != wanted.sobol.has_value())
    return there.sobol ? "its runs are a Sobol design" : "its runs are no Sobol design";
  if (there.sobol && *there.sobol != *wanted.sobol)
    return fmt::format("its Sobol design has {} rows, seed {}, and {}",
                       there.sobol->rows, there.sobol->seed, words_of(*there.sobol));
  return different_runs(there, wanted);
}

std::string hash_of_deck(const std::string& path) {
  files::expect_regular(path);  // a worker cannot read a stream of this process
  const std::string text = run::read_deck(path);
  deck::Diagnostics ignored(path, text);
  const deck::Deck deck = deck::parse(path, text, ignored);
  const std::string files = run::file_sums(deck, run::deck_folder(path), "");
  files::Fnv1a hash;
  hash.add(text.data(), text.size());
  hash.add(files.data(), files.size());
  return hash.text();
}

void expect_same_program_and_deck(const std::string& folder, const Plan& plan) {
  Plan here = plan;
  here.version = BLOCKS_VERSION;
  here.numerics = numerics();
  if (!plan.deck.empty())
    here.deck_hash = hash_of_deck(plan.deck);
  if (const std::string other = difference(plan, here); !other.empty())
    throw files::FileError(fmt::format(
        "cannot go on with the sweep in {}: {}\n  hint: restore it, or sweep into "
        "another folder with -o",
        folder, other));
}

std::vector<deck::Override> overrides_of(const Variation& run) {
  std::vector<deck::Override> overrides;
  for (const std::string& set : run.sets)
    if (const auto override = deck::parse_override(set))
      overrides.push_back(*override);
  return overrides;
}

std::string run_folder(const std::string& folder, std::size_t id) {
  return (std::filesystem::path(folder) / "runs" / fmt::format("{:03}", id / 1000) /
          fmt::format("{:06}", id))
      .string();
}

}  // namespace blocks::sweep
