// `mien motion stream` as a capture system meets it: through pipes that are fed slowly, cut and
// closed.

#include <algorithm>
#include <filesystem>
#include <string>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>
#include <unistd.h>

#include "end_to_end/program.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;

const std::string bow = "posture: {head-flexion: 20}";

long lines_of(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

class MotionStream : public testing::Test {
 protected:
  MotionStream() {
    const Ended made = run_mien({"motion", "blend", "--examples", "builtin:walks-10", "--weights",
                                 "normal=1", "--cycles", "2", "-o", walk});
    EXPECT_EQ(made.code, 0) << made.errors;
    text = text_of(walk);
    const std::size_t motion = text.find("Frame Time");
    head = text.substr(0, text.find('\n', motion) + 1);
    frames = text.substr(head.size());
  }

  Ended stream(const std::vector<std::string>& words) const {
    std::vector<std::string> all = {"motion", "stream"};
    all.insert(all.end(), words.begin(), words.end());
    return run_mien(all);
  }

  /// The program with a pipe for its input, which `feed` writes to.
  template <typename Feed>
  Ended fed(const std::vector<std::string>& words, Feed feed) const {
    const std::string pipe = scratch.path() / "live.bvh";
    EXPECT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    std::vector<std::string> all = {"motion", "stream", pipe};
    all.insert(all.end(), words.begin(), words.end());
    Running running(mien_with(all));
    const int descriptor = ::open(pipe.c_str(), O_WRONLY);
    EXPECT_GE(descriptor, 0);
    feed(descriptor, running);
    ::close(descriptor);
    fs::remove(pipe);
    return running.wait(60.0);
  }

  static void write_to(int descriptor, const std::string& part) {
    EXPECT_EQ(::write(descriptor, part.data(), part.size()), static_cast<ssize_t>(part.size()));
  }

  Scratch scratch;
  const std::string walk = scratch.path() / "walk.bvh";
  std::string text, head, frames;
};

TEST_F(MotionStream, IsTheSameFromAFileAndFromAPipeThatIsFedSlowly) {
  const Ended whole = stream({walk, bow});
  ASSERT_EQ(whole.code, 0) << whole.errors;
  EXPECT_NE(whole.errors.find("latency 0 frames (0 ms)"), std::string::npos) << whole.errors;
  const std::string out = scratch.path() / "out.bvh";
  const Ended live = fed({bow, "-o", out, "--lines"}, [&](int descriptor, Running&) {
    write_to(descriptor, head);
    // Cut so that numbers and lines are in two pieces.
    for (std::size_t at = 0; at < frames.size(); at += 1777) {
      write_to(descriptor, frames.substr(at, 1777));
      pause_for(0.005);
    }
  });
  ASSERT_EQ(live.code, 0) << live.errors;
  EXPECT_TRUE(whole.output.ends_with(text_of(out)));
  EXPECT_EQ(lines_of(text_of(out)), lines_of(frames));
}

TEST_F(MotionStream, AnswersEachFrameBeforeTheNextComes) {
  const std::string out = scratch.path() / "answer.bvh";
  ASSERT_EQ(::mkfifo(out.c_str(), 0600), 0);
  const std::string pipe = scratch.path() / "live.bvh";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  Running running({"sh", "-c", "exec \"$0\" motion stream \"$1\" \"$2\" --lines > \"$3\"",
                   mien_with({}).front(), pipe, bow, out});
  const int to = ::open(pipe.c_str(), O_RDWR);
  const int from = ::open(out.c_str(), O_RDWR);
  write_to(to, head);
  std::size_t at = 0;
  std::string answers;
  for (int frame = 0; frame < 5; ++frame) {
    const std::size_t end = frames.find('\n', at) + 1;
    write_to(to, frames.substr(at, end - at));
    at = end;
    // Would never come back if the frame were kept until another comes.
    while (lines_of(answers) <= frame) {
      char bytes[4096];
      const ssize_t count = ::read(from, bytes, sizeof bytes);
      ASSERT_GT(count, 0);
      answers.append(bytes, static_cast<std::size_t>(count));
    }
    EXPECT_EQ(lines_of(answers), frame + 1);
  }
  running.send(SIGINT);
  const Ended ended = running.wait(20.0);
  EXPECT_EQ(ended.code, 130);
  EXPECT_NE(ended.errors.find("5 frames at 30 per second"), std::string::npos) << ended.errors;
  ::close(to);
  ::close(from);
}

TEST_F(MotionStream, TellsItsDelayAndItsError) {
  const std::string told = scratch.path() / "told.json";
  const std::string out = scratch.path() / "longer.bvh";
  const Ended ended = stream({walk, "paths: 1.8", "--measure", "--json", told, "-o", out});
  ASSERT_EQ(ended.code, 0) << ended.errors;
  const auto report = nlohmann::json::parse(text_of(told));
  EXPECT_EQ(report["frames"], lines_of(frames));
  EXPECT_GT(report["delay"]["frames"], 8);
  EXPECT_LT(report["delay"]["milliseconds"], 550.0);
  EXPECT_GT(report["error"]["largest_metres"], 0.0);
  EXPECT_LT(report["error"]["largest_metres"], 0.01);
  EXPECT_GT(report["feet"]["largest_drift_metres"],
            report["feet"]["largest_drift_of_source_metres"]);
  EXPECT_NE(ended.errors.find("feet are not locked"), std::string::npos);
  // The file is whole: it says how many frames there are.
  EXPECT_EQ(run_mien({"motion", "info", out}).code, 0);
  EXPECT_EQ(stream({walk, "paths: 1.8", "--still-legs", "--measure", "--json", told}).code, 0);
  const auto still = nlohmann::json::parse(text_of(told));
  EXPECT_NEAR(still["feet"]["largest_drift_metres"].get<double>(),
              still["feet"]["largest_drift_of_source_metres"].get<double>(), 1e-4);
  EXPECT_LT(still["error"]["largest_metres"], 0.01);
  const Ended short_of_it =
      stream({walk, "paths: 1.8", "--measure", "--delay", "200", "--json", told, "-o", out});
  ASSERT_EQ(short_of_it.code, 0) << short_of_it.errors;
  const auto worse = nlohmann::json::parse(text_of(told));
  EXPECT_EQ(worse["delay"]["frames"], 6);
  EXPECT_GT(worse["error"]["largest_metres"], report["error"]["largest_metres"]);
}

TEST_F(MotionStream, OfAFileIsAsLongAsTheFileAndCanBeReadAgain) {
  const Ended once = stream({walk, "paths: 0.5"});
  ASSERT_EQ(once.code, 0) << once.errors;
  const std::string again = scratch.write("again.bvh", once.output);
  EXPECT_EQ(run_mien({"motion", "info", again}).code, 0);
  EXPECT_EQ(stream({walk, "paths: 0.5"}).output, once.output);
}

TEST_F(MotionStream, LeavesNothingHalfWrittenWhenItsInputBreaks) {
  const std::string out = scratch.path() / "out.bvh";
  const std::string broken = scratch.write(
      "broken.bvh", head + frames.substr(0, 5000) + "\n1 2\n" + frames.substr(0, 3000));
  const Ended ended = stream({broken, bow, "-o", out});
  EXPECT_EQ(ended.code, 2);
  EXPECT_NE(ended.errors.find("broken.bvh:"), std::string::npos) << ended.errors;
  for (const auto& entry : fs::directory_iterator(scratch.path())) {
    EXPECT_EQ(entry.path().string().find("out.bvh"), std::string::npos) << entry.path();
  }
  const std::size_t between = frames.find(' ', 5000);  // two numbers
  const Ended cut = stream({scratch.write("cut.bvh", head + frames.substr(0, between)), bow});
  EXPECT_EQ(cut.code, 2);
  EXPECT_NE(cut.errors.find("truncated"), std::string::npos) << cut.errors;
  const Ended empty = stream({scratch.write("empty.bvh", head), bow});
  EXPECT_EQ(empty.code, 2);
  EXPECT_NE(empty.errors.find("no frame came"), std::string::npos) << empty.errors;
}

TEST_F(MotionStream, EndsWhenItsReaderGoes) {
  const Ended ended =
      run_program({"sh", "-c", "\"$0\" motion stream \"$1\" \"$2\" --paced | head -n 3",
                   mien_with({}).front(), walk, bow});
  EXPECT_EQ(ended.code, 0);
  EXPECT_EQ(lines_of(ended.output), 3);
  EXPECT_NE(ended.errors.find("the reader closed the stream"), std::string::npos) << ended.errors;
}

TEST_F(MotionStream, KeepsWhatHasComeWhenItIsInterrupted) {
  const std::string out = scratch.path() / "out.bvh";
  const Ended ended = fed({bow, "-o", out}, [&](int descriptor, Running& running) {
    write_to(descriptor, head + frames.substr(0, 9001));
    pause_for(0.5);
    running.send(SIGINT);
    running.wait(20.0);
  });
  EXPECT_EQ(ended.code, 130);
  EXPECT_EQ(run_mien({"motion", "info", out}).code, 0);
}

TEST_F(MotionStream, RefusesWhatItCannotDoBeforeItReads) {
  const Ended sad = stream({"-", "sad"});
  EXPECT_EQ(sad.code, 2);
  EXPECT_NE(sad.errors.find("tempo 0.7 cannot be streamed"), std::string::npos) << sad.errors;
  EXPECT_EQ(stream({walk, "sad", "--leave-out", "tempo"}).code, 0);
  EXPECT_EQ(stream({walk, "[{emotion: sad}, {paths: 1.2}]"}).code, 2);
  EXPECT_EQ(stream({walk, bow, "-o", walk}).code, 2);
  EXPECT_EQ(stream({scratch.path() / "none.bvh", bow}).code, 2);
  EXPECT_EQ(stream({scratch.path(), bow}).code, 2);
}

}  // namespace
}  // namespace mien::test
