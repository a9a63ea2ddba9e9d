#include "motion/formats/numpy/npy.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <numeric>
#include <optional>

#include "motion/text/excerpt.h"
#include "motion/text/file_contents.h"
#include "motion/text/file_kind.h"

namespace mien::motion {

namespace {

/// Number of bytes of the elements; empty if it exceeds what can be counted.
std::optional<std::size_t> bytes_of(const NpyHeader& header) {
  std::size_t bytes = header.type.bytes;
  if (std::find(header.shape.begin(), header.shape.end(), 0U) != header.shape.end()) return 0;
  for (const std::size_t extent : header.shape)
    if (__builtin_mul_overflow(bytes, extent, &bytes)) return std::nullopt;
  return bytes;
}

/// The array of a header, without its elements, of which so many bytes are there.
NpyArray outline(NpyHeader header, std::size_t present, const std::string& file_name,
                 std::string_view name) {
  const std::optional<std::size_t> declared = bytes_of(header);
  NpyArray array{std::string(name),       header.type, std::move(header.shape),
                 header.is_fortran_order, true,        {}};
  require_readable(array, {file_name});
  if (declared == present) return array;
  const bool is_short = !declared || *declared > present;
  throw Error({file_name},
              described(array) + " of shape " + excerpt(shape_text(array)) +
                  (is_short ? " is cut short: " : " is followed by other bytes: ") +
                  std::to_string(present) + " bytes follow its header at byte " +
                  std::to_string(header.start) + ", not " +
                  (declared ? std::to_string(*declared) : "as many as its shape needs"),
              is_short ? "obtain the file again" : "save one array a file with numpy.save");
}

}  // namespace

std::size_t NpyArray::size() const {
  return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

std::string shape_text(const NpyArray& array) {
  std::string text;
  for (const std::size_t extent : array.shape)
    text += (text.empty() ? "" : ", ") + std::to_string(extent);
  return "(" + text + (array.shape.size() == 1 ? ",)" : ")");
}

std::string described(const NpyArray& array) {
  return array.name.empty() ? "the array" : "the array " + in_quotes(array.name);
}

void require_readable(const NpyArray& array, const Place& place) {
  const std::string subject = described(array);
  switch (array.type.kind) {
    case 'O':
      throw Error(place, subject + " holds Python objects, which are never unpickled",
                  "save its parts as arrays of numbers with numpy.savez(file, poses=…, trans=…)");
    case 'V':
      throw Error(place, subject + " holds records of several fields",
                  "save each field as an array of its own with numpy.savez");
    case 'c':
    case 'M':
    case 'm':
      throw Error(place,
                  subject + (array.type.kind == 'c' ? " holds complex numbers" : " holds times"),
                  "save it as an array of real numbers");
    default:
      break;
  }
}

NpyArray npy_member(NpyHeader header, std::string elements, const std::string& file_name,
                    std::string_view name) {
  NpyArray array = outline(std::move(header), elements.size(), file_name, name);
  array.bytes = std::move(elements);
  return array;
}

NpyArray parse_npy(std::string_view bytes, const std::string& file_name) {
  NpyHeader header = parse_npy_header(bytes, file_name);
  const std::string_view elements = bytes.substr(header.start);
  NpyArray array = outline(std::move(header), elements.size(), file_name, {});
  array.bytes = elements;
  return array;
}

NpyArray read_npy(const std::filesystem::path& path) {
  const std::string bytes = read_contents(path);
  require_kind(bytes, path.string(), "npy");
  return parse_npy(bytes, path.string());
}

NpyArray array_of_text(std::string_view ascii) {
  NpyArray array;
  array.type = {'U', 4 * ascii.size(), false};
  for (const char letter : ascii) array.bytes.append({letter, '\0', '\0', '\0'});
  return array;
}

std::string to_npy(const NpyArray& array) {
  const std::size_t length = array.type.kind == 'U' ? array.type.bytes / 4 : array.type.bytes;
  const bool has_order = array.type.kind == 'U' || (array.type.bytes > 1 && array.type.kind != 'S');
  std::string text = "{'descr': '";
  text += !has_order ? '|' : array.type.is_big_endian ? '>' : '<';
  text += array.type.kind + std::to_string(length) +
          "', 'fortran_order': " + (array.is_fortran_order ? "True" : "False") +
          ", 'shape': " + shape_text(array) + ", }";
  // The elements begin at a multiple of 64 bytes.
  text.append(63 - (10 + text.size()) % 64, ' ');
  text += '\n';
  std::string file("\x93NUMPY\x01\x00", 8);
  file.reserve(10 + text.size() + array.bytes.size());
  file += static_cast<char>(text.size() & 0xFFU);
  file += static_cast<char>(text.size() >> 8U);
  return file + text + array.bytes;
}

}  // namespace mien::motion
