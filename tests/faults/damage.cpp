#include "faults/damage.h"

#include <fstream>

#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include "pipeline/tasks/receipt.h"

#include "end_to_end/program.h"

namespace mien::test {

namespace {

namespace fs = std::filesystem;
using Random = std::mt19937_64;

void write(const fs::path& file, const std::string& bytes) {
  fs::remove(file);  // a frame may have a second name, whose bytes are to stay
  std::ofstream(file, std::ios::binary) << bytes;
}

std::string with_flipped_bit(std::string bytes, Random& random) {
  if (bytes.empty()) return "x";
  bytes[random() % bytes.size()] ^= static_cast<char>(1u << random() % 8);
  return bytes;
}

void flip_bit(const fs::path& file, Random& random) {
  write(file, with_flipped_bit(text_of(file), random));
}

/// In the file itself, as a failing disk does: what has a second name for it changes, too.
void flip_bit_in_place(const fs::path& file, Random& random) {
  const std::string bytes = with_flipped_bit(text_of(file), random);
  std::ofstream(file, std::ios::binary) << bytes;
}

void cut_off(const fs::path& file, Random& random) {
  const std::string bytes = text_of(file);
  write(file, bytes.empty() ? "x" : bytes.substr(0, random() % bytes.size()));
}

/// What a machine leaves that lost its power before the bytes were on the disk.
void fill_with_zeros(const fs::path& file, Random& random) {
  const std::string bytes = text_of(file);
  const std::size_t kept = bytes.empty() ? 0 : random() % bytes.size();
  const std::string zeros(bytes.size() - kept + 1, '\0');
  write(file, bytes.substr(0, kept) + zeros);
}

void empty(const fs::path& file, Random&) { write(file, text_of(file).empty() ? "x" : ""); }

void append(const fs::path& file, Random&) { write(file, text_of(file) + "x"); }

void remove(const fs::path& file, Random&) { fs::remove(file); }

void replace_by_folder(const fs::path& file, Random&) {
  fs::remove(file);
  fs::create_directories(file / "inside");
}

void replace_by_loop(const fs::path& file, Random&) {
  fs::remove(file);
  fs::create_symlink(file.filename(), file);
}

void replace_by_pipe(const fs::path& file, Random&) {
  fs::remove(file);
  mkfifo(file.c_str(), 0600);
}

std::string receipt_text(const fs::path& study, const std::string& path) {
  return text_of(pipeline::receipt_path(study, path));
}

}  // namespace

const std::vector<Damage>& damages() {
  static const std::vector<Damage> all = {{"a flipped bit", flip_bit},
                                          {"a bit flipped in place", flip_bit_in_place},
                                          {"cut off", cut_off},
                                          {"zeros", fill_with_zeros},
                                          {"emptied", empty},
                                          {"a byte more", append},
                                          {"removed", remove},
                                          {"a folder in its place", replace_by_folder},
                                          {"a loop of links in its place", replace_by_loop},
                                          {"a pipe in its place", replace_by_pipe}};
  return all;
}

void swap_files(const fs::path& one, const fs::path& other) {
  fs::path between = one;
  between += ".between";
  fs::rename(one, between);
  fs::rename(other, one);
  fs::rename(between, other);
}

void forge_receipt(const fs::path& study, const std::string& path, const std::string& other) {
  auto forged = pipeline::receipt_from_json(receipt_text(study, other));
  if (!forged) return;  // it was damaged before
  forged->path = path;
  write(pipeline::receipt_path(study, path), pipeline::to_json(*forged));
}

void forge_hash(const fs::path& study, const std::string& path) {
  auto forged = nlohmann::json::parse(receipt_text(study, path), nullptr, false);
  if (!forged.is_object()) return;
  const std::string bytes = text_of(study / path);
  forged["hash"] = pipeline::hash_of(bytes);
  forged["size"] = bytes.size();
  write(pipeline::receipt_path(study, path), forged.dump(1) + "\n");
}

}  // namespace mien::test
