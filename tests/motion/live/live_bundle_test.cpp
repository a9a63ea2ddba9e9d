#include "motion/live/live_bundle.h"

#include <cstring>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/live/bytes.h"
#include "motion/live/live_core.h"
#include "motion/live/small_bundle.h"

namespace mien::motion {
namespace {

constexpr std::size_t head_bytes = 32;

/// With a checksum and a length that fit what has become of the rest.
std::string sealed(std::string bytes) {
  const std::string_view body = std::string_view(bytes).substr(head_bytes);
  const std::uint64_t length = body.size();
  const std::uint64_t sum = checksum(body);
  std::memcpy(bytes.data() + 16, &length, 8);
  std::memcpy(bytes.data() + 24, &sum, 8);
  return bytes;
}

TEST(LiveBundle, ComesBackToTheLastBit) {
  const LiveBundle bundle = test::small_bundle();
  const std::string bytes = to_bytes(bundle);
  const LiveBundle read = parse_live_bundle(bytes);
  EXPECT_EQ(to_bytes(read), bytes);
  EXPECT_EQ(read.info, bundle.info);
  EXPECT_EQ(read.how, bundle.how);
  ASSERT_EQ(read.examples.examples.size(), bundle.examples.examples.size());
  EXPECT_EQ(read.examples.examples[2].keytimes, bundle.examples.examples[2].keytimes);
  EXPECT_EQ(read.adjectives.values, bundle.adjectives.values);
  ASSERT_EQ(read.targets.size(), 1u);
  EXPECT_EQ(read.targets[0].playback.cycles, 3);
}

TEST(LiveBundle, RefusesEveryCutAndEveryChangedByte) {
  const std::string bytes = to_bytes(test::small_bundle());
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 400; ++trial) {
    const std::size_t place = random() % bytes.size();
    EXPECT_THROW(parse_live_bundle(bytes.substr(0, place)), Error);
    std::string changed = bytes;
    changed[place] = static_cast<char>(changed[place] ^ (1 << random() % 8));
    EXPECT_THROW(parse_live_bundle(changed), Error) << "byte " << place;
  }
  EXPECT_THROW(parse_live_bundle(bytes + "x"), Error);
  EXPECT_THROW(parse_live_bundle(""), Error);
}

TEST(LiveBundle, NeedsNoChecksumToRefuseWhatCannotBeUsed) {
  const std::string bytes = to_bytes(test::small_bundle());
  std::mt19937_64 random(4);
  int refused = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    std::string changed = bytes;
    // Counts and choices lie at the start of things: small numbers more often than not.
    const std::size_t place = head_bytes + random() % (bytes.size() - head_bytes - 4);
    const auto count = static_cast<std::int32_t>(random() >> (32 + random() % 32));
    if (trial % 3 == 0) std::memcpy(changed.data() + place, &count, 4);
    if (trial % 3 == 1) changed[place] = static_cast<char>(random());
    if (trial % 3 == 2) changed.resize(place);
    try {
      const LiveBundle read = parse_live_bundle(sealed(changed));
      LiveCore core(read);
      core.make({InterfaceKind::weights, {read.examples.examples[0].name}, {1.0}});
    } catch (const Error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 500);
}

TEST(LiveBundle, RefusesExamplesThatCannotBeBlended) {
  const auto refuses = [](const auto& change) {
    LiveBundle bundle = test::small_bundle();
    change(bundle);
    EXPECT_THROW(parse_live_bundle(to_bytes(bundle)), Error);
  };
  refuses([](LiveBundle& b) { b.examples.examples[1].keytimes.pop_back(); });
  refuses([](LiveBundle& b) {
    std::swap(b.examples.examples[0].keytimes[1], b.examples.examples[0].keytimes[2]);
  });
  refuses([](LiveBundle& b) { b.examples.examples[1].clip.poses.resize(1); });
  refuses([](LiveBundle& b) { b.examples.examples[1].clip.loops = false; });
  refuses([](LiveBundle& b) { b.examples.examples[0].clip.body.joints.pop_back(); });
  refuses([](LiveBundle& b) { b.examples.examples[0].clip.body.joints[3].parent = 7; });
  refuses(
      [](LiveBundle& b) { b.adjectives.values.conservativeResize(b.adjectives.values.rows(), 1); });
  refuses([](LiveBundle& b) { b.features.names[0] = "brightness"; });
  refuses([](LiveBundle& b) { b.frames_per_second = 0.0; });
  refuses([](LiveBundle& b) { b.playback.cycles = 0; });
  refuses([](LiveBundle& b) { b.how.weights.grid_cells = 1'000'000; });
  refuses([](LiveBundle& b) {
    b.examples.examples[0].clip.poses[4].root_position.x() =
        std::numeric_limits<double>::quiet_NaN();
  });
  refuses([](LiveBundle& b) { b.targets[0].motion.clip.poses[0].rotations.pop_back(); });
}

TEST(LiveBundle, SaysWhichVersionItIsOf) {
  std::string bytes = to_bytes(test::small_bundle());
  bytes[8] = 9;
  try {
    parse_live_bundle(bytes);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("version 9"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace mien::motion
