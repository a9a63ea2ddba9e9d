#include "pipeline/farm/queue_capacity.h"

#include <cmath>
#include <random>
#include <regex>

#include <gtest/gtest.h>

#include "motion/error.h"

namespace mien::pipeline {
namespace {

/// A study of so many seconds and frames, in one array.
struct Load {
  double seconds = 0.0;
  int frames = 0;

  Submission operator()(const Chunking& chunking) const {
    const double elements = chunking.chunk_frames > 0
                                ? std::ceil(double(frames) / chunking.chunk_frames)
                                : std::ceil(seconds / chunking.element_seconds);
    SubmissionJob job;
    job.job.elements = static_cast<int>(elements);
    job.elements.assign(static_cast<std::size_t>(elements), {{"film:a"}, 1.0, 10});
    Submission submission;
    submission.stages = {{2, {job}}};
    return submission;
  }
};

Chunking in_chunks(int frames) {
  Chunking chunking;
  chunking.chunk_frames = frames;
  return chunking;
}

std::string refusal_of(const Load& load, const Chunking& requested, const QueueCapacity& capacity) {
  try {
    fitting_submission(load, requested, 3600.0, capacity);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(QueueCapacity, IsOneLessThanSlurmSays) {
  EXPECT_TRUE((QueueCapacity{10, 4}.has_capacity_for(5)));
  EXPECT_FALSE((QueueCapacity{10, 4}.has_capacity_for(6)));
  EXPECT_TRUE((QueueCapacity{0, 4}.has_capacity_for(1'000'000))) << "limits unknown";
}

TEST(QueueCapacity, IsMadeByLongerElementsUnlessAChunkIsAskedFor) {
  const Load load{900.0 * 300.0, 9000};
  const FittingSubmission fitting = fitting_submission(load, {}, 3600.0, {400, 0});
  EXPECT_EQ(fitting.chunking.element_seconds, 1200.0);
  EXPECT_EQ(fitting.submission.elements(), 225);
  EXPECT_EQ(fitting_submission(load, {}, 3600.0, {1000, 0}).submission.elements(), 900);
  EXPECT_THROW(fitting_submission(load, {}, 600.0, {400, 0}), Error)
      << "they would not end in time";
  EXPECT_THROW(fitting_submission(load, in_chunks(10), 3600.0, {400, 0}), Error);
}

TEST(QueueCapacity, IsFoundOrAChunkIsNamedThatFits) {
  std::mt19937 random(5);
  const auto below = [&](int most) { return static_cast<int>(random() % unsigned(most)); };
  for (int i = 0; i < 300; ++i) {
    const Load load{1.0 + below(3'000'000), 1 + below(30'000)};
    const QueueCapacity capacity{3 + below(2000), 0};
    const Chunking requested = i % 2 == 0 ? in_chunks(1 + below(50)) : Chunking{};
    const std::string refusal = refusal_of(load, requested, capacity);
    if (refusal.empty()) {
      EXPECT_TRUE(capacity.has_capacity_for(
          fitting_submission(load, requested, 3600.0, capacity).submission.jobs()));
      continue;
    }
    EXPECT_FALSE(capacity.has_capacity_for(load(requested).jobs()));
    std::smatch named;
    ASSERT_TRUE(std::regex_search(refusal, named, std::regex(R"(--chunk (\d+) gives (\d+) jobs)")))
        << refusal;
    const int jobs = load(in_chunks(std::stoi(named[1]))).jobs();
    EXPECT_EQ(jobs, std::stoi(named[2]));
    EXPECT_TRUE(capacity.has_capacity_for(jobs)) << refusal;
  }
}

TEST(QueueCapacity, IsToldWithWhatSlurmHas) {
  const std::string told = refusal_of({1.0, 400}, in_chunks(10), {30, 12});
  EXPECT_EQ(told,
            "the study needs 41 jobs, but Slurm has room for 17: it accepts 29 jobs of all users "
            "(MaxJobCount) and has 12 now, including those that ended in the last minutes; --chunk "
            "40 gives 11 jobs; or wait until other jobs have ended");
}

TEST(QueueCapacity, IsNotAskedForByWhatMayBeNeedless) {
  EXPECT_EQ(fitting_submission(Load{}, in_chunks(5), 3600.0, {10, 10}).submission.elements(), 0);
}

TEST(QueueCapacity, IsMadeWithinHalfOfTheTimeLimit) {
  for (const auto& [limit, seconds] :
       {std::pair("", 3600.0), std::pair("20", 600.0), std::pair("20:30", 615.0),
        std::pair("1:00:00", 1800.0), std::pair("1-12:00:00", 3600.0), std::pair("0-1", 1800.0),
        std::pair("0-0:40", 1200.0), std::pair("soon", 3600.0), std::pair("0", 3600.0)}) {
    EXPECT_EQ(longest_element_seconds(limit), seconds) << limit;
  }
}

}  // namespace
}  // namespace mien::pipeline
