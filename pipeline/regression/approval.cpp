#include "pipeline/regression/approval.h"

#include <algorithm>
#include <set>
#include <utility>

#include "motion/formats/motion_file.h"
#include "motion/text/excerpt.h"
#include "motion/text/safe_name.h"
#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/people.h"
#include "pipeline/production/film/film_tables.h"
#include "pipeline/production/run/study_inputs.h"
#include "pipeline/regression/approved_frames.h"
#include "pipeline/regression/overlay_comparison.h"
#include "pipeline/regression/rendition.h"
#include "pipeline/tasks/store.h"
#include "render/image/image_io.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

std::map<std::string, Hash> hashes_of_files(const fs::path& folder) {
  std::map<std::string, Hash> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files[fs::relative(entry.path(), folder).generic_string()] = hash_of_file(entry.path());
  return files;
}

Hash hash_of_folder(const fs::path& folder) {
  KeyBuilder key;
  for (const auto& [path, hash] : hashes_of_files(folder)) key.add(path, hash);
  return key.key();
}

/// Where everything is made before any of it takes its place, so that an approval that ends early
/// leaves the baseline as it was. It is gone when this ends; what a kill leaves there git ignores.
class Unfinished {
 public:
  explicit Unfinished(const fs::path& baseline)
      : edition_(baseline / "editions" / ".next"), stimuli_(baseline / "stimuli" / ".next") {
    for (const fs::path& folder : {edition_, stimuli_}) {
      fs::remove_all(folder);
      make_folder(folder);
      write_file(folder / ".gitignore", "*\n");
    }
  }
  ~Unfinished() {
    std::error_code unknown;
    fs::remove_all(edition_, unknown);
    fs::remove_all(stimuli_, unknown);
  }
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;

  /// As deep in the baseline as the edition will lie: what its manifest names, it names from there.
  const fs::path& edition() const { return edition_; }
  fs::path stimulus(const std::string& id) const { return stimuli_ / id; }

 private:
  fs::path edition_;
  fs::path stimuli_;
};

/// Fills a folder with the manifest and what it names. Returns the edition's name.
std::string make_edition(const Manifest& manifest, const std::map<std::string, Hash>& inputs,
                         const fs::path& next) {
  Store store(next);
  put_inputs(manifest, inputs, store);
  return hash_of_folder(next / "inputs").substr(0, 12);
}

/// Unless it is there as it should be.
void put_edition(const std::string& name, const fs::path& next, const fs::path& baseline) {
  const fs::path edition = baseline / "editions" / name;
  if (fs::is_directory(edition / "inputs") && hash_of_folder(edition / "inputs").starts_with(name))
    return;
  fs::remove_all(edition);
  make_folder(edition);
  fs::rename(next / "inputs", edition / "inputs");
}

/// Removes the editions that no stimulus was approved with.
void remove_unused(const Baseline& baseline) {
  std::set<std::string> used;
  for (const StimulusFacts& facts : baseline.stimuli) used.insert(facts.edition);
  std::vector<fs::path> unused;
  for (const fs::directory_entry& entry : fs::directory_iterator(baseline.folder / "editions"))
    if (!used.contains(entry.path().filename().string())) unused.push_back(entry.path());
  for (const fs::path& folder : unused) fs::remove_all(folder);
}

/// Fills a folder with a stimulus's files, but its facts.
void put_files(StimulusFacts& facts, Rendition& now, const fs::path& folder,
               const ApprovalOptions& options, const std::stop_token& stop) {
  make_folder(folder / "frames");
  motion::write_motion(motion::to_recording(now.clip_of(facts.id)), folder / "motion.bvh");
  const StagedFilm film = staged(facts.id, {&now, &now, &now}, options.threads);
  const std::vector<int> frames = key_frames_of(film.shot.frame_count(), options.key_frames);
  const std::vector<render::Image8> pictures = drawn(film, frames, stop);
  const std::vector<BlockStatistics> noise = measured_blocks(film, frames, stop);
  Baseline names;
  names.folder = folder.parent_path().parent_path();
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const fs::path picture = folder / "frames" / names.picture_file(facts.id, frames[i]).filename();
    const fs::path blocks = folder / "frames" / names.blocks_file(facts.id, frames[i]).filename();
    render::write_png(picture, pictures[i]);
    write_blocks(blocks, noise[i]);
    facts.key_frames.push_back({frames[i], hash_of_pixels(pictures[i])});
  }
}

