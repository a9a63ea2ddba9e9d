#pragma once

#include <filesystem>
#include <random>
#include <string>
#include <vector>

namespace mien::test {

/// A kind of damage to a file: "a flipped bit", "cut off", …
struct Damage {
  const char* name;
  void (*to)(const std::filesystem::path& file, std::mt19937_64& random);
};

/// All kinds of damage to a single file. Each changes its bytes or removes it.
const std::vector<Damage>& damages();

/// Exchanges two files.
void swap_files(const std::filesystem::path& one, const std::filesystem::path& other);

/// Replaces the receipt of an artifact by that of another one with adapted path and a correct
/// checksum, like a careful forger.
void forge_receipt(const std::filesystem::path& study, const std::string& path,
                   const std::string& other);

/// Updates hash and size in the receipt to the artifact's present content, but not its checksum.
void forge_hash(const std::filesystem::path& study, const std::string& path);

}  // namespace mien::test
