#include "pipeline/production/archive/verify.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <set>
#include <system_error>
#include <tuple>

#include <fmt/format.h>

#include "motion/text/file_contents.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/production/archive/artifact_check.h"
#include "pipeline/production/archive/keep.h"
#include "pipeline/production/film/film_record.h"
#include "pipeline/tasks/parallel.h"
#include "pipeline/tasks/receipt.h"
#include "pipeline/tasks/stale_artifacts.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// Where a packed recording is in the study's folder.
std::string place_of(const RecordingRecord& recording) {
  return std::string(packed_recordings_folder) + "/" + recording.path;
}

std::set<std::string> known_paths(const StudyContents& contents) {
  std::set<std::string> known = {"provenance.json", not_kept_path, contents.as_run};
  for (const ArtifactRecord& record : contents.artifacts) known.insert(record.path);
  for (const ArtifactRecord& record : contents.inputs) known.insert(record.path);
  // Of no graph at all, everything that has a receipt is stale.
  for (const Receipt& receipt : stale_artifacts(contents.folder, {}, {}))
    known.insert(receipt.path);
  return known;
}

/// Files in a study's folder that neither its provenance nor the store's receipts know, by path:
/// files of unknown origin. Files inside known frame sequences are not checked.
std::vector<std::string> extra_files(const StudyContents& contents) {
  const std::set<std::string> known = known_paths(contents);
  std::vector<std::string> extra;
  std::error_code unknown;
  for (auto entry = fs::recursive_directory_iterator(contents.folder);
       entry != fs::recursive_directory_iterator(); ++entry) {
    const std::string path = entry->path().lexically_relative(contents.folder).generic_string();
    const bool is_folder = entry->is_directory(unknown) && !entry->is_symlink(unknown);
    if (is_bookkeeping(path) || known.contains(path) || is_only_in_archive(contents, path)) {
      if (is_folder) entry.disable_recursion_pending();
    } else if (!is_folder) {
      extra.push_back(path);
    }
  }
  std::ranges::sort(extra);
  return extra;
}

/// What films' records say of their videos, by the videos' paths. A record that cannot be read is
/// found elsewhere.
std::map<std::string, VideoRecord> recorded_videos(const StudyContents& contents) {
  std::map<std::string, VideoRecord> videos;
  for (const ArtifactRecord& artifact : contents.artifacts) {
    if (!artifact.path.starts_with("metrics/films/")) continue;
    const motion::FileReading text =
        motion::bytes_of_file(contents.folder / artifact.path, motion::max_document_bytes);
    if (!text.bytes || hash_of(*text.bytes) != artifact.hash) continue;
    for (const VideoRecord& video : parse_film_record(*text.bytes).videos)
      videos[video.file] = video;
  }
  return videos;
}

/// Checks one artifact after the other, on several threads.
class Verifier {
 public:
  Verifier(const StudyContents& contents, const ShareDone& done)
      : contents_(contents), done_(done), videos_(recorded_videos(contents)) {
    for (const ArtifactRecord& record : not_kept_in(contents.folder))
      not_kept_[record.path] = record;
    for (const ArtifactRecord& record : contents.artifacts) add(record);
    for (const ArtifactRecord& record : contents.inputs) add(record);
    for (const std::string& name : contents.packed.packed) {
      const RecordingRecord* recording = contents.find_recording(name);
      if (recording != nullptr) recordings_.push_back({place_of(*recording), recording->hash});
    }
    for (const ArtifactRecord& record : recordings_) add(record);
    for (const std::string& name : contents.packed.left_out) {
      const RecordingRecord* recording = contents.find_recording(name);
      if (recording != nullptr && !recording->share)
        result_.findings.push_back({Finding::Kind::left_out, name, licences({recording->licence})});
    }
  }

  Verification take(int jobs, const std::stop_token& stop) {
    result_.artifacts = static_cast<int>(contents_.artifacts.size());
    result_.inputs = static_cast<int>(contents_.inputs.size() + recordings_.size());
    for_each_of(present_.size(), jobs, stop, [&](std::size_t i) { check(*present_[i]); });
    check_own_files();
    for (const std::string& path : extra_files(contents_))
      result_.findings.push_back({Finding::Kind::extra, path, ""});
    std::ranges::sort(result_.findings, {},
                      [](const Finding& one) { return std::tie(one.kind, one.path); });
    return std::move(result_);
  }

