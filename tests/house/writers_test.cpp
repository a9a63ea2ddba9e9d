#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace mien::test {
namespace {

namespace fs = std::filesystem;

/// Sources that open files for writing themselves, each for a reason: the writer of all results;
/// what other libraries write, into drafts and a store's attempts; what is appended to or taken by
/// one process alone; a stream of frames, into a draft; and a file whose time is that of a
/// file server.
const std::set<std::string> writers = {"motion/text/result_file.cpp",
                                       "render/image/png_file.cpp",
                                       "pipeline/tasks/claim.cpp",
                                       "pipeline/tasks/frame_store.cpp",
                                       "pipeline/farm/jobs/submission_journal.cpp",
                                       "pipeline/farm/jobs/worker_reports.cpp",
                                       "pipeline/study/studio/open_browser.cpp",
                                       "pipeline/commands/motion/live_stream.h"};

bool opens_for_writing(const std::string& text) {
  for (const char* words : {"std::ofstream", "O_CREAT", ", \"wb\")", ", \"w\")", ", \"ab\")"}) {
    if (text.find(words) != std::string::npos) return true;
  }
  return false;
}

/// Sources that put files in their places themselves: the writer of all results; records that do
/// not wait for the disk; and folders, which are put in their places whole.
const std::set<std::string> movers = {
    "motion/text/result_file.cpp", "pipeline/base/documents/files.cpp",
    "pipeline/tasks/store_state.cpp", "pipeline/tasks/frame_store.cpp",
    "pipeline/regression/approval.cpp"};

bool moves_files(const std::string& text) { return text.find("::rename(") != std::string::npos; }

std::set<std::string> sources_that(bool (*do_it)(const std::string& text)) {
  std::set<std::string> found;
  for (const char* module : {"motion", "render", "scenes", "pipeline"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(MIEN_SOURCE_DIR) / module)) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
      std::ifstream stream(entry.path());
      const std::string text{std::istreambuf_iterator<char>(stream), {}};
      if (do_it(text))
        found.insert(entry.path().lexically_relative(MIEN_SOURCE_DIR).generic_string());
    }
  }
  return found;
}

TEST(Writers, OfResultsAreOne) {
  EXPECT_EQ(sources_that(opens_for_writing), writers)
      << "results are written by motion/text/result_file.h";
}

TEST(Writers, PutResultsInTheirPlacesInOneWay) {
  EXPECT_EQ(sources_that(moves_files), movers)
      << "results are written by motion/text/result_file.h";
}

}  // namespace
}  // namespace mien::test
