#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "motion/formats/numpy/npy.h"
#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

constexpr std::size_t most_numbers = std::size_t{1} << 29U;  // 4 GiB

template <typename Number>
Number reversed(Number number) {
  unsigned char bytes[sizeof number];
  std::memcpy(bytes, &number, sizeof number);
  std::reverse(std::begin(bytes), std::end(bytes));
  std::memcpy(&number, bytes, sizeof number);
  return number;
}

/// A number of 16 bits: 1 sign, 5 exponent, 10 fraction (IEEE 754).
double half(std::uint16_t bits) {
  const int exponent = bits >> 10U & 31;
  const double fraction = bits & 1023;
  const double size = exponent == 31  ? (fraction == 0.0 ? HUGE_VAL : NAN)
                      : exponent == 0 ? std::ldexp(fraction, -24)
                                      : std::ldexp(1024.0 + fraction, exponent - 25);
  return (bits & 0x8000U) != 0 ? -size : size;
}

template <typename Number, typename Convert>
void convert(const NpyArray& array, std::vector<double>& numbers, Convert to_double) {
  const bool is_foreign = array.type.is_big_endian != (std::endian::native == std::endian::big);
  const char* from = array.bytes.data();
  for (double& number : numbers) {
    Number value;
    std::memcpy(&value, from, sizeof value);
    from += sizeof value;
    number = to_double(is_foreign ? reversed(value) : value);
  }
}

template <typename Number>
void convert(const NpyArray& array, std::vector<double>& numbers) {
  convert<Number>(array, numbers, [](Number value) { return static_cast<double>(value); });
}

/// The first index varies slowest in the result.
std::vector<double> in_c_order(const std::vector<double>& fortran,
                               const std::vector<std::size_t>& shape) {
  std::vector<double> numbers(fortran.size());
  std::vector<std::size_t> steps(shape.size(), 1);
  for (std::size_t d = 1; d < shape.size(); ++d) steps[d] = steps[d - 1] * shape[d - 1];
  std::vector<std::size_t> index(shape.size(), 0);
  std::size_t from = 0;
  for (double& number : numbers) {
    number = fortran[from];
    for (std::size_t d = shape.size(); d-- > 0;) {
      from += steps[d];
      if (++index[d] < shape[d]) break;
      from -= steps[d] * shape[d];
      index[d] = 0;
    }
  }
  return numbers;
}

bool convert_by_type(const NpyArray& array, std::vector<double>& numbers) {
  const auto is = [&](char kind, std::size_t bytes) {
    return array.type.kind == kind && array.type.bytes == bytes;
  };
  if (is('f', 8))
    convert<double>(array, numbers);
  else if (is('f', 4))
    convert<float>(array, numbers);
  else if (is('f', 2))
    convert<std::uint16_t>(array, numbers, half);
  else if (is('i', 8))
    convert<std::int64_t>(array, numbers);
  else if (is('i', 4))
    convert<std::int32_t>(array, numbers);
  else if (is('i', 2))
    convert<std::int16_t>(array, numbers);
  else if (is('i', 1))
    convert<std::int8_t>(array, numbers);
  else if (is('u', 8))
    convert<std::uint64_t>(array, numbers);
  else if (is('u', 4))
    convert<std::uint32_t>(array, numbers);
  else if (is('u', 2))
    convert<std::uint16_t>(array, numbers);
  else if (is('u', 1) || is('b', 1))
    convert<std::uint8_t>(array, numbers);
  else
    return false;
  return true;
}

void append_utf8(std::string& text, std::uint32_t code) {
  if (code < 0x80) {
    text += static_cast<char>(code);
    return;
  }
  const unsigned follow = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
  const unsigned lead = follow == 1 ? 0xC0 : follow == 2 ? 0xE0 : 0xF0;
  text += static_cast<char>(lead | code >> (6 * follow));
  for (unsigned i = follow; i-- > 0;) text += static_cast<char>(0x80 | (code >> (6 * i) & 63U));
}

/// An element of an array of Unicode text, four bytes a character.
std::string unicode_text(std::string_view element, bool is_big_endian) {
  std::string text;
  for (std::size_t i = 0; i + 4 <= element.size(); i += 4) {
    std::uint32_t code = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto byte = static_cast<unsigned char>(element[i + (is_big_endian ? k : 3 - k)]);
      code = code << 8U | byte;
    }
    const bool is_character = code <= 0x10FFFF && !(code >= 0xD800 && code <= 0xDFFF);
    append_utf8(text, is_character ? code : 0xFFFD);
  }
  return text;
}

template <typename Number>
NpyArray array_as(std::span<const double> numbers, std::vector<std::size_t> shape) {
  NpyArray array;
  array.type = {'f', sizeof(Number), false};
  array.shape = std::move(shape);
  array.bytes.resize(numbers.size() * sizeof(Number));
  char* to = array.bytes.data();
  for (const double number : numbers) {
    auto value = static_cast<Number>(number);
    if constexpr (std::endian::native == std::endian::big) value = reversed(value);
    std::memcpy(to, &value, sizeof value);
    to += sizeof value;
  }
  return array;
}

}  // namespace

std::vector<double> numbers_of(const NpyArray& array, const Place& place) {
  require_readable(array, place);
  if (array.type.bytes == 0 || array.bytes.size() / array.type.bytes != array.size()) {
    throw Error(place, described(array) + " holds no numbers", "save it as an array of numbers");
  }
  if (array.size() > most_numbers)
    throw Error(place, described(array) + " holds more than 536870912 numbers",
                "cut the motion into shorter files");
  std::vector<double> numbers(array.size());
  if (!convert_by_type(array, numbers)) {
    throw Error(place,
                described(array) +
                    (array.type.kind == 'U' || array.type.kind == 'S'
                         ? " holds text"
                         : " holds numbers of " + std::to_string(array.type.bytes) + " bytes") +
                    ", where numbers of up to 64 bits are needed",
                "save it as an array of numbers, for example with .astype(float)");
  }
  const bool is_table = array.shape.size() > 1;
  return array.is_fortran_order && is_table ? in_c_order(numbers, array.shape) : numbers;
}

std::vector<std::string> texts_of(const NpyArray& array, const Place& place) {
  require_readable(array, place);
  const bool is_unicode = array.type.kind == 'U';
  if (!is_unicode && array.type.kind != 'S')
    throw Error(place, described(array) + " holds numbers, where text is needed",
                "save it as an array of text");
  std::vector<std::string> texts;
  if (array.type.bytes == 0) return texts;
  const std::string_view bytes = array.bytes;
  for (std::size_t at = 0; at + array.type.bytes <= bytes.size(); at += array.type.bytes) {
    const std::string_view element = bytes.substr(at, array.type.bytes);
    std::string text =
        is_unicode ? unicode_text(element, array.type.is_big_endian) : std::string(element);
    while (text.ends_with('\0')) text.pop_back();
    texts.push_back(std::move(text));
  }
  return texts;
}

NpyArray array_of(std::span<const double> numbers, std::vector<std::size_t> shape) {
  return array_as<double>(numbers, std::move(shape));
}

NpyArray array_of_floats(std::span<const double> numbers, std::vector<std::size_t> shape) {
  return array_as<float>(numbers, std::move(shape));
}

}  // namespace mien::motion
