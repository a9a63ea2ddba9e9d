#include "motion/formats/motion_file.h"

#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "motion/formats/motion_format.h"
#include "motion/formats/mvnx/mvnx_text.h"
#include "motion/procedural/walker.h"
#include "motion/random_recording.h"
#include "motion/refusal.h"
#include "motion/rig/recording_clip.h"
#include "pipeline/temporary_folder.h"

namespace mien::motion {
namespace {

bool holds(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

TEST(MotionFormats, AreFoundByTheirEndingsInAnyCase) {
  std::set<std::string_view> endings;
  for (const MotionFormat& format : motion_formats()) {
    EXPECT_TRUE(endings.insert(format.ending).second) << format.ending;
    std::string name = "walk" + std::string(format.ending);
    EXPECT_EQ(motion_format(name), &format) << name;
    for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    EXPECT_EQ(motion_format(name), &format) << name;
    EXPECT_EQ(motion_format(name.substr(0, 4)), nullptr);
  }
}

TEST(MotionFormats, OfSkeletonsThatAreWrittenAreReadAgain) {
  const test::TemporaryFolder folder;
  std::mt19937_64 random(5);
  const Recording recording = test::random_recording(random);
  int written = 0;
  for (const MotionFormat& format : motion_formats()) {
    if (format.bytes_of_motion == nullptr || format.is_of_body) continue;
    const auto file = folder.path() / ("walk" + std::string(format.ending));
    write_motion(recording, file);
    const Recording read = read_motion(file);
    EXPECT_EQ(read.frame_count(), recording.frame_count()) << file;
    EXPECT_EQ(read.skeleton.size(), recording.skeleton.size()) << file;
    EXPECT_LT(test::largest_joint_distance(read, recording), 1e-3) << file;
    ++written;
  }
  EXPECT_EQ(written, 2);
}

TEST(MotionFormats, AreNamedWhereAnotherIsRefused) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() / "walk.txt") << "walk";
  const std::string read = test::refusal_of([&] { read_motion(folder.path() / "walk.txt"); });
  const std::string written = test::refusal_of([] { write_motion({}, "walk.txt"); });
  for (const MotionFormat& format : motion_formats()) {
    EXPECT_TRUE(holds(read, format.name) && holds(read, format.ending)) << read;
    EXPECT_EQ(holds(written, format.ending), format.is_written()) << written;
    if (format.has_takes) continue;
    const std::string single =
        test::refusal_of([&] { read_take("walk" + std::string(format.ending), "second"); });
    EXPECT_TRUE(holds(single, "holds one motion")) << single;
    EXPECT_TRUE(holds(single, formats_with_takes())) << single;
  }
  EXPECT_EQ(formats_read(),
            "BVH (.bvh), Acclaim (.amc), FBX (.fbx), glTF (.gltf, .glb), VRM (.vrma, .vrm), MVNX "
            "(.mvnx), C3D (.c3d), TRC (.trc), NumPy (.npz, .npy), tables of points (.csv, .tsv) or "
            "keypoints (.json)");
}

TEST(MotionFormats, AreNotAskedForWhereThereIsNoFileOrOnlyASkeleton) {
  const test::TemporaryFolder folder;
  const auto refusal = [&](const char* name) {
    return test::refusal_of([&] { read_motion(folder.path() / name); });
  };
  EXPECT_TRUE(holds(refusal("walk.pkl"), "walk.pkl: there is no such file")) << refusal("walk.pkl");
  std::ofstream(folder.path() / "02.asf") << "skeleton";
  EXPECT_TRUE(holds(refusal("02.asf"), "is the skeleton of Acclaim motions; name the motion"));
  std::ofstream(folder.path() / "02_02.amc") << "motion";
  std::ofstream(folder.path() / "02_01.amc") << "motion";
  EXPECT_TRUE(holds(refusal("02.asf"), "name the motion, 02_01.amc")) << refusal("02.asf");
}

TEST(MotionFormats, OfBytesAreNotMistakenForTheirText) {
  const test::TemporaryFolder folder;
  for (const char* name : {"a.glb", "a.vrm", "a.vrma", "a.npz"}) {
    std::ofstream(folder.path() / name) << "no motion";
    const std::string refusal = test::refusal_of([&] { read_motion(folder.path() / name); });
    EXPECT_TRUE(holds(refusal, name[2] == 'n' ? "is not an .npz file" : "is not a glTF file"))
        << refusal;
    EXPECT_FALSE(holds(refusal, "JSON")) << refusal;
  }
}

/// "… are read; … are written": what the page says of both.
TEST(MotionFormats, AreThoseOfTheirPage) {
  std::ifstream file(MIEN_SOURCE_DIR "/motion/README.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  const std::size_t first = page.find("## Formats");
  const std::size_t read_end = page.find(" are read;", first);
  const std::size_t written_end = page.find(" are written", read_end);
  ASSERT_NE(written_end, std::string::npos);
  const std::string read = page.substr(first, read_end - first);
  const std::string written = page.substr(read_end, written_end - read_end);
  for (const MotionFormat& format : motion_formats()) {
    const std::string ending = "`" + std::string(format.ending) + "`";
    EXPECT_TRUE(holds(read, ending) && holds(read, format.name)) << ending;
    EXPECT_EQ(holds(written, ending), format.is_written()) << ending;
    if (!format.part_ending.empty()) {
      EXPECT_TRUE(holds(read, "`" + std::string(format.part_ending) + "`")) << format.part_ending;
    }
  }
}

TEST(MotionFormats, OfAnyKindRefuseARateThatIsNone) {
  ReadOptions how;
  for (const double rate : {0.0, -3.0, 1e6, std::nan("")}) {
    how.frames_per_second = rate;
    EXPECT_TRUE(holds(test::refusal_of([&] { read_motion("walk.bvh", how); }), "frame rate"))
        << rate;
  }
}

TEST(MotionFormats, RefuseChoicesThatTheirFilesDoNotHave) {
  ReadOptions joints;
  joints.joints = {"a"};
  EXPECT_TRUE(holds(test::refusal_of([&] { read_motion("walk.bvh", joints); }), "names of"));
  ReadOptions person;
  person.subject = "Ann";
  EXPECT_TRUE(holds(test::refusal_of([&] { read_motion("walk.amc", person); }), "one person"));
  ReadOptions model;
  model.body_model = "SMPLX_NEUTRAL.npz";
  EXPECT_TRUE(holds(test::refusal_of([&] { read_motion("walk.bvh", model); }), "no SMPL motion"));
}

// A table of answers in a folder of motions is none of them.
TEST(MotionFormats, ThatOtherFilesHaveAsWellAreReadWhenNamed) {
  for (const char* name : {"a.csv", "a.tsv", "a.json", "a.npy", "a.npz"}) {
    EXPECT_TRUE(is_motion_file(name)) << name;
    EXPECT_FALSE(is_found_as_motion(name)) << name;
  }
  EXPECT_TRUE(is_found_as_motion("a.bvh.gz"));
  EXPECT_TRUE(is_found_as_motion("a.C3D"));
}

// From the file's name on: what the readers of bytes do is tested beside them.
TEST(MotionFormats, AreReadFromTheirFiles) {
  const test::TemporaryFolder folder;
  const Clip clip = walk({}, 60.0, standard_body()).clip;
  const auto file = [&](const char* name) { return folder.path() / name; };
  for (const char* name : {"walk.npy", "walk.npz", "walk.trc", "walk.csv",
                           "sub-01_task-walk_tracksys-joints_motion.tsv"})
    write_motion(to_recording(clip), file(name));
  std::ofstream(file("walk.mvnx")) << test::mvnx_document(test::mvnx_subject(clip));
  int formats = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(".json") || name.ends_with("_channels.tsv")) continue;  // of BIDS
    const Recording read = read_motion(entry.path());
    EXPECT_EQ(read.frame_count(), clip.frame_count()) << name;
    EXPECT_NEAR(read.frames_per_second, 60.0, 1e-6) << name;
    const Clip again = clip_of(read);
    ASSERT_TRUE(is_body(again.body)) << name;
    EXPECT_LT((joint_paths(again)[9][LeftKnee] - joint_paths(again)[9][Pelvis]).norm(), 0.7)
        << name;
    EXPECT_GT(joint_paths(again)[9][Pelvis].y(), 0.7) << name;
    ++formats;
  }
  EXPECT_EQ(formats, 6);
}

}  // namespace
}  // namespace mien::motion
