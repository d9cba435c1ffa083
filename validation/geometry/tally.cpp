#include "validation/geometry/tally.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "validation/geometry/families.hpp"

namespace blocks::validation {
namespace {

const char* const names[generators] = {"ours", "naive", "naive_checked"};

std::string percent(long part, long whole) {
  if (whole == 0)
    return "-";
  std::ostringstream out;
  out.precision(part * 100 < whole ? 2 : 3);
  out << 100.0 * static_cast<double>(part) / static_cast<double>(whole) << " %";
  return out.str();
}

FamilyTally sum(const Run& run) {
  FamilyTally total;
  for (const auto& family : run.families)
    for (std::size_t g = 0; g < generators; ++g)
      total[g].add(family[g]);
  return total;
}

void row(std::ostream& out, std::string_view name, std::string_view about,
         const FamilyTally& t) {
  out << "| " << name << " | " << about << " | " << t[0].layers << " | " << t[0].blocks
      << " | " << t[0].refused << " | " << t[0].failures << " | " << t[1].failures
      << " (" << percent(t[1].failures, t[1].layers) << ") | " << t[2].failures << " ("
      << percent(t[2].failures, t[2].layers) << ") |\n";
}

}  // namespace

void Tally::add(const Tally& other) {
  layers += other.layers;
  blocks += other.blocks;
  refused += other.refused;
  failures += other.failures;
  judged += other.judged;
  judge_says += other.judge_says;
  disagree += other.disagree;
  failed.insert(failed.end(), other.failed.begin(), other.failed.end());
  std::sort(failed.begin(), failed.end());
}

std::string markdown(const Run& run) {
  const FamilyTally total = sum(run);
  std::ostringstream out;
  out << R"(# Generated layers: failures

Written by `./go validate layers`; do not edit. Each layer is made three times: by
`geometry::cut_layer`, by a plain program of doubles as in 1982 (naive), and by that
program with a crossing check. A failure is a layer that does not tile its outline
according to the certificate, or a layer from corners that admit none. Refused: an error
instead of a layer. Either blocks do not survive rounding to doubles, or the layer is of
the last family, where each one must be refused.

| family | layers of it | layers | blocks | ours: refused | ours: failures | naive: failures | naive with check: failures |
|---|---|---|---|---|---|---|---|
)";
  for (std::size_t i = 0; i < run.families.size(); ++i)
    row(out, families()[i].name, families()[i].about, run.families[i]);
  row(out, "**all**", "", total);
  long judged = 0;
  long disagree = 0;
  for (const Tally& t : total) {
    judged += t.judged;
    disagree += t.disagree;
  }
  out << "\nIndependent judge (brute force on whole numbers, every " << run.every
      << "th layer of at most 300 blocks): " << judged << " meshes judged, "
      << total[0].judged
      << " of them ours, of which not a tiling or beyond their four corners: "
      << total[0].judge_says << "; of naive " << total[1].judge_says << " of "
      << total[1].judged << ", of naive with check " << total[2].judge_says << " of "
      << total[2].judged << ". Certificate and judge disagreed " << disagree
      << " times.\n\nFailures for replay (`layers --replay FAMILY:NUMBER`):\n\n";
  bool any = false;
  for (std::size_t i = 0; i < run.families.size(); ++i)
    for (std::size_t g = 0; g < generators; ++g) {
      const auto& failed = run.families[i][g].failed;
      if (failed.empty())
        continue;
      any = true;
      out << "- " << families()[i].name << ", " << names[g] << ":";
      for (std::size_t k = 0; k < std::min<std::size_t>(failed.size(), 5); ++k)
        out << ' ' << failed[k];
      out << (failed.size() > 5 ? " ...\n" : "\n");
    }
  if (!any)
    out << "none\n";
  out << "\n"
      << run.layers << " layers, " << static_cast<long>(run.seconds + 0.5) << " s on "
      << run.threads << " threads.\n";
  return out.str();
}

std::string json(const Run& run) {
  nlohmann::json root;
  root["layers"] = run.layers;
  root["judged_every"] = run.every;
  root["threads"] = run.threads;
  root["seconds"] = run.seconds;
  for (std::size_t i = 0; i < run.families.size(); ++i) {
    nlohmann::json family;
    family["name"] = families()[i].name;
    for (std::size_t g = 0; g < generators; ++g) {
      const Tally& t = run.families[i][g];
      const auto listed = std::min<std::size_t>(t.failed.size(), 200);
      const std::vector<std::uint64_t> failed(
          t.failed.begin(), t.failed.begin() + static_cast<std::ptrdiff_t>(listed));
      family[names[g]] = {{"layers", t.layers},     {"blocks", t.blocks},
                          {"refused", t.refused},   {"failures", t.failures},
                          {"judged", t.judged},     {"judge_says", t.judge_says},
                          {"disagree", t.disagree}, {"failed", failed}};
    }
    root["families"].push_back(std::move(family));
  }
  return root.dump() + "\n";
}

}  // namespace blocks::validation
