#include "motion/stream/streamed_modification.h"

#include <algorithm>
#include <iostream>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "motion/modify/path_measures.h"
#include "motion/modify/real_takes.h"
#include "motion/refusal.h"
#include "motion/stream/look_ahead.h"
#include "motion/stream/streamed_motions.h"

namespace mien::motion {
namespace {

using namespace mien::test;

Modification with_paths(double paths) {
  Modification modification;
  modification.paths = paths;
  modification.repair = FootRepair::none;
  return modification;
}

Modification with_turns(std::vector<PostureChange> turns) {
  Modification modification;
  modification.posture = std::move(turns);
  modification.repair = FootRepair::none;
  return modification;
}

Modification without_limits(Modification modification) {
  modification.soft_joint_limits = false;
  return modification;
}

double error_of(const Clip& clip, const Modification& modification, const StreamDelay& delay) {
  return stream_error(streamed(clip, modification, delay), modified(clip, modification))
      .largest_metres;
}

TEST(StreamedModification, OfPathsIsTheOfflineOneWhenItLooksAheadFarEnough) {
  for (const double rate : {24.0, 30.0, 60.0, 100.0, 120.0}) {
    const Clip walk = performed("walks-10", rate).front();
    for (const double paths : {0.0, 0.5, 1.3, 2.0}) {
      const Modification change = with_paths(paths);
      const int reach = path_reach(path_mix(change).gains, rate);
      EXPECT_LT(error_of(walk, without_limits(change), {reach, 0, 0}), 1e-9)
          << rate << " " << paths;
      EXPECT_LT(error_of(walk, change, {walk.frame_count(), 0, 0}), 1e-9) << rate << " " << paths;
    }
  }
}

TEST(StreamedModification, OfASingleStepIsTheOfflineOne) {
  // So short that it holds fewer bands than a longer motion.
  Clip clip = performed("walks-10").front();
  for (const size_t frames : {2u, 3u, 5u, 9u}) {
    Clip part = clip;
    part.poses.resize(frames);
    EXPECT_LT(error_of(part, with_paths(2.0), {40, 0, 0}), 1e-9) << frames;
  }
}

TEST(StreamedModification, OfGainsOfBandsIsTheOfflineOne) {
  Modification change = with_paths(1.0);
  change.gains = PathGains{1.0, 1.0, 1.0, {0.2, 1.7, 1.0, 0.6, 1.2}};
  const Clip walk = performed("walks-10", 60.0).front();
  const int reach = path_reach(*change.gains, 60.0);
  EXPECT_EQ(reach, 62);
  EXPECT_LT(error_of(walk, change, {reach, 0, 0}), 1e-9);
  EXPECT_GT(error_of(walk, change, {reach - 20, 0, 0}), 1e-9);
}

TEST(StreamedModification, OfTrunkAndHeadIsTheOfflineOneAtOnce) {
  Modification change = with_turns({{PostureUnit::head_flexion, 25.0},
                                    {PostureUnit::chest_flexion, -10.0},
                                    {PostureUnit::pelvis_tilt, 5.0}});
  change.soft_joint_limits = false;
  for (const Clip& clip : performed("actors")) {
    EXPECT_EQ(error_of(clip, change, {}), 0.0) << clip.name;
  }
}

TEST(StreamedModification, OfLimbsComesNearerTheOfflineOneTheFurtherItLooksAhead) {
  const Modification change =
      with_turns({{PostureUnit::shoulder_abduction, 20.0}, {PostureUnit::elbow_flexion, 25.0}});
  double worst = 0.0;
  for (const Clip& clip : performed("actors")) {
    const double at_once = error_of(clip, change, {});
    EXPECT_LE(error_of(clip, change, {0, 0, 6}), at_once + 1e-12) << clip.name;
    EXPECT_LT(error_of(clip, change, {0, 0, 1000}), 1e-9) << clip.name;
    worst = std::max(worst, at_once);
  }
  EXPECT_GT(worst, 0.001);
  EXPECT_LT(worst, 0.04);
}

TEST(StreamedModification, DoesNotDependOnWhatComesLaterThanItsDelay) {
  Modification change = with_turns({{PostureUnit::shoulder_flexion, 15.0}});
  change.paths = 1.8;
  change.acceleration = 0.7;
  const StreamDelay delay = {9, 2, 3};
  const Clip whole = performed("actors").front();
  const size_t first = whole.poses.size() / 2;
  const Clip one = streamed(whole, change, delay);
  const Clip other = streamed(changed_from(whole, first), change, delay);
  ASSERT_EQ(one.frame_count(), other.frame_count());
  const size_t same = first - static_cast<size_t>(delay.frames());
  for (size_t f = 0; f < same; ++f) {
    EXPECT_EQ(one.poses[f].root_position, other.poses[f].root_position) << f;
    for (size_t j = 0; j < one.poses[f].rotations.size(); ++j) {
      EXPECT_EQ(one.poses[f].rotations[j].coeffs(), other.poses[f].rotations[j].coeffs()) << f;
    }
  }
  EXPECT_NE(one.poses[same].rotations[LeftElbow].coeffs(),
            other.poses[same].rotations[LeftElbow].coeffs());
}

TEST(StreamedModification, GivesEachFrameAsLateAsItSays) {
  Modification change = with_turns({{PostureUnit::head_flexion, 15.0}});
  change.paths = 0.5;
  change.acceleration = -0.5;
  const StreamDelay delay = {4, 2, 1};
  const Clip clip = performed("walks-10").front();
  StreamedModification stream(clip.body, clip.frames_per_second, change, delay);
  EXPECT_EQ(stream.delay().frames(), 7);
  int given = 0;
  for (int f = 0; f < clip.frame_count(); ++f) {
    const std::optional<Pose> pose = stream.push(clip.poses[static_cast<size_t>(f)]);
    EXPECT_EQ(pose.has_value(), f >= 7) << f;
    if (!pose) continue;
    EXPECT_EQ(pose->root_position, clip.poses[static_cast<size_t>(given)].root_position);
    ++given;
  }
  EXPECT_EQ(given + static_cast<int>(stream.finish().size()), clip.frame_count());
}

TEST(StreamedModification, DelaysOnlyWhatItChanges) {
  const Skeleton body = standard_body();
  const StreamDelay asked = {15, 5, 3};
  EXPECT_EQ(StreamedModification(body, 30.0, {}, asked).delay().frames(), 0);
  EXPECT_EQ(StreamedModification(body, 30.0, with_paths(1.2), asked).delay().frames(), 15);
  const Modification turned = with_turns({{PostureUnit::head_turn, 5.0}});
  EXPECT_EQ(StreamedModification(body, 30.0, turned, asked).delay().frames(), 3);
}

TEST(StreamedModification, OfTheUpperBodyLeavesTheFeetWhereTheyStand) {
  const Clip walk = performed("actors").front();
  const Clip longer =
      streamed(walk, without_limits(with_paths(2.0)), {15, 0, 0}, PathScope::upper_body);
  const auto before = joint_paths(walk);
  const auto after = joint_paths(longer);
  for (size_t f = 0; f < before.size(); ++f) {
    for (const BodyJoint joint : {LeftAnkle, LeftToe, RightAnkle, RightToe}) {
      EXPECT_EQ(before[f][joint], after[f][joint]) << f;
    }
  }
  EXPECT_GT(path_length(longer, LeftWrist), 1.3 * path_length(walk, LeftWrist));
}

TEST(StreamedModification, OfNothingGivesTheSameFramesAtOnce) {
  const Clip clip = performed("walks-10").front();
  EXPECT_EQ(stream_error(streamed(clip, {}, {15, 5, 3}), clip).largest_metres, 0.0);
}

TEST(StreamedModification, RefusesWhatCannotBeStreamed) {
  const auto refused = [](auto change) {
    Modification modification;
    change(modification);
    return refusal_of([&] { check_streamable(modification); });
  };
  EXPECT_NE(refused([](auto& m) { m.tempo = 0.8; }).find("fall behind without limit"),
            std::string::npos);
  EXPECT_NE(refused([](auto& m) { m.tempo = 1.2; }).find("need future frames"), std::string::npos);
  EXPECT_NE(refused([](auto& m) { m.variation = 0.3; }).find("variation"), std::string::npos);
  for (const auto place : {AccelerationPlace::contacts, AccelerationPlace::hits}) {
    EXPECT_NE(refused([place](auto& m) {
                m.acceleration = 0.3;
                m.acceleration_place = place;
              }).find("pauses"),
              std::string::npos);
  }
  EXPECT_NE(refused([](auto& m) {
              m.paths = 1.2;
              m.signal = RotationSignal::quaternions;
            }).find("direction-vectors"),
            std::string::npos);
  EXPECT_NE(refused([](auto& m) {
              m.gains = PathGains{};
              m.gains->bands.assign(13, 1.1);
            }).find("12 bands"),
            std::string::npos);
  EXPECT_NE(refused([](auto& m) { m.paths = 3.0; }).find("from 0 to 2"), std::string::npos);
}

TEST(LookAhead, KeepsBuiltInMotionsWithinACentimetre) {
  for (const double rate : {30.0, 60.0, 120.0}) {
    const Modification change = without_limits(with_paths(2.0));
    const int frames = shortest_look_ahead(change, rate);
    EXPECT_NEAR(frames / rate, 0.54, 0.06) << rate;
    for (const Clip& clip : performed("walks-27", rate, 2)) {
      EXPECT_LT(error_of(clip, change, {frames, 0, 0}), largest_stream_error)
          << clip.name << " at " << rate;
    }
  }
}

TEST(LookAhead, IsTheShorterTheLessIsChanged) {
  const int least = shortest_look_ahead(with_paths(1.1), 30.0);
  const int middle = shortest_look_ahead(with_paths(1.5), 30.0);
  const int most = shortest_look_ahead(with_paths(2.0), 30.0);
  EXPECT_LT(least, middle);
  EXPECT_LT(middle, most);
  EXPECT_EQ(shortest_look_ahead(with_paths(1.0), 30.0), 0);
  EXPECT_GT(shortest_look_ahead(with_paths(1.5), 30.0, 0.001), middle);
}

TEST(LookAhead, KeepsRealMotionsWithinACentimetre) {
  std::vector<Clip> takes = real_takes("bandai-namco-1", "_00");
  if (takes.empty()) GTEST_SKIP() << "no motion capture here: set MIEN_DATA";
  const std::vector<Clip> runs = real_takes("aalto-two-actors", "_run_");
  takes.insert(takes.end(), runs.begin(), runs.end());
  for (const double paths : {0.0, 1.4, 2.0}) {
    double worst = 0.0;
    double worst_with_limits = 0.0;
    std::map<double, int> known;
    for (const Clip& take : takes) {
      const Modification change = with_paths(paths);
      const double rate = take.frames_per_second;
      if (!known.contains(rate)) known[rate] = shortest_look_ahead(change, rate);
      const StreamDelay delay = {known[rate], 0, 0};
      const double error = error_of(take, without_limits(change), delay);
      EXPECT_LT(error, largest_stream_error) << take.name << " " << paths;
      worst = std::max(worst, error);
      worst_with_limits = std::max(worst_with_limits, error_of(take, change, delay));
    }
    EXPECT_LT(worst_with_limits, 0.1);
    std::cout << takes.size() << " takes, paths " << paths << ": " << 1000.0 * worst
              << " mm, with joint limits " << 1000.0 * worst_with_limits << " mm\n";
  }
}

TEST(LookAhead, SharesOutADelay) {
  Modification change = with_paths(1.5);
  EXPECT_EQ(split_delay(20, change, 30.0).paths, 20);
  EXPECT_EQ(split_delay(50, change, 30.0).paths, 33);
  EXPECT_EQ(split_delay(50, change, 30.0).posture, 17);
  change.acceleration = 0.5;
  EXPECT_EQ(split_delay(50, change, 30.0).timing, 17);
  change.paths = 1.0;
  EXPECT_EQ(split_delay(50, change, 30.0).timing, 50);
}

}  // namespace
}  // namespace mien::motion
