// The results file between any two changes of it, which readers find during a run and
// after kill -9. It has every frame that was published before.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "post/read/results_reader.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

/// Repeats the changes of a file one by one (write_log.cpp).
class Changes {
 public:
  Changes(const fs::path& log, const fs::path& image)
      : log_(log, std::ios::binary), path_(image.string()),
        image_(open(path_.c_str(), O_RDWR | O_CREAT | O_TRUNC, 0666)) {}
  ~Changes() { close(image_); }
  Changes(const Changes&) = delete;
  Changes& operator=(const Changes&) = delete;

  bool next() {
    std::int64_t offset = 0, size = 0;
    if (!log_.read(reinterpret_cast<char*>(&offset), sizeof offset) ||
        !log_.read(reinterpret_cast<char*>(&size), sizeof size))
      return false;
    if (size == -2)
      return named_ = true;
    if (size == -1)
      return ftruncate(image_, offset) == 0;
    bytes_.resize(static_cast<std::size_t>(size));
    log_.read(bytes_.data(), size);
    grew_node_ = std::string_view(bytes_.data(), bytes_.size()).starts_with("TREE") &&
                 offset >= lseek(image_, 0, SEEK_END);
    return pwrite(image_, bytes_.data(), bytes_.size(), offset) == size;
  }
  /// Whether the last change was a new node of an index.
  bool grew_node() const { return grew_node_; }
  /// Whether the file has its own name by now.
  bool named() const { return named_; }
  const std::string& path() const { return path_; }

 private:
  std::ifstream log_;
  std::string path_;
  int image_;
  bool named_ = false, grew_node_ = false;
  std::vector<char> bytes_;
};

bool same(const post::Frame& a, const post::Frame& b) {
  return a.step == b.step && a.number == b.number && a.centroid == b.centroid &&
         a.stress == b.stress && a.velocity == b.velocity && a.angle == b.angle &&
         a.spin == b.spin && a.outlines == b.outlines && a.material == b.material;
}

struct Tally {
  long moments = 0, readable = 0;
  std::string first_fault;
};

bool is_beginning_of(const post::RecordedHistory& part,
                     const post::RecordedHistory& whole) {
  const auto rows = static_cast<Eigen::Index>(part.time.size());
  return rows <= whole.values.cols() &&
         std::equal(part.time.begin(), part.time.end(), whole.time.begin()) &&
         part.values == whole.values.leftCols(rows);
}

/// Reads the file after every `stride`-th change, and after every change while its
/// indices grow.
Tally look_at_all_moments(const std::string& deck, long stride) {
  const TemporaryFolder folder;
  folder.write("a.deck", deck);
  setenv("BLOCKS_LOG", (folder / "log").c_str(), 1);
  setenv("LD_PRELOAD", BLOCKS_WRITE_LOG, 1);
  const Outcome run = blocks("run a.deck -q", folder.path());
  unsetenv("LD_PRELOAD");
  EXPECT_EQ(run.code, 0) << run.err;

  const post::ResultsReader whole((folder / "a.vtkhdf").string());
  const post::RecordedHistory recorded = whole.recorded().at(0);
  Changes changes(folder / "log", folder / "image.vtkhdf");
  Tally tally;
  long published = 0, growing = 0;
  for (long moment = 1; changes.next(); ++moment) {
    if (changes.grew_node())
      growing = 100;
    if (!changes.named() || (moment % stride != 0 && growing-- <= 0))
      continue;
    ++tally.moments;
    try {
      const post::ResultsReader reader(changes.path());
      const long frames = reader.frames();
      if (frames < published || frames > whole.frames())
        throw std::runtime_error("frames were lost");
      published = frames;
      const auto samples = reader.recorded();
      if (!samples.empty() && !is_beginning_of(samples[0], recorded))
        throw std::runtime_error("samples differ");
      for (const long i : {0L, frames / 2, frames - 2, frames - 1})
        if (i >= 0 && !same(reader.frame(i), whole.frame(i)))
          throw std::runtime_error("frame " + std::to_string(i) + " differs");
      ++tally.readable;
    } catch (const std::exception& fault) {
      if (tally.first_fault.empty())
        tally.first_fault = "change " + std::to_string(moment) + ": " + fault.what();
    }
  }
  EXPECT_EQ(post::ResultsReader(changes.path()).frames(), whole.frames());
  return tally;
}

const std::string many_blocks =
    "START, 1000, 4\nMANY BLOCKS\nXLIMITS, -10, 1000\nYLIMITS, -10, 1000\n"
    "BOXES, 10, 10, 0.1\nSTIFF, 1.E7, 1.E7\nFRACTION, 0.02\n"
    "MATERIAL, 1, 1.E9, 4.E8, 1000\nRIGID\nEND\nCLOOP, 260, 2, 0\nCREATE, 4, 1\n"
    "0, 0, 1, 1\n0, 1, 1, 0\nGRAVITY, 0, -9.8\nPLOTS, 1.E-6\n"
    "HISTORY, 1.E-5, ke, y:2-9\n";

TEST(ResultsAtAnyMoment, HaveEveryPublishedFrame) {
  const bool all = std::getenv("BLOCKS_THOROUGH") != nullptr;
  const Tally tally = look_at_all_moments(
      many_blocks + "CYCLE, 70\nCREATE, 4, 1\n0, 0, 1, 1\n5, 6, 6, 5\nCYCLE, 70\n",
      all ? 1 : 199);
  RecordProperty("moments", std::to_string(tally.moments));
  EXPECT_GT(tally.moments, 100);
  EXPECT_EQ(tally.readable, tally.moments) << tally.first_fault;
}

}  // namespace
}  // namespace blocks::testing
