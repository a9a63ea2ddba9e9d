#include "pipeline/tasks/disk_fault.h"

#include <cerrno>
#include <cstdint>
#include <system_error>

#include <sys/statvfs.h>

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// A disk with less free space counts as full.
constexpr std::uint64_t least_free_bytes = 1 << 20;

std::error_code code_of_disk(const fs::path& folder) {
  struct statvfs disk {};
  if (::statvfs(folder.c_str(), &disk) != 0) return {errno, std::generic_category()};
  if ((disk.f_flag & ST_RDONLY) != 0) return std::make_error_code(std::errc::read_only_file_system);
  const bool has_room = std::uint64_t{disk.f_bavail} * disk.f_frsize >= least_free_bytes;
  const bool has_names = disk.f_files == 0 || disk.f_favail > 0;
  if (has_room && has_names) return {};
  return std::make_error_code(std::errc::no_space_on_device);
}

std::error_code code_of(const std::exception& error) {
  if (const auto* system = dynamic_cast<const std::system_error*>(&error)) return system->code();
  if (const auto* write = dynamic_cast<const WriteFailure*>(&error)) return write->code();
  return {};
}

/// Whether an error means that the file server or mounted disk of a folder is unavailable.
bool is_away(const std::error_code& code) {
  return code == std::errc::no_such_file_or_directory || code == std::errc::not_connected ||
         code == std::errc::no_such_device ||
         code == std::error_code(ESTALE, std::generic_category());
}

struct DiskProblem {
  std::string words;
  std::string remedy;
};

DiskProblem problem_with_disk(const std::error_code& code, const std::string& folder) {
  constexpr const char* make_room = "free some space, and run the same command again to continue";
  if (code == std::errc::no_space_on_device)
    return {"the disk that holds " + folder + " is full", make_room};
  if (code == std::error_code(EDQUOT, std::generic_category()))
    return {"your quota on the disk that holds " + folder + " is used up", make_room};
  if (code == std::errc::read_only_file_system) {
    return {folder + " cannot be written to (" + code.message() + ")",
            "make the disk writable, or choose another folder with --out"};
  }
  return {};
}

/// The problem of a folder that should exist.
DiskProblem problem_with_folder(const fs::path& folder, const std::error_code& error_code) {
  const std::error_code now = code_of_disk(folder);
  if (!is_away(now) || (error_code && !is_away(error_code))) return {};
  return {folder.string() + " is not there (" + now.message() + ")",
          "restore the disk that held it, and run the same command again to continue"};
}

std::string to_text(const DiskProblem& disk_problem) {
  return disk_problem.words.empty() ? "" : disk_problem.words + "; " + disk_problem.remedy;
}

}  // namespace

std::string disk_fault(const fs::path& folder, const std::exception& error) {
  if (dynamic_cast<const DiskFault*>(&error) != nullptr) return error.what();
  const std::error_code code = code_of(error);
  for (const DiskProblem& one : {problem_with_disk(code, folder.string()),
                                 problem_with_disk(code_of_disk(folder), folder.string()),
                                 problem_with_folder(folder, code)}) {
    if (!one.words.empty()) return to_text(one);
  }
  return "";
}

std::string current_disk_problem(const fs::path& folder) {
  return problem_with_disk(code_of_disk(folder), folder.string()).words;
}

}  // namespace mien::pipeline
