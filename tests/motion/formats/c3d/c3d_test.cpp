#include "motion/formats/c3d/c3d.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "motion/formats/c3d/written_c3d.h"
#include "motion/refusal.h"

using mien::test::refusal_of;
using mien::test::WrittenC3d;

namespace mien::motion {
namespace {

/// Two points in three frames; the second is missing in the middle one.
WrittenC3d small_file() {
  WrittenC3d file;
  file.frames = {{{{100.0, -250.5, 1000.0, 0.0}, {1.5, 2.0, -3.5, 2.0}}},
                 {{{101.0, -251.5, 1001.0, 0.0}, {0.0, 0.0, 0.0, -1.0}}},
                 {{{102.0, -252.5, 1002.0, 0.0}, {3.5, 4.0, -5.5, 0.0}}}};
  return file;
}

ReadOptions with_subject(const std::string& subject) {
  ReadOptions options;
  options.subject = subject;
  return options;
}

ReadOptions with_rate(double frames_per_second) {
  ReadOptions options;
  options.frames_per_second = frames_per_second;
  return options;
}

bool has_note(const std::vector<std::string>& notes, const std::string& words) {
  for (const std::string& note : notes) {
    if (note.find(words) != std::string::npos) return true;
  }
  return false;
}

void expect_refusal(const std::string& bytes, const std::string& words,
                    const ReadOptions& options = {}) {
  const std::string said = refusal_of([&] { parse_c3d(bytes, "walk.c3d", options); });
  EXPECT_TRUE(said.starts_with("walk.c3d:")) << said;
  EXPECT_NE(said.find(words), std::string::npos) << said << "\nlacks: " << words;
  EXPECT_NE(said.find("; "), std::string::npos) << "no remedy: " << said;
}

TEST(C3d, StatesTheAxisThatIsUpOnTheScreen) {
  const auto screen = [](const std::string& right, const std::string& up) {
    WrittenC3d file = small_file();
    file.more = (right.empty() ? "" : file.texts(1, "X_SCREEN", {right})) +
                (up.empty() ? "" : file.texts(1, "Y_SCREEN", {up}));
    return parse_c3d(file.bytes(), "walk.c3d");
  };
  EXPECT_EQ(screen("", "").stated_up, "");
  EXPECT_EQ(screen("+X", "").stated_up, "");
  EXPECT_EQ(screen("+X", "+Z").stated_up, "+Z");
  EXPECT_EQ(screen("-Y", "-x").stated_up, "-X");
  EXPECT_EQ(screen("", "Y").stated_up, "+Y");
  EXPECT_TRUE(screen("+X", "+Z").notes.empty());
  for (const char* wrong : {"+X", "up", "+", "++Z", "+A", "\xff"}) {
    const PointRecording recording = screen("-X", wrong);
    EXPECT_EQ(recording.stated_up, "") << wrong;
    EXPECT_TRUE(has_note(recording.notes, "do not tell which way is up")) << wrong;
  }
}

TEST(C3d, IsReadFromEveryProcessorAsFloatsAndAsIntegers) {
  for (const int processor : {84, 85, 86}) {
    for (const bool floats : {true, false}) {
      for (const int analog : {0, 5}) {
        WrittenC3d file = small_file();
        file.processor = processor;
        file.floats = floats;
        file.analog = analog;
        const PointRecording recording = parse_c3d(file.bytes(), "some/walk.c3d");
        EXPECT_EQ(recording.name, "walk");
        EXPECT_EQ(recording.format, "c3d");
        EXPECT_EQ(recording.frames_per_second, 100.0);
        EXPECT_EQ(recording.points, (std::vector<std::string>{"LASI", "RASI"}));
        EXPECT_EQ(recording.unit, "mm");
        EXPECT_EQ(recording.metres_per_unit, 0.001);
        EXPECT_TRUE(recording.notes.empty());
        ASSERT_EQ(recording.frame_count(), 3);
        for (int frame = 0; frame < 3; ++frame) {
          const std::size_t first = recording.at(frame, 0);
          EXPECT_TRUE(recording.seen[first]);
          EXPECT_EQ(recording.positions[first],
                    Vec3(100.0 + frame, -250.5 - frame, 1000.0 + frame));
          EXPECT_EQ(recording.seen[recording.at(frame, 1)], frame != 1);
        }
        EXPECT_EQ(recording.positions[recording.at(2, 1)], Vec3(3.5, 4.0, -5.5));
      }
    }
  }
}

TEST(C3d, GapsAreMarkedOrNotFiniteOrExactlyAtTheOrigin) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  WrittenC3d file = small_file();
  file.frames[0][0] = {5.0, 6.0, 7.0, -1.0};  // marked, although there are numbers
  file.frames[1][0] = {nan, nan, nan, 0.0};
  file.frames[2][0] = {0.0, 0.0, 0.0, 0.0};
  file.frames[0][1] = {0.0, 0.0, 1e-3, 0.0};
  const PointRecording recording = parse_c3d(file.bytes(), "walk.c3d");
  for (int frame = 0; frame < 3; ++frame) {
    EXPECT_FALSE(recording.seen[recording.at(frame, 0)]);
    EXPECT_EQ(recording.positions[recording.at(frame, 0)], Vec3::Zero());
  }
  EXPECT_TRUE(recording.seen[recording.at(0, 1)]);
  EXPECT_TRUE(has_note(recording.notes, "1 position of exactly 0 0 0"));
}

TEST(C3d, NamesContinueBeyond255) {
  WrittenC3d file;
  file.labels.clear();
  file.frames.resize(1);
  for (int i = 0; i < 600; ++i) {
    file.labels.push_back("P" + std::to_string(i));
    file.frames[0].push_back({1.0 + i, 0.0, 0.0, 0.0});
  }
  const PointRecording recording = parse_c3d(file.bytes(), "walk.c3d");
  EXPECT_EQ(recording.points, file.labels);
  EXPECT_EQ(recording.positions[599].x(), 600.0);
}

TEST(C3d, NamesAreMadeDistinct) {
  WrittenC3d file = small_file();
  file.labels = {"LASI", "LASI", "", "LASI_2", "LASI"};
  for (auto& frame : file.frames) frame.resize(5, {1.0, 1.0, 1.0, 0.0});
  const PointRecording recording = parse_c3d(file.bytes(), "walk.c3d");
  EXPECT_EQ(recording.points,
            (std::vector<std::string>{"LASI", "LASI_3", "point_3", "LASI_2", "LASI_4"}));
  EXPECT_TRUE(has_note(recording.notes, "1 point has no name"));
  EXPECT_TRUE(has_note(recording.notes, "LASI_2: LASI."));
}

TEST(C3d, FramesBeyondTheHeadersLimitAreCountedElsewhere) {
  WrittenC3d file;
  file.floats = false;
  file.labels = {"A"};
  file.frames.assign(70'000, {{{1.0, 2.0, 3.0, 0.0}}});
  file.last_frame = 65'535;
  EXPECT_EQ(parse_c3d(file.bytes(), "walk.c3d").frame_count(), 70'016)
      << "by the size of the file, whose last block is filled";
  file.more = file.group(2, "TRIAL") + file.words(2, "ACTUAL_START_FIELD", {1, 0}) +
              file.words(2, "ACTUAL_END_FIELD", {70'000 - 65'536, 1});
  EXPECT_EQ(parse_c3d(file.bytes(), "walk.c3d").frame_count(), 70'000);
  file.more = file.floats_of(1, "FRAMES", {70'000});
  EXPECT_EQ(parse_c3d(file.bytes(), "walk.c3d").frame_count(), 70'000);
  file.last_frame = 70'000 - 65'536;  // some writers begin again at zero
  EXPECT_EQ(parse_c3d(file.bytes(), "walk.c3d").frame_count(), 70'000);
}

TEST(C3d, EventsCountFromTheFirstFrameOfTheFile) {
  WrittenC3d file = small_file();
  file.first_frame = 51;  // half a second into the trial
  file.more = file.group(3, "EVENT") + file.words(3, "USED", {2}) +
              file.texts(3, "LABELS", {"Foot Off", "Foot Strike"}) +
              file.texts(3, "CONTEXTS", {"Left", "Right"}) +
              file.floats_of(3, "TIMES", {0.0, 0.52, 0.0, 0.51}, {2, 2});
  PointRecording recording = parse_c3d(file.bytes(), "walk.c3d");
  ASSERT_EQ(recording.events.size(), 2u);
  EXPECT_EQ(recording.events[0].label, "Foot Strike");
  EXPECT_EQ(recording.events[0].context, "Right");
  EXPECT_NEAR(recording.events[0].seconds, 0.01, 1e-6);
  EXPECT_NEAR(recording.events[1].seconds, 0.02, 1e-6);
  // Times that only lie within the file as they stand are not moved.
  file.first_frame = 20'001;
  file.more = file.group(3, "EVENT") + file.words(3, "USED", {1}) +
              file.texts(3, "LABELS", {"Foot Off"}) +
              file.floats_of(3, "TIMES", {0.0, 0.02}, {2, 1});
  recording = parse_c3d(file.bytes(), "walk.c3d");
  ASSERT_EQ(recording.events.size(), 1u);
  EXPECT_NEAR(recording.events[0].seconds, 0.02, 1e-6);
  // Minutes count too.
  file.more = file.group(3, "EVENT") + file.words(3, "USED", {1}) +
              file.texts(3, "LABELS", {"Foot Off"}) +
              file.floats_of(3, "TIMES", {3.0, 20.01}, {2, 1});
  EXPECT_NEAR(parse_c3d(file.bytes(), "walk.c3d").events.at(0).seconds, 0.01, 1e-4);
}

TEST(C3d, EventsOfTheHeaderAreReadWhereThereIsNoGroup) {
  const WrittenC3d file = small_file();
  std::string bytes = file.bytes();
  std::string event;
  file.put_word(event, 12345);
  file.put_word(event, 1);
  file.put_word(event, 0);
  file.put_float(event, 0.02);
  bytes.replace(298, event.size(), event);
  bytes.replace(396, 4, "RHS ");
  const PointRecording recording = parse_c3d(bytes, "walk.c3d");
  ASSERT_EQ(recording.events.size(), 1u);
  EXPECT_EQ(recording.events[0].label, "RHS");
  EXPECT_NEAR(recording.events[0].seconds, 0.02, 1e-6);
}

TEST(C3d, ThePrefixOfTheOnlyPersonIsRemoved) {
  WrittenC3d file = small_file();
  file.labels = {"Ann:LASI", "Ann:RASI"};
  file.more = file.group(4, "SUBJECTS") + file.texts(4, "NAMES", {"Ann"});
  const PointRecording recording = parse_c3d(file.bytes(), "walk.c3d");
  EXPECT_EQ(recording.points, (std::vector<std::string>{"LASI", "RASI"}));
  EXPECT_EQ(recording.subjects, std::vector<std::string>{"Ann"});
  EXPECT_EQ(recording.subject, "Ann");
}

TEST(C3d, OneOfSeveralPeopleIsChosenByNameOrNumber) {
  WrittenC3d file = small_file();
  file.labels = {"Ann:LASI", "Bo:LASI", "Wand", "Bo:RASI"};
  for (auto& frame : file.frames) {
    frame.resize(4);
    for (std::size_t i = 0; i < 4; ++i) frame[i] = {i + 1.0, 0.0, 0.0, 0.0};
  }
  file.more = file.group(4, "SUBJECTS") + file.texts(4, "NAMES", {"Ann", "Bo"}) +
              file.group(3, "EVENT") + file.words(3, "USED", {2}) +
              file.texts(3, "LABELS", {"Foot Off", "Foot Strike"}) +
              file.texts(3, "SUBJECTS", {"Ann", "Bo"}) +
              file.floats_of(3, "TIMES", {0.0, 0.01, 0.0, 0.02}, {2, 2});
  const PointRecording all = parse_c3d(file.bytes(), "walk.c3d");
  EXPECT_EQ(all.points, file.labels);
  EXPECT_EQ(all.subject, "");
  EXPECT_EQ(all.events.size(), 2u);
  EXPECT_TRUE(has_note(all.notes, "2 people (Ann, Bo); all are read. Choose one with subject:"));
  for (const char* choice : {"Bo", "bo", "2"}) {
    const PointRecording bo = parse_c3d(file.bytes(), "walk.c3d", with_subject(choice));
    EXPECT_EQ(bo.points, (std::vector<std::string>{"LASI", "RASI"}));
    EXPECT_EQ(bo.subject, "Bo");
    EXPECT_EQ(bo.positions[0].x(), 2.0);
    EXPECT_EQ(bo.positions[1].x(), 4.0);
    ASSERT_EQ(bo.events.size(), 1u);
    EXPECT_EQ(bo.events[0].label, "Foot Strike");
  }
  expect_refusal(file.bytes(), "there is no subject \"Cy\"; choose one of: Ann, Bo",
                 with_subject("Cy"));
  expect_refusal(file.bytes(), "there is no subject \"3\"", with_subject("3"));
}

TEST(C3d, LettersForSidesAreNoPeople) {
  WrittenC3d file = small_file();
  file.labels = {"L:ASI", "R:ASI", "L:KNE", "R:KNE", "L:ANK", "R:ANK"};
  for (auto& frame : file.frames) frame.resize(6, {1.0, 1.0, 1.0, 0.0});
  const PointRecording recording = parse_c3d(file.bytes(), "walk.c3d");
  EXPECT_EQ(recording.points, file.labels);
  EXPECT_TRUE(recording.subjects.empty());
}

TEST(C3d, ResultsThatAreNoPositionsAreLeftOut) {
  WrittenC3d file = small_file();
  file.labels = {"LASI", "LHipAngles", "Effort", "RASI", "RKneeMoment", "CentreOfMass"};
  for (auto& frame : file.frames) {
    frame.resize(6);
    for (std::size_t i = 0; i < 6; ++i) frame[i] = {i + 1.0, 0.0, 0.0, 0.0};
  }
  file.more = file.texts(1, "TYPE_GROUPS", {"ANGLES", "EFFORTS", "MODELED_MARKERS"}) +
              file.texts(1, "ANGLES", {"LHipAngles"}) + file.texts(1, "EFFORTS", {"Effort"}) +
              file.texts(1, "MODELED_MARKERS", {"CentreOfMass"});
  const PointRecording recording = parse_c3d(file.bytes(), "walk.c3d");
  EXPECT_EQ(recording.points, (std::vector<std::string>{"LASI", "RASI", "CentreOfMass"}));
  EXPECT_EQ(recording.positions[1].x(), 4.0);
  EXPECT_EQ(recording.positions[2].x(), 6.0);
  EXPECT_TRUE(has_note(recording.notes, "no positions: LHipAngles, Effort, RKneeMoment."));
}

TEST(C3d, UnitsAreThoseOfTheFile) {
  WrittenC3d file = small_file();
  for (const auto& [unit, metres] :
       std::vector<std::pair<std::string, double>>{{"m", 1.0}, {"CM", 0.01}, {"inches", 0.0254}}) {
    file.unit = unit;
    const PointRecording recording = parse_c3d(file.bytes(), "walk.c3d");
    EXPECT_EQ(recording.unit, unit);
    EXPECT_EQ(recording.metres_per_unit, metres);
  }
  file.unit = "furlong";
  EXPECT_TRUE(has_note(parse_c3d(file.bytes(), "walk.c3d").notes, "\"furlong\", is not known"));
  file.unit = "";
  const PointRecording recording = parse_c3d(file.bytes(), "walk.c3d");
  EXPECT_EQ(recording.unit, "");
  EXPECT_EQ(recording.metres_per_unit, 0.0);
  EXPECT_TRUE(has_note(recording.notes, "does not state the unit"));
}

TEST(C3d, FrameRatesAreStatedOrAskedFor) {
  WrittenC3d file = small_file();
  file.with_point_rate = false;
  file.rate = 59.94;
  EXPECT_NEAR(parse_c3d(file.bytes(), "walk.c3d").frames_per_second, 59.94, 1e-5);
  EXPECT_NEAR(parse_c3d(file.bytes(), "walk.c3d", with_rate(50.0)).frames_per_second, 59.94, 1e-5);
  file.more = file.floats_of(1, "RATE", {120.0});
  const PointRecording recording = parse_c3d(file.bytes(), "walk.c3d");
  EXPECT_EQ(recording.frames_per_second, 120.0);
  EXPECT_TRUE(has_note(recording.notes, "59.94 Hz, but POINT:RATE says 120 Hz"));
  file.more.clear();
  file.rate = 0.0;
  expect_refusal(file.bytes(), "states no frame rate");
  EXPECT_EQ(parse_c3d(file.bytes(), "walk.c3d", with_rate(50.0)).frames_per_second, 50.0);
}

TEST(C3d, IsRefusedWithItsFault) {
  const WrittenC3d good = small_file();
  const std::string bytes = good.bytes();
  expect_refusal("", "is not a C3D file");
  expect_refusal(std::string(2000, 'x'), "is not a C3D file");
  std::string changed = bytes;
  changed[0] = 100;
  expect_refusal(changed, "at byte 50688: the parameter section leads beyond the end");
  changed = bytes;
  changed[512 + 3] = 1;
  expect_refusal(changed, "at byte 515: the parameter section does not state how numbers");
  changed = bytes;
  changed[bytes.find("LABELS") + 6 + 4] = static_cast<char>(255);  // 255 letters each
  changed[bytes.find("LABELS") + 6 + 5] = static_cast<char>(255);
  expect_refusal(changed, "leads beyond the end of the file");
  WrittenC3d file = good;
  file.labels.clear();
  for (auto& frame : file.frames) frame.clear();
  expect_refusal(file.bytes(), "holds no points");
  file = good;
  file.labels = {"LHipAngles", "RHipAngles"};
  expect_refusal(file.bytes(), "none of its points is a position: LHipAngles, RHipAngles");
  file = good;
  file.frames[1][0][1] = 1e20;
  expect_refusal(file.bytes(), "too far away");
  file = good;
  file.floats = false;
  file.more = file.floats_of(1, "SCALE", {0.0});
  std::string no_scale = file.bytes();
  no_scale.replace(no_scale.find("SCALE"), 5, "XCALE");
  expect_refusal(no_scale, "POINT:SCALE is no scale");
  const std::size_t data = static_cast<std::size_t>(good.parameter_blocks() + 1) * 512;
  expect_refusal(bytes.substr(0, data), "ends before its points begin");
  expect_refusal(bytes.substr(0, data + 31), "no complete frame");
}

TEST(C3d, ThatIsCutShortIsReadAsFarAsItGoes) {
  const WrittenC3d file = small_file();
  const std::size_t data = static_cast<std::size_t>(file.parameter_blocks() + 1) * 512;
  const PointRecording recording = parse_c3d(file.bytes().substr(0, data + 70), "walk.c3d");
  EXPECT_EQ(recording.frame_count(), 2);
  EXPECT_TRUE(has_note(recording.notes, "says 3 frames, but the file ends after 2"));
}

}  // namespace
}  // namespace mien::motion
