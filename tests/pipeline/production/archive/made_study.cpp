#include "pipeline/production/archive/made_study.h"

#include <optional>
#include <stdexcept>

#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/production/run/run.h"

#include "shared_set_up.h"

namespace mien::test {

namespace {

namespace fs = std::filesystem;
using namespace mien::pipeline;

constexpr char manifest_text[] = R"(mien: 1
study: tiny
seed: 7
examples: {set: builtin:walks-10}
recipes: my.recipes.yaml
equalize: [luminance]
output: {size: [48, 32], fps: 8, cycles: 1, quality: draft, frames: none}
stimuli:
  - {id: a, weights: {normal: 1}, output: {frames: png, video: [gif], clips: [bvh]}}
  - {id: b, weights: {sad: 1}, output: {video: [mp4], presentation: {blank_before: 0.5, fade_in: 0.4}}}
  - {id: c, weights: {proud: 1}, output: {video: [webp, mp4-lossless]}}
  - {id: d, weights: {brisk: 1}, modify: {emotion: heavy, strength: 0.5}, output: {frames: exr, video: []}}
overlays: [{target: a, created: b, output: {video: [webm]}}]
sheets: [{compare: {target: a, created: b}}]
)";

void make(const fs::path& folder) {
  write_file(folder / "my.recipes.yaml", "recipes: {heavy: {tempo: 0.9}}\n");
  write_file(folder / "m.yaml", manifest_text);
  Production production(
      load_manifest(folder / "m.yaml", [](const std::string&) { return std::nullopt; }), {});
  const RunResult result = run(production, folder / "tiny", 2, {}, {});
  for (const TaskOutcome& outcome : result.outcomes) {
    if (!outcome.error.empty()) throw std::runtime_error(outcome.error);
  }
}

}  // namespace

MadeStudy::MadeStudy() {
  fs::copy(shared_set_up("made_study", make) / "tiny", folder_, fs::copy_options::recursive);
}

void MadeStudy::forget_receipts() const { fs::remove_all(folder_ / ".mien"); }

void MadeStudy::forge(const std::function<void(nlohmann::ordered_json&)>& change) const {
  const fs::path file = folder_ / "provenance.json";
  auto record = nlohmann::ordered_json::parse(read_file(file));
  change(record);
  write_file(file, record.dump(2) + "\n");
}

void MadeStudy::forge_artifact(const std::string& path, const std::string& bytes) const {
  write_file(folder_ / path, bytes);
  forge([&](nlohmann::ordered_json& record) {
    record["artifacts"][path] = {{"hash", hash_of(bytes)}, {"size", bytes.size()}};
  });
}

}  // namespace mien::test
