#include "end_to_end/page_folder.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include <sys/wait.h>

#include "end_to_end/two_people.h"

namespace mien::test {

namespace {

namespace fs = std::filesystem;

constexpr const char* small_study = R"(mien: 1
study: quickstart
examples: {set: builtin:walks-10}
output: {size: [64, 48], fps: 10, cycles: 1, frames: none}
stimuli:
  - {id: target-1, role: target, weights: {normal: 1}}
  - {id: guess-1, weights: {sad: 1}}
)";

constexpr const char* sessions = R"(participant,target,interface,first_guess_d,time_s,success
p1,t1,adjectives,0.05,60,1
p1,t1,weights,0.09,140,1
p2,t1,adjectives,0.04,75,1
p2,t1,weights,0.11,300,0
p3,t1,adjectives,0.07,90,1
p3,t1,weights,0.08,120,1
)";

constexpr const char* word_rows = R"(participant,language,motion,verb,modifier1
p1,english,slow,walking,very slowly
p2,english,fast,walking,fast
p1,finnish,sad,kävelee,surullisesti
)";

/// A walk of the built-in set, and the files that it stands for.
struct Standing {
  std::string walk;
  std::vector<std::string> files;
};

const std::vector<Standing> motions = {
    {"normal",
     {"walk.bvh", "approved.bvh", "new.bvh", "target.bvh", "a.bvh", "walks/normal.bvh",
      "captures/walk.bvh", "captures/anna_walk_fast.bvh"}},
    {"sad",
     {"created.bvh", "b.bvh", "walks/proud.bvh", "captures/anna_walk_sad.bvh",
      "captures/anna_walk_slow.bvh"}},
};

void make(const std::vector<std::string>& arguments) {
  const Ended ended = run_mien(arguments);
  if (ended.code != 0) throw std::runtime_error(ended.errors);
}

std::string bvh_of(const std::string& walk) {
  const Scratch scratch;
  const std::string file = scratch.path() / "walk.bvh";
  make({"motion", "blend", "--examples", "builtin:walks-10", "--weights", walk + "=1", "--cycles",
        "3", "-o", file});
  return text_of(file);
}

/// A walk that leaps 5 m in one frame.
std::string broken(const std::string& bvh) {
  std::istringstream lines(bvh);
  std::string text;
  int frame = -1;
  for (std::string line; std::getline(lines, line);) {
    if (frame >= 0) ++frame;
    if (line.starts_with("Frame Time:")) frame = 0;
    text += (frame == 40 ? "5" + line.substr(line.find(' ')) : line) + "\n";
  }
  return text;
}

/// A WAV with two seconds of a tone.
std::string tone(double hertz) {
  constexpr int rate = 8'000;
  constexpr int count = 2 * rate;
  std::string bytes = "RIFF";
  const auto put = [&](int value, int size) {
    for (int i = 0; i < size; ++i)
      bytes += static_cast<char>(static_cast<unsigned>(value) >> (8 * i) & 0xffU);
  };
  put(36 + 2 * count, 4);
  bytes += "WAVEfmt ";
  for (const auto& [value, size] :
       {std::pair(16, 4), {1, 2}, {1, 2}, {rate, 4}, {2 * rate, 4}, {2, 2}, {16, 2}})
    put(value, size);
  bytes += "data";
  put(2 * count, 4);
  for (int i = 0; i < count; ++i)
    put(static_cast<int>(3000.0 * std::sin(6.283185307 * hertz * i / rate)), 2);
  return bytes;
}

std::string replaced(const std::string& text, const std::string& pattern, const std::string& by) {
  return std::regex_replace(text, std::regex(pattern), by);
}

}  // namespace

Ended run_in(const fs::path& folder, const std::string& command) {
  const Scratch said;
  const std::string output = said.path() / "output";
  const std::string errors = said.path() / "errors";
  const std::string script = "set -e\ncd '" + folder.string() + "'\n{\n" + command + "\n} >'" +
                             output + "' 2>'" + errors + "'";
  const int status = std::system(script.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 255, text_of(output), text_of(errors)};
}

PageFolder::PageFolder() {
  fs::create_symlink(MIEN_PROGRAM, path() / "mien");
  fs::create_directory_symlink(fs::path(MIEN_SOURCE_DIR) / "manifests", path() / "manifests");
  for (const Standing& motion : motions) {
    const std::string bvh = bvh_of(motion.walk);
    for (const std::string& file : motion.files) write(file, bvh);
  }
  make({"study", "simulate", "--examples", "builtin:walks-27", "-o", path() / "answers.csv"});
  write("captures/dance.bvh",
        two_people(text_of(path() / "walk.bvh"), text_of(path() / "created.bvh")).both);
  write("captures/one.wav", tone(440.0));
  write("captures/two.wav", tone(330.0));
  write("broken.bvh", broken(text_of(path() / "walk.bvh")));
  write("study.yaml", small_study);
  write("sessions.csv", sessions);
  write("words.csv", word_rows);
}

fs::path PageFolder::write(const std::string& name, const std::string& text) const {
  fs::create_directories((path() / name).parent_path());
  return scratch_.write(name, text);
}

std::string made_cheap(const std::string& command) {
  std::string cheap = replaced(command, R"(\./mien run (manifests|out)/)", "./mien plan $1/");
  cheap = replaced(cheap, R"( \| jq .*)", "");
  if (cheap.find("--crop") == std::string::npos) {
    cheap = replaced(cheap, R"( --size \S+)", "");
    cheap = replaced(cheap, R"(\./mien render)", "$& --size 160x120");
  }
  return replaced(cheap, R"(\./mien render)", "$& --quality draft --fps 5");
}

std::string completed(const std::string& yaml) {
  std::vector<std::string> parts = top_level_parts(yaml);
  const auto has = [&parts](const std::string& key) {
    return std::any_of(parts.begin(), parts.end(),
                       [&](const std::string& part) { return key_of(part) == key; });
  };
  if (has("mien")) return yaml;
  if (has("modify")) {
    return completed("stimuli:\n- id: page\n  weights: {normal: 1}\n  " + parts.front());
  }
  std::string text = "mien: 1\nstudy: page\n" + yaml;
  if (!has("examples")) text += "examples: {set: builtin:walks-10}\n";
  if (!has("stimuli")) {
    text += "stimuli: [{id: target-1, clip: walk.bvh}, {id: guess-1, clip: walk.bvh}]\n";
  }
  return text;
}

}  // namespace mien::test
