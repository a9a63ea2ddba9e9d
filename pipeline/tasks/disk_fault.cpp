#include "pipeline/tasks/disk_fault.h"

#include <cerrno>
#include <cstdint>
#include <system_error>

#include <sys/statvfs.h>

#include "pipeline/documents/files.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// A disk with less is as good as full.
constexpr std::uint64_t full_below_bytes = 1 << 20;

std::error_code code_of_disk(const fs::path& folder) {
  struct statvfs disk {};
  if (::statvfs(folder.c_str(), &disk) != 0) return {};
  if ((disk.f_flag & ST_RDONLY) != 0) return std::make_error_code(std::errc::read_only_file_system);
  const bool has_room = std::uint64_t{disk.f_bavail} * disk.f_frsize >= full_below_bytes;
  const bool has_names = disk.f_files == 0 || disk.f_favail > 0;
  if (has_room && has_names) return {};
  return std::make_error_code(std::errc::no_space_on_device);
}

std::error_code code_of(const std::exception& error) {
  if (const auto* system = dynamic_cast<const std::system_error*>(&error)) return system->code();
  if (const auto* write = dynamic_cast<const WriteFailure*>(&error)) return write->code();
  return {};
}

std::string in_words(const std::error_code& code, const std::string& folder) {
  constexpr const char* go_on = "; make room, and the same command goes on from here";
  if (code == std::errc::no_space_on_device)
    return "the disk that holds " + folder + " is full" + go_on;
  if (code == std::error_code(EDQUOT, std::generic_category()))
    return "your quota of the disk that holds " + folder + " is used up" + go_on;
  if (code == std::errc::read_only_file_system) {
    return folder + " cannot be written to (" + code.message() +
           "); make the disk writable, or choose another folder with --out";
  }
  return "";
}

}  // namespace

std::string disk_fault(const fs::path& folder, const std::exception& error) {
  const std::string told = in_words(code_of(error), folder.string());
  return told.empty() ? in_words(code_of_disk(folder), folder.string()) : told;
}

}  // namespace mien::pipeline
