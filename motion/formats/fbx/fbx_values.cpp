#include "motion/formats/fbx/fbx_values.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <type_traits>

#include <zlib.h>

#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

template <class T>
T at(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

std::size_t element_size(char type) {
  switch (type) {
    case 'f':
    case 'i':
      return 4;
    case 'd':
    case 'l':
      return 8;
    case 'b':
    case 'c':
      return 1;
    default:
      return 0;
  }
}

std::size_t scalar_size(char type) {
  switch (type) {
    case 'C':
    case 'B':
      return 1;
    case 'Y':
      return 2;
    case 'I':
    case 'F':
      return 4;
    case 'D':
    case 'L':
      return 8;
    default:
      return 0;
  }
}

/// Like a cast, but defined for any number.
std::int64_t whole(double number) {
  if (!(std::abs(number) < 9.2e18)) return 0;
  return static_cast<std::int64_t>(number);
}

FbxValue integer_value(std::int64_t integer) {
  return {FbxValue::Kind::integer, integer, static_cast<double>(integer), {}};
}

FbxValue number_value(double number) { return {FbxValue::Kind::number, whole(number), number, {}}; }

FbxValue binary_value(std::string_view bytes) {
  const char* data = bytes.data() + 1;
  switch (bytes.front()) {
    case 'C':
    case 'B':
      return {FbxValue::Kind::integer, at<std::uint8_t>(data),
              static_cast<double>(at<std::uint8_t>(data)), bytes.substr(1, 1)};
    case 'Y':
      return integer_value(at<std::int16_t>(data));
    case 'I':
      return integer_value(at<std::int32_t>(data));
    case 'L':
      return integer_value(at<std::int64_t>(data));
    case 'F':
      return number_value(at<float>(data));
    case 'D':
      return number_value(at<double>(data));
    case 'S':
      return {FbxValue::Kind::text, 0, 0.0, bytes.substr(5)};
    case 'R':
      return {FbxValue::Kind::raw, 0, 0.0, bytes.substr(5)};
    default:
      return {FbxValue::Kind::array, 0, 0.0, bytes};
  }
}

bool is_separator(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f' || c == ',';
}

/// Over white space, commas and comments.
void skip_separators(std::string_view& text) {
  size_t i = 0;
  while (i < text.size()) {
    if (text[i] == ';') {
      i = std::min(text.find_first_of("\r\n", i), text.size());
    } else if (is_separator(text[i])) {
      ++i;
    } else {
      break;
    }
  }
  text.remove_prefix(i);
}

std::string_view word_of(std::string_view text) {
  size_t i = 0;
  while (i < text.size() && !is_separator(text[i]) && text[i] != '"' && text[i] != ';') ++i;
  return text.substr(0, std::max<size_t>(i, 1));
}

bool begins_number(char c) { return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.'; }

/// A decimal number; those too small for a double are zero. Returns where it ends, null if it is
/// none.
const char* parse_decimal(const char* start, const char* end, double& number) {
  if (start + 1 < end && *start == '+' && start[1] != '-') ++start;
  const std::from_chars_result result = std::from_chars(start, end, number);
  if (result.ec == std::errc::result_out_of_range) {
    const std::string word(start, result.ptr);
    number = std::strtod(word.c_str(), nullptr);
    return std::abs(number) < 1.0 ? result.ptr : nullptr;
  }
  return result.ec == std::errc{} ? result.ptr : nullptr;
}

FbxValue text_number(const FbxDocument& document, std::string_view word) {
  const char* const end = word.data() + word.size();
  std::int64_t integer = 0;
  const std::from_chars_result result = std::from_chars(word.data(), end, integer);
  if (result.ec == std::errc{} && result.ptr == end) return integer_value(integer);
  double number = 0.0;
  const char* stop = parse_decimal(word.data(), end, number);
  if (stop != end) {
    refuse_fbx(document, word.data(), in_quotes(word) + " is not a valid number", fbx_again);
  }
  return number_value(number);
}

std::optional<FbxValue> next_text_value(FbxValueCursor& cursor) {
  skip_separators(cursor.rest);
  if (!cursor.rest.empty() && cursor.rest.front() == '*') {
    cursor.rest.remove_prefix(word_of(cursor.rest).size());
    skip_separators(cursor.rest);
  }
  if (cursor.rest.empty()) return std::nullopt;
  if (cursor.rest.front() == '"') {
    // The parser of the document has seen that there is a second one.
    const size_t close = std::min(cursor.rest.find('"', 1), cursor.rest.size() - 1);
    const FbxValue value{FbxValue::Kind::text, 0, 0.0, cursor.rest.substr(1, close - 1)};
    cursor.rest.remove_prefix(close + 1);
    return value;
  }
  const std::string_view word = word_of(cursor.rest);
  cursor.rest.remove_prefix(word.size());
  if (begins_number(word.front())) return text_number(cursor.document, word);
  return FbxValue{FbxValue::Kind::text, 0, 0.0, word};
}

/// Inflates into exactly `size` bytes; false if the stream is damaged or of another length.
bool inflate_exactly(std::string_view deflated, char* bytes, std::size_t size) {
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) return false;
  char nothing = 0;
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(deflated.data()));
  stream.avail_in = static_cast<uInt>(deflated.size());
  stream.next_out = reinterpret_cast<Bytef*>(size == 0 ? &nothing : bytes);
  stream.avail_out = static_cast<uInt>(size);
  const int result = inflate(&stream, Z_FINISH);
  const bool is_whole = result == Z_STREAM_END && stream.total_out == size;
  inflateEnd(&stream);
  return is_whole;
}

