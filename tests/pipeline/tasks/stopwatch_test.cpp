#include "pipeline/tasks/stopwatch.h"

#include <thread>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

using namespace std::chrono_literals;

TEST(Stopwatch, StandsStillUntilSomethingRuns) {
  const Stopwatch watch;
  std::this_thread::sleep_for(2ms);
  EXPECT_EQ(watch.seconds(), 0.0);
}

TEST(Stopwatch, CountsTimeOnceHoweverManyRun) {
  Stopwatch watch;
  const auto start = std::chrono::steady_clock::now();
  {
    const Stopwatch::Running outer(&watch);
    const Stopwatch::Running inner(&watch);
    std::this_thread::sleep_for(5ms);
  }
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  EXPECT_GE(watch.seconds(), 0.005);
  EXPECT_LE(watch.seconds(), passed.count());
}

TEST(Stopwatch, MayBeAbsent) { const Stopwatch::Running none(nullptr); }

}  // namespace
}  // namespace mien::pipeline
