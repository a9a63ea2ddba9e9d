#include <algorithm>
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

/// No artifact depends on them.
bool is_about_finished_studies(const std::string& source) {
  return source.starts_with("pipeline/production/archive/") ||
         source.starts_with("pipeline/commands/");
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

TEST(CodeIdentity, HoldsEverySourceOutsideTheCommandLine) {
  const test::TemporaryFolder folder;
  const auto hashed = hashed_sources(hashes_of(MIEN_SOURCE_DIR, folder.path()));
  for (const std::string& source : sources_of(MIEN_SOURCE_DIR)) {
    EXPECT_EQ(hashed.contains(source), !is_about_finished_studies(source)) << source;
  }
}

TEST(CodeIdentity, OfFilmsHoldsWhatPicturesAreMadeBy) {
  const test::TemporaryFolder folder;
  const auto hashed = hashed_sources(hashes_of(MIEN_SOURCE_DIR, folder.path()));
  for (const auto& [source, hashes] : hashed) {
    if (source.starts_with("pipeline/")) continue;
    EXPECT_TRUE(hashes.contains("film")) << source;
    EXPECT_EQ(hashes.contains("motion"), source.starts_with("motion/")) << source;
  }
}

/// Changes one source of every so many folders, the deepest always.
void expect_changes(int step) {
  const test::TemporaryFolder folder;
  const fs::path tree = folder.path() / "tree";
  fs::create_directory(tree);
  for (const std::string& module : modules)
    fs::copy(fs::path(MIEN_SOURCE_DIR) / module, tree / module, fs::copy_options::recursive);
  std::set<std::string> seen{text_of(hashes_of(tree, folder.path()))};
  std::set<fs::path> folders;
  for (const std::string& source : sources_of(tree)) {
    if (is_about_finished_studies(source) || !folders.insert(fs::path(source).parent_path()).second)
      continue;
    const bool is_deep = std::ranges::count(source, '/') > 2;
    if (!is_deep && static_cast<int>(folders.size()) % step != 0) continue;
    std::ofstream(tree / source, std::ios::app) << "// changed\n";
    EXPECT_TRUE(seen.insert(text_of(hashes_of(tree, folder.path()))).second) << source;
  }
}

TEST(CodeIdentity, ChangesWithADeepSource) { expect_changes(9); }

TEST(CodeIdentity, ChangesWithAnySourceHoweverDeepItLies) { expect_changes(1); }

}  // namespace
}  // namespace mien::pipeline
