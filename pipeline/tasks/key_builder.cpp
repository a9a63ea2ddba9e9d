#include "pipeline/tasks/key_builder.h"

#include <bit>

#include <fmt/format.h>

namespace mien::pipeline {

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
