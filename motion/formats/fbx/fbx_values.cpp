#include "motion/formats/fbx/fbx_values.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "motion/formats/fbx/fbx_words.h"
#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

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

FbxValue integer_value(std::int64_t integer) {
  return {FbxValue::Kind::integer, integer, static_cast<double>(integer), {}};
}

FbxValue number_value(double number) {
  return {FbxValue::Kind::number, as_integer(number), number, {}};
}

FbxValue binary_value(std::string_view bytes) {
  const char* data = bytes.data() + 1;
  switch (bytes.front()) {
    case 'C':
    case 'B':
      return {FbxValue::Kind::integer, bytes_as<std::uint8_t>(data),
              static_cast<double>(bytes_as<std::uint8_t>(data)), bytes.substr(1, 1)};
    case 'Y':
      return integer_value(bytes_as<std::int16_t>(data));
    case 'I':
      return integer_value(bytes_as<std::int32_t>(data));
    case 'L':
      return integer_value(bytes_as<std::int64_t>(data));
    case 'F':
      return number_value(bytes_as<float>(data));
    case 'D':
      return number_value(bytes_as<double>(data));
    case 'S':
      return {FbxValue::Kind::text, 0, 0.0, bytes.substr(5)};
    case 'R':
      return {FbxValue::Kind::raw, 0, 0.0, bytes.substr(5)};
    default:
      return {FbxValue::Kind::array, 0, 0.0, bytes};
  }
}

bool begins_number(char c) { return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.'; }

FbxValue text_number(const FbxDocument& document, std::string_view word) {
  const char* const end = word.data() + word.size();
  std::int64_t integer = 0;
  const std::from_chars_result result = std::from_chars(word.data(), end, integer);
  if (result.ec == std::errc{} && result.ptr == end) return integer_value(integer);
  double number = 0.0;
  const char* stop = parse_fbx_decimal(word.data(), end, number);
  if (stop != end) {
    refuse_fbx(document, word.data(), in_quotes(word) + " is not a valid number", fbx_again);
  }
  return number_value(number);
}

std::optional<FbxValue> next_text_value(FbxValueCursor& cursor) {
  skip_fbx_separators(cursor.rest);
  if (!cursor.rest.empty() && cursor.rest.front() == '*') {
    cursor.rest.remove_prefix(fbx_word(cursor.rest).size());
    skip_fbx_separators(cursor.rest);
  }
  if (cursor.rest.empty()) return std::nullopt;
  if (cursor.rest.front() == '"') {
    // The parser of the document has seen that there is a second one.
    const size_t close = std::min(cursor.rest.find('"', 1), cursor.rest.size() - 1);
    const FbxValue value{FbxValue::Kind::text, 0, 0.0, cursor.rest.substr(1, close - 1)};
    cursor.rest.remove_prefix(close + 1);
    return value;
  }
  const std::string_view word = fbx_word(cursor.rest);
  cursor.rest.remove_prefix(word.size());
  if (begins_number(word.front())) return text_number(cursor.document, word);
  return FbxValue{FbxValue::Kind::text, 0, 0.0, word};
}

}  // namespace

std::uint64_t FbxArray::inflated_bytes() const { return count * element_size(type); }

std::size_t binary_value_size(std::string_view bytes) {
  if (bytes.empty()) return 0;
  const char type = bytes.front();
  std::uint64_t size = 0;
  if (type == 'S' || type == 'R') {
    if (bytes.size() < 5) return 0;
    size = 5 + std::uint64_t{bytes_as<std::uint32_t>(bytes.data() + 1)};
  } else if (element_size(type) > 0) {
    if (bytes.size() < 13) return 0;
    size = 13 + std::uint64_t{bytes_as<std::uint32_t>(bytes.data() + 9)};
    if (bytes_as<std::uint32_t>(bytes.data() + 5) > 1) return 0;
  } else if (scalar_size(type) > 0) {
    size = 1 + scalar_size(type);
  }
  return size <= bytes.size() ? size : 0;
}

FbxArray binary_array(std::string_view bytes) {
  if (bytes.empty() || element_size(bytes.front()) == 0) return {};
  return {bytes.front(), bytes_as<std::uint32_t>(bytes.data() + 5) == 1,
          bytes_as<std::uint32_t>(bytes.data() + 1),
          bytes.substr(13, bytes_as<std::uint32_t>(bytes.data() + 9))};
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

}  // namespace mien::motion