template <class Number, class Stored>
std::vector<Number> converted(std::string_view bytes) {
  std::vector<Number> numbers(bytes.size() / sizeof(Stored));
  for (size_t i = 0; i < numbers.size(); ++i) {
    const Stored stored = at<Stored>(bytes.data() + i * sizeof(Stored));
    if constexpr (std::is_floating_point_v<Stored> && std::is_integral_v<Number>) {
      numbers[i] = whole(stored);
    } else {
      numbers[i] = static_cast<Number>(stored);
    }
  }
  return numbers;
}

template <class Number>
std::vector<Number> array_numbers(const FbxDocument& document, const FbxArray& array) {
  std::string inflated;
  std::string_view bytes = array.stored;
  if (array.is_deflated) {
    inflated.resize(array.inflated_bytes());
    if (!inflate_exactly(array.stored, inflated.data(), inflated.size())) {
      refuse_fbx(document, array.stored.data(),
                 "a compressed array is damaged or not of the stated length", fbx_again);
    }
    bytes = inflated;
  }
  switch (array.type) {
    case 'f':
      return converted<Number, float>(bytes);
    case 'd':
      return converted<Number, double>(bytes);
    case 'l':
      return converted<Number, std::int64_t>(bytes);
    case 'i':
      return converted<Number, std::int32_t>(bytes);
    default:
      return converted<Number, std::uint8_t>(bytes);
  }
}

/// The numbers of a list as text.
template <class Number>
std::vector<Number> listed_numbers(const FbxDocument& document, std::string_view text) {
  std::vector<Number> numbers;
  for (;;) {
    skip_separators(text);
    if (text.empty()) return numbers;
    Number number{};
    const char* const end = text.data() + text.size();
    const char* stop = nullptr;
    if constexpr (std::is_integral_v<Number>) {
      const std::from_chars_result result = std::from_chars(text.data(), end, number);
      if (result.ec == std::errc{}) stop = result.ptr;
    }
    if (stop == nullptr || (stop < end && !is_separator(*stop) && *stop != ';')) {
      double decimal = 0.0;
      stop = parse_decimal(text.data(), end, decimal);
      if constexpr (std::is_integral_v<Number>) {
        number = whole(decimal);
      } else {
        number = static_cast<Number>(decimal);
      }
    }
    if (stop == nullptr || (stop < end && !is_separator(*stop) && *stop != ';')) {
      refuse_fbx(document, text.data(), in_quotes(word_of(text)) + " is not a valid number",
                 fbx_again);
    }
    numbers.push_back(number);
    text.remove_prefix(static_cast<size_t>(stop - text.data()));
  }
}

