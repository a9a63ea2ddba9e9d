#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>

#include "end_to_end/program.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;

using nlohmann::json;

const fs::path source = MIEN_SOURCE_DIR;

/// What a script for bash says on both streams, and its exit code.
Ended run_bash(const std::string& script) {
  const Scratch scratch;
  const std::string command = "bash " + scratch.write("script", script).string() + " 2>&1";
  Ended ended;
  FILE* pipe = popen(command.c_str(), "r");
  for (int c = fgetc(pipe); c != EOF; c = fgetc(pipe)) ended.output += static_cast<char>(c);
  ended.code = WEXITSTATUS(pclose(pipe));
  return ended;
}

bool is_there(const std::string& program) { return run_bash("command -v " + program).code == 0; }

TEST(Manifests, AreListedWithWhatTheyAreAbout) {
  const Ended ended = run_mien({"manifests"});
  EXPECT_EQ(ended.code, 0) << ended.errors;
  EXPECT_NE(ended.output.find("quickstart       Three synthetic walks"), std::string::npos)
      << ended.output;
  EXPECT_EQ(ended.output.find("scales"), std::string::npos);
}

TEST(Manifests, ArePrintedWithASchemaThatEditorsFind) {
  const Ended ended = run_mien({"manifests", "quickstart"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_EQ(ended.errors, "");
  const std::string text = text_of(source / "manifests/quickstart.yaml");
  EXPECT_EQ(ended.output.substr(ended.output.find('\n')), text.substr(text.find('\n')));
  const std::size_t start = ended.output.find("$schema=") + 8;
  const fs::path schema = ended.output.substr(start, ended.output.find('\n') - start);
  EXPECT_TRUE(schema.is_absolute() && fs::exists(schema)) << schema;
}

TEST(Manifests, SayWhatHasToLieBesideThem) {
  EXPECT_EQ(run_mien({"manifests", "real-walks"}).errors,
            "it names a file that must be beside it: mien manifests five-factors.scales.yaml > "
            "five-factors.scales.yaml\n");
}

TEST(Manifests, AreUsedByNameFromAnyFolder) {
  const Scratch scratch;
  const std::string there = "cd " + scratch.path().string() + "\n" MIEN_PROGRAM;
  const std::string told = "using " + (source / "manifests/quickstart.yaml").string() + "\n";
  for (const char* name : {"quickstart", "quickstart.yaml", "manifests/quickstart.yaml"}) {
    const Ended plan = run_bash(there + " plan " + name);
    EXPECT_EQ(plan.code, 0);
    EXPECT_EQ(plan.output.substr(0, told.size()), told) << plan.output;
  }
  scratch.write("quickstart.yaml", "mien: 1\n");
  EXPECT_EQ(run_bash(there + " plan quickstart.yaml").code, 2) << "one's own comes first";
  EXPECT_EQ(run_bash(there + " check gallery").code, 0);
}

TEST(Manifests, ThatAreMisspeltAreGuessed) {
  for (const char* command : {"run", "plan", "manifests"}) {
    const Ended ended = run_mien({command, "quikstart"});
    EXPECT_EQ(ended.code, 2);
    EXPECT_NE(ended.errors.find("; did you mean \"quickstart\"?\n"), std::string::npos)
        << ended.errors;
  }
}

TEST(Manifests, GoWithTheProgramWhenItsPrefixIsMoved) {
  const Scratch scratch;
  const fs::path manifests = scratch.path() / "prefix/share/mien/manifests";
  fs::create_directories(scratch.path() / "prefix/bin");
  fs::create_directories(manifests);
  fs::copy_file(MIEN_PROGRAM, scratch.path() / "prefix/bin/mien");
  fs::copy_file(source / "manifests/mien.schema.json", manifests / "mien.schema.json");
  fs::copy_file(source / "manifests/quickstart.yaml", manifests / "mine.yaml");
  fs::rename(scratch.path() / "prefix", scratch.path() / "moved");
  const Ended ended = run_bash("cd " + scratch.path().string() + "\nmoved/bin/mien check mine");
  EXPECT_EQ(ended.code, 0);
  const std::string file = scratch.path() / "moved/share/mien/manifests/mine.yaml";
  EXPECT_TRUE(ended.output.starts_with("using " + file + "\n" + file + ": no faults\n"))
      << ended.output;
  EXPECT_NE(ended.output.find("target-1  quickness "), std::string::npos) << ended.output;
}

TEST(Program, SaysWhichOfItsPartsIsNotThere) {
  const Scratch scratch;
  fs::create_directories(scratch.path() / "bin");
  fs::copy_file(MIEN_PROGRAM, scratch.path() / "bin/mien");
  const std::string there = "cd " + scratch.path().string() + "\n";
  const auto expect_told = [](const Ended& ended, const std::string& part) {
    EXPECT_EQ(ended.code, 1);
    EXPECT_TRUE(ended.output.starts_with("mien ")) << ended.output;
    EXPECT_NE(ended.output.find(part), std::string::npos) << ended.output;
    EXPECT_NE(ended.output.find("; install or build mien again\n"), std::string::npos)
        << ended.output;
  };
  expect_told(
      run_bash(there +
               "bin/mien version\n"
               "bin/mien motion blend --examples builtin:walks-10 --weights sad=1 -o a.bvh\n"
               "bin/mien render a.bvh --size 64x36 --quality draft -o a.mp4"),
      "mien-video-files.so: the part of mien that reads and writes videos");
  EXPECT_FALSE(fs::exists(scratch.path() / "a.mp4"));
  const auto bring = [&](const fs::path& part) {
    fs::copy_file(fs::path(MIEN_PROGRAM).parent_path() / part, scratch.path() / "bin" / part);
  };
  bring("mien-video-files.so");
  const std::string study =
      "mien: 1\nstudy: a\n"
      "examples: {set: builtin:walks-10}\n"
      "stimuli: [{id: a, weights: {sad: 1}}, {id: b, weights: {happy: 1}}]\n";
  std::ofstream(scratch.path() / "sheet.yaml")
      << study << "output: {size: [64, 36], quality: draft}\n"
      << "sheets: [{compare: {target: a, created: b}}]\n";
  expect_told(run_bash(there + "bin/mien version && bin/mien run sheet.yaml"),
              "mien-pages.so: the part of mien that draws sheets and charts");
  bring("mien-pages.so");
  std::ofstream(scratch.path() / "a.yaml")
      << study << "output: {size: [64, 36], quality: draft, frames: exr}\n";
  expect_told(run_bash(there + "bin/mien version && bin/mien run a.yaml"),
              "mien-image-files.so: the part of mien that reads and writes pictures");
}

TEST(Program, LoadsNoLibraryThatDrawsBeforeItDrawsSomething) {
  const Scratch scratch;
  const std::string folder = scratch.path().string();
  const Ended ended = run_bash(
      "cd " + folder + "\ncp " MIEN_PROGRAM " " + (source / "manifests/quickstart.yaml").string() +
      " . && ./mien motion blend --examples builtin:walks-10 " +
      "--weights sad=1 -o a.bvh >&2 && export LD_DEBUG=files && ./mien version && " +
      "./mien check quickstart.yaml && ./mien plan quickstart.yaml && ./mien motion info a.bvh");
  EXPECT_EQ(ended.code, 0);
  EXPECT_NE(ended.output.find("calling init: "), std::string::npos);
  for (const char* library :
       {"libavcodec", "libswscale", "libOpenImageIO", "libcairo", "libpango-1.0", "libsqlite3"})
    EXPECT_EQ(ended.output.find(std::string("/") + library + ".so."), std::string::npos) << library;
}

TEST(Program, FindsItsPartsInAnInstallationThatIsMoved) {
  const Scratch scratch;
  const fs::path prefix = scratch.path() / "prefix";
  const fs::path parts = prefix / MIEN_PARTS_FOLDER;
  fs::create_directories(prefix / "bin");
  fs::create_directories(parts);
  fs::copy_file(MIEN_PROGRAM, prefix / "bin/mien");
  for (const char* part : {"mien-image-files.so", "mien-pages.so", "mien-video-files.so"})
    fs::copy_file(fs::path(MIEN_PROGRAM).parent_path() / part, parts / part);
  fs::rename(prefix, scratch.path() / "moved");
  // By another name and from elsewhere: where it is comes from the program itself.
  const Ended ended =
      run_bash("cd " + scratch.path().string() +
               "\nln -s moved/bin/mien another\n"
               "./another motion blend --examples builtin:walks-10 --weights sad=1 -o a.bvh\n"
               "./another render a.bvh --still --size 64x36 --quality draft -o a.png &&"
               "./another render a.bvh --size 64x36 --quality draft -o a.mp4");
  EXPECT_EQ(ended.code, 0) << ended.output;
  EXPECT_TRUE(fs::exists(scratch.path() / "a.png"));
  EXPECT_TRUE(fs::exists(scratch.path() / "a.mp4"));
}

/// The words that stand at the start of a help's lines between two headings, or its end.
std::vector<std::string> words_below(const std::string& help, const std::string& heading) {
  std::vector<std::string> words;
  std::istringstream lines(help.substr(std::min(help.find("\n" + heading + ":\n"), help.size())));
  std::string line;
  std::getline(lines, line);
  std::getline(lines, line);
  const std::regex entry("  ([^ ]+).*");
  std::smatch match;
  while (std::getline(lines, line) && !line.empty()) {
    if (std::regex_match(line, match, entry)) words.push_back(match[1]);
  }
  return words;
}

/// The page as it is read: roff's escapes of hyphens and fonts resolved.
std::string without_roff(const std::string& page) {
  return std::regex_replace(std::regex_replace(page, std::regex(R"(\\f[BIR])"), ""),
                            std::regex(R"(\\-)"), "-");
}

/// The lines of a page below one of its headings, to the next.
std::string section(const std::string& page, const std::string& heading) {
  const std::size_t start = page.find(heading + "\n");
  if (start == std::string::npos) return "";
  return page.substr(start, page.find("\n.S", start + 1) - start);
}

void expect_told(const std::string& page, const std::vector<std::string>& command) {
  std::vector<std::string> words = command;
  words.emplace_back("--help");
  const std::string help = run_mien(words).output;
  std::string name = "mien";
  for (const std::string& word : command) name += " " + word;
  const std::string own = section(page, command.empty() ? ".SH OPTIONS" : ".SS " + name);
  EXPECT_NE(own, "") << name;
  const std::vector<std::string> options = words_below(help, "Options");
  EXPECT_FALSE(options.empty()) << help;
  for (const std::string& names : options) {
    std::istringstream each(names);
    for (std::string option; std::getline(each, option, ',');) {
      if (option == "-h" || option == "--help") continue;
      const std::regex told("\n.TP\n(-., )?" + option + "(?![a-z-])");
      EXPECT_EQ(std::distance(std::sregex_iterator(own.begin(), own.end(), told), {}), 1)
          << name << " " << option;
    }
  }
  for (const std::string& argument : words_below(help, "Positionals")) {
    EXPECT_NE(own.find("\n.TP\n" + argument), std::string::npos) << name << " " << argument;
  }
  for (const std::string& below : words_below(help, "Subcommands")) {
    std::vector<std::string> deeper = command;
    deeper.push_back(below);
    expect_told(page, deeper);
  }
}

/// The programs that make up mien.
std::vector<std::string> programs() {
  return {MIEN_PROGRAM, MIEN_PROGRAM "-regress", MIEN_PROGRAM "-study"};
}

/// Whether `mien` only knows of it that another program has it.
bool is_elsewhere(const json& command) {
  return command["options"].empty() && command["commands"].empty() && command["notes"] == "";
}

void expect_explained(const json& command, const std::string& above) {
  const std::string name = above + command["name"].get<std::string>();
  EXPECT_NE(command["summary"], "") << name;
  const bool explains_itself = !command["commands"].empty() || command["name"] == "version";
  EXPECT_TRUE(explains_itself ||
              command["notes"].get<std::string>().find("mien ") != std::string::npos)
      << name;
  std::set<std::string> names;
  for (const json& option : command["options"]) {
    EXPECT_NE(option["help"], "") << name << " " << option;
    for (const json& each : option["names"]) EXPECT_TRUE(names.insert(each).second) << name << each;
  }
  for (const json& below : command["commands"]) expect_explained(below, name + " ");
}

TEST(Commands, SayWhatTheyAreAndShowAnExample) {
  for (const std::string& program : programs()) {
    const json told = json::parse(run_program({program, "--commands"}).output)["program"];
    for (const json& command : told["commands"]) {
      if (program != MIEN_PROGRAM || !is_elsewhere(command)) expect_explained(command, "mien ");
    }
  }
}

TEST(Commands, OfAnotherProgramThatIsNotThereSayHowToGetIt) {
  const Scratch scratch;
  fs::copy_file(MIEN_PROGRAM, scratch.path() / "mien");
  for (const std::string words : {"study analyze a.csv", "help studio", "regress --help"}) {
    const Ended ended = run_bash((scratch.path() / "mien").string() + " " + words);
    EXPECT_EQ(ended.code, 1) << words;
    EXPECT_NE(ended.output.find(" was not found; it is part of the mien package, and ./mien "),
              std::string::npos)
        << ended.output;
  }
  const Ended man = run_bash((scratch.path() / "mien").string() + " man");
  EXPECT_EQ(man.code, 1);
  EXPECT_NE(man.output.find("mien-regress: the program for mien regress was not found"),
            std::string::npos)
      << man.output;
}

// As in the archive for other systems. Where the fonts that come with the program are none, sheets
// cannot be drawn, so that it is seen that they are used.
TEST(InstalledFonts, AreUsedUnlessOthersAreNamed) {
  const Scratch scratch;
  const fs::path bin = scratch.path() / "bin", fonts = scratch.path() / "share/mien/fonts";
  fs::create_directories(bin);
  fs::create_directories(fonts / "none");
  for (const auto& entry : fs::directory_iterator(fs::path(MIEN_PROGRAM).parent_path()))
    if (entry.path().filename() == "mien" || entry.path().extension() == ".so")
      fs::copy_file(entry.path(), bin / entry.path().filename());
  std::ofstream(fonts / "fonts.conf") << "<fontconfig><dir prefix=\"relative\">none</dir>"
                                         "<cachedir prefix=\"xdg\">fontconfig</cachedir>"
                                         "</fontconfig>\n";
  const std::string manifest = scratch
                                   .write("tiny.yaml", R"(mien: 1
study: tiny
examples: {set: builtin:walks-10}
output: {size: [48, 36], fps: 8, cycles: 1, quality: draft, frames: none, video: []}
stimuli: [{id: a, weights: {normal: 1}}, {id: b, weights: {sad: 1}}]
sheets: [{compare: {target: a, created: b}}]
)")
                                   .string();
  const std::string run =
      (bin / "mien").string() + " run " + manifest + " --out " + (scratch.path() / "out").string();
  const Ended without = run_bash("unset FONTCONFIG_FILE; " + run);
  EXPECT_NE(without.code, 0);
  EXPECT_NE(without.output.find("no font on this machine has Japanese characters"),
            std::string::npos)
      << without.output;
  const Ended named = run_bash("export FONTCONFIG_FILE=/etc/fonts/fonts.conf; " + run);
  EXPECT_EQ(named.code, 0) << named.output;
}

TEST(Commands, OfAProgramOfAnotherVersionAreRefused) {
  const Ended ended = run_bash("MIEN_STARTED_BY=0.0.9 " MIEN_PROGRAM "-study study scales");
  EXPECT_EQ(ended.code, 1);
  EXPECT_TRUE(std::regex_match(
      ended.output,
      std::regex("mien: this program has version [0-9.]+, but mien, which started it, "
                 "has 0.0.9; install or build both\n")))
      << ended.output;
}

TEST(Commands, OfOtherProgramsAreGuessedAndEndAsTheyDo) {
  EXPECT_EQ(run_mien({"studdy"}).errors, "unknown command \"studdy\"; did you mean \"study\"?\n");
  EXPECT_EQ(run_mien({"study", "analyse"}).errors,
            "unknown command \"analyse\"; did you mean \"analyze\"?\n");
  // A command that is another's, from whichever program.
  for (const auto& [words, meant] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"export", "emotion-study"}, "mien study export, or mien farm export"},
           {{"serve", "emotion-study"}, "mien study serve"},
           {{"info", "walk.bvh"}, "mien motion info"},
           {{"approve"}, "mien regress approve"},
           {{"study", "check", "my.yaml"}, "mien check"},
           {{"study", "studio"}, "mien studio"},
           {{"motion", "render", "walk.bvh"}, "mien render"}}) {
    const Ended other = run_mien(words);
    EXPECT_EQ(other.code, 2);
    EXPECT_TRUE(other.errors.ends_with("\"; did you mean " + meant + "?\n")) << other.errors;
  }
  const Ended missing = run_mien({"study", "words"});
  EXPECT_EQ(missing.code, 2);
  EXPECT_TRUE(missing.errors.starts_with("mien study words: words and --lexicon and --output "))
      << missing.errors;
  EXPECT_EQ(run_mien({"help", "study", "words"}).output,
            run_mien({"study", "words", "--help"}).output);
  EXPECT_EQ(run_bash("echo walk | " MIEN_PROGRAM " study scales | head -n 0").code, 0);
}

