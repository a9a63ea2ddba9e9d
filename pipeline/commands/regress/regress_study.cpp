#include "pipeline/commands/regress/regress_study.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <map>
#include <memory>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "motion/text/nearest_word.h"
#include "motion/text/safe_name.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/base/documents/page_bundle.h"
#include "pipeline/commands/line/installed_manifests.h"
#include "pipeline/commands/regress/study_baseline.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/manifest/people.h"
#include "pipeline/production/run/study_inputs.h"
#include "pipeline/regression/approval.h"
#include "pipeline/regression/regression.h"
#include "pipeline/regression/report/regression_report.h"
#include "pipeline/regression/report/regression_texts.h"
#include "pipeline/tasks/command_run.h"
#include "pipeline/tasks/progress.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;
using Videos = std::map<std::string, std::vector<VideoFacts>>;

bool is_selected(const std::vector<std::string>& only, const std::string& id) {
  return only.empty() || std::ranges::find(only, id) != only.end();
}

/// The study and its products.
struct ProducedStudy {
  std::unique_ptr<Production> production;
  fs::path folder;
  Videos videos;
};

void make(ProducedStudy& study, const StudyArguments& arguments, const Console& console) {
  Production& production = *study.production;
  make_study(production, study.folder, arguments.production, console);
  // A film of several people is compared once, with the first of them.
  for (const Stimulus& stimulus : production.manifest().stimuli)
    if (is_selected(arguments.production.only, stimulus.id))
      study.videos[motions_in(stimulus).front()->id] = videos_of(stimulus.id, study.folder);
  for (const Overlay& overlay : production.manifest().overlays)
    if (is_selected(arguments.production.only, overlay.film.id))
      study.videos[overlay.film.id] = videos_of(overlay.film.id, study.folder);
}

/// Whether the manifest has a stimulus or an overlay with this id.
bool has_film(const Manifest& manifest, const std::string& id) {
  const auto is_overlay = [&](const Overlay& overlay) { return overlay.film.id == id; };
  return find_stimulus(manifest, id) != nullptr ||
         std::ranges::any_of(manifest.overlays, is_overlay);
}

/// Reads and plans the study without running it; selected stimuli and overlays that are not in the
/// manifest are ignored.
ProducedStudy planned(const StudyArguments& arguments, const Console& console) {
  const fs::path file = resolve_manifest(arguments.production.manifest, console);
  const Manifest manifest = load_with_warnings(file, arguments.production.out, console);
  ProductionOptions options = options_of(arguments.production);
  std::erase_if(options.only, [&](const std::string& id) { return !has_film(manifest, id); });
  ProducedStudy study;
  study.production = std::make_unique<Production>(manifest, options);
  study.folder = folder_of(arguments.production, study.production->manifest());
  return study;
}

/// Approved editions of the study, each produced on demand.
class Editions {
 public:
  Editions(const Baseline& baseline, int threads, std::stop_token stop)
      : baseline_(baseline), threads_(threads), stop_(std::move(stop)) {}

  Rendition& of(const std::string& name) {
    std::unique_ptr<Edition>& known = editions_[name];
    if (known == nullptr) {
      auto edition = std::make_unique<Edition>();
      edition->rendition = std::make_unique<Rendition>(
          load_manifest(baseline_.edition_manifest(name), process_environment()),
          edition->folder.path(), threads_, stop_);
      known = std::move(edition);  // only when it could be made
    }
    return *known->rendition;
  }

 private:
  struct Edition {
    ScratchFolder folder;
    std::unique_ptr<Rendition> rendition;
  };

  const Baseline& baseline_;
  int threads_;
  std::stop_token stop_;
  std::map<std::string, std::unique_ptr<Edition>> editions_;
};

/// File that marks a folder as a report, which may be overwritten.
constexpr char report_mark[] = ".mien-regression";

/// Creates an empty folder for the report, removing an earlier one. Throws Error for a folder with
/// other contents, which would be overwritten.
fs::path cleared_report_folder(const StudyArguments& arguments, const Manifest& manifest) {
  const fs::path folder = !arguments.report.empty() ? fs::path(arguments.report)
                                                    : fs::path(arguments.production.out) /
                                                          (manifest.study + "-regression");
  if (fs::exists(folder) && !fs::is_directory(folder))
    throw Error({folder.string()}, "is not a folder", "name a folder for the report with --report");
  if (fs::exists(folder) && !fs::is_empty(folder) && !fs::exists(folder / report_mark))
    throw Error({folder.string()}, "exists, but was not written by mien regress",
                "name a new folder with --report");
  make_folder(folder);
  for (const char* own : {report_mark, "summary.md"})
    motion::inside(folder, own, {folder.string()});
  write_file(folder / report_mark, "");
  for (const char* old : {"frames", "videos", "report.html", "regression.json", "junit.xml"})
    fs::remove_all(folder / old);
  // Remains if this run is not completed.
  write_file(folder / "summary.md",
             "## ❌ " + manifest.study + "\n\nThe comparison was not completed.\n");
  return folder;
}

