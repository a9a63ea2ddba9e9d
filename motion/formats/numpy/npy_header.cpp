#include <algorithm>
#include <charconv>
#include <cstdint>

#include "motion/formats/numpy/npy.h"
#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

using std::string_view_literals::operator""sv;

constexpr std::string_view magic = "\x93NUMPY"sv;
constexpr std::size_t most_dimensions = 64;  // as NumPy 2
constexpr std::string_view save_again = "save the array again with numpy.save";

/// The Python dictionary of a header, read from left to right.
struct HeaderText {
  std::string_view text;
  std::size_t at = 0;
  std::size_t offset = 0;  ///< of the text in the file or member, bytes
  Place place;
  std::string_view name;  ///< of the array; may be empty
};

std::string subject_of(std::string_view name) {
  return name.empty() ? "the array" : "the array " + in_quotes(name);
}

[[noreturn]] void fail(const HeaderText& header, std::string_view wrong) {
  throw Error(header.place,
              "the header of " + subject_of(header.name) + " is invalid at byte " +
                  std::to_string(header.offset + header.at) + ": " + std::string(wrong),
              save_again);
}

void skip_blanks(HeaderText& header) {
  header.at = std::min(header.text.find_first_not_of(" \t\n\r", header.at), header.text.size());
}

/// Passes over the character if it is next.
bool take(HeaderText& header, char wanted) {
  skip_blanks(header);
  if (header.at >= header.text.size() || header.text[header.at] != wanted) return false;
  ++header.at;
  return true;
}

void require(HeaderText& header, char wanted) {
  if (!take(header, wanted)) fail(header, std::string("'") + wanted + "' is missing");
}

/// The text between quotes, which contains no escapes.
std::string_view quoted(HeaderText& header) {
  skip_blanks(header);
  const char quote = header.at < header.text.size() ? header.text[header.at] : '\0';
  if (quote != '\'' && quote != '"') fail(header, "a text in quotes is missing");
  const std::size_t end = header.text.find(quote, header.at + 1);
  if (end == std::string_view::npos) fail(header, "a quotation mark is missing");
  const std::string_view text = header.text.substr(header.at + 1, end - header.at - 1);
  header.at = end + 1;
  return text;
}

bool truth(HeaderText& header) {
  skip_blanks(header);
  for (const std::string_view word : {"True"sv, "False"sv}) {
    if (!header.text.substr(header.at).starts_with(word)) continue;
    header.at += word.size();
    return word == "True";
  }
  fail(header, "True or False is missing");
}

/// Python 2 writes "3L".
std::size_t extent(HeaderText& header) {
  skip_blanks(header);
  std::uint64_t value = 0;
  const char* const first = header.text.data() + header.at;
  const auto [end, error] = std::from_chars(first, header.text.data() + header.text.size(), value);
  if (error != std::errc() || value > PTRDIFF_MAX) fail(header, "a length is missing or too large");
  header.at += static_cast<std::size_t>(end - first);
  if (header.at < header.text.size() && header.text[header.at] == 'L') ++header.at;
  return static_cast<std::size_t>(value);
}

std::vector<std::size_t> shape_in(HeaderText& header) {
  std::vector<std::size_t> shape;
  require(header, '(');
  while (!take(header, ')')) {
    if (shape.size() == most_dimensions) fail(header, "the array has more than 64 dimensions");
    shape.push_back(extent(header));
    if (take(header, ',')) continue;
    if (shape.size() == 1) fail(header, "a comma is missing");
    require(header, ')');
    break;
  }
  return shape;
}

/// The description of records is a list, which is passed over.
void skip_list(HeaderText& header) {
  std::size_t depth = 0;
  do {
    skip_blanks(header);
    if (header.at >= header.text.size()) fail(header, "']' is missing");
    const char next = header.text[header.at];
    if (next == '\'' || next == '"') {
      quoted(header);
      continue;
    }
    if (next == '[') ++depth;
    if (next == ']') --depth;
    ++header.at;
  } while (depth > 0);
}

