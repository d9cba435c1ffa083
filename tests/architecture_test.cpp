// Source folders include only the folders that docs/architecture.md allows.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace blocks {
namespace {

namespace fs = std::filesystem;

const fs::path root = BLOCKS_SOURCE_DIR;

/// An include directive of a source file.
struct Include {
  std::string file;    ///< relative to the project, "src/deck/parser.cpp"
  std::string folder;  ///< "deck", "geometry", "geometry/exact"
  std::string target;  ///< "model/blocks.hpp"; as written if it is not of the project
  bool in_quotes;      ///< rather than in brackets
};

/// Returns a path relative to the project, without "src/".
std::string short_path(const fs::path& path) {
  const std::string name = fs::relative(path, root).generic_string();
  return name.starts_with("src/") ? name.substr(4) : name;
}

/// Returns the short path of what a file in `folder` includes in quotes, or an empty
/// text if the project has no such file.
std::string included_file(const fs::path& folder, const std::string& written) {
  for (const fs::path& start : {folder, root / "src", root / "src/library", root})
    if (fs::is_regular_file(start / written))
      return short_path(start / written);
  return {};
}

/// Returns all include directives of src and geometry.
std::vector<Include> includes() {
  const std::regex line_form(R"re(\s*#\s*include\s*([<"])([^>"]+)[>"].*)re");
  std::vector<Include> found;
  for (const char* top : {"src", "geometry"})
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      const std::string ending = entry.path().extension().string();
      if (ending != ".hpp" && ending != ".cpp")
        continue;
      const std::string file = fs::relative(entry.path(), root).generic_string();
      const fs::path folder = entry.path().parent_path();
      std::ifstream in(entry.path());
      std::smatch match;
      for (std::string line; std::getline(in, line);)
        if (std::regex_match(line, match, line_form)) {
          const bool in_quotes = match[1] == "\"";
          const std::string name = in_quotes ? included_file(folder, match.str(2)) : "";
          found.push_back({file, short_path(folder), name.empty() ? match.str(2) : name,
                           in_quotes});
        }
    }
  return found;
}

/// Returns the first part of a path such as "model/blocks.hpp", or an empty text for
/// headers outside the project.
std::string folder_of(const std::string& target) {
  const std::string first = target.substr(0, target.find('/'));
  return target.find('/') != std::string::npos &&
                 (fs::is_directory(root / "src" / first) ||
                  fs::is_directory(root / first))
             ? first
             : "";
}

/// Returns the first part of the folder of a source file.
std::string top_of(const Include& include) { return folder_of(include.folder + '/'); }

/// The list of the states of a contact. The layout of kernels and the states that
/// readers of results know follow from it.
constexpr const char* list_of_states = "model/law_state.hpp";

// Without sources the tests below would pass.
TEST(Architecture, SourceFoldersAreFound) {
  std::set<std::string> folders;
  for (const Include& include : includes())
    folders.insert(include.folder);
  EXPECT_EQ(folders, (std::set<std::string>{"apps",
                                            "apps/help",
                                            "apps/options",
                                            "audit",
                                            "convert",
                                            "dblock",
                                            "deck",
                                            "deck/cards",
                                            "deck/mesh",
                                            "draw",
                                            "draw/chart",
                                            "dynamics",
                                            "dynamics/contacts",
                                            "dynamics/cracks",
                                            "dynamics/decisions",
                                            "dynamics/energy",
                                            "dynamics/kernels",
                                            "dynamics/loads",
                                            "dynamics/preparation",
                                            "dynamics/rules",
                                            "dynamics/search",
                                            "dynamics/support",
                                            "exchange",
                                            "files",
                                            "geometry",
                                            "geometry/exact",
                                            "joints",
                                            "library",
                                            "library/blocks",
                                            "model",
                                            "model/words",
                                            "output",
                                            "output/checkpoint",
                                            "output/listing",
                                            "output/results",
                                            "post/chart",
                                            "post/export",
                                            "post/figure",
                                            "post/page",
                                            "post/read",
                                            "python",
                                            "quantities",
                                            "report",
                                            "run",
                                            "run/builder",
                                            "run/cutting",
                                            "run/executor",
                                            "run/plausibility",
                                            "run/reports",
                                            "run/safety",
                                            "run/support",
                                            "run/watch",
                                            "study",
                                            "sweep",
                                            "text",
                                            "why"}));
}

// The rules below say nothing about a folder that they do not know.
TEST(Architecture, IncludesInQuotesAreFilesOfTheProject) {
  for (const Include& include : includes())
    if (include.in_quotes) {
      EXPECT_TRUE(fs::is_regular_file(root / "src" / include.target) ||
                  fs::is_regular_file(root / include.target))
          << include.file << " includes " << include.target;
    }
  EXPECT_EQ(included_file(root / "src/deck", "model/blocks.hpp"), "model/blocks.hpp");
  EXPECT_EQ(included_file(root / "src/deck", "../model/blocks.hpp"),
            "model/blocks.hpp");
  EXPECT_EQ(included_file(root / "src/deck", "modle/blocks.hpp"), "");
}

