// Every page is checked: its links lead somewhere, its commands run, its manifests are accepted,
// the files that it names exist. Commands run in a folder as PageFolder makes it, and as
// made_cheap() has them; what cannot run there is named below, with the reason. Tutorials have a
// test of their own (tutorials_test.cpp).

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "end_to_end/page.h"
#include "end_to_end/page_folder.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const fs::path root = MIEN_SOURCE_DIR;

/// Beginning of a command, and why it is not run.
struct NotRun {
  std::string beginning;
  std::string reason;
};

const std::vector<NotRun> not_run = {
    {"./mien test", "the launcher's, not the program's: it would run this test again"},
    {"./mien package", "the launcher's: it builds"},
    {"./mien tarball", "the launcher's: it builds"},
    {"./mien docs", "the launcher's: it needs Sphinx"},
    {"./mien study export", "needs pages, which Node.js builds (questionnaire_page_test.cpp)"},
    {"./mien studio", "serves until it is told to end (studio_page_test.cpp)"},
    {"./mien study serve", "serves until it is told to end (serve_study_test.cpp)"},
    {"./mien farm submit", "needs Slurm"},
    {"./mien farm resume", "needs Slurm"},
    {"./mien farm cancel", "needs Slurm"},
    {"./mien farm logs study.yaml film:target-1", "needs a submission"},
    {"./mien farm status study.yaml --out /shared/studies --watch", "needs somebody who works"},
    {"./mien study design closed-loop-1 -o plans.csv --freeze", "needs the study to be made"},
    {"./mien regress study.yaml --baseline main", "needs a repository"},
    {"./mien study report", "needs answers that people gave"},
    {"./mien study withdraw", "needs answers that people gave (serve_study_test.cpp)"},
    {"./mien motion info people.glb", "needs a file of several motions (gltf_takes_test.cpp)"},
    {"./mien motion info trial.c3d", "needs a recording of markers (recorded_points_test.cpp)"},
    {"./mien motion info team.c3d", "needs a recording of several people (c3d_test.cpp)"},
    {"./mien motion info poses.npz", "needs a file without a frame rate (smpl_test.cpp)"},
    {"./mien motion info openpose-output", "needs OpenPose's frames (keypoint_frames_test.cpp)"},
    {"./mien motion info track.npy", "needs points without names (npy_positions_test.cpp)"},
    {"./mien motion compare dance.c3d", "needs a recording of several people (people_test.cpp)"},
    {"./mien motion compare walk.fbx#Slow", "needs a file of several motions (cli_test.cpp)"},
    {"./mien motion features *.fbx", "needs files of several motions (cli_test.cpp)"},
    {"./mien render two-people.bvh", "needs a recording of several people (people_test.cpp)"},
    {"./mien render anna.bvh", "needs recordings of one space (people_test.cpp)"},
    {"./mien render trial.c3d", "needs a recording of markers (recorded_points_test.cpp)"},
    {"./mien render character.fbx", "needs a file of several motions (fbx_test.cpp)"},
    {"./mien render walk.bvh --figure character.fbx", "needs a character (fbx_character_test.cpp)"},
    {"./mien render dance.vrma", "needs a character (vrm_character_test.cpp)"},
    {"./mien render walk.bvh --figure avatar.vrm", "needs a character (face_test.cpp)"},
    {"./mien render talk.bvh", "needs a character and a table of weights (face_test.cpp)"},
    {"./mien render walk.npz --body-model", "needs an SMPL model (smpl_model_test.cpp)"},
    {"./mien render walk.npz#markers", "needs markers of AMASS (smpl_test.cpp)"},
    {"./mien regress approved.mp4 now.mp4", "needs two videos"},
    {"./mien regress approved.png now.png", "needs two pictures"},
    {"./mien regress approved-frames/ now-frames/", "needs two folders of pictures"},
    {"cmake --preset", "builds"},
    {"ctest --preset", "needs another build"},
    {"mkdir corpus", "needs a build by clang"},
    {"build/release/tests/bench/", "needs a build with benchmarks"},
    {"tests/fresh/", "takes half an hour, root's rights and a network"},
    {"tests/bench/", "takes minutes, and a machine that does nothing else"},
    {"tests/peers/", "needs a build with benchmarks, and Blender or matplotlib"},
    {"./mien study predict --examples manifests/real-walks.yaml",
     "needs recordings that are no part of mien"},
    {"./mien study estimate --examples manifests/real-walks.yaml",
     "needs recordings that are no part of mien"},
};

