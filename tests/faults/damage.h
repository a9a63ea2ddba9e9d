#pragma once

#include <filesystem>
#include <random>
#include <string>
#include <vector>

namespace mien::test {

/// What befalls a file: "a flipped bit", "cut off", …
struct Damage {
  const char* name;
  void (*to)(const std::filesystem::path& file, std::mt19937_64& random);
};

/// All that can befall a file by itself. Each leaves other bytes than there were, or no file.
const std::vector<Damage>& damages();

/// Two files change places.
void swap_files(const std::filesystem::path& one, const std::filesystem::path& other);

/// The receipt of an artifact of the study becomes that of another one, said to be of this one,
/// with a checksum that is right: the work of a careful forger.
void forge_receipt(const std::filesystem::path& study, const std::string& path,
                   const std::string& other);

/// The receipt gets the hash and size of what now lies in the artifact's place, and keeps its
/// checksum.
void forge_hash(const std::filesystem::path& study, const std::string& path);

}  // namespace mien::test