void put_videos(const StimulusFacts& facts, const fs::path& study, const fs::path& folder) {
  if (study.empty() || facts.videos.empty()) return;
  make_folder(folder / "videos");
  for (const VideoFacts& video : facts.videos)
    fs::copy_file(study / video.record.file,
                  folder / "videos" / fs::path(video.record.file).filename());
}

/// Puts the stimulus's new folder in the place of the old one.
void exchange(const fs::path& next, const fs::path& folder) {
  // No stimulus is called so.
  const fs::path old = folder.parent_path() / ("." + folder.filename().string() + ".old");
  fs::remove_all(old);
  if (fs::exists(folder)) fs::rename(folder, old);
  fs::rename(next, folder);
  fs::remove_all(old);
}

void put(Baseline& baseline, StimulusFacts facts) {
  const auto same = std::ranges::find(baseline.stimuli, facts.id, &StimulusFacts::id);
  if (same != baseline.stimuli.end())
    *same = std::move(facts);
  else
    baseline.stimuli.push_back(std::move(facts));
}

/// Refuses symbolic links by which files outside the baseline would be written or removed.
void refuse_ways_out(const fs::path& folder) {
  for (const char* own : {"baseline.json", "baseline.json.next", "editions", "stimuli"})
    motion::inside(folder, own, {folder.string()});
}

bool is_wanted(const std::string& id, const Approval& approval) {
  return approval.only.empty() || std::ranges::find(approval.only, id) != approval.only.end();
}

/// Overlays that are approved now, and the others as they were. A baseline that does not know its
/// overlays learns of them when all are approved.
void put_overlays(Baseline& baseline, Rendition& now, const Approval& approval,
                  const std::map<std::string, std::vector<VideoFacts>>& videos) {
  if (!baseline.overlays && !approval.only.empty()) return;
  std::vector<StimulusFacts> before =
      std::exchange(baseline.overlays, {}).value_or(std::vector<StimulusFacts>());
  std::vector<StimulusFacts> overlays;
  for (const Overlay& overlay : now.manifest().overlays) {
    const auto old = std::ranges::find(before, overlay.film.id, &StimulusFacts::id);
    if (is_wanted(overlay.film.id, approval)) {
      overlays.push_back(overlay_facts(overlay, now));
      const auto made = videos.find(overlay.film.id);
      if (made != videos.end()) overlays.back().videos = made->second;
    } else if (old != before.end()) {
      overlays.push_back(*old);
    }
    if (old != before.end()) before.erase(old);
  }
  for (StimulusFacts& removed : before)
    if (!is_wanted(removed.id, approval)) overlays.push_back(std::move(removed));
  baseline.overlays = std::move(overlays);
}

/// Hashes of what was approved now, and of the rest those that were known. A baseline of mien 0.2
/// had none: what it holds is taken as it is.
void put_sums(Baseline& baseline, const std::vector<StimulusFacts>& approved,
              const std::string& edition) {
  const std::map<std::string, Hash> known = std::exchange(baseline.sums, {});
  for (const StimulusFacts& facts : baseline.stimuli) {
    const std::string path = facts_path(facts.id);
    const auto old = known.find(path);
    const bool is_new = std::ranges::find(approved, facts.id, &StimulusFacts::id) != approved.end();
    baseline.sums[path] =
        is_new || old == known.end() ? hash_of_file(baseline.folder / path) : old->second;
    const bool is_known = facts.edition != edition && !known.empty();
    for (const auto& [file, hash] :
         is_known ? known : sums_of_edition(baseline.folder, facts.edition))
      if (file.starts_with("editions/" + facts.edition + "/")) baseline.sums[file] = hash;
  }
}