bool is_run(const std::string& command) {
  return std::none_of(not_run.begin(), not_run.end(),
                      [&](const NotRun& one) { return command.starts_with(one.beginning); });
}

class Pages : public testing::TestWithParam<std::string> {
 protected:
  const Page page = read_page(GetParam());

  std::string at(int line) const { return page.name + ":" + std::to_string(line) + ": "; }
};

/// What is wrong with a link of a page; nothing if it leads somewhere.
std::string broken_link(const Page& page, const std::string& target) {
  if (target.find("://") != std::string::npos) return "";
  const std::size_t hash = std::min(target.find('#'), target.size());
  const fs::path file =
      hash == 0 ? root / page.name : (root / page.name).parent_path() / target.substr(0, hash);
  if (!fs::exists(file)) return "there is no " + file.lexically_normal().string();
  if (hash == target.size()) return "";
  const Page other = read_page(fs::relative(file, root).string());
  return other.anchors.contains(target.substr(hash + 1)) ? "" : "there is no such heading";
}

TEST_P(Pages, LinksLeadSomewhere) {
  for (const PageLink& link : page.links) {
    EXPECT_EQ(broken_link(page, link.target), "") << at(link.line) << link.target;
  }
}

TEST_P(Pages, FilesThatAreNamedExist) {
  const std::regex path(R"((manifests|motion|render|scenes|pipeline|tests)/[\w./-]+)");
  for (const std::string& code : page.code) {
    const bool exists = !std::regex_match(code, path) || fs::exists(root / code);
    EXPECT_TRUE(exists) << page.name << ": " << code;
  }
}

std::vector<PageCommand> run_commands(const Page& page) {
  std::vector<PageCommand> commands = commands_of(page);
  std::erase_if(commands, [](const PageCommand& command) { return !is_run(command.text); });
  return commands;
}

/// The file that a command names behind -o.
std::string output_of(const std::string& command) {
  std::smatch named;
  return std::regex_search(command, named, std::regex(R"( -o (\S+))")) ? named[1] : std::string();
}

TEST_P(Pages, CommandsRun) {
  const std::vector<PageCommand> commands = run_commands(page);
  if (commands.empty() || is_followed(page.name)) return;
  const PageFolder folder;
  for (const PageCommand& command : commands) {
    const std::string text = made_cheap(command.text);
    ASSERT_TRUE(text.find("./mien") != std::string::npos) << at(command.line) << "is not run";
    const Ended ended = folder.run(text);
    EXPECT_EQ(ended.code, command.code) << at(command.line) << text << "\n" << ended.errors;
    EXPECT_TRUE(fs::exists(folder.path() / output_of(text))) << at(command.line) << text;
  }
}

/// "my.scales.yaml" where a block begins with "# my.scales.yaml".
std::string file_name(const PageBlock& block) {
  std::smatch named;
  return std::regex_search(block.text, named, std::regex(R"(^# (\S+\.yaml)\n)")) ? named[1]
                                                                                 : std::string();
}

/// What the manifests of pages may name: files that are blocks themselves, or that commands make.
/// The answers are about the captures where a page has scales of its own, else about built-in
/// walks.
void write_named_files(const Page& page, const PageFolder& folder) {
  for (const PageBlock& block : page.blocks) {
    const std::string name = file_name(block);
    if (!name.empty()) folder.write(name, block.text);
  }
  for (const fs::path file : {"walking-words.scales.yaml", "five-factors.scales.yaml"}) {
    fs::copy_file(root / "manifests" / file, folder.path() / file);
  }
  folder.run(
      "./mien study analyze answers.csv --examples builtin:walks-27 -o analysis\n"
      "[ ! -e my.scales.yaml ] || ./mien study simulate --examples 'captures/*walk*.bvh' "
      "--scales my.scales.yaml -o answers.csv");
  const auto names_chains = [](const PageBlock& block) {
    return block.text.find("chains/words.ratings.csv") != std::string::npos;
  };
  if (std::ranges::any_of(page.blocks, names_chains))
    folder.run(
        "./mien study simulate gibbs-words -o steps.csv\n"
        "./mien study chains gibbs-words steps.csv -o chains");
}

