#include "motion/text/shell_word.h"

#include <algorithm>

#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

/// Characters that no shell takes for more than themselves; those beyond ASCII are letters to it.
bool is_plain(char character) {
  constexpr std::string_view marks = "%+,-./:=@_";
  const auto code = static_cast<unsigned char>(character);
  return (character >= 'a' && character <= 'z') || (character >= 'A' && character <= 'Z') ||
         (character >= '0' && character <= '9') || code >= 0x80 ||
         marks.find(character) != std::string_view::npos;
}

/// Between $' and '.
std::string with_escapes(std::string_view text) {
  std::string escaped;
  for (const char character : text) {
    const auto code = static_cast<unsigned char>(character);
    if (character == '\'' || character == '\\') {
      escaped += std::string("\\") + character;
    } else if (code >= 0x20 && code < 0x7F) {
      escaped += character;
    } else {  // octal, always of three digits: a digit that follows is not taken for part of it
      escaped += '\\';
      for (int shift = 6; shift >= 0; shift -= 3)
        escaped += static_cast<char>('0' + ((code >> shift) & 7));
    }
  }
  return escaped;
}

}  // namespace

std::string in_single_quotes(std::string_view text) {
  std::string quoted = "'";
  for (const char character : text) {
    if (character == '\'') {
      quoted += "'\\''";
    } else {
      quoted += character;
    }
  }
  return quoted + "'";
}

std::string shell_word(std::string_view text) {
  if (printable(text) != text) return "$'" + with_escapes(text) + "'";
  // "=" at the start is a path of a command to zsh.
  const bool is_word = !text.empty() && text.front() != '=' && std::ranges::all_of(text, is_plain);
  return is_word ? std::string(text) : in_single_quotes(text);
}

std::string shell_path(std::string_view path) {
  return shell_word(path.starts_with('-') ? "./" + std::string(path) : std::string(path));
}

}  // namespace mien::motion