/// Throws Error for a folder with other contents than a complete or partial baseline.
void refuse_other_folder(const fs::path& folder) {
  if (!fs::exists(folder) || is_baseline(folder)) return;
  const bool is_folder = fs::is_directory(folder);
  const auto is_ours = [](const fs::directory_entry& entry) {
    return entry.path().filename() == "editions" || entry.path().filename() == "stimuli";
  };
  if (is_folder && std::ranges::all_of(fs::directory_iterator(folder), is_ours)) return;
  throw Error({folder.string()}, is_folder ? "exists, but is not a baseline" : "is not a folder",
              "name a new folder with --baseline");
}

/// The script that shows images, motions and videos in a report; empty if it has not been built.
std::string report_script(const Console& console) {
  try {
    return read_file(page_bundle("regress") / "regress.js");
  } catch (const Error& error) {
    console.err << "note: report.html has no images, motions or videos: " << error.what() << '\n';
    return "";
  }
}

/// `made` is the study's folder, or empty if it was not run.
void write_reports(const Regression& regression, const ComparedStudy& study, const fs::path& folder,
                   const fs::path& made, const Console& console) {
  const auto replace = nlohmann::ordered_json::error_handler_t::replace;
  write_file(folder / "report.html", regression_report(regression, study, report_script(console),
                                                       ReportVideos(made, folder)));
  write_file(folder / "regression.json", as_json(regression).dump(2, ' ', false, replace) + "\n");
  write_file(folder / "junit.xml", junit_text(regression));
  write_file(folder / "summary.md", markdown_text(regression));
}

std::string now_text() {
  const char* epoch = std::getenv("SOURCE_DATE_EPOCH");
  const std::time_t now =
      epoch != nullptr ? static_cast<std::time_t>(std::strtoll(epoch, nullptr, 10))
                       : std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
}

/// Default name of the approving person: the user name of git in the study's folder, or else that
/// of the system.
std::string user_name(const Manifest& manifest) {
  const fs::path folder = fs::absolute(manifest.file).parent_path();
  const CommandResult git =
      run_command({"git", "-C", folder.string(), "config", "user.name"}, std::chrono::seconds(10));
  const std::string name = git.output.substr(0, git.output.find('\n'));
  if (git.succeeded() && !name.empty()) return name;
  const char* user = std::getenv("USER");
  return user != nullptr && *user != '\0' ? user : "unknown";
}

/// The selected stimuli, with several people in place of a stimulus that shows them.
std::vector<std::string> with_people(const std::vector<std::string>& only,
                                     const Manifest& manifest) {
  std::vector<std::string> ids;
  for (const std::string& id : only) {
    const Stimulus* stimulus = find_stimulus(manifest, id);
    if (stimulus == nullptr) ids.push_back(id);
    if (stimulus == nullptr) continue;
    for (const Stimulus* motion : motions_in(*stimulus)) ids.push_back(motion->id);
  }
  return ids;
}

/// Refuses unknown stimuli and overlays. Those only in the baseline can be approved too, which
/// removes them.
void refuse_unknown(const std::vector<std::string>& ids, const Manifest& manifest,
                    const Baseline& baseline) {
  std::vector<std::string> known;
  for (const Stimulus& stimulus : manifest.stimuli) known.push_back(stimulus.id);
  for (const Overlay& overlay : manifest.overlays) known.push_back(overlay.film.id);
  const auto add_removed = [&](const std::vector<StimulusFacts>& approved) {
    for (const StimulusFacts& facts : approved)
      if (!has_film(manifest, facts.id)) known.push_back(facts.id);
  };
  add_removed(baseline.stimuli);
  if (baseline.overlays) add_removed(*baseline.overlays);
  for (const std::string& id : ids)
    if (std::ranges::find(known, id) == known.end())
      throw Error({"--only"}, "the study has no stimulus " + motion::in_quotes(id),
                  motion::did_you_mean(id, known));
}

}  // namespace