/// "<f4", ">i8", "|b1", "<U7", "|O", "<M8[ns]"
NpyType type_in(HeaderText& header) {
  skip_blanks(header);
  if (header.at < header.text.size() && header.text[header.at] == '[') {
    skip_list(header);
    return {'V', 0, false};
  }
  const std::size_t start = header.at;
  const std::string_view text = quoted(header);
  const bool has_order = !text.empty() && "<>|="sv.find(text.front()) != text.npos;
  const std::string_view word = text.substr(has_order ? 1 : 0);
  NpyType type{word.empty() ? '?' : word.front(), 0, text.starts_with('>')};
  if (type.kind == 'O') return type;
  const char* const end = word.data() + word.size();
  const auto [rest, error] = word.empty() ? std::from_chars_result{end, std::errc::invalid_argument}
                                          : std::from_chars(word.data() + 1, end, type.bytes);
  const bool is_time = type.kind == 'M' || type.kind == 'm';
  if (error != std::errc() || (rest != end && !is_time) ||
      "biufcUSaVMm"sv.find(type.kind) == text.npos || type.bytes > PTRDIFF_MAX / 4) {
    header.at = start;
    fail(header, "the type " + in_quotes(text) + " is unknown");
  }
  if (type.kind == 'a') type.kind = 'S';
  if (type.kind == 'U') type.bytes *= 4;
  return type;
}

/// Length of the header's text and where it begins.
struct TextExtent {
  std::size_t start = 0;
  std::size_t length = 0;
};

TextExtent text_extent(std::string_view bytes, const Place& place, std::string_view name) {
  const auto refuse = [&](std::string_view wrong) {
    throw Error(place, subject_of(name) + " " + std::string(wrong), save_again);
  };
  if (!bytes.starts_with(magic)) refuse("is not a NumPy array: it does not begin with \\x93NUMPY");
  if (bytes.size() < 10) refuse("is cut short at byte " + std::to_string(bytes.size()));
  const auto byte = [&](std::size_t i) {
    return static_cast<std::size_t>(static_cast<unsigned char>(bytes[i]));
  };
  const std::size_t version = byte(6);
  if (version < 1 || version > 3) {
    refuse("is of version " + std::to_string(version) + "." + std::to_string(byte(7)) +
           " of the format; versions 1 to 3 are read");
  }
  TextExtent text{version == 1 ? std::size_t{10} : std::size_t{12}, 0};
  if (bytes.size() < text.start) refuse("is cut short at byte " + std::to_string(bytes.size()));
  for (std::size_t i = text.start; i-- > 8;) text.length = text.length << 8U | byte(i);
  if (text.length > bytes.size() - text.start) {
    refuse("is cut short: its header has " + std::to_string(text.length) + " bytes, but " +
           std::to_string(bytes.size() - text.start) + " follow byte " +
           std::to_string(text.start));
  }
  return text;
}

}  // namespace

NpyHeader parse_npy_header(std::string_view bytes, const std::string& file_name,
                           std::string_view name) {
  const Place place{file_name};
  const TextExtent extent_of_text = text_extent(bytes, place, name);
  HeaderText header{bytes.substr(extent_of_text.start, extent_of_text.length), 0,
                    extent_of_text.start, place, name};
  NpyHeader read;
  read.start = extent_of_text.start + extent_of_text.length;
  bool has_type = false;
  bool has_order = false;
  bool has_shape = false;
  const auto once = [&](bool& has) {
    if (has) fail(header, "an entry occurs twice");
    has = true;
    require(header, ':');
  };
  require(header, '{');
  while (!take(header, '}')) {
    const std::string_view key = quoted(header);
    if (key == "descr") {
      once(has_type);
      read.type = type_in(header);
    } else if (key == "fortran_order") {
      once(has_order);
      read.is_fortran_order = truth(header);
    } else if (key == "shape") {
      once(has_shape);
      read.shape = shape_in(header);
    } else {
      fail(header, "the entry " + in_quotes(key) + " is unknown");
    }
    if (take(header, ',')) continue;
    require(header, '}');
    break;
  }
  skip_blanks(header);
  if (header.at != header.text.size()) fail(header, "text follows the dictionary");
  if (!has_type || !has_order || !has_shape)
    fail(header, "it lacks one of descr, fortran_order and shape");
  return read;
}

}  // namespace mien::motion
