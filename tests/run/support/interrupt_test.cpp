// The signals that ask a run or a check to end.
#include <gtest/gtest.h>

#include <csignal>

#include "run/run.hpp"
#include "run/support/interrupt.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

// The end of the session or of the processor time must not lose the work of a run.
TEST(Interrupts, IncludeTheEndOfTheSessionAndOfTheProcessorTime) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU})
    EXPECT_EXIT(
        {
          run::catch_interrupts();
          std::raise(signal);
          std::exit(run::interrupt_requested() ? 0 : 1);
        },
        ::testing::ExitedWithCode(0), "")
        << signal;
}

// The system repeats it every second, and writing a checkpoint may take longer.
TEST(Interrupts, OfTheProcessorTimeMayComeAgain) {
  EXPECT_EXIT(
      {
        run::catch_interrupts();
        std::raise(SIGXCPU);
        std::raise(SIGXCPU);
        std::exit(0);
      },
      ::testing::ExitedWithCode(0), "");
}

TEST(Interrupts, OfTheSessionRemainIgnoredUnderNohup) {
  EXPECT_EXIT(
      {
        std::signal(SIGHUP, SIG_IGN);
        run::catch_interrupts();
        std::raise(SIGHUP);
        std::exit(run::interrupt_requested() ? 1 : 0);
      },
      ::testing::ExitedWithCode(0), "");
}

// Until a run begins there is nothing to save, and to free the memory takes time.
TEST(Interrupts, EndTheProcessAtOnceWhileThereIsNothingToSave) {
  EXPECT_EXIT(
      {
        run::catch_interrupts();
        const run::EndAtOnce at_once("nothing was saved\n", 42);
        std::raise(SIGINT);
        std::exit(0);
      },
      ::testing::ExitedWithCode(42), "nothing was saved\n");
  EXPECT_EXIT(
      {
        run::catch_interrupts();
        { const run::EndAtOnce at_once("nothing was saved\n", 42); }
        std::raise(SIGINT);
        std::exit(run::interrupt_requested() ? 0 : 1);
      },
      ::testing::ExitedWithCode(0), "");
}

TEST(Interrupts, OfACallingProgramDoNotEndTheProcess) {
  EXPECT_EXIT(
      {
        run::catch_interrupts();
        bool asked = false;
        const run::InterruptPoll poll([&asked] { return asked = true; });
        const run::EndAtOnce at_once("nothing was saved\n", 42);
        std::raise(SIGINT);
        std::exit(run::interrupt_requested() && asked ? 0 : 1);
      },
      ::testing::ExitedWithCode(0), "");
}

TEST(Interrupts, EndACheckBetweenTwoCards) {
  const TemporaryFolder folder;
  folder.write("a.deck", preliminary() + rectangle(0, 0, 1, 1) + "MOTION, 1\n");
  run::RunOptions options;
  options.deck = (folder / "a.deck").string();
  const run::InterruptPoll poll([] { return true; });
  EXPECT_EQ(run::build_checked(options).code, run::interrupted);
}

}  // namespace
}  // namespace blocks::testing