int regress_study(const StudyArguments& arguments, const Console& console) {
  ProducedStudy produced_study = planned(arguments, console);
  const Manifest& manifest = produced_study.production->manifest();
  const fs::path folder = cleared_report_folder(arguments, manifest);
  const FoundBaseline found = find_baseline(arguments.baseline, manifest);
  const Baseline baseline = read_baseline(found.folder);
  if (baseline.study != manifest.study)
    throw Error({found.folder.string()},
                "is the baseline of the study " + motion::in_quotes(baseline.study),
                "name the baseline of " + motion::in_quotes(manifest.study) + " with --baseline");
  check_files(baseline);
  if (baseline.sums.empty())
    console.err
        << "note: " << found.folder.string()
        << ": this baseline has no checksums, so damage to it may go unnoticed; approve again\n";
  refuse_unknown(arguments.production.only, manifest, baseline);
  const std::vector<std::string> only = with_people(arguments.production.only, manifest);
  const bool has_selected_film = std::ranges::any_of(films_of(manifest), [&](const Stimulus* film) {
    return is_selected(arguments.production.only, film->id);
  });
  if (!arguments.without_videos && has_selected_film) make(produced_study, arguments, console);
  const int threads = jobs_of(arguments.production);
  const ScratchFolder scratch;
  Rendition now(manifest, scratch.path(), threads, console.stop);
  Editions editions(baseline, threads, console.stop);
  const ComparedPictures pictures(folder / "frames");
  const ComparedStudy study{
      .baseline = baseline,
      .now = now,
      .approved = [&](const std::string& edition) -> Rendition& { return editions.of(edition); },
      .pictures = &pictures,
      .threads = threads,
      .stop = console.stop,
      .only = only};
  Regression regression;
  {
    ProgressBar bar(console.err, console.err_is_terminal);
    regression =
        regress(study, produced_study.videos, {.audit_share = arguments.audits},
                [&](double share, const StimulusComparison& one) { bar.show(share, one.id); });
  }
  regression.repetitions = repeated(study, arguments.repeat);
  write_reports(regression, study, folder,
                arguments.without_videos ? fs::path() : produced_study.folder, console);
  if (arguments.production.json) {
    const auto replace = nlohmann::ordered_json::error_handler_t::replace;
    console.out << as_json(regression).dump(2, ' ', false, replace) << '\n';
  } else {
    console.out << plain_text(regression) << (folder / "report.html").string() << '\n';
  }
  return regression.passes() ? exit_done : exit_failed;
}

int approve_study(const StudyArguments& arguments, const Console& console) {
  if (arguments.keep_videos && arguments.without_videos)
    throw Error({"--keep-videos"}, "there are none with --without-videos", "leave one of them out");
  StudyArguments whole = arguments;
  whole.production.only.clear();
  ProducedStudy produced_study = planned(whole, console);
  const Manifest& manifest = produced_study.production->manifest();
  const fs::path folder = new_baseline(arguments.baseline, manifest);
  refuse_other_folder(folder);
  const Baseline before = is_baseline(folder) ? read_baseline(folder) : Baseline{};
  refuse_unknown(arguments.production.only, manifest, before);
  if (!arguments.without_videos) make(produced_study, whole, console);
  const int threads = jobs_of(arguments.production);
  const ScratchFolder scratch;
  Rendition now(manifest, scratch.path(), threads, console.stop);
  ProgressBar bar(console.err, console.err_is_terminal);
  const Baseline baseline =
      approve(now, folder,
              {.who = arguments.approver.empty() ? user_name(manifest) : arguments.approver,
               .when = now_text(),
               .why = arguments.reason,
               .only = with_people(arguments.production.only, manifest)},
              produced_study.videos, produced_study.production->inputs(),
              {.key_frames = arguments.key_frames,
               .videos_from = arguments.keep_videos ? produced_study.folder : fs::path(),
               .threads = threads},
              console.stop, [&](double share) { bar.show(share, "approving"); });
  const std::size_t approved = arguments.production.only.empty() ? baseline.stimuli.size()
                                                                 : arguments.production.only.size();
  console.out << fmt::format("{}: {} {} approved by {}\n", folder.string(), approved,
                             approved == 1 ? "stimulus" : "stimuli", baseline.approvals.back().who);
  for (const StimulusFacts& facts : before.stimuli)
    if (baseline.find(facts.id) == nullptr)
      console.out << facts.id << " was removed from the baseline\n";
  return exit_done;
}

}  // namespace mien::pipeline