TEST(ManualPage, TellsEveryCommandOptionAndArgumentOfHelp) {
  const Ended ended = run_mien({"man"});
  ASSERT_EQ(ended.code, 0);
  EXPECT_GE(words_below(run_mien({"--help"}).output, "Subcommands").size(), 10u);
  expect_told(without_roff(ended.output), {});
}

TEST(ManualPage, IsOfThisVersionWhichTheChangelogBeginsWith) {
  const std::string changelog = text_of(source / "CHANGELOG.md");
  std::smatch top;
  ASSERT_TRUE(std::regex_search(
      changelog, top, std::regex(R"(\n## \[([0-9.]+)\] - ([0-9]{4}-[0-9]{2}-[0-9]{2})\n)")));
  EXPECT_EQ(run_mien({"--version"}).output, "mien " + top[1].str() + "\n");
  EXPECT_TRUE(run_mien({"man"}).output.starts_with(".TH MIEN 1 " + top[2].str() + " \"mien " +
                                                   top[1].str() + "\" \"User Commands\"\n"));
}

TEST(ManualPage, IsPlainTextThatGroffAndMandocTake) {
  const std::string page = run_mien({"man"}).output;
  for (const char c : page) ASSERT_LT(static_cast<unsigned char>(c), 0x80);
  const Scratch scratch;
  const std::string file = scratch.write("mien.1", page);
  if (!is_there("groff") && !is_there("mandoc")) GTEST_SKIP() << "neither groff nor mandoc here";
  for (const char* checker : {"groff -ww -z -man ", "mandoc -T lint -W warning "}) {
    const std::string program(checker, std::string_view(checker).find(' '));
    if (is_there(program)) {
      EXPECT_EQ(run_bash(checker + file).output, "") << program;
    }
  }
}

