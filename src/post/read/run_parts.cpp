#include "post/read/run_parts.hpp"

#include <algorithm>

#include "output/results/results.hpp"
#include "post/read/results_reader.hpp"

namespace blocks::post {
namespace {

struct Part {
  std::string file, run, continues;
  unsigned long long seed = 0;
  double begin = 0.0, end = 0.0;  ///< [T]

  bool is_continued_by(const Part& other) const {
    return !run.empty() && other.continues == run && &other != this;
  }
};

Part read_part(const std::string& file) {
  const ResultsReader results(file);
  Part part{file,
            output::ResultsWriter::run_id_of(file),
            {},
            0,
            results.times().front(),
            results.times().back()};
  if (const auto identity = output::ResultsWriter::identity_of(file)) {
    part.continues = identity->continues_run;
    part.seed = identity->seed;
  }
  return part;
}

}  // namespace

std::vector<RunParts> join_parts(const std::vector<std::string>& files) {
  std::vector<Part> parts;
  for (const std::string& file : files)
    parts.push_back(read_part(file));
  const auto earlier = [&](const Part& part) {
    return std::find_if(parts.begin(), parts.end(),
                        [&](const Part& other) { return other.is_continued_by(part); });
  };
  std::vector<RunParts> runs;
  for (const Part& last : parts) {
    if (std::any_of(parts.begin(), parts.end(), [&](const Part& other) {
          return last.is_continued_by(other) && last.end <= other.begin;
        }))
      continue;
    RunParts run{{last.file}, last.seed};
    for (auto part = earlier(last);
         part != parts.end() && run.files.size() < parts.size(); part = earlier(*part))
      run.files.insert(run.files.begin(), part->file);
    runs.push_back(std::move(run));
  }
  return runs;
}

}  // namespace blocks::post
