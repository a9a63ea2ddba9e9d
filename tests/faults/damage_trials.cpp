#include "faults/damage_trials.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <iterator>
#include <memory>

#include "pipeline/tasks/receipt.h"

#include "faults/damage.h"

namespace mien::test {

namespace {

namespace fs = std::filesystem;

const std::string receipts = ".mien/receipts/";

/// Files below a folder of the study, as paths in the study, sorted.
std::vector<std::string> files_in(const fs::path& study, const std::string& below) {
  std::vector<std::string> files;
  if (!fs::exists(study / below)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(study / below)) {
    if (fs::is_regular_file(entry.symlink_status()))
      files.push_back(entry.path().lexically_relative(study).generic_string());
  }
  std::ranges::sort(files);
  return files;
}

/// Artifacts that are files by themselves, no frames.
std::vector<std::string> artifacts_in(const fs::path& study) {
  std::vector<std::string> artifacts;
  for (const std::string& file : files_in(study, receipts)) {
    const std::string path = file.substr(receipts.size(), file.size() - receipts.size() - 5);
    if (fs::is_regular_file(fs::symlink_status(study / path))) artifacts.push_back(path);
  }
  return artifacts;
}

std::vector<std::string> published_in(const fs::path& study) {
  std::vector<std::string> files = artifacts_in(study);
  for (const char* folder : {"frames", ".mien/receipts"})
    std::ranges::copy(files_in(study, folder), std::back_inserter(files));
  return files;
}

class Vandal {
 public:
  Vandal(Trial& trial, fs::path study) : trial_(trial), study_(std::move(study)) {}

  /// Damages one of these files by itself. Says what was done, as all here.
  std::string damage(const std::vector<std::string>& files) {
    const std::string file = pick(files);
    const Damage& damage = damages()[trial_.below(damages().size())];
    damage.to(study_ / file, trial_.random);
    return file + ": " + damage.name;
  }

  std::string swap_two(const std::vector<std::string>& files) {
    if (files.size() < 2) return "";
    const std::size_t first = trial_.below(files.size());
    const std::size_t second = (first + 1 + trial_.below(files.size() - 1)) % files.size();
    swap_files(study_ / files[first], study_ / files[second]);
    return files[first] + ": swapped with " + files[second];
  }

  /// Does something to what is published.
  std::string strike() {
    switch (trial_.below(9)) {
      case 0:
        return swap_two(artifacts_in(study_));
      case 1:
        return swap_two(files_in(study_, receipts));
      case 2:
        return forge();
      case 3:
        return damage_with_receipt();
      case 4:
        return swap_two(files_in(study_, "frames/one"));
      case 5:
        return swap_two(files_in(study_, "frames/two"));
      default:
        return damage(published_in(study_));
    }
  }

 private:
  std::string forge() {
    const std::vector<std::string> artifacts = artifacts_in(study_);
    const std::string one = pick(artifacts);
    const std::string other = pick(artifacts);
    if (one == other) return damage(artifacts);
    fs::copy_file(study_ / other, study_ / one, fs::copy_options::overwrite_existing);
    forge_receipt(study_, one, other);
    return one + ": forged, with its receipt, of " + other;
  }

  std::string damage_with_receipt() {
    const std::string file = pick(artifacts_in(study_));
    damages().front().to(study_ / file, trial_.random);
    forge_hash(study_, file);
    return file + ": a flipped bit, and its hash in the receipt";
  }

  const std::string& pick(const std::vector<std::string>& files) {
    return files[trial_.below(files.size())];
  }

