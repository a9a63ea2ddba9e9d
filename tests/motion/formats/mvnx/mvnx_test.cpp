#include "motion/formats/mvnx/mvnx.h"

#include <random>

#include <gtest/gtest.h>

#include "motion/formats/mvnx/mvnx_text.h"
#include "motion/handed_motion.h"
#include "motion/math/rotation.h"
#include "motion/procedural/walker.h"
#include "motion/refusal.h"
#include "motion/rig/body_mapping.h"
#include "motion/text/result_file.h"
#include "pipeline/temporary_folder.h"

namespace mien::motion {
namespace {

using namespace mien::test;

Clip walk_clip(int cycles = 1) {
  const Example example = walk({}, 60.0, standard_body());
  return repeated(example.clip, cycles);
}

ReadOptions asking_for(const std::string& subject) {
  ReadOptions options;
  options.subject = subject;
  return options;
}

/// A few frames of the walk.
Clip short_clip(size_t frames = 3) {
  Clip clip = walk_clip();
  clip.poses.resize(frames);
  return clip;
}

Clip t_pose_clip() {
  Clip clip = short_clip(2);
  for (Pose& pose : clip.poses)
    pose.rotations.assign(static_cast<size_t>(body_joint_count), Quat::Identity());
  return clip;
}

std::string with_word(std::string text, std::string_view word, std::string_view other) {
  const size_t at = text.find(word);
  EXPECT_NE(at, std::string::npos) << word;
  return text.replace(at, word.size(), other);
}

TEST(Mvnx, HoldsTheOriginsAndFramesOfTheSegments) {
  const Clip clip = walk_clip();
  const Recording recording = parse_mvnx(mvnx_text(clip), "walk.mvnx");
  EXPECT_EQ(recording.name, "walk");
  EXPECT_EQ(recording.format, "mvnx");
  EXPECT_EQ(recording.frames_per_second, 60.0);
  EXPECT_EQ(recording.subject, "Anna");
  EXPECT_EQ(recording.subjects, std::vector<std::string>{"Anna"});
  EXPECT_TRUE(recording.notes.empty()) << recording.notes.front();
  ASSERT_EQ(recording.frame_count(), clip.frame_count());
  ASSERT_TRUE(is_well_formed(recording.skeleton));
  ASSERT_EQ(recording.skeleton.size(), 23);
  for (size_t f = 0; f < clip.poses.size(); ++f) {
    const JointTransforms expected = world_transforms(clip.body, clip.poses[f]);
    const JointTransforms read = world_transforms(recording.skeleton, recording.poses[f]);
    for (const MvnSegment& segment : mvn_segments()) {
      const int j = find_joint(recording.skeleton, segment.name);
      ASSERT_GE(j, 0) << segment.name;
      const auto joint = static_cast<size_t>(j);
      const Quat& turn = expected.rotations[segment.follows];
      const Vec3 place = along_mvn(expected.positions[segment.follows] + turn * segment.place);
      EXPECT_LT((read.positions[joint] - place).norm(), 1e-6) << segment.name;
      const Vec3 axis = along_mvn(turn.vec());
      EXPECT_LT(angle_between(read.rotations[joint], Quat(turn.w(), axis.x(), axis.y(), axis.z())),
                1e-6);
    }
  }
}

TEST(Mvnx, HasTipsWhereChainsOfSegmentsEnd) {
  const Clip clip = short_clip();
  const Recording recording = parse_mvnx(mvnx_text(clip), "walk.mvnx");
  int tips = 0;
  for (const MvnSegment& segment : mvn_segments()) {
    const int j = find_joint(recording.skeleton, segment.name);
    const auto& tip = recording.skeleton.joints[static_cast<size_t>(j)].tip;
    const auto& expected = clip.body.joints[segment.follows].tip;
    ASSERT_EQ(tip.has_value(), expected.has_value()) << segment.name;
    if (!tip) continue;
    EXPECT_LT((*tip - along_mvn(*expected)).norm(), 1e-6);
    ++tips;
  }
  EXPECT_EQ(tips, 5);
}

/// What a walk along MVN's X becomes when its Z is turned up: a walk along +X.
Quat as_turned_up() { return Quat(Eigen::AngleAxisd(pi / 2.0, Vec3::UnitY())); }

TEST(Mvnx, OfAWalkIsThatWalkOnTheCanonicalBody) {
  const Clip clip = walk_clip(2);
  const Recording recording = parse_mvnx(mvnx_text(clip), "walk.mvnx");
  const BodyMapping mapping = recognise(recording);
  EXPECT_EQ(mapping.rig, "xsens-mvn");
  EXPECT_EQ(mapping.up, "+Z");
  EXPECT_GT(mapping.confidence, 0.95);
  EXPECT_EQ(mapping.metres_per_unit, 1.0);
  EXPECT_TRUE(mapping.warnings.empty()) << mapping.warnings.front();
  const Clip read = to_body(recording, mapping);
  double farthest = 0.0;
  double most_turned = 0.0;
  for (size_t f = 0; f < clip.poses.size(); ++f) {
    const JointTransforms expected = world_transforms(clip.body, clip.poses[f]);
    const JointTransforms got = world_transforms(read.body, read.poses[f]);
    for (size_t j = 0; j < size_t{body_joint_count}; ++j) {
      farthest =
          std::max(farthest, (got.positions[j] - as_turned_up() * expected.positions[j]).norm());
      most_turned = std::max(
          most_turned, angle_between(got.rotations[j], as_turned_up() * expected.rotations[j]));
    }
  }
  EXPECT_LT(farthest, 1e-6);
  EXPECT_LT(most_turned, 1e-6);
}

TEST(Mvnx, OfATPoseIsTheTPoseOfTheCanonicalBody) {
  const Clip read = to_body(parse_mvnx(mvnx_text(t_pose_clip()), "t.mvnx"));
  const JointTransforms got = world_transforms(read.body, read.poses[0]);
  for (size_t j = 0; j < size_t{body_joint_count}; ++j)
    EXPECT_LT(angle_between(got.rotations[j], as_turned_up()), 3.0 * radians_per_degree) << j;
  // Facing +X with +Y up, the left arm points along −Z.
  EXPECT_LT(got.positions[LeftWrist].z(), got.positions[Chest].z() - 0.5);
  EXPECT_GT(got.positions[RightWrist].z(), got.positions[Chest].z() + 0.5);
  EXPECT_GT(got.positions[LeftToe].x(), got.positions[LeftAnkle].x() + 0.05);
}

TEST(Mvnx, WithoutListsIsReadInTheOrderOfMvn) {
  const Clip clip = short_clip();
  const Recording whole = parse_mvnx(mvnx_text(clip), "walk.mvnx");
  const std::string text = mvnx_text(clip, {.has_segments = false, .has_joints = false});
  const Recording bare = parse_mvnx(text, "walk.mvnx");
  EXPECT_TRUE(same_rig(bare.skeleton, whole.skeleton));
  ASSERT_EQ(bare.notes.size(), 1u);
  EXPECT_NE(bare.notes[0].find("does not name its segments"), std::string::npos);
  // As is known of files that begin with <frames> and state no rate.
  const size_t from = text.find("<frames");
  const size_t to = text.find("</subject>");
  const Recording cut = parse_mvnx(text.substr(from, to - from), "walk.mvnx");
  EXPECT_TRUE(same_rig(cut.skeleton, whole.skeleton));
  EXPECT_NEAR(cut.frames_per_second, 60.0, 2.0);
  EXPECT_TRUE(cut.subjects.empty());
}

TEST(Mvnx, TakesTheParentsFromItsJoints) {
  const Clip clip = short_clip();
  std::string text = mvnx_text(clip);
  // A head on a bone that MVN does not have: the joints count, not the usual tree.
  text = with_word(text, "<connector1>Neck/jC1Head", "<connector1>T8/jC1Head");
  const Recording recording = parse_mvnx(text, "walk.mvnx");
  const auto head = static_cast<size_t>(find_joint(recording.skeleton, "Head"));
  EXPECT_EQ(recording.skeleton.joints[head].parent, find_joint(recording.skeleton, "T8"));
}

TEST(Mvnx, LeavesOutAPropAndSaysSo) {
  std::string text = mvnx_text(short_clip());
  text = with_word(text, "</segments>", "<segment label=\"Prop1\" id=\"24\"/></segments>");
  const auto add_to_each = [&](const std::string& end, const std::string& numbers) {
    for (size_t at = text.find(end); at != std::string::npos; at = text.find(end, at + 99))
      text.insert(at, numbers);
  };
  add_to_each("</orientation>", " 1 0 0 0");
  add_to_each("</position>", " 7 7 7");
  const Recording recording = parse_mvnx(text, "walk.mvnx");
  EXPECT_EQ(recording.skeleton.size(), 23);
  ASSERT_EQ(recording.notes.size(), 1u);
  EXPECT_EQ(recording.notes[0], "Segments that are connected to no other are left out: Prop1.");
}

Clip handed_clip() {
  std::mt19937_64 random(1);
  return with_moving_fingers(walk_clip(), random);
}

void expect_fingers(const Recording& recording, const Clip& clip) {
  EXPECT_TRUE(recording.notes.empty()) << recording.notes.front();
  EXPECT_EQ(recording.skeleton.size(), 23 + 2 * 20);
  const BodyMapping mapping = recognise(recording);
  EXPECT_TRUE(missing_finger_joints(mapping.hands).empty());
  const Clip read = to_body(recording, mapping);
  for (size_t f = 0; f < clip.poses.size(); ++f) {
    ASSERT_EQ(read.poses[f].fingers.size(), size_t(finger_joint_count));
    EXPECT_LT(largest_finger_turn(read.poses[f], clip.poses[f]), 1e-5) << f;
  }
}

TEST(Mvnx, HasTheTrackedFingersWhateverTheyAreSeenFrom) {
  const Clip clip = handed_clip();
  for (const MvnxHands hands : {MvnxHands::world, MvnxHands::hand}) {
    expect_fingers(parse_mvnx(mvnx_text(clip, {.hands = hands}), "a.mvnx"), clip);
    expect_fingers(parse_mvnx(mvnx_text(clip, {.hands = hands, .has_joints = false}), "a.mvnx"),
                   clip);
  }
}

TEST(Mvnx, LeavesOutAHandOfWhichNumbersAreMissingOrThatIsElsewhere) {
  const Clip clip = handed_clip();
  const std::string text = mvnx_text(clip, {.hands = MvnxHands::world});
  const std::string some = with_word(text, "<positionFingersLeft>", "<positionFingersLeft>1 2 3 ");
  const Recording left_out = parse_mvnx(some, "a.mvnx");
  EXPECT_EQ(left_out.skeleton.size(), 23 + 20);
  ASSERT_EQ(left_out.notes.size(), 1u);
  EXPECT_EQ(left_out.notes[0],
            "The finger tracking of the left hand is left out: not every frame has the numbers of "
            "all its segments.");
  const std::string far = with_word(text, "<positionFingersRight>", "<positionFingersRight>9");
  const Recording away = parse_mvnx(far, "a.mvnx");
  ASSERT_EQ(away.notes.size(), 1u);
  EXPECT_NE(away.notes[0].find("far from the hand"), std::string::npos) << away.notes[0];
}

TEST(Mvnx, OfSeveralPeopleGivesTheOneThatIsAskedFor) {
  const Clip clip = short_clip();
  Clip other = clip;
  for (Pose& pose : other.poses) pose.root_position.x() += 3.0;
  const std::string text =
      mvnx_document(mvnx_subject(clip) + mvnx_subject(other, {.subject = "Bert"}));
  const Recording first = parse_mvnx(text, "two.mvnx");
  EXPECT_EQ(first.subject, "Anna");
  ASSERT_EQ(first.notes.size(), 1u);
  EXPECT_NE(first.notes[0].find("(Anna, Bert); \"Anna\" is used"), std::string::npos);
  for (const char* wanted : {"Bert", "2"}) {
    const Recording second = parse_mvnx(text, "two.mvnx", asking_for(wanted));
    EXPECT_EQ(second.subject, "Bert");
    EXPECT_TRUE(second.notes.empty());
    EXPECT_NEAR(second.poses[0].root_position.y(), first.poses[0].root_position.y() + 3.0, 1e-6);
  }
  EXPECT_NE(refusal_of([&] {
              parse_mvnx(text, "two.mvnx", asking_for("Carl"));
            }).find("there is no subject \"Carl\"; it holds Anna, Bert"),
            std::string::npos);
}

TEST(Mvnx, TakesItsRateFromTheTimesWhenTheyContradictIt) {
  const Clip clip = walk_clip();
  const auto read = [&](const MvnxLook& look, const ReadOptions& options = {}) {
    return parse_mvnx(mvnx_text(clip, look), "walk.mvnx", options);
  };
  EXPECT_EQ(read({.rate = "frameRate=\"240\"", .milliseconds = 1000.0 / 240.0}).frames_per_second,
            240.0);
  const Recording contradicted = read({.rate = "frameRate=\"240\""});
  EXPECT_NEAR(contradicted.frames_per_second, 60.0, 0.5);
  ASSERT_EQ(contradicted.notes.size(), 1u);
  EXPECT_NE(contradicted.notes[0].find("states 240 Hz"), std::string::npos);
  EXPECT_EQ(read({.milliseconds = 0.0}).frames_per_second, 60.0);
  ReadOptions at_50;
  at_50.frames_per_second = 50.0;
  EXPECT_EQ(read({}, at_50).frames_per_second, 60.0);
  EXPECT_EQ(read({.rate = "", .milliseconds = 0.0}, at_50).frames_per_second, 50.0);
  EXPECT_EQ(read({.rate = ""}).notes.size(), 1u);
  EXPECT_NE(refusal_of([&] {
              read({.rate = "", .milliseconds = 0.0});
            }).find("the frame rate is not stated; give it with fps:"),
            std::string::npos);
}

TEST(Mvnx, SaysWhenBonesAreNotOfOneLength) {
  Clip clip = short_clip(9);
  std::string text = mvnx_text(clip);
  const size_t last = text.rfind("<position>") + 10;
  const size_t second = text.find(' ', text.find(' ', text.find(' ', last) + 1) + 1) + 1;
  text.replace(second, text.find(' ', second) - second, "9");
  const Recording recording = parse_mvnx(text, "walk.mvnx");
  ASSERT_EQ(recording.notes.size(), 1u);
  EXPECT_NE(recording.notes[0].find("\"L5\" by up to"), std::string::npos) << recording.notes[0];
  // The median is not moved by one bad frame.
  EXPECT_TRUE(same_rig(recording.skeleton, parse_mvnx(mvnx_text(clip), "a.mvnx").skeleton));
}

TEST(Mvnx, RefusesWhatIsNotThere) {
  const std::string good = mvnx_text(short_clip());
  struct Case {
    std::string text;
    std::string words;
  };
  const std::vector<Case> cases = {
      {"", "f.mvnx:1:1: the file is truncated"},
      {"<svg></svg>", "f.mvnx:1:1: is XML, but not MVNX: it begins with <svg>"},
      {"<mvnx></mvnx>", "there is no subject"},
      {"<mvnx><subject frameRate=\"60\"/></mvnx>", "f.mvnx:1:7: there are no frames of type"},
      {mvnx_text(short_clip(), {.has_positions = false}), "have no positions of the segments"},
      {with_word(good, "</points>", "</pints>"), "this is not well-formed XML (mismatched tag)"},
      {with_word(good, "type=\"normal\"", "type=\"other\""), ""},
      {with_word(good, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n",
                 "<!DOCTYPE a [<!ENTITY b \"c\">]>"),
       "f.mvnx:1:13: a document type (DOCTYPE) is declared"},
      {with_word(good, "A &amp; B", "A &b; B"), "this is not well-formed XML (undefined entity)"},
      {with_word(good, "frameRate=\"60\"", "frameRate=\"sixty\""),
       "\"sixty\" is not a valid number"},
      {with_word(good, "frameRate=\"60\"", "frameRate=\"-1\""), "a frame rate of -1 Hz"},
      {with_word(good, "<connector1>Neck/jC1Head", "<connector1>Head/jC1Head"), ""},
      {with_word(good, "<connector2>Head/jC1Head", "<connector2>Neck/jC1Head"),
       "segment \"Neck\" has two parents"},
      {with_word(good, "<segment label=\"Head\" id=\"7\">", "<other>"), "mismatched tag"},
      {with_word(good, "<segments>", "<segments><segment label=\"Prop\"/>"),
       "a frame has 23 segments, but 24 are listed"},
      {with_word(good, "<pos_b>0 0 0", "<pos_b>0 0"), "pos_b has 2 numbers, not 3"},
      {with_word(good, "<pos_b>0 0 0", "<pos_b>0 0 nan"), "\"nan\" is not a valid number"},
      {with_word(good, "<pos_b>0 0 0", "<pos_b>0 0,5 1"), "\"0,5\" is not a valid number"},
  };
  for (const Case& bad : cases) {
    if (bad.words.empty()) {
      EXPECT_NO_THROW(parse_mvnx(bad.text, "f.mvnx"));
      continue;
    }
    const std::string said = refusal_of([&] { parse_mvnx(bad.text, "f.mvnx"); });
    EXPECT_NE(said.find(bad.words), std::string::npos) << said << "\nlacks: " << bad.words;
    EXPECT_NE(said.find("; "), std::string::npos) << "no remedy: " << said;
  }
}

/// The text with the n-th element of that name of a normal frame changed.
std::string with_frame_part(std::string text, const std::string& name, int frame,
                            const std::function<std::string(std::string)>& change) {
  size_t at = 0;
  for (int f = 0; f <= frame; ++f) at = text.find("type=\"normal\"", at + 1);
  const size_t from = text.find("<" + name + ">", at);
  const size_t to = text.find("</" + name + ">", from) + name.size() + 3;
  return text.replace(from, to - from, change(text.substr(from, to - from)));
}

TEST(Mvnx, RefusesFramesThatDiffer) {
  const std::string good = mvnx_text(short_clip());
  const auto said = [&](const std::string& name, int frame,
                        const std::function<std::string(std::string)>& change) {
    return refusal_of([&] { parse_mvnx(with_frame_part(good, name, frame, change), "f.mvnx"); });
  };
  const auto nothing = [](const std::string&) { return std::string(); };
  const auto twice = [](const std::string& part) { return part + part; };
  const auto longer = [](std::string part) { return part.insert(part.find('>') + 1, "1 0 0 0 "); };
  const auto expect = [](const std::string& text, const std::string& words) {
    EXPECT_NE(text.find(words), std::string::npos) << text << "\nlacks: " << words;
  };
  expect(said("orientation", 1, nothing), "frame 2 has no orientation");
  expect(said("position", 1, nothing), "frame 2 has no position, unlike those before it");
  expect(said("position", 0, nothing), "frame 1 has no position, unlike a later one");
  expect(said("position", 2, twice), "a second position in frame 3");
  expect(said("orientation", 1, longer), "orientation of frame 2 has 96 numbers, not 92");
  expect(said("orientation", 0, longer), "orientation of frame 2 has 92 numbers, not 96");
  expect(said("position", 0, longer), "position of frame 2 has 69 numbers, not 73");
  expect(said("orientation", 1,
              [](std::string part) {
                const size_t at = part.find('>') + 1;
                size_t end = at;
                for (int i = 0; i < 4; ++i) end = part.find(' ', end + 1);
                return part.replace(at, end - at, "0 0 0 0");
              }),
         "the orientation of \"Pelvis\" in frame 2 is of length zero");
}

TEST(Mvnx, DoesNotGrowWithEntities) {
  std::string bomb = "<?xml version=\"1.0\"?><!DOCTYPE m [<!ENTITY a0 \"x\">";
  for (int i = 1; i < 40; ++i) {
    const std::string before = "&a" + std::to_string(i - 1) + ";";
    bomb += "<!ENTITY a" + std::to_string(i) + " \"" + before + before + "\">";
  }
  bomb += "]><mvnx><comment>&a39;</comment></mvnx>";
  EXPECT_NE(refusal_of([&] { parse_mvnx(bomb, "f.mvnx"); }).find("DOCTYPE"), std::string::npos);
}

TEST(Mvnx, RefusesDeepTagsAndEndlessOnes) {
  std::string deep = "<mvnx>";
  for (int i = 0; i < 1000; ++i) deep += "<a>";
  EXPECT_NE(refusal_of([&] { parse_mvnx(deep, "f.mvnx"); }).find("nested more than 64 deep"),
            std::string::npos);
  const std::string endless = "<mvnx><a b=\"" + std::string(size_t{8} << 20, 'x');
  EXPECT_NE(refusal_of([&] { parse_mvnx(endless, "f.mvnx"); }).find("a tag or comment of more"),
            std::string::npos);
}

TEST(Mvnx, CutShortAnywhereIsRefused) {
  const std::string good = mvnx_text(short_clip(1), {.has_calibration = false});
  for (size_t length = 0; length + 2 < good.size(); ++length)
    EXPECT_THROW(parse_mvnx(good.substr(0, length), "f.mvnx"), Error) << length;
}

TEST(Mvnx, ChangedAnywhereIsReadOrRefused) {
  const std::string good = mvnx_text(short_clip(2));
  std::mt19937_64 random(5);
  for (int trial = 0; trial < 200; ++trial) {
    std::string text = good;
    for (int i = 0; i < 3; ++i)
      text[random() % text.size()] =
          static_cast<char>(random() % 2 ? random() : good[random() % good.size()]);
    try {
      const Recording recording = parse_mvnx(text, "f.mvnx");
      EXPECT_TRUE(is_well_formed(recording.skeleton));
      for (const Pose& pose : recording.poses) EXPECT_TRUE(pose.root_position.allFinite());
    } catch (const Error& error) {
      EXPECT_LT(std::string(error.what()).size(), 400u);
    }
  }
}

TEST(Mvnx, IsReadFromAFile) {
  const TemporaryFolder folder;
  write_result(folder.path() / "a.mvnx", mvnx_text(short_clip()));
  EXPECT_EQ(read_mvnx(folder.path() / "a.mvnx").frame_count(), 3);
  write_result(folder.path() / "b.mvnx", "HIERARCHY\n");
  EXPECT_NE(refusal_of([&] { read_mvnx(folder.path() / "b.mvnx"); }).find("is a BVH file"),
            std::string::npos);
}

}  // namespace
}  // namespace mien::motion
