#include "faults/kills.h"

#include <array>
#include <csignal>
#include <fstream>
#include <iterator>
#include <memory>

namespace mien::test {

namespace {

namespace fs = std::filesystem;

/// Two processes at work on a study that is begun again and again.
class Campaign {
 public:
  Campaign(Trial& trial, Figures& figures) : trial_(trial), figures_(figures) { begin_study(); }

  /// Kills one or both after a while, unless the study is made before.
  void kill_some() {
    const double end = seconds_now() + trial_.chance() * trial_.duration();
    while (seconds_now() < end && !is_made_) {
      pause_for(0.001);
      look();
      take_ended();
    }
    if (is_made_) {
      end_study();
      return begin_study();
    }
    const std::size_t first = trial_.below(2);
    kill(first);
    if (trial_.below(4) == 0) kill(1 - first);
    for (auto& process : processes_) {
      if (!process) process = std::make_unique<Running>(trial_.any(out_));
    }
  }

  void end_study() {
    for (auto& process : processes_) {
      if (process) Trial::expect_code(Trial::ended(*process), 0, "the other process", figures_);
      process.reset();
    }
    // A run that ended well has said that all is there: that is to be true at once.
    if (is_made_) trial_.expect_artifacts(out_, "kills, before the last run", figures_);
    trial_.expect_whole(out_, "kills", figures_);
    fs::remove_all(out_);
  }

 private:
  void begin_study() {
    out_ = trial_.fresh_out();
    is_made_ = false;
    processes_[0] = std::make_unique<Running>(trial_.run(out_));
    processes_[1] = std::make_unique<Running>(trial_.any(out_));
  }

  /// At any moment an artifact is either not there or whole.
  void look() {
    const Bytes& whole = trial_.undisturbed();
    const auto& [path, bytes] = *std::next(whole.begin(), trial_.below(whole.size()));
    const fs::path file = Trial::study_in(out_) / path;
    if (std::ifstream stream(file, std::ios::binary); stream) {
      const std::string seen((std::istreambuf_iterator<char>(stream)), {});
      if (seen != bytes) figures_.complaints.push_back("kills: " + path + " was seen half-written");
    }
  }

  void take_ended() {
    for (auto& process : processes_) {
      if (!process || process->is_running()) continue;
      const Ended ended = process->wait();
      Trial::expect_code(ended, 0, "a process that was not killed", figures_);
      is_made_ = is_made_ || ended.output.find("tasks") != std::string::npos;
      process.reset();
    }
  }

  void kill(std::size_t which) {
    if (!processes_[which]) return;
    processes_[which]->send(SIGKILL);
    if (processes_[which]->wait().code == 128 + SIGKILL) ++figures_.faults;
    processes_[which].reset();
  }

  Trial& trial_;
  Figures& figures_;
  fs::path out_;
  bool is_made_ = false;  ///< a run says so
  std::array<std::unique_ptr<Running>, 2> processes_;
};

void pause_one(Trial& trial, bool waits, Figures& figures) {
  const fs::path out = trial.fresh_out();
  Running first(trial.any(out));
  pause_for(trial.chance() * trial.duration());
  if (!first.is_running()) return;
  first.send(SIGSTOP);
  ++figures.faults;
  if (!waits) fs::remove_all(Trial::study_in(out) / ".mien" / "workers");
  Trial::expect_code(Trial::ended(trial.run(out)), 0, "the one that took over", figures);
  trial.expect_artifacts(out, "while the first one sleeps", figures);
  first.send(SIGCONT);
  Trial::expect_code(Trial::ended(first), 0, "the one that was paused", figures);
  trial.expect_artifacts(out, "after the first one woke", figures);
  trial.expect_whole(out, "pause", figures);
  fs::remove_all(out);
}

}  // namespace

Figures random_kills(Trial& trial, int kills) {
  Figures figures{.fault = "SIGKILL of one of two processes, or of both"};
  Campaign campaign(trial, figures);
  while (figures.faults < kills) campaign.kill_some();
  campaign.end_study();
  return figures;
}

Figures duplicated_workers(Trial& trial, int pairs) {
  Figures figures{.fault = "two processes that make the same at the same moment"};
  for (; figures.faults < pairs; ++figures.faults) {
    const fs::path out = trial.fresh_out();
    const auto words = trial.any(out);
    Running one(words);
    Running other(words);
    Trial::expect_code(Trial::ended(one), 0, "the one", figures);
    Trial::expect_code(Trial::ended(other), 0, "the other", figures);
    trial.expect_whole(out, "duplicates", figures);
    fs::remove_all(out);
  }
  return figures;
}

Figures paused_workers(Trial& trial, int pauses, bool waits) {
  Figures figures{.fault = waits ? "SIGSTOP, counted as dead for its silence, SIGCONT"
                                 : "SIGSTOP, counted as dead at once, SIGCONT"};
  while (figures.faults < pauses) pause_one(trial, waits, figures);
  return figures;
}

}  // namespace mien::test
