#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "motion/math/geometry.h"

namespace mien::motion {

// Binary serialisation, little endian, doubles exact. A type's members are listed once, in a
// function template that works with a ByteWriter and a ByteReader alike:
//
//     template <class Bytes, class J>
//     void parts_of(Bytes& bytes, J& joint) { bytes.text(joint.name); bytes.vector(joint.offset); }

static_assert(std::endian::native == std::endian::little);

class ByteWriter {
 public:
  void whole(int value) { put(static_cast<std::int32_t>(value)); }
  void seed(std::uint64_t value) { put(value); }
  void flag(bool value) { whole(value ? 1 : 0); }
  void number(double value) { put(value); }
  void number_or_nan(double value) { put(value); }
  void text(const std::string& value);
  void vector(const Vec3& value);
  void rotation(const Quat& value);
  void matrix(const Eigen::MatrixXd& value);
  void vector(const Eigen::VectorXd& value);
  void numbers(const std::vector<double>& values);

  template <class Choice>
  void choice(Choice value, int /*count*/) {
    whole(static_cast<int>(value));
  }
  /// Writes the number of items, then calls `show` for each one. `least_bytes`: the smallest size
  /// of an item.
  template <class Items, class Show>
  void list(const Items& items, std::size_t /*least_bytes*/, Show show) {
    whole(static_cast<int>(items.size()));
    for (const auto& item : items) show(item);
  }
  template <class Value, class Show>
  void maybe(const std::optional<Value>& value, Show show) {
    flag(value.has_value());
    if (value) show(*value);
  }

  template <class Plain>
  void put(const Plain& value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }

  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Reads the values in the order in which ByteWriter wrote them. Throws Error for invalid input: a
/// count beyond the remaining bytes, a number that is not finite (except by `number_or_nan`), a
/// rotation that is not a unit quaternion, an unknown enumerator.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : remaining_(bytes) {}

  void whole(int& value);
  void seed(std::uint64_t& value) { value = take<std::uint64_t>(); }
  void flag(bool& value);
  void number(double& value);
  void number_or_nan(double& value) { value = take<double>(); }
  void text(std::string& value);
  void vector(Vec3& value);
  void rotation(Quat& value);
  void matrix(Eigen::MatrixXd& value);
  void vector(Eigen::VectorXd& value);
  void numbers(std::vector<double>& values);

  template <class Choice>
  void choice(Choice& value, int count) {
    int chosen = 0;
    whole(chosen);
    if (chosen < 0 || chosen >= count) refuse();
    value = static_cast<Choice>(chosen);
  }
  template <class Items, class Show>
  void list(Items& items, std::size_t least_bytes, Show show) {
    items.resize(count_of(least_bytes));
    for (auto& item : items) show(item);
  }
  template <class Value, class Show>
  void maybe(std::optional<Value>& value, Show show) {
    bool is_there = false;
    flag(is_there);
    if (is_there) show(value.emplace());
  }

  template <class Plain>
  Plain take() {
    if (remaining_.size() < sizeof(Plain)) refuse();
    Plain value;
    std::memcpy(&value, remaining_.data(), sizeof value);
    remaining_.remove_prefix(sizeof value);
    return value;
  }

  /// Number of bytes that have not been read yet.
  std::size_t remaining() const { return remaining_.size(); }
  /// Reads the number of items that follow, each of at least `least_bytes` bytes.
  std::size_t count_of(std::size_t least_bytes);
  [[noreturn]] static void refuse();

 private:
  std::string_view remaining_;
};

/// FNV-1a hash, 64 bits: inputs of the same length that differ in one byte have different
/// checksums.
std::uint64_t checksum(std::string_view bytes);

}  // namespace mien::motion