/// What bash offers for the last of the words, a line each.
std::string completions_of(const std::string& words) {
  const fs::path folder = fs::path(MIEN_PROGRAM).parent_path();
  return run_bash("PATH=" + folder.string() +
                  ":$PATH\nsource <(mien completion bash)\nCOMP_WORDS=(" + words +
                  ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_mien\n" +
                  "[[ ${#COMPREPLY[@]} -eq 0 ]] || printf '%s\\n' \"${COMPREPLY[@]}\"\n")
      .output;
}

TEST(BashCompletion, CompletesCommands) {
  EXPECT_EQ(completions_of("mien ru"), "run\n");
  EXPECT_EQ(completions_of("mien study an"), "analyze\n");
  EXPECT_EQ(completions_of("mien help study an"), "analyze\n");
  EXPECT_EQ(completions_of("mien motion zzz"), "");
}

TEST(BashCompletion, CompletesOptionsAndTheirChoices) {
  EXPECT_EQ(completions_of("mien run --qual"), "--quality\n");
  EXPECT_EQ(completions_of("mien run x.yaml --quality ''"), "draft\nstandard\nfinal\nreference\n");
  EXPECT_EQ(completions_of("mien run --quality = f"), "final\n");
  EXPECT_EQ(completions_of("mien run --quality ="), "draft\nstandard\nfinal\nreference\n");
  EXPECT_EQ(completions_of("mien study analyze --repeated l"), "last\n");
  EXPECT_EQ(completions_of("mien completion z"), "zsh\n");
  EXPECT_EQ(completions_of("mien run --jobs ''"), "");
}

TEST(BashCompletion, CompletesManifestsSetsAndFiles) {
  EXPECT_EQ(completions_of("mien run quick"), "quickstart\n");
  EXPECT_EQ(completions_of("mien sets tread"), "treadmill\n");
  const Scratch scratch;
  const std::string file = scratch.write("a walk.bvh", "");
  EXPECT_EQ(completions_of("mien render '" + (scratch.path() / "a w").string() + "'"), file + "\n");
  EXPECT_EQ(completions_of("mien run -o '" + (scratch.path() / "a w").string() + "'"), file + "\n");
}

TEST(ZshCompletion, IsAScript) {
  if (!is_there("zsh")) GTEST_SKIP() << "no zsh here";
  const Scratch scratch;
  const std::string file = scratch.write("_mien", run_mien({"completion", "zsh"}).output);
  EXPECT_EQ(run_bash("zsh -n " + file).output, "");
}

TEST(Completion, RefusesOtherShells) {
  const Ended ended = run_mien({"completion", "fish"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_NE(ended.errors.find("bash"), std::string::npos) << ended.errors;
}

}  // namespace
}  // namespace mien::test
