// Words in command lines of messages, as a shell reads them.
#include "run/support/shell_word.hpp"

#include <gtest/gtest.h>

#include "tools/program.hpp"

namespace blocks::testing {
namespace {

TEST(ShellWord, HasNoQuotesIfItNeedsNone) {
  for (const char* word : {"wall.deck", "../a-b/c_1.ckpt.h5", "CYCLE.ncycle=8"})
    EXPECT_EQ(run::shell_word(word), word);
}

TEST(ShellWord, IsReadByAShellAsItIs) {
  const TemporaryFolder folder;
  for (const char* word : {"", "x y", "it's", "MATERIAL[2].rho=1", "$HOME", "a;b", "~",
                           "\"", "\\", "a\nb", "*", "\xc3\xa4 #1"}) {
    const std::string echo = "printf %s " + run::shell_word(word);
    EXPECT_EQ(blocks("--version >&2; " + echo, folder.path()).out, word);
  }
}

}  // namespace
}  // namespace blocks::testing
