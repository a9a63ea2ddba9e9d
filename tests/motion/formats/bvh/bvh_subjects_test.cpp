// BVH files of several figures: a ROOT for each, and the numbers of all in every frame.

#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "motion/formats/bvh/bvh.h"
#include "motion/formats/bvh/bvh_stream.h"
#include "motion/random_recording.h"
#include "motion/refusal.h"

namespace mien::motion {
namespace {

ReadOptions asking_for_figure(const std::string& subject) {
  ReadOptions options;
  options.subject = subject;
  return options;
}

struct BvhParts {
  std::string hierarchy;
  std::string counts;
  std::vector<std::string> frames;
};

BvhParts parts_of(const Recording& recording) {
  BvhParts parts;
  std::istringstream text(to_bvh(recording));
  std::string line;
  std::getline(text, line);
  while (std::getline(text, line) && line != "MOTION") parts.hierarchy += line + "\n";
  for (int i = 0; i < 2 && std::getline(text, line); ++i) parts.counts += line + "\n";
  while (std::getline(text, line)) parts.frames.push_back(line);
  return parts;
}

/// The figures one after the other in one file.
std::string together(const std::vector<Recording>& figures) {
  std::string text = "HIERARCHY\n";
  std::vector<std::string> frames(figures[0].poses.size());
  std::string counts;
  for (const Recording& figure : figures) {
    const BvhParts parts = parts_of(figure);
    text += parts.hierarchy;
    counts = parts.counts;
    for (size_t f = 0; f < frames.size(); ++f) frames[f] += parts.frames[f] + " ";
  }
  text += "MOTION\n" + counts;
  for (const std::string& frame : frames) text += frame + "\n";
  return text;
}

std::vector<Recording> three_figures() {
  std::mt19937_64 random(3);
  std::vector<Recording> figures;
  for (const int joints : {7, 1, 12}) {
    mien::test::RandomRecordingOptions options;
    options.joints = joints;
    options.frames = 5;
    figures.push_back(mien::test::random_recording(random, options));
    figures.back().frames_per_second = 60.0;
  }
  figures[0].skeleton.joints[0].name = "A:Hips";
  figures[1].skeleton.joints[0].name = "B:Hips";
  figures[2].skeleton.joints[0].name = "A:Hips";
  return figures;
}

void expect_same_motion(const Recording& read, const Recording& alone) {
  EXPECT_EQ(read.frames_per_second, alone.frames_per_second);
  ASSERT_EQ(read.skeleton.size(), alone.skeleton.size());
  EXPECT_TRUE(is_well_formed(read.skeleton));
  for (size_t j = 0; j < read.skeleton.joints.size(); ++j) {
    EXPECT_EQ(read.skeleton.joints[j].name, alone.skeleton.joints[j].name);
    EXPECT_EQ(read.skeleton.joints[j].parent, alone.skeleton.joints[j].parent);
    EXPECT_EQ(read.skeleton.joints[j].offset, alone.skeleton.joints[j].offset);
  }
  ASSERT_EQ(read.frame_count(), alone.frame_count());
  for (size_t f = 0; f < read.poses.size(); ++f) {
    EXPECT_EQ(read.poses[f].root_position, alone.poses[f].root_position);
    EXPECT_EQ(read.poses[f].offsets, alone.poses[f].offsets);
    for (size_t j = 0; j < read.poses[f].rotations.size(); ++j)
      EXPECT_EQ(read.poses[f].rotations[j].coeffs(), alone.poses[f].rotations[j].coeffs());
  }
}

TEST(BvhSubjects, AreReadAsFromFilesOfTheirOwn) {
  const std::vector<Recording> figures = three_figures();
  const std::string text = together(figures);
  const std::vector<std::string> names = {"A", "B", "A 3"};
  for (size_t i = 0; i < figures.size(); ++i) {
    const Recording alone = parse_bvh(to_bvh(figures[i]), "f.bvh");
    for (const std::string& wanted : {names[i], std::to_string(i + 1)}) {
      const Recording read = parse_bvh(text, "f.bvh", asking_for_figure(wanted));
      expect_same_motion(read, alone);
      EXPECT_EQ(read.subjects, names);
      EXPECT_EQ(read.subject, names[i]);
      EXPECT_TRUE(read.notes.empty());
    }
  }
}

TEST(BvhSubjects, AreTheFirstOneUnlessChosenAndThatIsTold) {
  const std::vector<Recording> figures = three_figures();
  const Recording read = parse_bvh(together(figures), "f.bvh");
  expect_same_motion(read, parse_bvh(to_bvh(figures[0]), "f.bvh"));
  ASSERT_EQ(read.notes.size(), 1u);
  EXPECT_EQ(read.notes[0],
            "The file holds 3 people (A, B, A 3); \"A\" is used, because no "
            "subject was chosen.");
}

TEST(BvhSubjects, ThatAreNotThereAreRefused) {
  const std::string text = together(three_figures());
  for (const char* wanted : {"C:Hips", "0", "4", "", "1x", "-1", "99999999999999999999999"}) {
    const std::string said =
        mien::test::refusal_of([&] { parse_bvh(text, "f.bvh", asking_for_figure(wanted)); });
    EXPECT_NE(said.find("there is no subject \""), std::string::npos) << said;
    EXPECT_NE(said.find("A, B, A 3"), std::string::npos) << said;
  }
}

TEST(BvhSubjects, WithoutChannelsCannotBeChosen) {
  const std::string text =
      "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\n}\nROOT b\n{\nOFFSET 0 0 0\nCHANNELS 1 Xrotation\n}\n"
      "MOTION\nFrames: 1\nFrame Time: 0.01\n10\n";
  EXPECT_NE(mien::test::refusal_of([&] { parse_bvh(text, "f.bvh"); }).find("no joint has channels"),
            std::string::npos);
  EXPECT_EQ(parse_bvh(text, "f.bvh", asking_for_figure("b")).skeleton.size(), 1);
}

TEST(BvhSubjects, AreTooManyForAStream) {
  BvhStream stream("f.bvh");
  stream.push(together(three_figures()));
  const std::string said = mien::test::refusal_of([&] { stream.next(); });
  EXPECT_NE(said.find("a second ROOT, but one figure alone can be streamed"), std::string::npos);
}

TEST(BvhSubjects, AreStreamedIfChosen) {
  const std::vector<Recording> figures = three_figures();
  const Recording alone = parse_bvh(to_bvh(figures[2]), "f.bvh");
  BvhStream stream("f.bvh", "A 3");
  stream.push(together(figures));
  stream.finish();
  for (const Pose& pose : alone.poses) {
    const std::optional<Pose> next = stream.next();
    ASSERT_TRUE(next);
    EXPECT_EQ(next->root_position, pose.root_position);
    for (size_t j = 0; j < pose.rotations.size(); ++j)
      EXPECT_EQ(next->rotations[j].coeffs(), pose.rotations[j].coeffs());
  }
  EXPECT_FALSE(stream.next());
}

TEST(BvhSubjects, OfAFileOfOneAreOnlyThatOne) {
  const std::string text = to_bvh(three_figures()[1]);
  EXPECT_EQ(parse_bvh(text, "f.bvh", asking_for_figure("B:Hips")).skeleton.size(), 1);
  EXPECT_EQ(parse_bvh(text, "f.bvh", asking_for_figure("1")).skeleton.size(), 1);
  const std::string said =
      mien::test::refusal_of([&] { parse_bvh(text, "f.bvh", asking_for_figure("Ann")); });
  EXPECT_NE(said.find("there is no subject \"Ann\"; it holds only \"B:Hips\""), std::string::npos)
      << said;
}

TEST(BvhSubjects, OfAFileOfOneAreNotListed) {
  const std::string text = to_bvh(three_figures()[1]);
  const Recording read = parse_bvh(text, "f.bvh");
  EXPECT_TRUE(read.subjects.empty());
  EXPECT_EQ(read.subject, "");
  EXPECT_EQ(to_bvh(read), text);
}

}  // namespace
}  // namespace mien::motion