// CGAL compiles slowly and changes rounding flags.
TEST(Architecture, OnlyGeometryIncludesCgal) {
  int uses = 0;
  for (const Include& include : includes())
    if (include.target.starts_with("CGAL/")) {
      ++uses;
      EXPECT_TRUE(include.folder == "geometry/exact" ||
                  (include.folder == "geometry" && include.file.ends_with(".cpp")))
          << include.file << " includes " << include.target;
    }
  EXPECT_GT(uses, 0);
}

TEST(Architecture, OnlyGeometryIncludesItsExactPart) {
  for (const Include& include : includes())
    if (include.target.starts_with("geometry/exact/")) {
      EXPECT_TRUE(include.folder == "geometry/exact" ||
                  (include.folder == "geometry" && include.file.ends_with(".cpp")))
          << include.file << " includes " << include.target;
    }
}

// For example, deck is independent of physics, and dynamics is independent of files.
TEST(Architecture, FoldersIncludeOnlyAllowedFolders) {
  const std::map<std::string, std::set<std::string>> may = {
      {"geometry", {"geometry"}},
      {"text", {"text"}},
      {"files", {"files"}},
      {"deck", {"deck", "text", "geometry"}},
      {"exchange", {"exchange", "text", "geometry"}},
      {"joints", {"joints", "draw", "text", "geometry"}},
      {"model", {"model", "text", "geometry"}},
      {"dynamics", {"dynamics", "model", "geometry"}},
      {"audit", {"audit", "model", "geometry"}},
      {"quantities", {"quantities", "text", "model", "geometry"}},
      {"output", {"output", "files", "text", "quantities", "model", "geometry"}},
      {"draw", {"draw", "files", "text"}},
      {"post", {"post", "draw", "files", "text", "output", "quantities", "geometry"}},
      {"study", {"study", "dynamics", "draw", "text", "model", "geometry"}},
      {"run",
       {"run", "deck", "dynamics", "audit", "exchange", "quantities", "output", "files",
        "text", "model", "geometry"}},
      {"sweep",
       {"sweep", "study", "run", "text", "files", "deck", "quantities", "model",
        "geometry"}},
      {"report",
       {"report", "sweep", "post", "draw", "run", "quantities", "output", "files",
        "text", "deck"}},
      {"why",
       {"why", "audit", "post", "output", "files", "quantities", "model", "geometry"}},
      {"dblock", {"dblock", "post", "draw", "run", "deck", "text"}},
      {"convert",
       {"convert", "joints", "post", "draw", "run", "exchange", "quantities", "deck",
        "files", "model", "geometry"}},
      {"library",
       {"library", "run", "deck", "dynamics", "output", "files", "model", "geometry"}},
      {"python",
       {"python", "library", "study", "post", "draw", "run", "deck", "quantities",
        "files", "model", "geometry"}},
  };
  for (const Include& include : includes()) {
    const std::string target = folder_of(include.target);
    if (const auto rule = may.find(top_of(include));
        rule != may.end() && !target.empty() &&
        !(top_of(include) == "post" && include.target == list_of_states)) {
      EXPECT_TRUE(rule->second.contains(target))
          << include.file << " includes " << include.target;
    }
  }
}

// Reading results is independent of drawing pictures of them, and the core of drawing
// is independent of both.
TEST(Architecture, FoldersOfPicturesIncludeOnlyAllowedFolders) {
  const std::map<std::string, std::set<std::string>> may = {
      {"draw", {"draw"}},
      {"draw/chart", {"draw", "draw/chart"}},
      {"post/read", {"draw", "post/read"}},
      {"post/figure", {"draw", "post/read", "post/figure"}},
      {"post/chart", {"draw", "draw/chart", "post/read", "post/figure", "post/chart"}},
      {"post/page", {"draw", "post/read", "post/figure", "post/page"}},
      {"post/export", {"draw", "post/read", "post/export"}},
  };
  int headers = 0;
  for (const Include& include : includes()) {
    const auto rule = may.find(include.folder);
    const std::string top = folder_of(include.target);
    if (rule == may.end() || (top != "draw" && top != "post"))
      continue;
    ++headers;
    EXPECT_TRUE(
        rule->second.contains(include.target.substr(0, include.target.rfind('/'))))
        << include.file << " includes " << include.target;
  }
  EXPECT_GT(headers, 100);
}

// The folders of a run are in layers: cards become a model without the time loop.
TEST(Architecture, FoldersOfARunIncludeOnlyAllowedFolders) {
  const std::map<std::string, std::set<std::string>> may = {
      {"support", {"support"}},
      {"reports", {"reports"}},
      {"watch", {"watch"}},
      {"safety", {"safety", "watch"}},
      {"cutting", {"cutting", "support"}},
      {"plausibility", {"plausibility", "support"}},
      {"builder", {"builder", "cutting", "plausibility", "support"}},
      {"executor", {"executor", "builder", "reports", "safety", "support", "watch"}},
  };
  int headers = 0;
  const std::string run = "run/";
  for (const Include& include : includes()) {
    if (!include.folder.starts_with(run) || !include.target.starts_with(run))
      continue;
    ++headers;
    const auto rule = may.find(include.folder.substr(run.size()));
    ASSERT_NE(rule, may.end()) << include.folder;
    const std::string rest = include.target.substr(run.size());
    EXPECT_TRUE(rule->second.contains(rest.substr(0, rest.find('/'))))
        << include.file << " includes " << include.target;
  }
  EXPECT_GT(headers, 60);
}

