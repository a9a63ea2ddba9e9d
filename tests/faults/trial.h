#pragma once

#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "end_to_end/program.h"
#include "faults/study_bytes.h"

namespace mien::test {

/// Results of the trials of one kind of fault.
struct Figures {
  std::string fault;
  int faults = 0;                            ///< number of faults injected
  int studies = 0;                           ///< number compared with the undisturbed one
  std::vector<std::string> complaints = {};  ///< each a defect of mien
  std::string skipped = {};                  ///< why the trials could not be run here
  double seconds = 0.0;
};

/// A study of small films with every kind of artifact, and the result of an undisturbed run.
class Trial {
 public:
  using Words = std::vector<std::string>;

  explicit Trial(std::uint64_t seed);

  std::mt19937_64 random;

  /// Seconds that the undisturbed run took.
  double duration() const { return duration_; }
  const Bytes& undisturbed() const { return undisturbed_; }

  /// A folder for --out that does not exist yet.
  std::filesystem::path fresh_out();
  /// A folder for --out with the finished study.
  std::filesystem::path finished_out();
  /// The study's folder in it.
  static std::filesystem::path study_in(const std::filesystem::path& out) { return out / "faults"; }

  /// Command lines of programs that work on the study: `mien run`; a worker of the farm for films,
  /// sheets and the report; one for chunks of the films; a random one of these.
  Words run(const std::filesystem::path& out) const { return run(manifest(), out); }
  Words worker(const std::filesystem::path& out) const;
  Words chunks(const std::filesystem::path& out) const;
  Words any(const std::filesystem::path& out);

  /// A uniform random number from 0 to 1.
  double chance() { return std::uniform_real_distribution<double>()(random); }
  std::size_t below(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
  }

  /// Waits for the end; the limit is for programs that hang.
  static Ended ended(Running& program) { return program.wait(300.0); }
  static Ended ended(const Words& words) { return Running(words).wait(300.0); }

  /// Adds a complaint unless the exit code is `code`.
  static void expect_code(const Ended& ended, int code, const std::string& when, Figures& figures);
  /// Compares a study's artifacts and receipts with the undisturbed ones.
  void expect_artifacts(const std::filesystem::path& out, const std::string& when,
                        Figures& figures) const;
  /// Completes the study with one run, and expects exactly the undisturbed files afterwards.
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
