#include "pipeline/production/archive/artifact_check.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "motion/formats/motion_file.h"
#include "motion/text/file_contents.h"
#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/base/documents/utf8.h"
#include "pipeline/tasks/receipt.h"
#include "render/image/image_io.h"
#include "render/video/sound_file.h"
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

bool is_sound(const fs::path& file) {
  const std::vector<std::string> endings = render::sound_endings();
  return std::ranges::find(endings, motion::lower_case_ending(file)) != endings.end();
}

void decode_by_ending(const fs::path& file) {
  static const std::map<std::string, std::function<void(const fs::path&)>> readers = {
      {".png", [](const fs::path& one) { render::check_image(one); }},
      {".exr", [](const fs::path& one) { render::check_image(one); }},
      {".csv", [](const fs::path& one) { read_csv(one); }},
      {".json", read_as_json},
      {".pdf", [](const fs::path& one) { read_from_to(one, "%PDF-", "%%EOF"); }},
      {".html", [](const fs::path& one) { read_from_to(one, "<!", "</html>"); }},
      {".npz", [](const fs::path& one) { motion::read_file(one); }},
      {".npy", [](const fs::path& one) { motion::read_file(one); }},
      {".md", read_as_text},
      {".bib", read_as_text},
      {".yaml", read_as_text},
  };
  const auto reader = readers.find(file.extension().string());
  if (render::video_kind_of(file)) {
    render::probe(file);
  } else if (is_sound(file)) {
    render::read_sound(file);
  } else if (motion::is_found_as_motion(file)) {
    motion::read_file(file);
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

/// What is wrong with the sound of a video by its record; decoding it throws.
std::string fault_of_sound(const fs::path& file, const VideoSoundRecord& record) {
  const std::optional<render::VideoSound> found = render::sound_of_video(file);
  if (!found) return "has no sound, and its record has one";
  if (found->codec != record.codec)
    return fmt::format("has a sound in {} instead of the {} of its record", found->codec,
                       record.codec);
  if (found->sound.channels != record.channels || found->sound.frames() < record.frames)
    return fmt::format(
        "has a sound of {} sample frames and {} channels instead of the {} and {} of "
        "its record",
        found->sound.frames(), found->sound.channels, record.frames, record.channels);
  return "";
}

/// What a reader throws, in words that follow the file's name.
std::string reader_fault(const fs::path& file, const std::exception& error) {
  std::string text = error.what();
  if (text.starts_with(file.string())) text = text.substr(file.string().size());
  while (text.starts_with(':') || text.starts_with(' ')) text.erase(0, 1);
  while (text.ends_with('\n')) text.pop_back();
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n'))
    text.replace(at, 1, "; ");
  return "does not decode: " + text;
}

/// What is wrong with a file that mien wrote, found by reading all of it as what its name says:
/// videos (decoded, their frames counted, their time measured), sounds, pictures (every pixel),
/// CSV, JSON, motions, PDF and pages (from beginning to end), texts. Empty when nothing is.
std::string decoding_fault(const fs::path& file) {
  try {
    decode_by_ending(file);
    return "";
  } catch (const std::exception& error) {
    return reader_fault(file, error);
  }
}

/// What is wrong with a video; also if it is not the one of the film's record.
std::string decoding_fault(const fs::path& file, const VideoRecord& record) {
  try {
    std::string fault = fault_of_video(render::probe(file), record);
    if (fault.empty() && record.sound) fault = fault_of_sound(file, *record.sound);
    return fault;
  } catch (const std::exception& error) {
    return reader_fault(file, error);
  }
}

bool is_picture(const std::string& name) {
  return name.ends_with(".png") || name.ends_with(".exr");
}

/// What is wrong with a file's bytes; empty for nothing. A size of 0 is not known.
std::string fault_of_bytes(const fs::path& file, const Hash& hash, std::uint64_t size) {
  if (const std::string problem = motion::read_error(file, motion::any_size); !problem.empty())
    return problem;
  const std::uintmax_t found = fs::file_size(file);
  if (size > 0 && found != size) return fmt::format("{} bytes instead of {}", found, size);
  return hash_of_file(file) == hash ? "" : "different content";
}

/// The names of a sequence's files, ascending.
std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

/// "00012.png"
bool is_frame_name(const std::string& name) {
  const std::string stem = name.substr(0, name.find('.'));
  return is_picture(name) && stem.size() >= 5 && name.size() == stem.size() + 4 &&
         std::ranges::all_of(stem, [](char c) { return c >= '0' && c <= '9'; });
}

class FramesCheck {
 public:
  FramesCheck(const fs::path& folder, const ArtifactRecord& record)
      : folder_(folder), record_(record), names_(names_in(folder / record.path)) {}

  ArtifactCheck take() {
    const std::optional<Receipt> receipt = read_receipt(folder_, record_.path);
    if (receipt && hash_of(receipt->frames) == record_.hash) {
      compare_with(receipt->frames);
    } else {
      compare_as_a_whole();
    }
    for (const std::string& name : names_) {
      if (is_frame_name(name)) decode(name);
    }
    return std::move(check_);
  }

 private:
  fs::path file_of(const std::string& name) const { return folder_ / record_.path / name; }

  void find(Finding::Kind kind, const std::string& name, const std::string& what) {
    check_.findings.push_back({kind, record_.path + "/" + name, what});
    if (kind == Finding::Kind::changed) changed_.push_back(name);
  }

  /// The receipt has the hash of each frame, and the provenance that of the receipt.
  void compare_with(const std::vector<FrameReceipt>& frames) {
    std::map<std::string, const FrameReceipt*> wanted;
    for (const FrameReceipt& frame : frames) wanted[frame.name] = &frame;
    for (const std::string& name : names_) {
      const auto frame = wanted.find(name);
      if (frame == wanted.end()) {
        find(Finding::Kind::extra, name, "");
        continue;
      }
      const std::string fault =
          fault_of_bytes(file_of(name), frame->second->hash, frame->second->size);
      if (!fault.empty()) find(Finding::Kind::changed, name, fault);
      check_.bytes += frame->second->size;
      wanted.erase(frame);
    }
    for (const auto& [name, frame] : wanted) find(Finding::Kind::missing, name, "");
  }

  void compare_as_a_whole() {
    std::vector<FrameReceipt> frames;
    for (const std::string& name : names_) {
      if (!is_frame_name(name)) {
        find(Finding::Kind::extra, name, "");
        continue;
      }
      if (const std::string fault = motion::read_error(file_of(name), motion::any_size);
          !fault.empty()) {
        find(Finding::Kind::changed, name, fault);
        continue;
      }
      frames.push_back({name, hash_of_file(file_of(name)), fs::file_size(file_of(name))});
      check_.bytes += frames.back().size;
    }
    const int found = static_cast<int>(frames.size());
    if (found != record_.frames) {
      check_.findings.push_back({Finding::Kind::changed, record_.path,
                                 fmt::format("{} frames instead of {}", found, record_.frames)});
    } else if (hash_of(frames) != record_.hash) {
      check_.findings.push_back({Finding::Kind::changed, record_.path, "a frame differs"});
    }
  }

  void decode(const std::string& name) {
    if (std::ranges::find(changed_, name) != changed_.end()) return;  // has been reported
    ++check_.pictures;
    const std::string fault = decoding_fault(file_of(name));
    if (!fault.empty()) find(Finding::Kind::changed, name, fault);
  }

  const fs::path& folder_;
  const ArtifactRecord& record_;
  std::vector<std::string> names_;
  std::vector<std::string> changed_;
  ArtifactCheck check_;
};

/// What hinders reading is a finding and no reason to stop.
template <class Check>
ArtifactCheck found_by(const ArtifactRecord& record, const Check& check) {
  try {
    return check();
  } catch (const std::exception& error) {
    return {.findings = {{Finding::Kind::changed, record.path, error.what()}}};
  }
}

}  // namespace

ArtifactCheck check_file(const fs::path& folder, const ArtifactRecord& record,
                         const std::optional<VideoRecord>& video) {
  return found_by(record, [&] {
    ArtifactCheck check;
    const fs::path file = folder / record.path;
    std::string fault = fault_of_bytes(file, record.hash, record.size);
    if (fault.empty()) {
      check.bytes = fs::file_size(file);
      check.videos = render::video_kind_of(file) ? 1 : 0;
      check.pictures = is_picture(record.path) ? 1 : 0;
      fault = video ? decoding_fault(file, *video) : decoding_fault(file);
    }
    if (!fault.empty()) check.findings.push_back({Finding::Kind::changed, record.path, fault});
    return check;
  });
}

ArtifactCheck check_frames(const fs::path& folder, const ArtifactRecord& record) {
  return found_by(record, [&]() -> ArtifactCheck {
    if (!fs::is_directory(folder / record.path))
      return {.findings = {{Finding::Kind::changed, record.path, "is not a folder of frames"}}};
    return FramesCheck(folder, record).take();
  });
}

}  // namespace mien::pipeline
