#include "pipeline/tasks/hash.h"

#include <array>
#include <bit>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include <fmt/format.h>
#include <xxhash.h>

#include "pipeline/base/documents/files.h"

namespace mien::pipeline {

namespace {

Hash as_text(XXH128_hash_t hash) { return fmt::format("{:016x}{:016x}", hash.high64, hash.low64); }

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

struct StateDeleter {
  void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
};

[[noreturn]] void throw_errno(const std::filesystem::path& file) {
  throw std::system_error(errno, std::generic_category(), file.string());
}

}  // namespace

Hash hash_of(std::string_view bytes) { return as_text(XXH3_128bits(bytes.data(), bytes.size())); }

Hash hash_of_file(const std::filesystem::path& file) {
  refuse_special_file(file);
  const std::unique_ptr<std::FILE, CloseFile> stream(std::fopen(file.c_str(), "rb"));
  if (!stream) throw_errno(file);
  const std::unique_ptr<XXH3_state_t, StateDeleter> state(XXH3_createState());
  XXH3_128bits_reset(state.get());
  auto buffer = std::make_unique<std::array<char, 1 << 16>>();
  while (const std::size_t count = std::fread(buffer->data(), 1, buffer->size(), stream.get())) {
    XXH3_128bits_update(state.get(), buffer->data(), count);
  }
  if (std::ferror(stream.get()) != 0) throw_errno(file);
  return as_text(XXH3_128bits_digest(state.get()));
}

KeyBuilder& KeyBuilder::add(std::string_view name, std::string_view value) {
  determinants_ += fmt::format("{}:{}={}:{};", name.size(), name, value.size(), value);
  return *this;
}

KeyBuilder& KeyBuilder::add(std::string_view name, double value) {
  return add(name, fmt::format("{:016x}", std::bit_cast<std::uint64_t>(value)));
}

KeyBuilder& KeyBuilder::add(std::string_view name, std::int64_t value) {
  return add(name, fmt::format("{}", value));
}

Hash KeyBuilder::key() const { return hash_of(determinants_); }

}  // namespace mien::pipeline