 private:
  /// Videos take longer to decode than others of their size.
  static double cost_of(const ArtifactRecord& record) {
    constexpr double of_a_video = 50.0;
    return static_cast<double>(record.size + 1) *
           (render::video_kind_of(record.path) ? of_a_video : 1.0);
  }

  static std::string licences(const std::vector<std::string>& names) {
    return fmt::format("licence {}", fmt::join(names, ", "));
  }

  bool is_left_out(const std::string& path) const {
    return std::ranges::find(contents_.packed.left_out_files, path) !=
           contents_.packed.left_out_files.end();
  }

  void add(const ArtifactRecord& record) {
    std::error_code unknown;
    if (fs::exists(fs::symlink_status(contents_.folder / record.path, unknown))) {
      present_.push_back(&record);
      total_cost_ += cost_of(record);
      return;
    }
    if (!record.restricting.empty() && is_left_out(record.path)) {
      result_.findings.push_back(
          {Finding::Kind::left_out, record.path, licences(record.restricting)});
      return;
    }
    const auto removed = not_kept_.find(record.path);
    const bool on_purpose = removed != not_kept_.end() && removed->second.hash == record.hash;
    const std::string what = record.frames > 0 ? fmt::format("{} frames", record.frames) : "";
    result_.findings.push_back(
        {on_purpose ? Finding::Kind::not_kept : Finding::Kind::missing, record.path, what});
  }

  void check(const ArtifactRecord& record) {
    const auto video = videos_.find(record.path);
    ArtifactCheck found = record.frames > 0 ? check_frames(contents_.folder, record)
                          : video != videos_.end()
                              ? check_file(contents_.folder, record, video->second)
                              : check_file(contents_.folder, record);
    const std::lock_guard guard(mutex_);
    result_.bytes += found.bytes;
    result_.videos += found.videos;
    result_.pictures += found.pictures;
    for (Finding& finding : found.findings) result_.findings.push_back(std::move(finding));
    done_cost_ += cost_of(record);
    if (done_) done_(done_cost_ / total_cost_, record.path);
  }

  /// Files that no artifact's entry names, but the receipts do, where there are any.
  void check_own_files() {
    for (const std::string& path : {std::string("provenance.json"), contents_.as_run}) {
      const fs::path file = contents_.folder / path;
      const std::string problem = motion::read_error(file, motion::any_size);
      if (!problem.empty()) {
        result_.findings.push_back({Finding::Kind::missing, path, problem});
        continue;
      }
      const std::optional<Receipt> receipt = read_receipt(contents_.folder, path);
      if (receipt && receipt->hash != hash_of_file(file))
        result_.findings.push_back({Finding::Kind::changed, path, "different content"});
    }
  }

  const StudyContents& contents_;
  const ShareDone& done_;
  std::map<std::string, VideoRecord> videos_;
  std::map<std::string, ArtifactRecord> not_kept_;
  std::vector<ArtifactRecord> recordings_;  ///< those packed with the study
  std::vector<const ArtifactRecord*> present_;
  std::mutex mutex_;  ///< of all below
  double total_cost_ = 0.0;
  double done_cost_ = 0.0;
  Verification result_;
};

}  // namespace

std::string_view name_of(Finding::Kind kind) {
  constexpr std::string_view names[] = {"missing", "changed", "extra", "not kept", "left out"};
  return names[static_cast<std::size_t>(kind)];
}

int Verification::count(Finding::Kind kind) const {
  return static_cast<int>(std::ranges::count(findings, kind, &Finding::kind));
}

bool Verification::is_sound() const {
  return count(Finding::Kind::missing) == 0 && count(Finding::Kind::changed) == 0;
}

Verification verify(const StudyContents& contents, int jobs, const std::stop_token& stop,
                    const ShareDone& done) {
  return Verifier(contents, done).take(jobs, stop);
}

}  // namespace mien::pipeline