// The contact rule is a function of blocks and their neighbours. It is independent of
// pairs, arrays and the time loop. Kernels work on arrays of numbers.
TEST(Architecture, FoldersOfTheStepIncludeOnlyAllowedFolders) {
  const std::map<std::string, std::set<std::string>> may = {
      {"support", {"support"}},
      {"kernels", {"kernels"}},
      {"rules", {"rules", "support"}},
      {"search", {"search", "support"}},
      {"contacts", {"contacts", "kernels", "rules", "search", "support"}},
      {"decisions", {"decisions", "contacts", "kernels", "rules", "search", "support"}},
      {"loads", {"loads", "contacts", "kernels", "support"}},
      {"energy", {"energy", "loads", "contacts", "kernels", "support"}},
      // Before the first step, or between steps.
      {"preparation",
       {"preparation", "energy", "loads", "contacts", "kernels", "rules", "search",
        "support"}},
      {"cracks", {"cracks", "energy", "preparation", "step.hpp", "workspace.hpp"}},
  };
  int headers = 0;
  const std::string step = "dynamics/";
  for (const Include& include : includes()) {
    if (!include.folder.starts_with(step) || !include.target.starts_with(step))
      continue;
    ++headers;
    const auto rule = may.find(include.folder.substr(step.size()));
    ASSERT_NE(rule, may.end()) << include.folder;
    const std::string rest = include.target.substr(step.size());
    EXPECT_TRUE(rule->second.contains(rest.substr(0, rest.find('/'))))
        << include.file << " includes " << include.target;
  }
  EXPECT_GT(headers, 40);
}

// Of other folders, the contact rule includes blocks, kept depths and geometry, kernels
// include constants of geometry and the list of states, and support includes nothing.
TEST(Architecture, RulesKernelsAndSupportAreIndependentOfTheModel) {
  for (const Include& include : includes()) {
    const std::string folder = folder_of(include.target);
    if (folder.empty() || folder == "dynamics")
      continue;
    if (include.folder == "dynamics/rules") {
      EXPECT_TRUE(include.target == "model/blocks.hpp" ||
                  include.target == "model/kept_decisions.hpp" || folder == "geometry")
          << include.file << " includes " << include.target;
    }
    if (include.folder == "dynamics/kernels") {
      EXPECT_TRUE(include.target == "geometry/contact_constants.hpp" ||
                  include.target == list_of_states)
          << include.file << " includes " << include.target;
    }
    if (include.folder == "dynamics/support") {
      ADD_FAILURE() << include.file << " includes " << include.target;
    }
  }
}

// Kernels are compiled for instruction sets that the processor may lack, so what they
// include must not bring functions of other headers.
TEST(Architecture, TheListOfStatesDependsOnTheStandardLibraryOnly) {
  int headers = 0;
  for (const Include& include : includes())
    if (include.file == std::string("src/") + list_of_states) {
      ++headers;
      EXPECT_EQ(include.target.find_first_of("/."), std::string::npos)
          << include.target;
    }
  EXPECT_GT(headers, 0);
}

// The state of a run knows nothing of messages.
TEST(Architecture, TheModelHasNoWords) {
  for (const Include& include : includes())
    if (include.folder == "model") {
      EXPECT_FALSE(include.target.starts_with("model/words/") ||
                   folder_of(include.target) == "text")
          << include.file << " includes " << include.target;
    }
}

// Installed headers include no header that is not installed.
TEST(Architecture, InstalledHeadersAreSelfContained) {
  int headers = 0;
  for (const Include& include : includes())
    if (include.folder == "library/blocks") {
      ++headers;
      EXPECT_TRUE(include.target.starts_with("Eigen/") ||
                  include.target.find('/') == std::string::npos)
          << include.file << " includes " << include.target;
    }
  EXPECT_GT(headers, 0);
}

// Figures are drawn from results files, so they need no search and no cutting.
TEST(Architecture, PostIncludesOnlyShapesOfGeometry) {
  for (const Include& include : includes())
    if (top_of(include) == "post" && folder_of(include.target) == "geometry") {
      EXPECT_EQ(include.target, "geometry/block_shape.hpp") << include.file;
    }
}

// Figures are drawn from results files.
TEST(Architecture, PostIncludesOnlyResultsOfOutput) {
  for (const Include& include : includes())
    if (top_of(include) == "post" && folder_of(include.target) == "output") {
      EXPECT_TRUE(include.target.starts_with("output/results/"))
          << include.file << " includes " << include.target;
    }
}

}  // namespace
}  // namespace blocks
