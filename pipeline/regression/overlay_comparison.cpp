#include "pipeline/regression/overlay_comparison.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "motion/text/shell_word.h"
#include "pipeline/production/synthesis/motion_record.h"
#include "pipeline/regression/attribution.h"
#include "pipeline/regression/settings.h"

namespace mien::pipeline {

namespace {

/// The stimuli on an overlay, as far as they were compared.
std::vector<const StimulusComparison*> stimuli_on(const Overlay& overlay,
                                                  const std::vector<StimulusComparison>& stimuli) {
  std::vector<const StimulusComparison*> shown;
  for (const auto& [role, name] : motions_on(overlay)) {
    const auto found = std::ranges::find(stimuli, name, &StimulusComparison::id);
    if (found != stimuli.end()) shown.push_back(&*found);
  }
  return shown;
}

bool has_same_pictures(const VideoChange& video) { return video.same_pictures.value_or(false); }

/// Compares one overlay.
class OverlayComparer {
 public:
  OverlayComparer(const StimulusFacts& before, const StimulusFacts& now,
                  std::vector<const StimulusComparison*> shown, bool shows_others)
      : before_(before), now_(now), shown_(std::move(shown)), shows_others_(shows_others) {
    result_.id = now.id;
    result_.settings = changes_between(before.settings, now.settings);
    result_.videos = video_changes(before.videos, now.videos);
  }

  StimulusComparison compare() {
    if (result_.videos.empty()) return std::move(result_);
    find_causes();
    const bool is_accepted = is_judged_by_stimuli();
    const bool differs = std::ranges::any_of(result_.videos, [&](const VideoChange& video) {
      if (!video.same_frames) return true;
      return has_same_pictures(video) ? video.psnr_lost_db > now_.limits.psnr_db : !is_accepted;
    });
    for (const VideoChange& video : result_.videos)
      if (differs) result_.reasons.push_back(video.format + ": " + video.what.front());
    result_.verdict = differs ? Verdict::differs : Verdict::alike;
    return std::move(result_);
  }

 private:
  /// Whether noise or motions may have changed, and nothing else: the stimuli were judged for both.
  bool is_judged_by_stimuli() const {
    const bool has_own_change = std::ranges::any_of(
        result_.settings, [](const SettingChange& change) { return change.path != "seed"; });
    const auto has = [&](Verdict verdict) {
      return std::ranges::any_of(shown_, [&](const auto* one) { return one->verdict == verdict; });
    };
    if (has_own_change || has(Verdict::differs) || has(Verdict::appeared)) return false;
    const bool was_approved_later = is_of_other_motions() && !shows_others_;
    return was_approved_later || !result_.settings.empty() || before_.origin != now_.origin ||
           has(Verdict::alike);
  }

  bool is_of_other_motions() const { return before_.motion != now_.motion; }

  void find_causes() {
    const auto& videos = result_.videos;
    if (!std::ranges::all_of(videos, &VideoChange::is_made)) {
      result_.causes = video_causes(before_, now_, videos);
    } else if (std::ranges::all_of(videos, has_same_pictures)) {
      add(video_causes(before_, now_, videos), "the same frames give a different file");
    } else {
      for (const auto& [aspect, cause] :
           {std::pair(Aspect::motion, Cause::motion), std::pair(Aspect::scene, Cause::scene),
            std::pair(Aspect::drawing, Cause::drawing),
            std::pair(Aspect::video, Cause::presentation)})
        add_settings(aspect, cause);
      for (const StimulusComparison* stimulus : shown_)
        add(stimulus->causes, "the overlay shows " + stimulus->id);
      if (result_.causes.empty() && is_of_other_motions())
        result_.causes.push_back({Cause::motion,
                                  "motions of its stimuli",
                                  "the overlay was approved with other motions",
                                  {}});
      if (result_.causes.empty())
        add(program_causes({before_, before_, now_}),
            "with the same motions and settings, the video shows other frames");
    }
  }

