#pragma once

#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "end_to_end/program.h"
#include "faults/study_bytes.h"

namespace mien::test {

/// What came of one kind of fault.
struct Figures {
  std::string fault;
  int faults = 0;                            ///< that were done
  int studies = 0;                           ///< that were held against the undisturbed one
  std::vector<std::string> complaints = {};  ///< each a defect of mien
  std::string skipped = {};                  ///< why it could not be tried here
  double seconds = 0.0;
};

/// A study of small films that has every kind of artifact, and what an undisturbed run makes of it.
class Trial {
 public:
  using Words = std::vector<std::string>;

  explicit Trial(std::uint64_t seed);

  std::mt19937_64 random;

  /// Seconds that the undisturbed run took.
  double duration() const { return duration_; }
  const Bytes& undisturbed() const { return undisturbed_; }

  /// A folder for --out that is not there yet.
  std::filesystem::path fresh_out();
  /// One with the finished study.
  std::filesystem::path finished_out();
  /// Where in it the study lies.
  static std::filesystem::path study_in(const std::filesystem::path& out) { return out / "faults"; }

  /// Words of programs that work on the study: `mien run`; a worker of the farm that makes films,
  /// sheets and the report; one that draws chunks of the films; one of them by chance.
  Words run(const std::filesystem::path& out) const { return run(manifest(), out); }
  Words worker(const std::filesystem::path& out) const;
  Words chunks(const std::filesystem::path& out) const;
  Words any(const std::filesystem::path& out);

  /// From 0 to 1.
  double chance() { return std::uniform_real_distribution<double>()(random); }
  std::size_t below(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
  }

  /// Waits, as long as a program may take that does not hang.
  static Ended ended(Running& program) { return program.wait(300.0); }
  static Ended ended(const Words& words) { return Running(words).wait(300.0); }

  /// Complains of another exit code.
  static void expect_code(const Ended& ended, int code, const std::string& when, Figures& figures);
  /// Holds a study's artifacts and receipts against the undisturbed ones.
  void expect_artifacts(const std::filesystem::path& out, const std::string& when,
                        Figures& figures) const;
  /// Lets one run do what is left to do, and expects that all is there then and nothing else.
  void expect_whole(const std::filesystem::path& out, const std::string& when,
                    Figures& figures) const;

 private:
  static Words run(const std::filesystem::path& manifest, const std::filesystem::path& out);
  std::filesystem::path manifest() const { return set_up_ / "study.yaml"; }

  Scratch scratch_;
  std::filesystem::path set_up_;  ///< manifest, finished study, and how many seconds it took
  Bytes undisturbed_;
  double duration_ = 0.0;
  int folders_ = 0;
};

}  // namespace mien::test