/// Writes a block as a file that can be checked, and gives its name.
std::string written(const PageBlock& block, const PageFolder& folder) {
  if (!file_name(block).empty()) return file_name(block);
  const std::string name = "line-" + std::to_string(block.line) + ".yaml";
  folder.write(name, completed(block.text));
  return name;
}

TEST_P(Pages, ManifestsAreAccepted) {
  const std::vector<PageBlock> manifests = blocks_of(page, "yaml");
  if (manifests.empty()) return;
  const PageFolder folder;
  write_named_files(page, folder);
  std::string check = "./mien check";
  for (const PageBlock& block : manifests) check += " " + written(block, folder);
  const Ended ended = folder.run(check);
  EXPECT_EQ(ended.code, 0) << page.name << "\n" << ended.errors;
}

std::string name_of(const testing::TestParamInfo<std::string>& page) {
  return std::regex_replace(fs::path(page.param).replace_extension().string(), std::regex("\\W"),
                            "_");
}

INSTANTIATE_TEST_SUITE_P(, Pages, testing::ValuesIn(page_names()), name_of);

TEST(PagesTogether, HaveEveryCommandThatIsNotRun) {
  std::string all;
  for (const std::string& name : page_names()) {
    for (const PageCommand& command : commands_of(read_page(name))) all += "\n" + command.text;
  }
  for (const NotRun& one : not_run) {
    EXPECT_NE(all.find("\n" + one.beginning), std::string::npos) << one.beginning;
  }
}

const PageBlock& block_with(const Page& page, const std::string& beginning) {
  const auto found =
      std::find_if(page.blocks.begin(), page.blocks.end(),
                   [&](const PageBlock& block) { return block.text.starts_with(beginning); });
  if (found == page.blocks.end()) throw std::runtime_error("no block begins with " + beginning);
  return *found;
}

std::string without_comment_lines(const std::string& yaml) {
  return std::regex_replace(yaml, std::regex("(^|\n)(#[^\n]*\n)+"), "$1");
}

TEST(PageOfManifests, ShowsTheQuickstartAsItIs) {
  const Page page = read_page("manifests/README.md");
  EXPECT_EQ(block_with(page, "mien: 1").text,
            without_comment_lines(text_of(root / "manifests" / "quickstart.yaml")));
}

/// The quickstart with the two slips that the page speaks of.
std::string with_slips(std::string manifest) {
  manifest.replace(manifest.find("quickness"), 9, "quicknes");
  manifest.replace(manifest.find("guess-1", manifest.find("sheets:")), 7, "gues-1");
  return manifest;
}

TEST(PageOfManifests, PrintsFaultsAsTheProgramDoes) {
  const Page page = read_page("manifests/README.md");
  const std::string command = "./mien check study.yaml";
  const PageFolder folder;
  folder.write("study.yaml", with_slips(block_with(page, "mien: 1").text));
  const Ended ended = folder.run(command);
  EXPECT_EQ(ended.code, 2);
  EXPECT_EQ("$ " + command + "\n" + ended.errors, block_with(page, "$ " + command).text);
}

void add_keys(const json& schema, std::set<std::string>& keys) {
  if (schema.is_object() && schema.contains("properties")) {
    for (const auto& property : schema["properties"].items())
      if (!property.value().contains("x-now")) keys.insert(property.key());
  }
  for (const json& part : schema) {
    if (part.is_structured()) add_keys(part, keys);
  }
}

/// Words between backticks on the pages about manifests and looks.
std::set<std::string> explained_keys() {
  std::set<std::string> keys;
  for (const char* name : {"manifests/README.md", "scenes/README.md"}) {
    for (const std::string& code : read_page(name).code) {
      const std::regex word(R"([A-Za-z_][\w-]*)");
      for (std::sregex_iterator at(code.begin(), code.end(), word), end; at != end; ++at) {
        keys.insert(at->str());
      }
    }
  }
  return keys;
}

TEST(PageOfManifests, ExplainsEveryKey) {
  const std::set<std::string> explained = explained_keys();
  std::set<std::string> keys;
  for (const char* folder : {"manifests", "scenes"}) {
    for (const fs::directory_entry& file : fs::recursive_directory_iterator(root / folder)) {
      if (file.path().string().ends_with(".schema.json")) {
        add_keys(json::parse(std::ifstream(file.path())), keys);
      }
    }
  }
  EXPECT_GT(keys.size(), 150u);
  for (const std::string& key : keys) EXPECT_TRUE(explained.contains(key)) << key;
}

}  // namespace
}  // namespace mien::test
