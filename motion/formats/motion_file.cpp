#include "motion/formats/motion_file.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <system_error>
#include <vector>

#include "motion/error.h"
#include "motion/formats/acclaim/acclaim.h"
#include "motion/formats/bvh/bvh.h"
#include "motion/formats/gltf/gltf.h"

namespace mien::motion {

namespace {

using ChosenTake = std::optional<std::string>;

constexpr MotionFormat formats[] = {
    {.ending = ".bvh",
     .name = "BVH",
     .is_streamed = true,
     .read = [](const std::filesystem::path& path, const ChosenTake&) { return read_bvh(path); },
     .write = write_bvh},
    {.ending = ".amc",
     .name = "Acclaim",
     .part_ending = ".asf",
     .read = [](const std::filesystem::path& path, const ChosenTake&) { return read_amc(path); }},
    {.ending = ".gltf",
     .name = "glTF",
     .part_ending = ".bin",
     .has_takes = true,
     .read = read_gltf},
    {.ending = ".glb",
     .name = "glTF",
     .has_takes = true,
     .is_metric = true,
     .read = read_gltf,
     .write = write_glb},
};

std::string names_and_extensions(bool (*is_meant)(const MotionFormat&)) {
  std::vector<std::string> parts;  // "glTF (.gltf, .glb"
  std::string_view name;
  for (const MotionFormat& format : formats) {
    if (!is_meant(format)) continue;
    if (format.name != name) parts.push_back(std::string(format.name) + " (");
    parts.back() += (format.name == name ? ", " : "") + std::string(format.ending);
    name = format.name;
  }
  std::string words;
  for (std::size_t i = 0; i < parts.size(); ++i)
    words += (i == 0 ? "" : i + 1 < parts.size() ? ", " : " or ") + parts[i] + ")";
  return words;
}

}  // namespace

std::span<const MotionFormat> motion_formats() { return formats; }

std::string lower_case_ending(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

const MotionFormat* motion_format(const std::filesystem::path& path) {
  const auto* const found =
      std::ranges::find(formats, lower_case_ending(path), &MotionFormat::ending);
  return found == std::end(formats) ? nullptr : found;
}

std::string formats_read() {
  return names_and_extensions([](const MotionFormat&) { return true; });
}

std::string formats_written() {
  return names_and_extensions([](const MotionFormat& format) { return format.write != nullptr; });
}

std::string formats_with_takes() {
  return names_and_extensions([](const MotionFormat& f) { return f.has_takes; });
}

bool is_motion_file(const std::filesystem::path& path) { return motion_format(path) != nullptr; }

bool may_hold_takes(const std::filesystem::path& path) {
  const MotionFormat* format = motion_format(path);
  return format != nullptr && format->has_takes;
}

Recording read_motion(const std::filesystem::path& path, const std::optional<std::string>& take) {
  std::error_code unknown;
  if (std::filesystem::is_directory(path, unknown)) {
    throw Error({path.string(), 0, 0}, "is a folder", "name a motion file in it");
  }
  const MotionFormat* format = motion_format(path);
  if (format == nullptr) {
    throw Error({path.string(), 0, 0}, "is not a motion file that can be read",
                "use " + formats_read());
  }
  if (take && !format->has_takes) {
    throw Error({path.string(), 0, 0}, "holds one motion, so no take can be chosen",
                "omit the take; only " + formats_with_takes() + " can hold several");
  }
  return format->read(path, take);
}

Recording read_take(const std::filesystem::path& path, const std::string& take) {
  return read_motion(path, take.empty() ? std::nullopt : std::optional(take));
}

void write_motion(const Recording& recording, const std::filesystem::path& path) {
  const MotionFormat* format = motion_format(path);
  if (format == nullptr || format->write == nullptr) {
    throw Error({path.string(), 0, 0}, "is not a motion file that can be written",
                "use " + formats_written());
  }
  format->write(recording, path);
}

}  // namespace mien::motion
