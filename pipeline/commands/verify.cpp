#include "pipeline/production/archive/verify.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pipeline/base/documents/environment.h"
#include "pipeline/commands/line/console.h"
#include "pipeline/commands/verification_text.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/production/archive/rerender.h"
#include "pipeline/production/run/provenance.h"
#include "pipeline/tasks/progress.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

struct VerifyOptions {
  std::string study;
  int rerender = 0;
  std::optional<std::uint64_t> seed;
  int jobs = 0;
  bool json = false;

  int threads() const {
    return jobs > 0 ? jobs : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  }
};

/// Result of rendering frames again.
struct Rerendered {
  std::uint64_t seed = 0;
  std::vector<RerenderedFrame> frames;
  std::vector<std::string> changes;  ///< since the study was made: then pictures may differ

  bool all_agree() const {
    return std::ranges::all_of(frames, [](const RerenderedFrame& frame) { return frame.agrees; });
  }
};

Rerendered rerender(const StudyContents& contents, const VerifyOptions& options,
                    const Console& console) {
  const Manifest manifest = load_manifest(contents.provenance(), process_environment());
  Rerendered result{options.seed.value_or(contents.seed), {}, {}};
  result.changes = changes_since(contents.provenance(), manifest);
  const std::vector<ComparableFilm> films = comparable_films(manifest, contents);
  if (films.empty())
    throw Error({contents.folder.string()}, "has neither frames nor videos with records",
                "omit --rerender; mien clean --keep videos,metrics keeps what it needs");
  ProgressBar bar(console.err, console.err_is_terminal);
  result.frames = rerender(manifest, contents, sampled_frames(films, options.rerender, result.seed),
                           options.threads(), console.stop,
                           [&](double share, const std::string& film) { bar.show(share, film); });
  return result;
}

void print_result(const Rerendered& drawn, const Console& console) {
  for (const std::string& change : drawn.changes) console.err << "warning: " << change << '\n';
  for (const RerenderedFrame& frame : drawn.frames)
    console.out << fmt::format("{:<9} frame {} of {}, against {}: {}\n",
                               frame.agrees ? "agrees" : "differs", frame.frame, frame.film,
                               frame.against, frame.how);
  const auto agree = std::ranges::count(drawn.frames, true, &RerenderedFrame::agrees);
  console.out << fmt::format("{} of {} rerendered frames agree (seed {})\n", agree,
                             drawn.frames.size(), drawn.seed);
}

ordered_json as_json(const Rerendered& drawn) {
  ordered_json frames = ordered_json::array();
  for (const RerenderedFrame& frame : drawn.frames)
    frames.push_back({{"film", frame.film},
                      {"frame", frame.frame},
                      {"against", frame.against},
                      {"agrees", frame.agrees},
                      {"how", frame.how}});
  return {{"seed", drawn.seed}, {"changed_since", drawn.changes}, {"frames", frames}};
}

int run_verify(const VerifyOptions& options, const Console& console) {
  const StudyContents contents = contents_of(options.study);
  const Verification verification = verified(contents, options.threads(), console);
  if (!options.json) print_result(verification, contents, console);
  std::optional<Rerendered> drawn;
  if (options.rerender > 0) drawn = rerender(contents, options, console);
  if (options.json) {
    ordered_json result = as_json(verification, contents);
    if (drawn) result["rerendered"] = as_json(*drawn);
    const auto replace = ordered_json::error_handler_t::replace;
    console.out << result.dump(2, ' ', false, replace) << '\n';
  } else if (drawn) {
    print_result(*drawn, console);
  }
  return verification.is_sound() && (!drawn || drawn->all_agree()) ? exit_done : exit_failed;
}

}  // namespace

Command verify_command() {
  const auto options = std::make_shared<VerifyOptions>();
  return {
      .name = "verify",
      .summary = "Verify a finished study against its provenance",
      .options = {argument("study", &options->study,
                           "Folder of a study, its provenance.json, or an unpacked archive of it"),
                  option("--rerender", &options->rerender,
                         "Number of randomly chosen frames to render again and compare")
                      .between(1, 1'000'000),
                  option("--seed", &options->seed,
                         "Random seed for --rerender (default: that of the study)"),
                  option("--jobs,-j", &options->jobs,
                         "Number of files read in parallel (default: one per processor)")
                      .between(1, 1024),
                  flag("--json", &options->json, "Findings as JSON on standard output")},
      .notes =
          "Every artifact is hashed and decoded frame by frame, and every copied input and packed "
          "recording is hashed. "
          "The report lists what is missing, changed or extra (of unknown origin), and what mien "
          "clean removed or mien pack left out because of a licence. Exit code: 1 if anything is "
          "missing or changed, or a rerendered frame "
          "differs; extra files are reported only.\n\n"
          "A rerendered frame must have the same bytes as the frame that was kept. If only a video "
          "was kept, the rerendered frame must match the video: exactly for lossless formats; "
          "for others at least as closely as the worst-matching frame did when the video was "
          "encoded, less a small tolerance.\n\n"
          "Examples:\n"
          "  mien verify out/my-study\n"
          "  mien verify out/my-study --rerender 20",
      .run = [options](const Console& console) { return run_verify(*options, console); }};
}

}  // namespace mien::pipeline
