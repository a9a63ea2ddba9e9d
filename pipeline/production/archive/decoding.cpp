#include "pipeline/production/archive/decoding.h"

#include <cmath>
#include <exception>
#include <functional>
#include <map>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "motion/formats/motion_file.h"
#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/base/documents/utf8.h"
#include "render/image/image_io.h"
#include "render/video/video.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

void read_as_text(const fs::path& file) {
  if (first_invalid_utf8(read_file(file))) throw std::runtime_error("is not UTF-8 text");
}

void read_as_json(const fs::path& file) {
  if (!nlohmann::json::accept(read_file(file))) throw std::runtime_error("is not JSON");
}

void read_from_to(const fs::path& file, const std::string& first, const std::string& last) {
  const std::string bytes = read_file(file);
  constexpr std::size_t tail = 64;
  const std::string end = bytes.substr(bytes.size() - std::min(tail, bytes.size()));
  if (!bytes.starts_with(first) || end.find(last) == std::string::npos)
    throw std::runtime_error("is truncated or not the expected file");
}

void decode_by_ending(const fs::path& file) {
  static const std::map<std::string, std::function<void(const fs::path&)>> readers = {
      {".png", [](const fs::path& one) { render::check_image(one); }},
      {".exr", [](const fs::path& one) { render::check_image(one); }},
      {".csv", [](const fs::path& one) { read_csv(one); }},
      {".json", read_as_json},
      {".pdf", [](const fs::path& one) { read_from_to(one, "%PDF-", "%%EOF"); }},
      {".html", [](const fs::path& one) { read_from_to(one, "<!", "</html>"); }},
      {".md", read_as_text},
      {".bib", read_as_text},
      {".yaml", read_as_text},
  };
  const auto reader = readers.find(file.extension().string());
  if (render::video_kind_of(file)) {
    render::probe(file);
  } else if (motion::is_motion_file(file)) {
    motion::read_motion(file);
  } else if (reader != readers.end()) {
    reader->second(file);
  }
}

std::string fault_of_video(const render::VideoSummary& video, const VideoRecord& record) {
  // A WebP shows a picture that repeats for longer; a film of one picture has no times.
  const bool counts = record.format != "webp" && record.frames > 1;
  if (counts && video.frames != record.frames) {
    return fmt::format("has {} frames instead of the {} of its record", video.frames,
                       record.frames);
  }
  const double tolerance = 2.0 * video.tick_seconds + 1e-3;
  if (video.frames > 1 && std::abs(video.duration_seconds - record.duration_s) > tolerance) {
    return fmt::format("lasts {:.3f} s instead of the {:.3f} s of its record",
                       video.duration_seconds, record.duration_s);
  }
  return "";
}

/// What a reader throws, in words that follow the file's name.
std::string fault_told(const fs::path& file, const std::exception& error) {
  std::string told = error.what();
  if (told.starts_with(file.string())) told = told.substr(file.string().size());
  while (told.starts_with(':') || told.starts_with(' ')) told.erase(0, 1);
  while (told.ends_with('\n')) told.pop_back();
  for (std::size_t at = told.find('\n'); at != std::string::npos; at = told.find('\n'))
    told.replace(at, 1, "; ");
  return "does not decode: " + told;
}

}  // namespace

std::string decoding_fault(const fs::path& file) {
  try {
    decode_by_ending(file);
    return "";
  } catch (const std::exception& error) {
    return fault_told(file, error);
  }
}

std::string decoding_fault(const fs::path& file, const VideoRecord& record) {
  try {
    return fault_of_video(render::probe(file), record);
  } catch (const std::exception& error) {
    return fault_told(file, error);
  }
}

}  // namespace mien::pipeline
