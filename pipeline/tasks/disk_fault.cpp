#include "pipeline/tasks/disk_fault.h"

#include <cerrno>
#include <cstdint>
#include <system_error>

#include <sys/statvfs.h>

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// A disk with less free space counts as full.
constexpr std::uint64_t full_below_bytes = 1 << 20;

std::error_code code_of_disk(const fs::path& folder) {
  struct statvfs disk {};
  if (::statvfs(folder.c_str(), &disk) != 0) return {errno, std::generic_category()};
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

/// Whether an error means that the file server or mounted disk of a folder is unavailable.
bool is_away(const std::error_code& code) {
  return code == std::errc::no_such_file_or_directory || code == std::errc::not_connected ||
         code == std::errc::no_such_device ||
         code == std::error_code(ESTALE, std::generic_category());
}

struct Ailment {
  std::string words;
  std::string remedy;
};

Ailment ailment_of(const std::error_code& code, const std::string& folder) {
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
Ailment absence_of(const fs::path& folder, const std::error_code& told) {
  const std::error_code now = code_of_disk(folder);
  if (!is_away(now) || (told && !is_away(told))) return {};
  return {folder.string() + " is not there (" + now.message() + ")",
          "restore the disk that held it, and run the same command again to continue"};
}

std::string in_words(const Ailment& ailment) {
  return ailment.words.empty() ? "" : ailment.words + "; " + ailment.remedy;
}

}  // namespace

std::string disk_fault(const fs::path& folder, const std::exception& error) {
  if (dynamic_cast<const DiskFault*>(&error) != nullptr) return error.what();
  const std::error_code code = code_of(error);
  for (const Ailment& one :
       {ailment_of(code, folder.string()), ailment_of(code_of_disk(folder), folder.string()),
        absence_of(folder, code)}) {
    if (!one.words.empty()) return in_words(one);
  }
  return "";
}

std::string disk_ailment(const fs::path& folder) {
  return ailment_of(code_of_disk(folder), folder.string()).words;
}

}  // namespace mien::pipeline
