#include "motion/formats/c3d/c3d_parameters.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "motion/error.h"
#include "motion/formats/c3d/c3d_bytes.h"

namespace mien::motion {

namespace {

constexpr std::size_t most_records = 65'536;
constexpr std::size_t most_texts = 65'536;
constexpr std::string_view obtain_again = "obtain the file again, or export it again";

std::string in_capitals(std::string_view text) {
  std::string capitals(text);
  for (char& c : capitals) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return capitals;
}

/// A group or a parameter of the section.
struct Record {
  int group = 0;  ///< negative for the definition of a group
  std::string_view name;
  std::size_t body = 0;  ///< where what follows the offset begins
  std::size_t next = 0;  ///< where the next record begins; 0: there is none
};

void require_bytes(const C3dFile& file, std::size_t at, std::size_t length) {
  if (at <= file.bytes.size() && length <= file.bytes.size() - at) return;
  fail_c3d(file, at, "the parameter section leads beyond the end of the file", obtain_again);
}

/// The record at a byte; nothing at the end of the section, a name of no characters.
std::optional<Record> parse_record(const C3dFile& file, std::size_t at) {
  if (at >= file.bytes.size()) return std::nullopt;
  const int length = std::abs(static_cast<signed char>(file.bytes[at]));
  if (length == 0) return std::nullopt;
  const std::size_t name_length = static_cast<std::size_t>(length);
  require_bytes(file, at, name_length + 4);
  Record record;
  record.group = static_cast<signed char>(file.bytes[at + 1]);
  record.name = file.bytes.substr(at + 2, name_length);
  const std::size_t offset_at = at + 2 + name_length;
  const std::size_t offset = c3d_word(file.bytes.data() + offset_at, file.processor);
  if (offset == 1) fail_c3d(file, offset_at, "a parameter has no room", obtain_again);
  record.body = offset_at + 2;
  record.next = offset == 0 ? 0 : offset_at + offset;
  return record;
}

C3dParameter parse_parameter(const C3dFile& file, const Record& record) {
  require_bytes(file, record.body, 2);
  C3dParameter parameter;
  parameter.type = static_cast<signed char>(file.bytes[record.body]);
  const std::size_t dimensions = byte_at(file.bytes.data() + record.body + 1);
  if ((parameter.type != -1 && parameter.type != 1 && parameter.type != 2 && parameter.type != 4) ||
      dimensions > 7) {
    fail_c3d(file, record.body, "a parameter is neither text nor numbers", obtain_again);
  }
  require_bytes(file, record.body + 2, dimensions);
  std::size_t size = static_cast<std::size_t>(std::abs(parameter.type));
  for (std::size_t i = 0; i < dimensions; ++i) {
    parameter.dimensions.push_back(byte_at(file.bytes.data() + record.body + 2 + i));
    size *= parameter.dimensions.back();
  }
  const std::size_t data = record.body + 2 + dimensions;
  require_bytes(file, data, size);
  parameter.data = file.bytes.substr(data, size);
  return parameter;
}

/// The value as it stands in the file, its integers with or without sign.
std::optional<double> number(const C3dFile& file, std::string_view name, std::size_t index,
                             bool with_sign) {
  const C3dParameter* parameter = find_c3d_parameter(file, name);
  if (parameter == nullptr || parameter->type < 1) return std::nullopt;
  const std::size_t size = static_cast<std::size_t>(parameter->type);
  if (index >= parameter->data.size() / size) return std::nullopt;
  const char* at = parameter->data.data() + index * size;
  if (parameter->type == 4) return c3d_real(at, file.processor);
  if (parameter->type == 1) {
    return with_sign ? static_cast<signed char>(*at) : static_cast<double>(byte_at(at));
  }
  const std::uint16_t word = c3d_word(at, file.processor);
  return with_sign ? static_cast<std::int16_t>(word) : static_cast<double>(word);
}

}  // namespace

void fail_c3d(const C3dFile& file, std::size_t byte, std::string_view wrong,
              std::string_view remedy) {
  throw Error({file.name}, "at byte " + std::to_string(byte) + ": " + std::string(wrong), remedy);
}

C3dFile parse_c3d_parameters(std::string_view bytes, const std::string& file_name) {
  C3dFile file{bytes, file_name, {}, {}};
  if (bytes.size() < 2 * block_bytes || bytes[1] != 0x50 || bytes[0] == 0) {
    throw Error({file_name}, "is not a C3D file, or is cut short within its header",
                "name a C3D file, or obtain it again");
  }
  const std::size_t start = (byte_at(bytes.data()) - 1) * block_bytes;
  require_bytes(file, start, 4);
  const std::uint32_t processor = byte_at(bytes.data() + start + 3);
  if (start == 0 || processor < 84 || processor > 86) {
    fail_c3d(file, start + 3, "the parameter section does not state how numbers are stored",
             obtain_again);
  }
  file.processor = static_cast<C3dProcessor>(processor);
  std::map<int, std::string> groups;
  std::vector<Record> records;
  for (std::size_t at = start + 4; at != 0;) {
    const std::optional<Record> record = parse_record(file, at);
    if (!record) break;
    if (record->group < 0) groups.try_emplace(-record->group, in_capitals(record->name));
    if (record->group > 0) records.push_back(*record);
    if (records.size() > most_records)
      fail_c3d(file, at, "there are too many parameters", obtain_again);
    at = record->next;
  }
  for (const Record& record : records) {
    const auto group = groups.find(record.group);
    if (group == groups.end()) continue;
    file.parameters.try_emplace(group->second + ":" + in_capitals(record.name),
                                parse_parameter(file, record));
  }
  return file;
}

const C3dParameter* find_c3d_parameter(const C3dFile& file, std::string_view name) {
  const auto found = file.parameters.find(name);
  return found == file.parameters.end() ? nullptr : &found->second;
}

std::optional<double> c3d_number(const C3dFile& file, std::string_view name, std::size_t index) {
  return number(file, name, index, true);
}

std::optional<std::size_t> c3d_count(const C3dFile& file, std::string_view name,
                                     std::size_t index) {
  const std::optional<double> value = number(file, name, index, false);
  if (!value || !(*value >= 0.0 && *value < 4294967296.0) || *value != std::floor(*value))
    return std::nullopt;
  return static_cast<std::size_t>(*value);
}

std::vector<std::string> c3d_texts(const C3dFile& file, std::string_view name) {
  const C3dParameter* parameter = find_c3d_parameter(file, name);
  if (parameter == nullptr || parameter->type != -1 || parameter->data.empty()) return {};
  const std::size_t length = parameter->dimensions.empty() ? 1 : parameter->dimensions.front();
  const std::size_t number_of_texts = std::min(parameter->data.size() / length, most_texts);
  std::vector<std::string> found;
  found.reserve(number_of_texts);
  for (std::size_t i = 0; i < number_of_texts; ++i) {
    std::string_view text = parameter->data.substr(i * length, length);
    text = text.substr(0, text.find('\0'));
    const std::size_t first = text.find_first_not_of(" \t");
    found.emplace_back(first == std::string_view::npos
                           ? std::string_view()
                           : text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1));
  }
  return found;
}

std::vector<std::string> c3d_all_texts(const C3dFile& file, std::string_view name) {
  std::vector<std::string> found = c3d_texts(file, name);
  for (int part = 2; found.size() < most_texts; ++part) {
    const std::string next = std::string(name) + std::to_string(part);
    if (find_c3d_parameter(file, next) == nullptr) break;
    const std::vector<std::string> more = c3d_texts(file, next);
    found.insert(found.end(), more.begin(), more.end());
  }
  return found;
}

}  // namespace mien::motion
