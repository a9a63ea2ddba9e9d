#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace mien::pipeline {

/// Files of a zip archive: path with '/' → bytes.
using ZipFiles = std::map<std::string, std::string>;

/// A zip archive of them, in the order of their paths, stored as they are. No dates: the same files
/// give the same bytes.
std::string zip_of(const ZipFiles& files);

/// All files of a zip archive. Throws Error for what is none, for damage, for paths that lead out
/// of it and for more content than 256 MiB or, if that is more, twenty times the archive's size, at
/// most 4 GiB; by the sizes that the archive states, where it does, before anything is unpacked.
ZipFiles read_zip(const std::filesystem::path& archive);
ZipFiles unzipped(const std::string& bytes, const std::string& name);

}  // namespace mien::pipeline
