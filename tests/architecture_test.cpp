// Who may include whom (docs/architecture.md): the picture is kept by a test, since one
// convenient include is how such borders fall.
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

struct Include {
  std::string file;    ///< relative to the project, "src/deck/parser.cpp"
  std::string folder;  ///< "deck", "geometry", "geometry/exact"
  std::string target;  ///< as written between the quotes or brackets
};

std::vector<Include> includes() {
  const fs::path root = BLOCKS_SOURCE_DIR;
  const std::regex line_form(R"re(\s*#\s*include\s*[<"]([^>"]+)[>"].*)re");
  std::vector<Include> found;
  for (const char* top : {"src", "geometry"})
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      const std::string ending = entry.path().extension().string();
      if (ending != ".hpp" && ending != ".cpp")
        continue;
      const std::string file = fs::relative(entry.path(), root).generic_string();
      std::string folder = fs::path(file).parent_path().generic_string();
      if (folder.starts_with("src/"))
        folder.erase(0, 4);
      std::ifstream in(entry.path());
      std::smatch match;
      for (std::string line; std::getline(in, line);)
        if (std::regex_match(line, match, line_form))
          found.push_back({file, folder, match[1]});
    }
  return found;
}

/// First part of "model/blocks.hpp"; empty for headers outside the project.
std::string folder_of(const std::string& target) {
  static const std::set<std::string> ours = {
      "geometry", "deck", "model", "dynamics", "exchange", "output",
      "post",     "run",  "study", "audit",    "library",  "apps"};
  const std::string first = target.substr(0, target.find('/'));
  return target.find('/') != std::string::npos && ours.contains(first) ? first : "";
}

// The tests below pass when nothing is found at all: this one does not.
TEST(Architecture, SourcesAreThere) {
  std::set<std::string> folders;
  for (const Include& include : includes())
    folders.insert(include.folder);
  EXPECT_EQ(folders, (std::set<std::string>{"apps",
                                            "audit",
                                            "deck",
                                            "dynamics",
                                            "dynamics/contacts",
                                            "dynamics/decisions",
                                            "dynamics/kernels",
                                            "dynamics/rules",
                                            "dynamics/search",
                                            "dynamics/support",
                                            "exchange",
                                            "geometry",
                                            "geometry/exact",
                                            "library",
                                            "library/blocks",
                                            "model",
                                            "output",
                                            "post",
                                            "run",
                                            "study",
                                            "study/corner_rules"}));
}

// CGAL compiles slowly and changes rounding flags: it stays behind geometry's headers.
TEST(Architecture, CgalStaysInsideGeometry) {
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

// The exact part of geometry is private to it.
TEST(Architecture, ExactNumbersArePrivate) {
  for (const Include& include : includes())
    if (include.target.starts_with("geometry/exact/")) {
      EXPECT_TRUE(include.folder == "geometry/exact" ||
                  (include.folder == "geometry" && include.file.ends_with(".cpp")))
          << include.file << " includes " << include.target;
    }
}

// deck knows no physics, dynamics no files, output never the deck, post only results.
TEST(Architecture, FoldersIncludeOnlyWhatTheyMay) {
  const std::map<std::string, std::set<std::string>> may = {
      {"geometry", {"geometry"}},
      {"geometry/exact", {"geometry"}},
      {"deck", {"deck", "geometry"}},
      {"exchange", {"exchange", "geometry"}},
      {"model", {"model", "geometry"}},
      {"dynamics", {"dynamics", "model", "geometry"}},
      {"audit", {"audit", "model", "geometry"}},
      {"output", {"output", "model", "geometry"}},
      {"post", {"post", "output"}},
      {"study", {"study", "dynamics", "post", "model", "geometry"}},
      {"run", {"run", "deck", "dynamics", "audit", "output", "model", "geometry"}},
      {"library",
       {"library", "run", "deck", "dynamics", "output", "model", "geometry"}},
  };
  for (const Include& include : includes()) {
    const std::string target = folder_of(include.target);
    if (const auto rule = may.find(include.folder);
        rule != may.end() && !target.empty()) {
      EXPECT_TRUE(rule->second.contains(target))
          << include.file << " includes " << include.target;
    }
  }
}

// The folders of a step. The contact rule is a function of blocks and their neighbours:
// it compiles without pairs, arrays and the time loop. Kernels see columns of numbers.
TEST(Architecture, FoldersOfTheStepIncludeOnlyWhatTheyMay) {
  const std::map<std::string, std::set<std::string>> may = {
      {"support", {"support"}},
      {"kernels", {"kernels"}},
      {"rules", {"rules"}},
      {"search", {"search", "support"}},
      {"contacts", {"contacts", "kernels", "rules", "search", "support"}},
      {"decisions", {"decisions", "contacts", "kernels", "rules", "search", "support"}},
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

// Outside of the step, the contact rule needs blocks and geometry, kernels the
// constants of geometry, and support nothing.
TEST(Architecture, RulesKernelsAndSupportSeeNoModel) {
  for (const Include& include : includes()) {
    const std::string folder = folder_of(include.target);
    if (folder.empty() || folder == "dynamics")
      continue;
    if (include.folder == "dynamics/rules") {
      EXPECT_TRUE(include.target == "model/blocks.hpp" || folder == "geometry")
          << include.file << " includes " << include.target;
    }
    if (include.folder == "dynamics/kernels") {
      EXPECT_EQ(include.target, "geometry/contact_constants.hpp") << include.file;
    }
    if (include.folder == "dynamics/support") {
      ADD_FAILURE() << include.file << " includes " << include.target;
    }
  }
}

// What is installed needs nothing of ours that is not.
TEST(Architecture, PublicHeadersStandAlone) {
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

// Figures are drawn from result files: of output, post sees the results alone.
TEST(Architecture, PostReadsResultsOnly) {
  for (const Include& include : includes())
    if (include.folder == "post" && folder_of(include.target) == "output") {
      EXPECT_TRUE(include.target.starts_with("output/results") ||
                  include.target == "output/file_tools.hpp" ||
                  include.target == "output/hdf5_handle.hpp")
          << include.file << " includes " << include.target;
    }
}

}  // namespace
}  // namespace blocks
