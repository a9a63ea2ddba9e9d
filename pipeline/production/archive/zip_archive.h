#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace mien::pipeline {

/// Files of a zip archive: path with '/' → bytes.
using ZipFiles = std::map<std::string, std::string>;

/// Returns a zip archive of the files, sorted by path and stored without compression. Its dates are
/// fixed: the same files give the same bytes.
std::string zip_of(const ZipFiles& files);

/// Returns all files of a zip archive. Throws Error for files that are not zip archives, for
/// damage, for paths that lead out of the archive, and for too much content. The limit is twenty
/// times the archive's size, but at least 256 MiB and at most 4 GiB; stated sizes are checked
/// before anything is unpacked.
ZipFiles read_zip(const std::filesystem::path& archive);
/// Does the same for an archive in memory; `name` stands for its path in messages.
ZipFiles unzipped(const std::string& bytes, const std::string& name);

}  // namespace mien::pipeline
