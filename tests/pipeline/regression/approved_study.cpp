#include "pipeline/regression/approved_study.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>

#include "motion/formats/motion_file.h"
#include "motion/procedural/builtin_sets.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/production/archive/scratch_folder.h"
#include "pipeline/production/run/study_inputs.h"
#include "pipeline/regression/approval.h"
#include "render/image/image_io.h"
#include "scenes/skinned_gltf.h"

#include "shared_set_up.h"

namespace mien::test {

namespace {

namespace fs = std::filesystem;
using namespace mien::pipeline;
using nlohmann::json;

constexpr char manifest_text[] = R"({
  "mien": 1, "study": "small", "seed": 3,
  "examples": {"set": {"folder": "walks", "cycle": "auto"}, "ratings": "simulated"},
  "look": {"scene": "studio", "figure": "stick", "camera": "three-quarter"},
  "output": {"size": [96, 54], "fps": 10, "cycles": 1, "quality": "draft", "video": ["gif"],
             "frames": "none"},
  "stimuli": [
    {"id": "blend", "weights": {"normal": 0.6, "proud": 0.4}},
    {"id": "wish", "adjectives": {"quickness": 0.6}},
    {"id": "styled", "weights": {"normal": 1}, "modify": {"emotion": "sad", "strength": 0.5}},
    {"id": "file", "clip": "walk.bvh"},
    {"id": "tinted", "weights": {"sad": 1}, "look": {"scene": "my.set.yaml"}},
    {"id": "someone", "weights": {"happy": 1}, "look": {"figure": {"character": "someone.gltf"}}}
  ]})";

constexpr char set_text[] = R"(name: mine
background: {horizon: "#d2d3d3", zenith: "#eef1f5"}
sky: {zenith: [0.3, 0.3, 0.3], horizon: [0.2, 0.2, 0.2], below: [0.1, 0.1, 0.1]}
ground: {colour: "#c08040"}
lights:
  - {azimuth: -28, elevation: 52, distance: 4, size: 0.8, strength: 0.7}
)";

std::optional<std::string> no_variable(const std::string&) { return std::nullopt; }

void write_character(const fs::path& folder) {
  SkinnedGltf character = skinned_gltf(motion::standard_body(), {});
  character.json["images"] = {{{"uri", "skin.png"}}};
  write_file(folder / "someone.gltf", character.text());
}

void write_study(const fs::path& folder) {
  make_folder(folder / "walks");
  for (const motion::Example& example : motion::builtin_examples("walks-10").examples) {
    const std::string name = example.clip.name + ".bvh";
    const motion::Recording walk = motion::to_recording(motion::repeated(example.clip, 3));
    motion::write_motion(walk, folder / "walks" / name);
    if (example.clip.name == "happy")
      motion::write_motion(motion::to_recording(example.clip), folder / "walk.bvh");
  }
  write_file(folder / "my.set.yaml", set_text);
  write_character(folder);
  write_texture(folder, 130);
  write_file(folder / "study.yaml", manifest_text);
}

Manifest manifest_in(const fs::path& folder) {
  return load_manifest(folder / "study.yaml", no_variable);
}

Videos videos_of_study(const json& manifest) {
  Videos videos;
  for (const json& stimulus : manifest.at("stimuli")) {
    const std::string id = stimulus.at("id");
    videos[id] = {{.record = {.file = "videos/" + id + ".mp4",
                              .format = "mp4",
                              .frames = 10,
                              .fps = 10.0,
                              .duration_s = 1.0,
                              .identical = false,
                              .worst_psnr_db = 41.0,
                              .worst_psnr_frame = 0,
                              .worst_ssim = 0.99,
                              .worst_ssim_frame = 0},
                   .hash = "0123456789abcdef"}};
  }
  return videos;
}

Baseline approve_in(const fs::path& study, const fs::path& folder, const Videos& videos) {
  const TemporaryFolder scratch;
  Rendition now(manifest_in(study), scratch.path(), 2, {});
  return approve(
      now, folder,
      {.who = "a tester", .when = "2026-01-01T00:00:00Z", .why = "for tests", .only = {}}, videos,
      hashes_of_inputs(now.manifest()), {.key_frames = 2, .threads = 2}, {}, {});
}

}  // namespace

json& ChangedStudy::stimulus(const std::string& id) {
  for (json& one : manifest.at("stimuli")) {
    if (one.at("id") == id) return one;
  }
  throw std::out_of_range(id);
}

StimulusFacts& ChangedStudy::approved(const std::string& id) {
  return *std::ranges::find(baseline.stimuli, id, &StimulusFacts::id);
}

void ChangedStudy::change_motion(const std::function<void(motion::Recording&)>& change) const {
  motion::Recording walk = motion::read_motion(folder / "walk.bvh");
  change(walk);
  motion::write_motion(walk, folder / "walk.bvh");
}

void ChangedStudy::change_text(const std::string& file, const std::string& from,
                               const std::string& to) const {
  std::string text = read_file(folder / file);
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::out_of_range(file + " has no " + from);
  write_file(folder / file, text.replace(at, from.size(), to));
}

void write_texture(const fs::path& folder, std::uint8_t grey) {
  render::Image8 skin(4, 4);
  std::ranges::fill(skin.channels, grey);
  render::write_png(folder / "skin.png", skin);
}

ApprovedStudy::ApprovedStudy()
    : folder_(shared_set_up("approved_study", [](const fs::path& folder) {
        write_study(folder);
        approve_in(folder, folder / "baselines" / "small",
                   videos_of_study(json::parse(manifest_text)));
      })) {}

ChangedStudy ApprovedStudy::copied(const fs::path& folder) const {
  fs::copy(folder_, folder, fs::copy_options::recursive);
  ChangedStudy study{.folder = folder,
                     .manifest = json::parse(manifest_text),
                     .baseline = read_baseline(folder / "baselines" / "small"),
                     .videos = {}};
  study.videos = videos_of_study(study.manifest);
  return study;
}

Baseline ApprovedStudy::approved(const ChangedStudy& study, const fs::path& folder) const {
  write_file(study.folder / "study.yaml", study.manifest.dump(1));
  return approve_in(study.folder, folder, study.videos);
}

const ApprovedStudy& approved_study() {
  static const ApprovedStudy study;
  return study;
}

std::unique_ptr<Rendition> rendition_of(const ChangedStudy& study, const fs::path& store) {
  write_file(study.folder / "study.yaml", study.manifest.dump(1));
  return std::make_unique<Rendition>(manifest_in(study.folder), store, study.threads,
                                     std::stop_token{});
}

Regression regressed(const ChangedStudy& study) {
  const ScratchFolder scratch, then_scratch;
  const std::unique_ptr<Rendition> now = rendition_of(study, scratch.path());
  std::map<std::string, std::unique_ptr<Rendition>> editions;
  const auto approved = [&](const std::string& edition) -> Rendition& {
    auto& one = editions[edition];
    if (one == nullptr) {
      one = std::make_unique<Rendition>(
          load_manifest(study.baseline.edition_manifest(edition), no_variable),
          then_scratch.path() / edition, study.threads, std::stop_token{});
    }
    return *one;
  };
  return regress({.baseline = study.baseline,
                  .now = *now,
                  .approved = approved,
                  .pictures = nullptr,
                  .threads = study.threads,
                  .stop = {}},
                 study.videos, {.audit_share = study.audits}, {});
}

const StimulusComparison& comparison_of(const Regression& regression, std::string_view id) {
  return *std::ranges::find(regression.stimuli, id, &StimulusComparison::id);
}

}  // namespace mien::test
