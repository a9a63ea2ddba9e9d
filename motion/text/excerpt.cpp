#include "motion/text/excerpt.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace mien::motion {

namespace {

/// One character of a text, or one byte that is none.
struct Character {
  std::size_t bytes = 1;
  std::uint32_t code = 0;
  bool is_utf8 = true;
};

/// Least code that may be written in so many bytes.
constexpr std::array<std::uint32_t, 5> least_code = {0, 0, 0x80, 0x800, 0x10000};

/// The character that the text, which is not empty, begins with.
Character first_of(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const Character broken{1, byte(0), false};
  if (byte(0) < 0x80) return {1, byte(0), true};
  const std::size_t bytes = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
  if (byte(0) < 0xC2 || byte(0) > 0xF4 || text.size() < bytes) return broken;
  std::uint32_t code = byte(0) & (0x7FU >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return broken;
    code = code << 6U | (byte(i) & 0x3FU);
  }
  const bool is_surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < least_code[bytes] || code > 0x10FFFF || is_surrogate) return broken;
  return {bytes, code, true};
}

bool is_within(std::uint32_t code, std::uint32_t first, std::uint32_t last) {
  return code >= first && code <= last;
}

/// What a terminal obeys (C0, DEL, C1), what reorders text (UAX #9), and what cannot be seen.
bool is_harmful(std::uint32_t code) {
  return code < 0x20 || is_within(code, 0x7F, 0x9F) || code == 0x061C || code == 0x200B ||
         is_within(code, 0x200E, 0x200F) || is_within(code, 0x2028, 0x202E) ||
         is_within(code, 0x2060, 0x206F) || code == 0xFEFF || is_within(code, 0xE0000, 0xE007F);
}

std::string hexadecimal(std::uint32_t code, int digits) {
  std::string text;
  for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4)
    text += "0123456789abcdef"[(code >> shift) & 15U];
  return text;
}

std::string written_out(const Character& character) {
  const std::uint32_t code = character.code;
  if (code == '\n') return "\\n";
  if (code == '\r') return "\\r";
  if (code == '\t') return "\\t";
  if (code < 0x80 || !character.is_utf8) return "\\x" + hexadecimal(code, 2);
  return code < 0x10000 ? "\\u" + hexadecimal(code, 4) : "\\U" + hexadecimal(code, 8);
}

/// Takes the first character off the text: as it is, or written out.
std::string take_shown(std::string_view& text, LineEnds line_ends) {
  const Character character = first_of(text);
  const bool is_kept =
      line_ends == LineEnds::kept && (character.code == '\n' || character.code == '\t');
  const bool stays = character.is_utf8 && (is_kept || !is_harmful(character.code));
  std::string shown = stays ? std::string(text.substr(0, character.bytes)) : written_out(character);
  text.remove_prefix(character.bytes);
  return shown;
}

}  // namespace

std::string printable(std::string_view text, LineEnds line_ends) {
  std::string shown;
  shown.reserve(text.size());
  while (!text.empty()) {
    const auto end =
        std::find_if_not(text.begin(), text.end(), [](char c) { return c >= 0x20 && c <= 0x7E; });
    const auto plain = static_cast<std::size_t>(end - text.begin());
    shown += text.substr(0, plain);
    text.remove_prefix(plain);
    if (!text.empty()) shown += take_shown(text, line_ends);
  }
  return shown;
}

std::string excerpt(std::string_view text, std::size_t most, LineEnds line_ends) {
  std::string shown;
  std::size_t characters = 0;
  std::size_t room_for_cut = 0;  // bytes of `shown` that leave room for "…"
  while (!text.empty()) {
    const std::string_view before = text;
    const std::string next = take_shown(text, line_ends);
    // What is written out is ASCII, a byte a character.
    const bool is_as_it_was =
        before.starts_with(next) && text.size() + next.size() == before.size();
    characters += is_as_it_was ? 1 : next.size();
    if (characters > most) return shown.substr(0, room_for_cut) + "…";
    shown += next;
    if (characters < most) room_for_cut = shown.size();
  }
  return shown;
}

std::string in_quotes(std::string_view text) { return "\"" + excerpt(text) + "\""; }

std::string first_of(std::span<const std::string> names, std::size_t most,
                     std::string_view between) {
  std::string text;
  for (const std::string& name : names.first(std::min(most, names.size())))
    text += (text.empty() ? "" : std::string(between)) + name;
  if (names.size() <= most) return text;
  return text + " and " + std::to_string(names.size() - most) + " more";
}

std::string listed(std::span<const std::string> names) {
  std::string text;
  for (const std::string& name : names.first(std::min(max_listed_names, names.size())))
    text += (text.empty() ? "" : ", ") + excerpt(name);
  if (names.size() <= max_listed_names) return text;
  return text + ", … (" + std::to_string(names.size()) + " in all)";
}

}  // namespace mien::motion