template <class Number>
std::vector<Number> text_numbers(const FbxDocument& document, std::uint32_t node) {
  std::string_view list = document.nodes[node].list;
  skip_separators(list);
  if (list.empty() || list.front() != '*') return listed_numbers<Number>(document, list);
  std::string_view stated = word_of(list);
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

std::uint64_t FbxArray::inflated_bytes() const { return count * element_size(type); }

std::size_t binary_value_size(std::string_view bytes) {
  if (bytes.empty()) return 0;
  const char type = bytes.front();
  std::uint64_t size = 0;
  if (type == 'S' || type == 'R') {
    if (bytes.size() < 5) return 0;
    size = 5 + std::uint64_t{at<std::uint32_t>(bytes.data() + 1)};
  } else if (element_size(type) > 0) {
    if (bytes.size() < 13) return 0;
    size = 13 + std::uint64_t{at<std::uint32_t>(bytes.data() + 9)};
    if (at<std::uint32_t>(bytes.data() + 5) > 1) return 0;
  } else if (scalar_size(type) > 0) {
    size = 1 + scalar_size(type);
  }
  return size <= bytes.size() ? size : 0;
}

FbxArray binary_array(std::string_view bytes) {
  if (bytes.empty() || element_size(bytes.front()) == 0) return {};
  return {bytes.front(), at<std::uint32_t>(bytes.data() + 5) == 1,
          at<std::uint32_t>(bytes.data() + 1),
          bytes.substr(13, at<std::uint32_t>(bytes.data() + 9))};
}

FbxValueCursor values_of(const FbxDocument& document, std::uint32_t node) {
  return {document, document.nodes[node].list, document.nodes[node].value_count};
}

std::optional<FbxValue> next_value(FbxValueCursor& cursor) {
  if (cursor.document.is_text) return next_text_value(cursor);
  if (cursor.left == 0) return std::nullopt;
  const size_t size = binary_value_size(cursor.rest);
  const FbxValue value = binary_value(cursor.rest.substr(0, size));
  cursor.rest.remove_prefix(size);
  --cursor.left;
  return value;
}

std::optional<FbxValue> value_at(const FbxDocument& document, std::uint32_t node, int index) {
  FbxValueCursor cursor = values_of(document, node);
  std::optional<FbxValue> value = next_value(cursor);
  for (int i = 0; i < index && value; ++i) value = next_value(cursor);
  return value;
}

std::int64_t integer_of(const FbxDocument& document, std::uint32_t node, int index) {
  const std::optional<FbxValue> value = value_at(document, node, index);
  if (!value) return 0;
  if (value->kind != FbxValue::Kind::integer && value->kind != FbxValue::Kind::number) {
    refuse_fbx(document, node,
               "a whole number is expected in " + in_quotes(document.nodes[node].name));
  }
  return value->integer;
}

double number_of(const FbxDocument& document, std::uint32_t node, int index) {
  const std::optional<FbxValue> value = value_at(document, node, index);
  if (!value) return 0.0;
  const bool is_number =
      value->kind == FbxValue::Kind::integer || value->kind == FbxValue::Kind::number;
  if (!is_number || !std::isfinite(value->number)) {
    refuse_fbx(document, node, "a number is expected in " + in_quotes(document.nodes[node].name));
  }
  return value->number;
}

std::string_view text_of(const FbxDocument& document, std::uint32_t node, int index) {
  const std::optional<FbxValue> value = value_at(document, node, index);
  return value && value->kind == FbxValue::Kind::text ? value->text : std::string_view();
}

std::string decoded(const FbxDocument& document, std::string_view text) {
  constexpr std::string_view quote = "&quot;";
  std::string plain;
  for (size_t at = 0; at < text.size();) {
    const size_t next =
        document.is_text ? std::min(text.find(quote, at), text.size()) : text.size();
    plain += text.substr(at, next - at);
    if (next < text.size()) plain += '"';
    at = next + (next < text.size() ? quote.size() : 0);
  }
  return plain;
}

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
