#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "pipeline/tasks/store.h"

namespace mien::pipeline {

/// What a Store and its FrameStores share.
struct Store::State {
  State(std::filesystem::path at, Sharing sharing);
  ~State();
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  std::filesystem::path internal() const { return folder / ".mien"; }
  const std::string& worker() const { return presence.self().name; }
  Maker self() const { return {presence.self().host, presence.self().instruction_set}; }

  /// Calls `work` with a new empty folder that no other attempt uses, and removes it afterwards.
  /// What fails because of the disk throws DiskFault: it is looked at before the attempt makes
  /// room. So does a folder that is not there any more, whose disk is another: it is not made anew.
  void in_attempt(const std::function<void(const std::filesystem::path& attempt)>& work);

  /// Puts an attempt's file or folder in an artifact's place, and its receipt after it. If an
  /// attempt at the same key was published before and is whole, that one stays and its receipt is
  /// returned.
  Receipt publish(const std::filesystem::path& attempt, Receipt receipt);

  /// Notes nondeterminism when the hashes differ.
  void compare(const std::string& path, const Hash& before, const Maker& before_by,
               const Hash& now);

  void note_repair(std::string text);

  /// Makes the folders above a file or folder of the study (`path` in it). What is no folder where
  /// one has to be, or in the place itself is not of its kind, is set aside: it may be a person's.
  void make_way(const std::string& path, bool for_folder);

  std::filesystem::path folder;
  WorkerPresence presence;
  const std::uint64_t disk;  ///< that holds the folder, as the system numbers it
  WorkerWatch watch;
  std::atomic<int> attempts = 0;
  mutable std::mutex mutex;
  std::vector<Nondeterminism> nondeterminism;
  std::set<std::string> repairs;

 private:
  void refuse_company(Sharing sharing);
  void refuse_absence() const;
  std::filesystem::path new_attempt();
  void move_into_place(const std::filesystem::path& attempt, const Receipt& receipt);
  void write_receipt(const Receipt& receipt);
  void set_aside(const std::filesystem::path& obstacle);
};

}  // namespace mien::pipeline
