#include "motion/text/safe_name.h"

#include <algorithm>
#include <array>
#include <system_error>

#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_name_bytes = 255;
constexpr char leads_out[] = "leads out of its folder";
constexpr char absolute[] = "is an absolute path";
constexpr char name_remedy[] =
    "write a plain name there: no \"/\", \"\\\", \"..\", control characters or name that a system "
    "reserves";
constexpr char path_remedy[] = "write a path below that folder there, without \"..\"";

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }

/// "c:"
bool has_drive(std::string_view text) {
  return text.size() >= 2 && is_letter(text[0]) && text[1] == ':';
}

std::string in_small_letters(std::string_view text) {
  std::string small(text);
  for (char& c : small) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return small;
}

/// Devices of Windows, with any ending: "nul", "COM1.txt".
bool is_reserved(std::string_view name) {
  constexpr std::array<std::string_view, 6> devices = {"con", "prn",    "aux",
                                                       "nul", "conin$", "conout$"};
  std::string stem = in_small_letters(name.substr(0, name.find('.')));
  while (!stem.empty() && stem.back() == ' ') stem.pop_back();
  if (std::ranges::find(devices, stem) != devices.end()) return true;
  return stem.size() == 4 && (stem.starts_with("com") || stem.starts_with("lpt")) &&
         stem[3] >= '0' && stem[3] <= '9';
}

bool lies_below(const fs::path& path, const fs::path& folder) {
  return std::ranges::mismatch(folder, path).in1 == folder.end();
}

/// A folder without links, with no '/' at its end.
fs::path real_folder(const fs::path& given) {
  const fs::path folder = given.empty() ? fs::path(".") : given;
  std::error_code unknown;
  fs::path real = fs::weakly_canonical(fs::absolute(folder, unknown), unknown);
  if (unknown) real = fs::absolute(folder, unknown).lexically_normal();
  return real.has_filename() ? real : real.parent_path();
}

/// Why a path leads out of a folder; empty when it does not.
std::string fault_inside(const fs::path& folder, std::string_view relative) {
  std::string fault = fault_of_relative(relative);
  if (!fault.empty()) return fault;
  const fs::path real = real_folder(folder);
  fs::path at = folder;
  for (const fs::path& name : fs::path(relative)) {
    at /= name;
    std::error_code unknown;
    if (!fs::is_symlink(fs::symlink_status(at, unknown))) continue;
    const fs::path target = fs::canonical(at, unknown);
    if (unknown) return "is a broken link";
    if (!lies_below(target, real)) return "is behind a link that leads out of its folder";
  }
  return "";
}

}  // namespace

std::string fault_of_name(std::string_view name) {
  if (name.empty()) return "is empty";
  if (name == "." || name == "..") return leads_out;
  if (name.front() == '/' || name.front() == '\\') return absolute;
  if (has_drive(name)) return "begins with a drive letter";
  if (name.find_first_of("/\\") != std::string_view::npos) return "is a path, not a name";
  if (std::ranges::any_of(name, is_control)) return "holds a control character";
  if (is_reserved(name)) return "is reserved on Windows";
  if (name.back() == '.' || name.back() == ' ') return "ends with a dot or a space";
  return name.size() > most_name_bytes ? "has more than 255 bytes" : "";
}

std::string fault_of_names(std::string_view path) {
  if (path.empty()) return "is empty";
  if (path.front() == '/') return absolute;
  while (!path.empty()) {
    const std::size_t end = std::min(path.find('/'), path.size());
    if (std::string fault = fault_of_name(path.substr(0, end)); !fault.empty()) return fault;
    if (end + 1 == path.size()) return "ends with \"/\"";
    path.remove_prefix(std::min(end + 1, path.size()));
  }
  return "";
}

std::string fault_of_relative(std::string_view relative) {
  if (relative.empty()) return "is empty";
  if (relative.find('\0') != std::string_view::npos) return "holds a zero byte";
  const fs::path path(relative);
  if (path.is_absolute()) return absolute;
  if (std::ranges::find(path, fs::path("..")) != path.end()) return leads_out;
  return path.lexically_normal() == "." ? "names the folder itself" : "";
}

std::string safe_component(std::string_view name, const Place& place) {
  const std::string fault = fault_of_name(name);
  if (!fault.empty()) throw Error(place, "the name " + in_quotes(name) + " " + fault, name_remedy);
  return std::string(name);
}

std::string safe_names(std::string_view path, const Place& place) {
  const std::string fault = fault_of_names(path);
  if (!fault.empty()) throw Error(place, "the path " + in_quotes(path) + " " + fault, path_remedy);
  return std::string(path);
}

fs::path inside(const fs::path& folder, std::string_view relative, const Place& place) {
  const std::string fault = fault_inside(folder, relative);
  if (!fault.empty())
    throw Error(place, "the path " + in_quotes(relative) + " " + fault, path_remedy);
  return folder / relative;
}

bool is_inside(const fs::path& folder, std::string_view relative) {
  return fault_inside(folder, relative).empty();
}

}  // namespace mien::motion
