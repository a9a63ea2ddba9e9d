#include "faults/disk_trials.h"

#include <algorithm>
#include <csignal>

#include "faults/own_disk.h"

namespace mien::test {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t page = 4096;
constexpr std::size_t ample = std::size_t{64} << 20;

/// What a finished study takes on such a disk.
struct Need {
  std::size_t bytes = 0;
  int files = 0;
};

Need need_of(const fs::path& folder) {
  Need need;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    ++need.files;
    if (entry.is_regular_file()) need.bytes += (entry.file_size() / page + 1) * page;
  }
  return need;
}

int count_of(const std::string& word, const std::string& text) {
  int count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    ++count;
  return count;
}

/// What ails the disk is told once, in plain words, by a program that ends by itself.
void expect_one_error(const Ended& ended, const std::string& words, const std::string& when,
                      Figures& figures) {
  if (ended.code == 0 || ended.code >= 128)
    figures.complaints.push_back(when + ": ended with " + std::to_string(ended.code));
  if (count_of(words, ended.errors) != 1 || count_of("\n  (", ended.errors) > 1)
    figures.complaints.push_back(when + ": told so: " + ended.errors);
}

fs::path folder_of_disk(Trial& trial) {
  fs::path out = trial.fresh_out();
  fs::create_directories(out);
  return out;
}

void fill(Trial& trial, const Need& need, bool with_files, Figures& figures) {
  const double share = 0.02 + 0.9 * trial.chance();
  const auto bytes =
      std::max(page, static_cast<std::size_t>(share * static_cast<double>(need.bytes)));
  const int files = 2 + static_cast<int>(share * need.files);
  const std::string when = with_files ? "room for " + std::to_string(files) + " files"
                                      : "room for " + std::to_string(bytes) + " bytes";
  const fs::path out = folder_of_disk(trial);
  OwnDisk disk(out, with_files ? ample : bytes, with_files ? files : 0);
  ++figures.faults;
  Running first(trial.run(out));
  if (trial.below(2) == 0) Trial::ended(trial.any(out));
  expect_one_error(Trial::ended(first), " is full", when, figures);
  if (!disk.resize(ample)) figures.complaints.push_back(when + ": the disk did not grow");
  trial.expect_whole(out, when, figures);
}

/// Tries until it is done or the program has ended. Says whether it was done.
bool soon(Running& program, const std::function<bool()>& change) {
  while (program.is_running()) {
    if (change()) return true;
    pause_for(0.002);
  }
  return false;
}

void fill_for_a_while(Trial& trial, Figures& figures) {
  const fs::path out = folder_of_disk(trial);
  OwnDisk disk(out, ample);
  Running first(trial.run(out));
  Running second(trial.any(out));
  pause_for(trial.chance() * trial.duration());
  const bool was_full = soon(first, [&] {
    const fs::space_info space = fs::space(out);
    return disk.resize(space.capacity - space.free);
  });
  if (was_full) ++figures.faults;
  pause_for(2.0 * trial.chance());
  disk.resize(ample);
  for (Running* program : {&first, &second}) {
    const Ended ended = Trial::ended(*program);
    if (ended.code != 0) expect_one_error(ended, " is full", "full for a while", figures);
  }
  trial.expect_whole(out, "full for a while", figures);
}

constexpr const char* read_only_words = "Read-only file system";

/// When it begins; nothing is there yet, or a part of the study, or all.
void begin_read_only(Trial& trial, Figures& figures) {
  const fs::path out = folder_of_disk(trial);
  OwnDisk disk(out, ample);
  if (trial.below(3) > 0)
    run_program(trial.run(out), (0.3 + trial.chance()) * trial.duration(), SIGKILL);
  if (!disk.set_read_only(true)) return;
  ++figures.faults;
  const Bytes before = bytes_in(out);
  expect_one_error(Trial::ended(trial.any(out)), read_only_words, "read-only store", figures);
  for (const std::string& difference : differences(before, bytes_in(out)))
    figures.complaints.push_back("read-only store: " + difference);
  disk.set_read_only(false);
  trial.expect_whole(out, "read-only store", figures);
}

void become_read_only(Trial& trial, Figures& figures) {
  const fs::path out = folder_of_disk(trial);
  OwnDisk disk(out, ample);
  Running mien(trial.run(out));
  pause_for(trial.chance() * trial.duration());
  if (soon(mien, [&] { return disk.set_read_only(true); })) ++figures.faults;
  const Ended ended = Trial::ended(mien);
  if (ended.code != 0)  // it may just have been done
    expect_one_error(ended, read_only_words, "read-only on the way", figures);
  disk.set_read_only(false);
  trial.expect_whole(out, "read-only on the way", figures);
}

}  // namespace

Figures full_disks(Trial& trial, int disks) {
  Figures figures{.fault = "disk full, or full of files"};
  with_own_mounts(figures, [&](Figures& own) {
    const Need need = need_of(trial.finished_out());
    for (int disk = 0; disk < disks; ++disk) fill(trial, need, disk % 3 == 2, own);
  });
  return figures;
}

Figures disks_full_for_a_while(Trial& trial, int disks) {
  Figures figures{.fault = "disk full for a while, below two processes"};
  with_own_mounts(figures, [&](Figures& own) {
    for (int disk = 0; disk < disks; ++disk) fill_for_a_while(trial, own);
  });
  return figures;
}

Figures read_only_stores(Trial& trial, int stores) {
  Figures figures{.fault = "store read-only, from the beginning or on the way"};
  with_own_mounts(figures, [&](Figures& own) {
    for (int store = 0; store < stores; ++store)
      store % 2 == 0 ? begin_read_only(trial, own) : become_read_only(trial, own);
  });
  return figures;
}

}  // namespace mien::test
