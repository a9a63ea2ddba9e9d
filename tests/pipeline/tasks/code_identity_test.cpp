#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

const fs::path script = MIEN_SOURCE_DIR "/pipeline/tasks/code_identity.cmake";
const std::string modules[] = {"motion", "render", "scenes", "pipeline"};

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

bool is_source(const fs::path& file) {
  return file.extension() == ".cpp" || file.extension() == ".h";
}

/// All C++ sources of the modules, relative to the tree.
std::set<std::string> sources_of(const fs::path& tree) {
  std::set<std::string> sources;
  for (const std::string& module : modules) {
    for (const auto& entry : fs::recursive_directory_iterator(tree / module)) {
      if (is_source(entry.path())) sources.insert(relative(entry.path(), tree).generic_string());
    }
  }
  return sources;
}

/// What the build works out for a tree: the header with the hashes, beside it the list of sources.
fs::path hashes_of(const fs::path& tree, const fs::path& folder) {
  const fs::path header = folder / "code_hashes.h";
  const std::string command = std::string(MIEN_CMAKE) + " -DSOURCE='" + tree.string() +
                              "' -DOUTPUT='" + header.string() + "' -P '" + script.string() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  return header;
}

/// Each source with the names of the hashes it is in.
std::map<std::string, std::set<std::string>> hashed_sources(const fs::path& header) {
  std::map<std::string, std::set<std::string>> hashed;
  std::ifstream listing(header.string() + ".sources");
  for (std::string name, source; listing >> name >> source;) hashed[source].insert(name);
  return hashed;
}

/// A house of the modules' folders in which a film includes the look of a motion, not its making.
class SmallProduction : public testing::Test {
 protected:
  void write(const std::string& file, const std::string& text) {
    fs::create_directories((tree() / file).parent_path());
    std::ofstream(tree() / file) << text;
  }

  void SetUp() override {
    const std::string production = "pipeline/production/";
    for (const char* root :
         {"synthesis/motion_task.cpp", "synthesis/durations_task.cpp", "film/film_task.cpp",
          "film/film_equalized.cpp", "film/film_dots.cpp", "film/film_tables.cpp",
          "sheets/sheet_task.cpp", "sheets/stills_task.cpp", "run/production.cpp"})
      write(production + root, "");
  }

  /// The names of the hashes that a source is in.
  std::set<std::string> hashes_with(const std::string& source) {
    return hashed_sources(hashes_of(tree(), folder_.path()))[source];
  }

  std::string hashes() { return text_of(hashes_of(tree(), folder_.path())); }

  fs::path tree() const { return folder_.path() / "tree"; }

 private:
  test::TemporaryFolder folder_;
};

using Names = std::set<std::string>;

TEST_F(SmallProduction, HashesWhatIsIncludedHoweverFar) {
  write("pipeline/production/film/film_dots.cpp", "#include \"render/a.h\"\n");
  write("render/a.h", "  #  include \"render/deep/b.h\"  // why\n");
  write("render/deep/b.h", "#include <vector>\n");
  write("render/deep/c.h", "");
  EXPECT_EQ(hashes_with("render/deep/b.h"), Names{"film"});
  EXPECT_EQ(hashes_with("render/deep/c.h"), Names{});
}

TEST_F(SmallProduction, TakesAHeaderForWhatDefinesIt) {
  write("pipeline/production/synthesis/motion_task.cpp", "#include \"motion/gait.h\"\n");
  write("motion/gait.h", "");
  write("motion/gait.cpp", "#include \"motion/gait.h\"\n#include \"motion/inside.h\"\n");
  write("motion/inside.h", "");
  write("motion/gait_on_ice.cpp", "#include \"motion/gait.h\"\n");
  write("motion/dance.h", "");
  write("motion/dance.cpp", "#include \"motion/gait.h\"\n");
  for (const char* source : {"motion/gait.cpp", "motion/inside.h", "motion/gait_on_ice.cpp"})
    EXPECT_EQ(hashes_with(source), Names{"motion"}) << source;
  EXPECT_EQ(hashes_with("motion/dance.cpp"), Names{}) << "it defines what dance.h declares";
}

