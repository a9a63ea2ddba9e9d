#include "motion/formats/fbx/fbx_numbers.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <new>
#include <type_traits>

#include <libdeflate.h>

#include "motion/formats/fbx/fbx_values.h"
#include "motion/formats/fbx/fbx_words.h"
#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

struct DecompressorFreeing {
  void operator()(libdeflate_decompressor* one) const { libdeflate_free_decompressor(one); }
};

/// Inflates into exactly `size` bytes; false if the stream is damaged or of another length.
bool inflate_exactly(std::string_view deflated, char* bytes, std::size_t size) {
  const std::unique_ptr<libdeflate_decompressor, DecompressorFreeing> decompressor(
      libdeflate_alloc_decompressor());
  if (!decompressor) throw std::bad_alloc();
  return libdeflate_zlib_decompress(decompressor.get(), deflated.data(), deflated.size(), bytes,
                                    size, nullptr) == LIBDEFLATE_SUCCESS;
}

/// Copies the bytes of an array, inflated if need be, to `bytes`, which has room for exactly them.
void copy_array(const FbxDocument& document, const FbxArray& array, char* bytes) {
  if (!array.is_deflated) {
    std::copy(array.stored.begin(), array.stored.end(), bytes);
  } else if (!inflate_exactly(array.stored, bytes, array.inflated_bytes())) {
    refuse_fbx(document, array.stored.data(),
               "a compressed array is damaged or not of the stated length", fbx_again);
  }
}

template <class Number, class Stored>
std::vector<Number> converted(const FbxDocument& document, const FbxArray& array) {
  std::vector<Number> numbers(array.count);
  if constexpr (std::is_same_v<Number, Stored>) {
    copy_array(document, array, reinterpret_cast<char*>(numbers.data()));
  } else {
    const auto stored = std::make_unique_for_overwrite<Stored[]>(array.count);
    copy_array(document, array, reinterpret_cast<char*>(stored.get()));
    for (size_t i = 0; i < numbers.size(); ++i) {
      if constexpr (std::is_floating_point_v<Stored> && std::is_integral_v<Number>) {
        numbers[i] = as_integer(stored[i]);
      } else {
        numbers[i] = static_cast<Number>(stored[i]);
      }
    }
  }
  return numbers;
}

template <class Number>
std::vector<Number> array_numbers(const FbxDocument& document, const FbxArray& array) {
  switch (array.type) {
    case 'f':
      return converted<Number, float>(document, array);
    case 'd':
      return converted<Number, double>(document, array);
    case 'l':
      return converted<Number, std::int64_t>(document, array);
    case 'i':
      return converted<Number, std::int32_t>(document, array);
    default:
      return converted<Number, std::uint8_t>(document, array);
  }
}

/// The numbers of a list as text.
template <class Number>
std::vector<Number> listed_numbers(const FbxDocument& document, std::string_view text) {
  std::vector<Number> numbers;
  for (;;) {
    skip_fbx_separators(text);
    if (text.empty()) return numbers;
    Number number{};
    const char* const end = text.data() + text.size();
    const char* stop = nullptr;
    if constexpr (std::is_integral_v<Number>) {
      const std::from_chars_result result = std::from_chars(text.data(), end, number);
      if (result.ec == std::errc{}) stop = result.ptr;
    }
    if (stop == nullptr || (stop < end && !is_fbx_separator(*stop) && *stop != ';')) {
      double decimal = 0.0;
      stop = parse_fbx_decimal(text.data(), end, decimal);
      if constexpr (std::is_integral_v<Number>) {
        number = as_integer(decimal);
      } else {
        number = static_cast<Number>(decimal);
      }
    }
    if (stop == nullptr || (stop < end && !is_fbx_separator(*stop) && *stop != ';')) {
      refuse_fbx(document, text.data(), in_quotes(fbx_word(text)) + " is not a valid number",
                 fbx_again);
    }
    numbers.push_back(number);
    text.remove_prefix(static_cast<size_t>(stop - text.data()));
  }
}

template <class Number>
std::vector<Number> text_numbers(const FbxDocument& document, std::uint32_t node) {
  std::string_view list = document.nodes[node].list;
  skip_fbx_separators(list);
  if (list.empty() || list.front() != '*') return listed_numbers<Number>(document, list);
  std::string_view stated = fbx_word(list);
  list.remove_prefix(stated.size());
  stated.remove_prefix(1);
  const std::uint32_t elements = find_child(document, node, "a");
  std::vector<Number> numbers;
  if (elements != 0) numbers = listed_numbers<Number>(document, document.nodes[elements].list);
  std::uint64_t count = 0;
  const char* const end = stated.data() + stated.size();
  const std::from_chars_result result = std::from_chars(stated.data(), end, count);
  if (result.ec != std::errc{} || result.ptr != end || count != numbers.size()) {
    refuse_fbx(document, stated.data(),
               "an array states " + in_quotes(stated) + " elements, but has " +
                   std::to_string(numbers.size()),
               fbx_again);
  }
  return numbers;
}

template <class Number>
std::vector<Number> numbers_of(const FbxDocument& document, std::uint32_t node) {
  if (document.is_text) return text_numbers<Number>(document, node);
  if (document.nodes[node].value_count == 1) {
    const FbxArray array = binary_array(document.nodes[node].list);
    if (array.type != 0) return array_numbers<Number>(document, array);
  }
  std::vector<Number> numbers;
  FbxValueCursor cursor = values_of(document, node);
  while (const std::optional<FbxValue> value = next_value(cursor)) {
    const bool is_number =
        value->kind == FbxValue::Kind::integer || value->kind == FbxValue::Kind::number;
    if (!is_number) refuse_fbx(document, node, "a list of numbers holds something else");
    numbers.push_back(std::is_integral_v<Number> ? static_cast<Number>(value->integer)
                                                 : static_cast<Number>(value->number));
  }
  return numbers;
}

template <class Number>
std::vector<Number> finite_numbers_of(const FbxDocument& document, std::uint32_t node) {
  std::vector<Number> numbers = numbers_of<Number>(document, node);
  if (!std::all_of(numbers.begin(), numbers.end(), [](Number n) { return std::isfinite(n); })) {
    refuse_fbx(document, node, "a number is not finite");
  }
  return numbers;
}

}  // namespace

std::vector<double> doubles_of(const FbxDocument& document, std::uint32_t node) {
  return finite_numbers_of<double>(document, node);
}

std::vector<float> floats_of(const FbxDocument& document, std::uint32_t node) {
  return numbers_of<float>(document, node);
}

std::vector<std::int64_t> integers_of(const FbxDocument& document, std::uint32_t node) {
  return numbers_of<std::int64_t>(document, node);
}

std::size_t stated_numbers_of(const FbxDocument& document, std::uint32_t node) {
  if (document.is_text) return 0;
  const FbxArray array = binary_array(document.nodes[node].list);
  return array.type != 0 ? array.count : document.nodes[node].value_count;
}

}  // namespace mien::motion
