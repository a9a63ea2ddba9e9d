#include "faults/own_disk.h"

#include <cerrno>
#include <cstring>
#include <exception>
#include <fstream>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>
#include <sched.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mien::test {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string limits(std::size_t bytes, int files) {
  return "size=" + std::to_string(bytes) + ",nr_inodes=" + std::to_string(files);
}

bool write_line(const char* file, const std::string& line) {
  std::ofstream stream(file);
  stream << line << std::flush;
  return stream.good();
}

/// A plain user may mount who is root in a space of users of its own.
bool become_root_of_own_space() {
  const std::string user = std::to_string(getuid());
  const std::string group = std::to_string(getgid());
  return unshare(CLONE_NEWUSER | CLONE_NEWNS) == 0 && write_line("/proc/self/setgroups", "deny") &&
         write_line("/proc/self/uid_map", "0 " + user + " 1") &&
         write_line("/proc/self/gid_map", "0 " + group + " 1");
}

bool take_own_mounts() {
  if (unshare(CLONE_NEWNS) != 0 && !become_root_of_own_space()) return false;
  return mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0;
}

void work_with_own_mounts(Figures& figures, const std::function<void(Figures&)>& work) {
  if (!take_own_mounts()) {
    figures.skipped = std::string("no disks of its own can be mounted: ") + std::strerror(errno);
    return;
  }
  try {
    work(figures);
  } catch (const std::exception& error) {
    figures.complaints.emplace_back(error.what());
  }
}

json told(const Figures& figures) {
  return {{"faults", figures.faults},
          {"studies", figures.studies},
          {"complaints", figures.complaints},
          {"skipped", figures.skipped}};
}

}  // namespace

OwnDisk::OwnDisk(fs::path folder, std::size_t bytes, int files) : folder_(std::move(folder)) {
  fs::create_directories(folder_);
  if (mount("tmpfs", folder_.c_str(), "tmpfs", 0, limits(bytes, files).c_str()) != 0)
    throw std::system_error(errno, std::generic_category(), "mount");
}

OwnDisk::~OwnDisk() { umount2(folder_.c_str(), MNT_DETACH); }

bool OwnDisk::resize(std::size_t bytes, int files) {
  return mount("tmpfs", folder_.c_str(), "tmpfs", MS_REMOUNT, limits(bytes, files).c_str()) == 0;
}

bool OwnDisk::set_read_only(bool is_read_only) {
  const unsigned long flags = MS_REMOUNT | (is_read_only ? MS_RDONLY : 0);
  return mount("tmpfs", folder_.c_str(), "tmpfs", flags, nullptr) == 0;
}

void with_own_mounts(Figures& figures, const std::function<void(Figures&)>& work) {
  const Scratch scratch;
  const fs::path file = scratch.path() / "figures";
  const pid_t child = fork();
  if (child == 0) {
    work_with_own_mounts(figures, work);
    write_line(file.c_str(), told(figures).dump());
    _exit(0);  // the scratch folders are the parent's
  }
  waitpid(child, nullptr, 0);
  const json result = json::parse(text_of(file), nullptr, false);
  if (result.is_discarded()) {
    figures.complaints.emplace_back("the trial ended before its time");
    return;
  }
  figures.faults = result["faults"];
  figures.studies = result["studies"];
  figures.complaints = result["complaints"];
  figures.skipped = result["skipped"];
}

}  // namespace mien::test