TEST_F(SmallProduction, KeepsPicturesOutOfMotions) {
  write("pipeline/production/synthesis/motion_task.cpp", "#include \"render/a.h\"\n");
  write("pipeline/production/sheets/stills_task.cpp", "#include \"render/a.h\"\n");
  write("render/a.h", "");
  EXPECT_EQ(hashes_with("render/a.h"), Names{"sheet"});
}

TEST_F(SmallProduction, EndsWhereSourcesIncludeEachOther) {
  write("pipeline/production/film/film_task.cpp", "#include \"scenes/a.h\"\n");
  write("scenes/a.h", "#include \"scenes/b.h\"\n");
  write("scenes/b.h", "#include \"scenes/a.h\"\n");
  EXPECT_EQ(hashes_with("scenes/b.h"), Names{"film"});
}

TEST_F(SmallProduction, ChangesWithEachSourceThatItHoldsAndWithNoOther) {
  write("pipeline/production/film/film_dots.cpp", "#include \"render/a.h\"\n");
  write("render/a.h", "");
  write("render/a.cpp", "");
  write("pipeline/study/page.cpp", "");
  const std::string before = hashes();
  write("pipeline/study/page.cpp", "// changed\n");
  EXPECT_EQ(hashes(), before);
  write("render/a.cpp", "// changed\n");
  const std::string after = hashes();
  EXPECT_NE(after, before);
  write("render/a.h", "// changed\n");
  EXPECT_NE(hashes(), after);
}

TEST(CodeIdentity, OfAnArtifactIsOfNoCodeThatCannotMakeIt) {
  const test::TemporaryFolder folder;
  auto hashed = hashed_sources(hashes_of(MIEN_SOURCE_DIR, folder.path()));
  for (const auto& [source, names] : hashed) {
    for (const char* wing : {"farm", "regression", "study", "commands"})
      EXPECT_FALSE(source.starts_with(std::string("pipeline/") + wing + "/")) << source;
    EXPECT_FALSE(names.contains("film") && source.starts_with("motion/lint/")) << source;
    EXPECT_FALSE(names.contains("film") && source.starts_with("pipeline/production/synthesis/"));
    EXPECT_FALSE(names.contains("motion") && source.starts_with("render/")) << source;
  }
}

TEST(CodeIdentity, OfAnArtifactIsOfAllCodeThatMakesIt) {
  const test::TemporaryFolder folder;
  const auto hashed = hashed_sources(hashes_of(MIEN_SOURCE_DIR, folder.path()));
  const auto expect_in = [&](const std::string& name, const std::string& folders) {
    int sources = 0;
    for (const std::string& source : sources_of(MIEN_SOURCE_DIR)) {
      if (!source.starts_with(folders) || source.ends_with(".h")) continue;
      ++sources;
      const auto found = hashed.find(source);
      EXPECT_TRUE(found != hashed.end() && found->second.contains(name)) << name << ": " << source;
    }
    EXPECT_GT(sources, 0) << folders;
  };
  for (const char* room :
       {"gait", "interpolation", "lint", "modify", "motion_graph", "procedural", "style_transfer"})
    expect_in("motion", std::string("motion/") + room + "/");
  for (const char* room : {"geometry", "light", "tracer"})
    expect_in("film", std::string("render/") + room + "/");
  for (const char* room : {"cameras", "point_light", "stage"})
    expect_in("film", std::string("scenes/") + room + "/");
  expect_in("motion", "pipeline/production/synthesis/motions");
  expect_in("film", "pipeline/production/film/film");
  expect_in("sheet", "pipeline/production/sheets/");
  for (const char* room : {"methods", "report"})
    expect_in("study", std::string("pipeline/production/") + room + "/");
}

}  // namespace
}  // namespace mien::pipeline