  void add_settings(Aspect aspect, Cause cause) {
    std::string root;
    for (const SettingChange& change : result_.settings)
      if (change.aspect == aspect) root += (root.empty() ? "" : "; ") + change_text(change);
    if (!root.empty())
      result_.causes.push_back({cause, root, "an option of the overlay has changed", {}});
  }

  /// Adds causes that are not known yet.
  void add(const std::vector<Attribution>& causes, const std::string& evidence) {
    for (const Attribution& cause : causes) {
      const bool is_known = std::ranges::any_of(result_.causes, [&](const Attribution& other) {
        return other.cause == cause.cause && other.root == cause.root;
      });
      if (!is_known) result_.causes.push_back({cause.cause, cause.root, evidence, {}});
    }
  }

  const StimulusFacts& before_;
  const StimulusFacts& now_;
  std::vector<const StimulusComparison*> shown_;
  bool shows_others_;  ///< motions that were not compared: of other stimuli, or examples
  StimulusComparison result_;
};

StimulusComparison appeared_overlay(const std::string& id, const Manifest& manifest) {
  StimulusComparison comparison{.id = id, .verdict = Verdict::appeared};
  comparison.reasons.push_back(
      fmt::format("is an overlay that is not in the baseline; if it is as intended: mien regress "
                  "approve {} --only {} --reason \"…\"",
                  motion::shell_path(manifest.file.string()), id));
  return comparison;
}

StimulusComparison gone_overlay(const std::string& id) {
  StimulusComparison comparison{.id = id, .verdict = Verdict::gone};
  comparison.reasons.emplace_back(
      "is an overlay in the baseline, but no longer in the manifest; approving it removes it from "
      "the baseline");
  return comparison;
}

}  // namespace

StimulusFacts overlay_facts(const Overlay& overlay, Rendition& rendition) {
  StimulusFacts facts;
  facts.id = overlay.film.id;
  facts.origin = this_origin();
  facts.settings = settings_of(overlay, rendition.manifest(), rendition.files());
  facts.limits = rendition.manifest().regression;
  KeyBuilder motions;
  for (const auto& [role, name] : motions_on(overlay))
    if (find_stimulus(rendition.manifest(), name) != nullptr)
      motions.add(name, digest_of(rendition.clip_of(name)));
  facts.motion = motions.key();
  return facts;
}

void compare_overlays(const ComparedStudy& study,
                      const std::map<std::string, std::vector<VideoFacts>>& videos,
                      Regression& result) {
  const Manifest& manifest = study.now.manifest();
  const std::vector<StimulusFacts> none;
  const std::vector<StimulusFacts>& approved =
      study.baseline.overlays ? *study.baseline.overlays : none;
  std::vector<StimulusComparison> compared;
  for (const Overlay& overlay : manifest.overlays) {
    const std::string& id = overlay.film.id;
    const auto made = videos.find(id);
    const bool has_videos = made != videos.end() && !made->second.empty();
    const auto before = std::ranges::find(approved, id, &StimulusFacts::id);
    if (!study.compares(id)) {
      result.not_compared.push_back(id);
    } else if (before == approved.end()) {
      if (study.baseline.overlays)
        compared.push_back(appeared_overlay(id, manifest));
      else if (has_videos)
        result.without_videos.push_back(id);
    } else if (made != videos.end()) {
      if (has_videos && before->videos.empty()) result.without_videos.push_back(id);
      StimulusFacts now = overlay_facts(overlay, study.now);
      now.videos = made->second;
      const auto shown = stimuli_on(overlay, result.stimuli);
      const bool shows_others = shown.size() < motions_on(overlay).size();
      compared.push_back(OverlayComparer(*before, now, shown, shows_others).compare());
    }
  }
  for (const StimulusFacts& facts : approved) {
    const bool is_there = std::ranges::any_of(
        manifest.overlays, [&](const Overlay& overlay) { return overlay.film.id == facts.id; });
    if (is_there) continue;
    if (study.compares(facts.id))
      compared.push_back(gone_overlay(facts.id));
    else
      result.not_compared.push_back(facts.id);
  }
  std::ranges::move(compared, std::back_inserter(result.stimuli));
}

}  // namespace mien::pipeline
