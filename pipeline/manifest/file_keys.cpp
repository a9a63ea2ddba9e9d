#include "pipeline/manifest/file_keys.h"

#include "pipeline/manifest/example_files.h"
#include "scenes/character/character.h"

namespace mien::pipeline {

namespace {

Hash key_with_parts(const std::filesystem::path& file) {
  KeyBuilder key;
  key.add("file", file.filename().string()).add("content", hash_of_file(file));
  for (const std::filesystem::path& part : motion_parts(file))
    key.add("part", part.filename().string()).add("content", hash_of_file(part));
  return key.key();
}

}  // namespace

const Hash& FileKeys::of(const std::filesystem::path& file) {
  const auto known = files_.find(file);
  return known != files_.end() ? known->second
                               : files_.emplace(file, key_with_parts(file)).first->second;
}

void FileKeys::set(const std::filesystem::path& file, const Hash& content) {
  files_[file] = KeyBuilder().add("file", file.filename().string()).add("content", content).key();
}

const Hash& FileKeys::of_character(const std::filesystem::path& file) {
  const auto known = characters_.find(file);
  if (known != characters_.end()) return known->second;
  KeyBuilder key;
  key.add("file", of(file));
  for (const std::filesystem::path& part : scenes::files_of_character(file))
    key.add("part", of(part));
  return characters_.emplace(file, key.key()).first->second;
}

}  // namespace mien::pipeline
