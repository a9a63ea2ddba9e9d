#include "faults/trial.h"

#include <fstream>
#include <stdexcept>

#include "shared_set_up.h"

namespace mien::test {

namespace {

namespace fs = std::filesystem;

// Small pictures and few samples: what counts is that every kind of artifact is made.
constexpr const char* manifest_text = R"(mien: 1
study: faults
seed: 3
examples: {set: "builtin:walks-10", ratings: builtin}
output: {size: [96, 54], fps: 15, cycles: 1, quality: draft, frames: png, video: [mp4], clips: [bvh, glb]}
equalize: [size, luminance]
stimuli:
  - {id: one, role: target, adjectives: {quickness: 0.7, largeness: 0.6}}
  - {id: two, weights: {normal: 0.5, sad: 0.5}, output: {frames: exr}}
  - {id: three, weights: {normal: 0.5, tired: 0.5}, output: {frames: none, video: [mp4, gif]}}
sheets:
  - compare: {target: one, created: two, reference: normal}
)";

constexpr const char* all_tasks =
    "film:three film:two film:one clip:one clip:two clip:three sheet:one_two report";
constexpr const char* all_chunks =
    "film:one[1/2] film:two[2/3] film:two[1/3] film:two[3/3] film:three[1/1] film:one[2/2]";

std::string end_of(const std::string& text) {
  constexpr std::size_t most = 600;
  return text.size() <= most ? text : text.substr(text.size() - most);
}

}  // namespace

Trial::Trial(std::uint64_t seed)
    : random(seed), set_up_(shared_set_up("faults", [](const fs::path& folder) {
        std::ofstream(folder / "study.yaml") << manifest_text;
        const double begin = seconds_now();
        const Ended made = ended(run(folder / "study.yaml", folder / "finished"));
        std::ofstream(folder / "seconds") << seconds_now() - begin;
        if (made.code != 0) throw std::runtime_error("the undisturbed run failed: " + made.errors);
      })) {
  duration_ = std::stod(text_of(set_up_ / "seconds"));
  undisturbed_ = bytes_in(study_in(set_up_ / "finished"));
}

fs::path Trial::fresh_out() { return scratch_.path() / std::to_string(++folders_); }

fs::path Trial::finished_out() {
  const fs::path out = fresh_out();
  fs::copy(set_up_ / "finished", out, fs::copy_options::recursive);
  return out;
}

Trial::Words Trial::run(const fs::path& manifest, const fs::path& out) {
  return mien_with({"run", manifest.string(), "--out", out.string(), "--jobs", "2"});
}

Trial::Words Trial::worker(const fs::path& out) const {
  return mien_with(
      {"farm", "worker", manifest().string(), "--out", out.string(), "--tasks", all_tasks});
}

Trial::Words Trial::chunks(const fs::path& out) const {
  return mien_with(
      {"farm", "worker", manifest().string(), "--out", out.string(), "--tasks", all_chunks});
}

Trial::Words Trial::any(const fs::path& out) {
  switch (below(4)) {
    case 0:
      return worker(out);
    case 1:
      return chunks(out);
    default:
      return run(out);
  }
}

void Trial::expect_code(const Ended& ended, int code, const std::string& when, Figures& figures) {
  if (ended.code == code) return;
  figures.complaints.push_back(when + ": ended with " + std::to_string(ended.code) + ", not " +
                               std::to_string(code) + ": " + end_of(ended.errors));
}

void Trial::expect_artifacts(const fs::path& out, const std::string& when, Figures& figures) const {
  ++figures.studies;
  for (const std::string& difference : differences(undisturbed_, bytes_in(study_in(out))))
    figures.complaints.push_back(when + ": " + difference);
}

void Trial::expect_whole(const fs::path& out, const std::string& when, Figures& figures) const {
  expect_code(ended(run(out)), 0, when + ", the last run", figures);
  expect_artifacts(out, when, figures);
  for (const std::string& left : leftovers(study_in(out)))
    figures.complaints.push_back(when + ": " + left + " is left");
}

}  // namespace mien::test
