#include "study_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>

#include "apps/options/option_checks.hpp"
#include "files/check_outputs.hpp"
#include "files/file_tools.hpp"
#include "run/run.hpp"
#include "study/figure.hpp"
#include "study/report.hpp"
#include "sweep/study_tables.hpp"
#include "text/suggest.hpp"

namespace blocks::apps {
namespace {

bool is_scene(const std::string& name) {
  const auto& names = study::scene_names();
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// True for "my/figure4.deck", a deck; false for "figure4", which may be a mistyped
/// scene.
bool looks_like_deck(const std::string& name) {
  return name == "-" || name.find_first_of("./") != std::string::npos ||
         std::filesystem::exists(name);
}

std::string did_you_mean(const std::string& word,
                         const std::vector<std::string_view>& names) {
  const std::string near = text::suggest(word, names);
  return near.empty() ? std::string() : fmt::format("; did you mean {}?", near);
}

/// Adds what the list does not have yet.
template <class One> void add_once(std::vector<One>& list, const One& one) {
  if (std::find(list.begin(), list.end(), one) == list.end())
    list.push_back(one);
}

/// Returns the names of scenes and decks, with "all" expanded. Prints an error and
/// returns nothing if a name is unknown.
std::vector<std::string> scenes_meant(const std::vector<std::string>& given) {
  std::vector<std::string> meant;
  for (const std::string& name : given) {
    if (name == "all") {
      for (const std::string_view scene : study::scene_names())
        add_once(meant, std::string(scene));
    } else if (is_scene(name) || looks_like_deck(name)) {
      add_once(meant, name);
    } else {
      fmt::print(stderr, "blocks: error: there is no scene '{}'{}\n{}", name,
                 did_you_mean(name, study::scene_names()), study::list_of_scenes());
      return {};
    }
  }
  return meant;
}

/// Does the same for variants; no name means all of them.
std::vector<const study::Variant*>
variants_meant(const std::vector<std::string>& given) {
  std::vector<const study::Variant*> meant;
  std::vector<std::string_view> names;
  for (const study::Variant& variant : study::all_variants())
    names.push_back(variant.name);
  for (const std::string& name :
       given.empty() ? std::vector<std::string>{"all"} : given) {
    const study::Variant* variant = study::find_variant(name);
    if (name == "all") {
      for (const study::Variant& one : study::all_variants())
        add_once(meant, &one);
    } else if (variant != nullptr) {
      add_once(meant, variant);
    } else {
      fmt::print(stderr, "blocks: error: there is no variant '{}'{}\n{}", name,
                 did_you_mean(name, names), study::list_of_variants());
      return {};
    }
  }
  return meant;
}

/// Checks that the outputs can be written before the study runs, which may take
/// minutes.
void check_files(const StudyOptions& options) {
  for (const std::string& name :
       {options.csv, options.json, options.figure, options.deck})
    if (name == "-")
      throw files::FileError(
          "the table is printed anyway; give the name of a file, not '-'");
  files::check_outputs({options.csv, options.json, options.figure, options.deck});
  const auto ending = std::filesystem::path(options.figure).extension();
  if (!options.figure.empty() && ending != ".png" && ending != ".svg" &&
      ending != ".pdf")
    throw files::FileError("the figure's name must end in .png, .svg or .pdf, found '" +
                           options.figure + "'");
}

/// Returns the rules that every run uses; --gate checks these.
const study::Variant* default_rules() { return &study::all_variants().front(); }

/// The largest share of contacts by which kept decisions may differ from those of the
/// same step in a scene that must pass (docs/kept-decisions.md#renewal).
constexpr double max_late = 1e-4;

/// Prints why --gate fails: the default rules hang, let a block through, or decide
/// differently from exact arithmetic. A deck also fails if the first two are not
/// counted. In scenes where they are known to fail, only the signs count.
bool default_is_sound(const std::vector<study::Study>& studies) {
  bool sound = true;
  for (const study::Study& study : studies)
    for (const study::Row& row : study.rows) {
      if (row.variant != default_rules())
        continue;
      const bool late = row.phantom.value > max_late || row.missed.value > max_late;
      const bool exact = !(row.wrong_signs.value > 0 || row.wrong_tangents.value > 0 ||
                           (late && study.must_pass));
      const bool counted = study.not_counted.empty();
      if (((counted && row.hung + row.fell == 0) || !study.must_pass) && exact)
        continue;
      sound = false;
      if (!counted) {
        fmt::print(stderr,
                   "blocks: error: --gate failed: {}: hang-ups and fall-throughs are "
                   "not counted, because {}\n",
                   study.scene, study.not_counted);
        continue;
      }
      fmt::print(stderr,
                 "blocks: error: --gate failed: {}: of {} frames, {} hung and {} fell "
                 "through{}\n",
                 study.scene, row.frames, row.hung, row.fell,
                 exact ? "" : "; some decisions were not exact");
    }
  return sound;
}

/// Makes all scenes, by name or from decks, before the first one runs. If a deck has an
/// error, sets `code` to its exit code and returns nothing.
std::vector<study::Scene> make_scenes(const std::vector<std::string>& names,
                                      int& code) {
  std::vector<study::Scene> scenes;
  for (const std::string& name : names) {
    if (is_scene(name)) {
      scenes.push_back(study::make_scene(name));
      continue;
    }
    run::RunOptions deck;
    deck.deck = name;
    const auto checked = run::build_checked(deck);
    if (checked.code != run::done) {
      code = checked.code;
      return {};
    }
    if (checked.model.blocks.size() == 0) {
      fmt::print(stderr,
                 "blocks: error: {} has no blocks to study\n  hint: make some with "
                 "CREATE, LAYER or READ9\n",
                 checked.file);
      code = run::deck_error;
      return {};
    }
    scenes.push_back(study::scene_of_deck(checked.file, checked.model));
  }
  return scenes;
}

/// Whether an option is given that chooses frames or variants, which a sweep has fixed.
bool chooses_frames(const StudyOptions& options) {
  const StudyOptions usual;
  return !options.variants.empty() || options.expected || options.offset ||
         options.scale || options.frames != usual.frames ||
         options.first != usual.first || options.steps != usual.steps ||
         options.seed != usual.seed;
}

/// Writes the tables of the studies finished so far. The first call keeps an older file
/// as .bak.
void save(const StudyOptions& options, const std::vector<study::Study>& studies) {
  const auto write = [&](const std::string& path, const std::string& text) {
    if (studies.size() == 1)
      files::replace_file_keeping_older(path, text);
    else
      files::replace_file(path, text);
  };
  if (!options.csv.empty())
    write(options.csv, study::csv(studies));
  if (!options.json.empty())
    write(options.json, study::json(studies, {options.frames, options.seed}));
}

/// Prints what was found in a scene. Returns the exit code.
int print_study(const study::Study& done, bool first) {
  fmt::print("{}{}", first ? "" : "\n", study::text(done));
  std::fflush(stdout);  // the next scene may take a minute
  if (!done.doubt.empty())
    fmt::print(
        stderr,
        "blocks: warning: {}: the run of {}, which is the expected motion, {}\n  "
        "hint: hang-ups and fall-throughs would be counted against that run, so they "
        "are not counted\n",
        done.scene, done.expected, done.doubt);
  if (done.refused.empty())
    return run::done;
  fmt::print(stderr,
             "blocks: error: {} was not run: {}\n  hint: a smaller --offset or a "
             "larger --scale leaves more digits for the blocks\n",
             done.scene, done.refused);
  return run::deck_error;
}

int finish(const StudyOptions& options, const std::vector<study::Study>& studies,
           int code) {
  if (!options.figure.empty())
    study::draw_studies(options.figure, studies);
  return options.gate && !default_is_sound(studies) ? run::unsound_run : code;
}

bool expect_default(const StudyOptions& options,
                    const std::vector<const study::Variant*>& variants,
                    const char* what_next) {
  if (!options.gate ||
      std::find(variants.begin(), variants.end(), default_rules()) != variants.end())
    return true;
  fmt::print(stderr, "blocks: error: --gate needs the variant {}: {}\n",
             default_rules()->name, what_next);
  return false;
}

/// Makes the tables of a sweep, without running a frame.
int show_sweep(const StudyOptions& options) {
  if (options.scenes.size() != 1 || chooses_frames(options)) {
    fmt::print(
        stderr,
        "blocks: error: a sweep has its own scenes, frames and variants\n  hint: "
        "name only its folder; --csv, --json, --figure and --gate are possible\n");
    return run::usage_error;
  }
  const std::string& folder = options.scenes.front();
  try {
    check_files(options);
    const sweep::Plan plan = sweep::read_plan(folder);
    if (plan.kind == sweep::Kind::study &&
        !expect_default(options, variants_meant(plan.variants),
                        "make a sweep with --variants default"))
      return run::usage_error;
    std::vector<study::Study> studies = sweep::read_studies(folder, plan), done;
    StudyOptions head = options;
    head.frames = static_cast<int>(plan.runs.size() / studies.size());
    int code = run::done;
    for (study::Study& study : studies) {
      done.push_back(std::move(study));
      code = std::max(code, print_study(done.back(), done.size() == 1));
      save(head, done);
    }
    return finish(options, done, code);
  } catch (const files::FileError& error) {
    fmt::print(stderr, "blocks: error: {}\n", error.what());
    return run::file_error;
  }
}

}  // namespace

void add_study_options(CLI::App& command, StudyOptions& options) {
  command.add_option("SCENE", options.scenes,
                     "names of scenes, all, or decks; or the folder of a sweep with "
                     "--study, whose table "
                     "is made from its outcomes");
  command.add_flag("--list", options.list, "list scenes and variants");
  command
      .add_option("--frames", options.frames, "number of random frames of each scene")
      ->check(whole_between(1, 1000000))
      ->capture_default_str();
  command
      .add_option("--first", options.first, "number of the first frame (default: 0)")
      ->check(whole_between(0, 1000000000));
  command.add_flag(
      "--gate", options.gate,
      "exit 4 if the default rules hang or let a block through (unless they are known "
      "to fail in the scene), or if a decision is not exact");
  command
      .add_option("--variants", options.variants,
                  "names of variants, such as default,report, or all (default: all)")
      ->delimiter(',');
  command.add_option("--expect", options.expected,
                     "variant whose run of a deck is the expected motion (default: the "
                     "variant default)");
  command
      .add_option("--offset", options.offset,
                  "distance from the origin in block sizes (default: random, 0 to 1e9)")
      ->check(number_between(0.0, 1e15));
  command
      .add_option("--scale", options.scale,
                  "factor on all lengths (default: random, 1e-3 to 1e6)")
      ->check(number_between(1e-30, 1e30));
  command
      .add_option("--steps", options.steps,
                  "number of time steps (default: that of the scene; 2000 for a deck)")
      ->check(whole_between(1, 1000000000));
  command.add_option("--seed", options.seed, "seed of the frames")
      ->check(whole_between(0, 9007199254740992))
      ->capture_default_str();
  command
      .add_option("-j,--threads", options.threads,
                  "number of threads; does not change results")
      ->check(whole_between(1, 1024))
      ->capture_default_str();
  command.add_option("--figure", options.figure,
                     "draw hang-ups and fall-throughs: .png, .svg or .pdf");
  command.add_option("--csv", options.csv, "write the table as CSV");
  command.add_option("--deck", options.deck,
                     "write the first frame of the first scene as a deck, and run it");
  command.add_option("--json", options.json,
                     "write the table as JSON, with the numbers of the frames");
}

int study_contacts(const StudyOptions& options) {
  if (options.list) {
    fmt::print("{}\n{}", study::list_of_scenes(), study::list_of_variants());
    return run::done;
  }
  if (options.scenes.empty()) {
    fmt::print(stderr, "blocks: error: the name of a scene is missing\n{}",
               study::list_of_scenes());
    return run::usage_error;
  }
  if (std::any_of(options.scenes.begin(), options.scenes.end(), sweep::has_plan))
    return show_sweep(options);
  const auto names = scenes_meant(options.scenes);
  study::StudyChoice choice{{options.seed, options.offset, options.scale},
                            options.first,
                            options.frames,
                            options.steps,
                            names.empty() ? std::vector<const study::Variant*>()
                                          : variants_meant(options.variants),
                            options.threads};
  if (choice.variants.empty())
    return run::usage_error;
  if (options.expected) {
    if (std::all_of(names.begin(), names.end(), is_scene)) {
      fmt::print(stderr, "blocks: error: --expect is for decks; the motion of a scene "
                         "is known\n");
      return run::usage_error;
    }
    const auto expected = variants_meant({*options.expected});
    if (expected.empty())
      return run::usage_error;
    choice.expected = expected.front();
  }
  if (!expect_default(options, choice.variants, "add it to --variants"))
    return run::usage_error;

  try {
    check_files(options);
  } catch (const std::exception& error) {
    fmt::print(stderr, "blocks: error: {}\n", error.what());
    return run::file_error;
  }
  int code = run::done;
  std::vector<study::Scene> scenes = make_scenes(names, code);
  if (code != run::done)
    return code;
  if (!options.deck.empty())
    files::replace_file_keeping_older(options.deck,
                                      study::first_deck(scenes.front(), choice));
  std::vector<study::Study> studies;
  for (study::Scene& scene : scenes) {
    studies.push_back(study::run_study(std::move(scene), choice));
    code = std::max(code, print_study(studies.back(), studies.size() == 1));
    save(options, studies);
  }
  return finish(options, studies, code);
}

}  // namespace blocks::apps
