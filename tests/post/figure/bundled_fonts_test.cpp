// The program archive has its own font, because it also runs on systems without fonts.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tools/program.hpp"

namespace blocks::testing {
namespace {

/// Folders as in the archive, and the results of a run.
class UnpackedArchive : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "bin");
    fs::create_directories(folder_ / "share/blocks/fonts");
    fs::copy_file(BLOCKS_PROGRAM, folder_ / "bin/blocks");
    run_text(folder_, "fall", preliminary() + rectangle(0, 0, 1, 1) + "CYCLE, 1\n");
  }
  /// Returns the picture that a program draws.
  std::string picture(const std::string& program) const {
    const std::string command = "cd " + folder_.path().string() +
                                " && env -u FONTCONFIG_FILE HOME=. " + program +
                                " plot fall.vtkhdf -o fall.png >plot.log 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << slurp(folder_ / "plot.log");
    return slurp(folder_ / "fall.png");
  }

  TemporaryFolder folder_;
};

TEST_F(UnpackedArchive, DrawsWithItsOwnFontLikeAnInstalledProgram) {
  const std::string usual = picture(BLOCKS_PROGRAM);
  EXPECT_EQ(picture("bin/blocks"), usual);  // without a share/blocks/fonts.conf
  fs::copy_file(BLOCKS_SOURCE_DIR "/packaging/fonts.conf",
                folder_ / "share/blocks/fonts.conf");
  EXPECT_NE(picture("bin/blocks"), usual) << "the folder of the fonts is still empty";
  fs::copy_file("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                folder_ / "share/blocks/fonts/DejaVuSans.ttf");
  EXPECT_EQ(picture("bin/blocks"), usual);
  fs::create_symlink(folder_ / "bin/blocks", folder_ / "shortcut");
  EXPECT_EQ(picture("./shortcut"), usual);
  EXPECT_EQ(picture("PATH=\"$PWD/bin:$PATH\" blocks"), usual);
}

}  // namespace
}  // namespace blocks::testing