  Trial& trial_;
  fs::path study_;
};

/// One run, or two processes at once. Returns what they said.
std::string make_good(Trial& trial, const fs::path& out, const std::string& what,
                      Figures& figures) {
  const auto other = trial.below(2) == 0 ? std::make_unique<Running>(trial.any(out)) : nullptr;
  const Ended one = Trial::ended(trial.run(out));
  Trial::expect_code(one, 0, what, figures);
  if (!other) return one.errors;
  const Ended two = Trial::ended(*other);
  Trial::expect_code(two, 0, what + ", the other process", figures);
  return one.errors + two.errors;
}

/// What is not there is made, and so is what has a whole receipt that names other inputs: both are
/// ordinary, and nothing is said of them.
bool is_to_be_named(const std::string& what) {
  return what.find("removed") == std::string::npos && what.find("forged") == std::string::npos;
}

/// A study that was killed on the way.
fs::path begun_out(Trial& trial) {
  const fs::path out = trial.fresh_out();
  Running mien(trial.any(out));
  pause_for((0.2 + 0.7 * trial.chance()) * trial.duration());
  mien.send(SIGKILL);
  mien.wait();
  return out;
}

void set_times(const fs::path& folder, fs::file_time_type time) {
  std::error_code gone;  // processes are at work there
  for (fs::recursive_directory_iterator entry(folder, gone);
       !gone && entry != fs::recursive_directory_iterator(); entry.increment(gone)) {
    std::error_code ignored;
    fs::last_write_time(entry->path(), time, ignored);
  }
}

void set_clock(Trial& trial, Figures& figures) {
  const bool is_begun = trial.below(3) > 0;
  const fs::path out = is_begun ? begun_out(trial) : trial.finished_out();
  const auto away = std::chrono::hours(1 + trial.below(24 * 3650));
  const auto now = fs::file_time_type::clock::now();
  const auto other = is_begun ? std::make_unique<Running>(trial.any(out)) : nullptr;
  if (is_begun) pause_for(trial.chance() * trial.duration() / 2.0);
  set_times(Trial::study_in(out), trial.below(2) == 0 ? now + away : now - away);
  ++figures.faults;
  const Ended ended = Trial::ended(trial.run(out));
  Trial::expect_code(ended, 0, "set clocks", figures);
  if (!is_begun && ended.output.find("nothing to do") == std::string::npos)
    figures.complaints.emplace_back("times alone made something be made again");
  if (other) Trial::expect_code(Trial::ended(*other), 0, "set clocks, another one", figures);
  trial.expect_whole(out, "set clocks", figures);
  fs::remove_all(out);
}

}  // namespace

Figures damaged_files(Trial& trial, int faults) {
  Figures figures{.fault = "damaged, swapped and forged artifacts, frames and receipts"};
  while (figures.faults < faults) {
    const fs::path out = trial.finished_out();
    Vandal vandal(trial, Trial::study_in(out));
    std::string what;
    for (std::size_t count = 1 + trial.below(4); count > 0; --count, ++figures.faults)
      what += (what.empty() ? "" : "; ") + vandal.strike();
    const std::string said = make_good(trial, out, what, figures);
    if (said.find("note: ") == std::string::npos && is_to_be_named(what))
      figures.complaints.push_back(what + ": nothing was said of it");
    trial.expect_whole(out, what, figures);
    fs::remove_all(out);
  }
  return figures;
}

Figures damaged_work(Trial& trial, int faults) {
  Figures figures{.fault = "damaged frames in the making, notes, claims and records"};
  while (figures.faults < faults) {
    const fs::path out = begun_out(trial);
    const fs::path study = Trial::study_in(out);
    std::vector<std::string> files;
    for (const char* folder : {".mien/partial", ".mien/claims", ".mien/workers", ".mien/attempts"})
      std::ranges::copy(files_in(study, folder), std::back_inserter(files));
    if (files.empty()) continue;
    Vandal vandal(trial, study);
    const std::string swapped = vandal.swap_two(files);
    const std::string what = swapped + "; " + vandal.damage(files);
    figures.faults += 2;
    make_good(trial, out, what, figures);
    trial.expect_whole(out, what, figures);
    fs::remove_all(out);
  }
  return figures;
}

Figures set_clocks(Trial& trial, int times) {
  Figures figures{.fault = "times of files in the far past and future"};
  while (figures.faults < times) set_clock(trial, figures);
  return figures;
}

}  // namespace mien::test
