// Tutorials, and the page of questions, are followed as readers follow them: their files are saved
// and their commands typed, in their order, in a folder that has nothing but mien; what they show
// of the output is compared.

#include <filesystem>
#include <iostream>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "end_to_end/page.h"
#include "end_to_end/page_folder.h"
#include "end_to_end/slurm_cluster.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> tutorials() {
  std::vector<std::string> names = page_names();
  std::erase_if(names, [](const std::string& name) { return !is_followed(name); });
  return names;
}

std::string with(const std::string& text, const std::string& pattern, const std::string& by) {
  return std::regex_replace(text, std::regex(pattern), by);
}

/// With 40 clips instead of 240, killed sooner, and a server that ends.
std::string made_short(const std::string& command) {
  std::string brief = with(command, "i < 240", "i < 40");
  brief = with(brief, "i / 239", "i / 39");
  brief = with(brief, "-s KILL 3", "-s KILL 0.4");
  return with(brief, R"((\./mien study serve .*))",
              "$1 --port 0 > served & until grep -q Ctrl-C served; do sleep 0.1; done; "
              "kill -TERM $!; wait $!");
}

class Tutorials : public testing::TestWithParam<std::string> {
 protected:
  const Page page = read_page(GetParam());
  const Scratch scratch;
  std::optional<SlurmCluster> cluster;

  void SetUp() override {
    fs::create_symlink(MIEN_PROGRAM, scratch.path() / "mien");
    if (!has("./mien farm submit") || !SlurmCluster::obstacle().empty()) return;
    cluster.emplace();
  }

  bool has(const std::string& beginning) const {
    for (const PageCommand& command : commands_of(page))
      if (command.text.starts_with(beginning)) return true;
    return false;
  }

  std::string at(int line) const { return page.name + ":" + std::to_string(line) + ": "; }

  /// Why a command cannot be run on this machine; empty if it can.
  std::string obstacle(const std::string& command) const {
    const bool needs_slurm =
        std::regex_search(command, std::regex("farm (submit|resume|logs|status .*--watch)"));
    if (needs_slurm && !cluster) return "Slurm cannot run here";
    const bool needs_pages = std::regex_search(command, std::regex("study (serve|export)"));
    const fs::path built = fs::path(MIEN_PROGRAM).parent_path() / "pages";
    if (needs_pages && !fs::exists(built / "questionnaire/questionnaire.js"))
      return "the pages are not built";
    return "";
  }

  void type(const PageCommand& command) {
    if (const std::string why = obstacle(command.text); !why.empty()) {
      std::cout << at(command.line) << "not run: " << why << "\n";
      return;
    }
    const Ended ended = run_in(scratch.path(), made_short(command.text));
    EXPECT_EQ(ended.code, command.code) << at(command.line) << command.text << "\n"
                                        << ended.output << ended.errors;
    std::smatch named;
    if (std::regex_search(command.text, named, std::regex(R"( -o (\S+))"))) {
      EXPECT_TRUE(fs::exists(scratch.path() / named[1].str())) << at(command.line) << named[1];
    }
  }

  /// Lines of a block "$ command", each of which must be part of the command's output.
  void compare(const PageBlock& block) {
    std::istringstream lines(block.text);
    std::string output;
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("$ ")) {
        const Ended ended = run_in(scratch.path(), line.substr(2));
        output = ended.output + ended.errors;
      } else {
        EXPECT_NE(output.find(line), std::string::npos) << at(block.line) << line << "\n" << output;
      }
    }
  }

  void follow(const PageBlock& block) {
    std::smatch named;
    if (block.language == "sh") {
      for (const PageCommand& command : commands_of(block)) type(command);
    } else if (block.text.starts_with("$ ")) {
      compare(block);
    } else if (std::regex_search(block.text, named, std::regex(R"(^# (\S+)\n)"))) {
      scratch.write(named[1], block.text);
    } else {
      ADD_FAILURE() << at(block.line) << "neither commands nor a file with a name";
    }
  }
};

/// Files that the text names: those that the commands have made.
std::vector<std::string> made_files(const Page& page) {
  std::vector<std::string> files = page.code;
  std::erase_if(files, [](const std::string& code) {
    return !std::regex_match(code, std::regex(R"((out|results|baselines)/\S+)"));
  });
  return files;
}

TEST_P(Tutorials, LeadWhereTheySay) {
  for (const PageBlock& block : page.blocks) {
    follow(block);
    if (HasFailure()) return;
  }
  for (const std::string& file : made_files(page))
    EXPECT_TRUE(fs::exists(scratch.path() / file)) << page.name << ": " << file;
}

std::string name_of_tutorial(const testing::TestParamInfo<std::string>& page) {
  return std::regex_replace(fs::path(page.param).stem().string(), std::regex("\\W"), "_");
}

INSTANTIATE_TEST_SUITE_P(, Tutorials, testing::ValuesIn(tutorials()), name_of_tutorial);

TEST(TutorialsTogether, AreThreeAndTheQuestions) { EXPECT_EQ(tutorials().size(), 4u); }

}  // namespace
}  // namespace mien::test