/// Sorts stimuli into the manifest's order; drops removed ones if their removal is approved.
void put_in_order(Baseline& baseline, const Manifest& manifest, const Approval& approval) {
  std::vector<StimulusFacts> ordered;
  for (const Stimulus* motion : motion_sources(manifest))
    if (const StimulusFacts* facts = baseline.find(motion->id)) ordered.push_back(*facts);
  for (StimulusFacts& facts : baseline.stimuli) {
    if (find_stimulus(manifest, facts.id) != nullptr) continue;
    if (is_wanted(facts.id, approval))
      fs::remove_all(baseline.folder / "stimuli" / facts.id);
    else
      ordered.push_back(std::move(facts));
  }
  baseline.stimuli = std::move(ordered);
}

}  // namespace

Baseline approve(Rendition& now, const fs::path& folder, const Approval& approval,
                 const std::map<std::string, std::vector<VideoFacts>>& videos,
                 const std::map<std::string, Hash>& inputs, const ApprovalOptions& options,
                 const std::stop_token& stop, const std::function<void(double)>& done) {
  const Manifest& manifest = now.manifest();
  refuse_ways_out(folder);
  Baseline baseline;
  if (is_baseline(folder)) baseline = read_baseline(folder);
  if (!baseline.study.empty() && baseline.study != manifest.study)
    throw Error({(folder / "baseline.json").string()},
                "belongs to the study " + motion::in_quotes(baseline.study),
                "name another folder with --baseline");
  baseline.folder = folder;
  baseline.study = manifest.study;
  const Unfinished unfinished(folder);
  const std::string edition = make_edition(manifest, inputs, unfinished.edition());
  std::vector<StimulusFacts> approved;
  double share = 0.0;
  const std::vector<const Stimulus*> sources = motion_sources(manifest);
  for (const Stimulus* source : sources) {
    const Stimulus& stimulus = *source;
    share += 1.0 / static_cast<double>(sources.size());
    if (!is_wanted(stimulus.id, approval)) continue;
    StimulusFacts facts = facts_of(stimulus.id, now);
    facts.edition = edition;
    if (const auto made = videos.find(stimulus.id); made != videos.end())
      facts.videos = made->second;
    const fs::path next = unfinished.stimulus(stimulus.id);
    put_files(facts, now, next, options, stop);
    put_videos(facts, options.videos_from, next);
    facts.files = hashes_of_files(next);
    write_facts(facts, next);
    approved.push_back(std::move(facts));
    if (done) done(share);
  }
  put_edition(edition, unfinished.edition(), folder);
  for (const StimulusFacts& facts : approved) {
    exchange(unfinished.stimulus(facts.id), folder / "stimuli" / facts.id);
    put(baseline, facts);
  }
  put_in_order(baseline, manifest, approval);
  put_overlays(baseline, now, approval, videos);
  baseline.approvals.push_back(approval);
  put_sums(baseline, approved, edition);
  write_baseline(baseline);
  remove_unused(baseline);
  return baseline;
}

std::vector<VideoFacts> videos_of(const std::string& id, const fs::path& folder) {
  std::vector<VideoFacts> videos;
  const fs::path record = folder / film_record_path(id);
  std::error_code unknown;
  if (!fs::is_regular_file(record, unknown)) return videos;
  const FilmRecord film = parse_film_record(read_file(record));
  for (const VideoRecord& video : film.videos)
    if (fs::is_regular_file(folder / video.file, unknown))
      videos.push_back({video, hash_of_file(folder / video.file), film.first_film_frame});
  return videos;
}

}  // namespace mien::pipeline
