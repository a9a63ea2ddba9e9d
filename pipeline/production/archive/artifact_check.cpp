#include "pipeline/production/archive/artifact_check.h"

#include <algorithm>
#include <exception>
#include <map>

#include <fmt/format.h>

#include "motion/text/file_contents.h"
#include "pipeline/production/archive/decoding.h"
#include "pipeline/tasks/receipt.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

bool is_picture(const std::string& name) {
  return name.ends_with(".png") || name.ends_with(".exr");
}

/// What is wrong with a file's bytes; empty for nothing. A size of 0 is not told.
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

  /// The receipt tells each frame, and the provenance the receipt.
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
    if (std::ranges::find(changed_, name) != changed_.end()) return;  // has been told
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
