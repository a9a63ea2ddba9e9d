#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "end_to_end/program.h"
#include "real_data.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* small_manifest = R"(mien: 1
study: small
examples: {set: builtin:walks-10}
output: {size: [64, 48], fps: 10, cycles: 1, quality: draft, frames: none, video: [], clips: [bvh]}
stimuli:
  - {id: a, weights: {normal: 1}}
  - {id: b, weights: {sad: 1}}
)";

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(CommandLine, HelpsWithEveryCommand) {
  const Ended help = run_mien({"--help"});
  EXPECT_EQ(help.code, 0);
  EXPECT_EQ(help.errors, "");
  for (const char* command :
       {"run", "check", "plan", "render", "regress", "motion", "study", "version"}) {
    EXPECT_TRUE(contains(help.output, std::string("\n  ") + command)) << command;
    const Ended own = run_mien({command, "--help"});
    EXPECT_EQ(own.code, 0) << command;
    EXPECT_TRUE(contains(own.output, "Usage: ")) << own.output;
  }
  EXPECT_TRUE(contains(run_mien({"run", "--help"}).output, "Examples:"));
}

TEST(CommandLine, RefusesWhatItDoesNotKnow) {
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{},
                                             {"walk"},
                                             {"run"},
                                             {"run", "a.yaml", "--quality", "superb"},
                                             {"run", "a.yaml", "--jobs", "0"},
                                             {"motion"},
                                             {"motion", "info"},
                                             {"check", "--nonsense", "a.yaml"}}) {
    const Ended ended = run_mien(arguments);
    EXPECT_EQ(ended.code, 2) << ended.errors;
    EXPECT_EQ(ended.output, "");
    EXPECT_NE(ended.errors, "");
  }
}

/// What a command line is refused with.
std::string refusal(const std::vector<std::string>& arguments) {
  const Ended ended = run_mien(arguments);
  EXPECT_EQ(ended.code, 2) << ended.errors;
  EXPECT_EQ(ended.output, "");
  EXPECT_EQ(std::count(ended.errors.begin(), ended.errors.end(), '\n'), 1) << ended.errors;
  return ended.errors;
}

TEST(CommandLine, TellsInOneLineWhatIsMissing) {
  EXPECT_EQ(refusal({"run"}),
            "mien run: manifest is missing; write mien run <manifest>; see mien run --help\n");
  EXPECT_EQ(refusal({"study", "export"}),
            "mien study export: manifest and --folder are missing; write mien study export "
            "<manifest> --folder …; see mien study export --help\n");
  EXPECT_TRUE(
      contains(refusal({"regress", "approve", "study.yaml"}), "--reason is missing; write"));
  EXPECT_TRUE(contains(refusal({"regress"}), "mien regress: nothing to compare was given; "));
  EXPECT_TRUE(contains(refusal({"study"}), "mien study: a command is missing; it is one of "));
  EXPECT_TRUE(contains(refusal({"run", "a.yaml", "--jobs"}), "--jobs: value missing"));
}

TEST(CommandLine, TellsInOneLineWhichOptionWasMeant) {
  EXPECT_EQ(refusal({"run", "a.yaml", "--qualty", "draft"}),
            "mien run: unknown option --qualty; did you mean --quality? see mien run --help\n");
  // Whatever else is wrong: its value has taken the manifest's place.
  EXPECT_TRUE(contains(refusal({"run", "--qualty=draft"}), "did you mean --quality?"));
  EXPECT_TRUE(contains(refusal({"check", "--nonsense", "a.yaml"}),
                       "mien check: unknown option --nonsense; see mien check --help"));
  EXPECT_TRUE(contains(refusal({"run", "a.yaml", "b.yaml"}), "unexpected argument \"b.yaml\""));
  EXPECT_TRUE(contains(refusal({"run", "a.yaml", "--jobs", "0"}), "mien run: --jobs: "));
}

TEST(CommandLine, NamesTheWordsThatAnOptionTakes) {
  const auto told = [](const std::vector<std::string>& choice) {
    std::vector<std::string> arguments = {"study", "targets", "--examples", "builtin:walks-10"};
    arguments.insert(arguments.end(), choice.begin(), choice.end());
    const Ended ended = run_mien(arguments);
    EXPECT_EQ(ended.code, 2);
    return ended.errors;
  };
  EXPECT_NE(
      told({"--spread", "sideways"}).find("\"sideways\" is not one of everything, parameters"),
      std::string::npos)
      << told({"--spread", "sideways"});
  EXPECT_NE(told({"--unreachable", "rejct"}).find("did you mean \"reject\"?"), std::string::npos)
      << told({"--unreachable", "rejct"});
}

TEST(CommandLine, CheckComparesFilmsWithTheLeadOfContinuousTrials) {
  const Scratch scratch;
  const fs::path file = scratch.write("short.yaml", R"(mien: 1
study: short
output: {video: [mp4]}
questionnaire: {participants: 2, scales: [sad-happy], trials: continuous, continuous: {lead: 20}}
stimuli:
  - {id: a, path: [{walk: 2}, {stand: 1}]}
)");
  const Ended ended = run_mien({"check", file.string()});
  EXPECT_EQ(ended.code, 2);
  EXPECT_TRUE(contains(ended.errors, ":6:5: ")) << ended.errors;
  EXPECT_TRUE(contains(ended.errors, "is over before the lead of 20 s")) << ended.errors;
}

TEST(CommandLine, CheckTellsEveryFaultAndWritesNothing) {
  const Scratch scratch;
  const fs::path bad = scratch.write("bad.yaml", R"(mien: 1
study: bad
examples: {set: builtin:walks-10}
stimuli:
  - {id: a, adjectives: {quicknes: 0.5}}
  - {id: b, weights: {nomal: 1}, look: {camera: top}}
)");
  const Ended ended = run_mien({"check", bad.string()});
  EXPECT_EQ(ended.code, 2);
  EXPECT_EQ(ended.output, "");
  const std::string at = bad.string();
  EXPECT_EQ(
      ended.errors,
      at +
          ":5:26: stimuli[0].adjectives.quicknes: unknown parameter; did you mean "
          "\"quickness\"?\n" +
          at + ":6:23: stimuli[1].weights.nomal: unknown example; did you mean \"normal\"?\n" + at +
          ":6:49: stimuli[1].look.camera: \"top\" is not one of the choices; use one of "
          "front, side, three-quarter, follow, orbit, or a map of keys and values\n");
  EXPECT_EQ(run_mien({"run", bad.string(), "--out", (scratch.path() / "out").string()}).code, 2);
  EXPECT_EQ(run_mien({"plan", bad.string(), "--out", (scratch.path() / "out").string()}).code, 2);
  EXPECT_FALSE(fs::exists(scratch.path() / "out"));
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch.path()), {}), 1);
}

TEST(CommandLine, CheckTellsFaultsOfTheFilesThatAManifestNames) {
  const Scratch scratch;
  scratch.write("bad.scales.yaml", "scales: {zeal: {low: idle}}\n");
  const std::string text =
      "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10, ratings: simulated, scales: "
      "bad.scales.yaml}\nstimuli: [{id: a, adjectives: {zeal: 1}}]\n";
  const Ended scales = run_mien({"check", scratch.write("m.yaml", text).string()});
  EXPECT_EQ(scales.code, 2);
  EXPECT_EQ(scales.errors, (scratch.path() / "bad.scales.yaml").string() +
                               ":1:16: scales.zeal.high: missing; add it, for example high: "
                               "extraverted\n");
  const Ended once =
      run_mien({"check", scratch
                             .write("n.yaml",
                                    "mien: 1\nstudy: s\nexamples: {set: builtin:walks-11}\n"
                                    "stimuli: [{id: a, weights: {normal: 1}}]\n")
                             .string()});
  EXPECT_EQ(once.errors, (scratch.path() / "n.yaml").string() +
                             ":3:17: examples.set: \"builtin:walks-11\" is not one of "
                             "builtin:walks-10, builtin:walks-27, builtin:actors; did you mean "
                             "\"builtin:walks-10\"?\n");
}

TEST(CommandLine, CheckTellsWhatIsWrongWithAPath) {
  const Scratch scratch;
  for (const auto& [path, said] :
       {std::pair("https://example.org/walk.bvh", "files are not fetched from the web"),
        std::pair("~/walk.bvh", "~ is not replaced by your home folder"),
        std::pair("captures\\walk.bvh", "write / instead of \\ between folders"),
        std::pair("walk.bvh", "give ")}) {
    const std::string text =
        std::string("mien: 1\nstudy: s\nstimuli:\n  - {id: a, clip: '") + path + "'}\n";
    const Ended ended = run_mien({"check", scratch.write("m.yaml", text).string()});
    EXPECT_EQ(ended.code, 2);
    EXPECT_TRUE(contains(ended.errors, "m.yaml:4:19: stimuli[0].clip: there is no file "))
        << ended.errors;
    EXPECT_TRUE(contains(ended.errors, said)) << ended.errors;
  }
}

TEST(CommandLine, CheckSpeaksJson) {
  const Scratch scratch;
  const fs::path bad = scratch.write("bad.yaml", "mien: 1\nstudy: 5\nstimuli: 1\n");
  const Ended ended = run_mien({"check", bad.string(), "--json"});
  EXPECT_EQ(ended.code, 2);
  const json faults = json::parse(ended.output)["faults"];
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_EQ(faults[0]["line"], 2);
  EXPECT_EQ(faults[0]["column"], 8);
  EXPECT_EQ(faults[0]["path"], "study");
  EXPECT_EQ(faults[0]["wrong"], "must be text but is 5");
  const fs::path good = scratch.write("good.yaml", small_manifest);
  const Ended fine = run_mien({"check", good.string(), "--json"});
  EXPECT_EQ(fine.code, 0);
  EXPECT_TRUE(json::parse(fine.output)["faults"].empty());
}

TEST(CommandLine, CheckSaysInJsonAllThatItPrints) {
  const json found = json::parse(run_mien({"check", "quickstart", "--json"}).output);
  ASSERT_EQ(found["notes"].size(), 6u);  // a parameter each
  std::istringstream printed(run_mien({"check", "quickstart"}).output);
  std::string line;
  std::getline(printed, line);
  EXPECT_EQ(line, found["notes"][0]["file"].get<std::string>() + ": no faults");
  std::getline(printed, line);  // the table's heading
  for (const json& note : found["notes"]) {
    std::getline(printed, line);
    std::string stimulus, parameter, requested, least, to, most;
    std::istringstream(line) >> stimulus >> parameter >> requested >> least >> to >> most;
    EXPECT_TRUE(note["text"].get<std::string>().starts_with(
        stimulus + ": " + parameter + " " + requested + " requested; feasible range " + least +
        " to " + most))
        << note["text"] << '\n'
        << line;
  }
  EXPECT_FALSE(std::getline(printed, line)) << line;
}

TEST(CommandLine, CheckReadsScalesFilesToo) {
  const Scratch scratch;
  const fs::path good =
      scratch.write("a.scales.yaml", "range: [1, 7]\nscales: {zeal: {low: idle, high: eager}}\n");
  EXPECT_EQ(run_mien({"check", good.string()}).code, 0);
  const fs::path bad = scratch.write("b.scales.yaml", "scales: {zeal: {low: idle}}\n");
  const Ended ended = run_mien({"check", bad.string()});
  EXPECT_EQ(ended.code, 2);
  EXPECT_EQ(ended.errors, bad.string() +
                              ":1:16: scales.zeal.high: missing; add it, for example "
                              "high: extraverted\n");
}

TEST(CommandLine, CheckGoesByWhatAFileHolds) {
  const Scratch scratch;
  EXPECT_EQ(run_mien({"check", scratch.write("stimulus-set.yaml", small_manifest).string()}).code,
            0);
  const fs::path recipes = scratch.write("mine.yaml", "recipes: {sad: {pathes: 0.5}}\n");
  EXPECT_EQ(run_mien({"check", recipes.string()}).errors,
            recipes.string() + ":1:17: recipes.sad.pathes: unknown key; did you mean \"paths\"?\n");
}

TEST(CommandLine, RunTellsWhatAFileHoldsThatIsNoManifest) {
  const Scratch scratch;
  const std::string scales =
      scratch.write("mine.yaml", "scales: {haste: {low: calm, high: hasty}}\n").string();
  for (const char* command : {"run", "plan"}) {
    const Ended ended = run_mien({command, scales});
    EXPECT_EQ(ended.code, 2);
    EXPECT_EQ(ended.errors,
              scales +
                  ":1:1: holds scales, and is not a manifest; refer to it in a manifest as "
                  "examples: {scales: mine.yaml}; only mien check accepts it directly\n");
  }
}

TEST(CommandLine, TellsAtWhichLineAFolderOrFileHoldsNothing) {
  const Scratch scratch;
  fs::create_directory(scratch.path() / "captures");
  const auto told = [&](const std::string& set) {
    const std::string file =
        scratch
            .write("m.yaml", "mien: 1\nstudy: s\nexamples: {set: " + set + "}\nstimuli:\n" +
                                 "  - {id: a, weights: {normal: 1}}\n")
            .string();
    const std::string errors = run_mien({"check", file}).errors;
    return errors.starts_with(file) ? errors.substr(file.size()) : errors;
  };
  const std::string none = told("{folder: captures}");
  EXPECT_TRUE(none.starts_with(":3:17: examples.set: ")) << none;
  EXPECT_TRUE(contains(none, "captures: holds no motion file that matches")) << none;
  EXPECT_EQ(
      told("./captures"),
      ":3:17: examples.set: \"./captures\" is not one of the choices; use one of "
      "builtin:walks-10, builtin:walks-27, builtin:actors, or a map of keys and values; for a "
      "folder of motion files write {folder: ./captures}\n");
  const std::string csv = scratch.write("a.csv", "").string();
  EXPECT_EQ(told("builtin:walks-10, ratings: a.csv"), csv +
                                                          ":1:1: the table is empty; begin with a "
                                                          "line of column names\n");
  const std::string empty = scratch.write("empty.yaml", "").string();
  EXPECT_EQ(run_mien({"run", empty}).errors,
            empty + ":1:1: the file is empty; write a document into it\n");
}

TEST(CommandLine, CheckTellsAnswersAboutNoExampleAndExamplesWithoutAnswer) {
  const Scratch scratch;
  const std::string text =
      "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10, ratings: a.csv}\n"
      "stimuli: [{id: a, adjectives: {sad-happy: 1}}]\n";
  const std::string manifest = scratch.write("m.yaml", text).string();
  const fs::path answers = scratch.write(
      "a.csv", "stimulus,scale,value\nnormal,sad-happy,1\nsaad,sad-happy,-2\nsad,sad-happy,NA\n");
  EXPECT_EQ(run_mien({"check", manifest}).errors,
            answers.string() +
                ":3:1: unknown stimulus \"saad\" (1 row); did you mean \"sad\"? "
                "(unknown: ignore leaves it out)\n");
  scratch.write("a.csv", "stimulus,scale,value\nnormal,sad-happy,1\nsad,sad-happy,NA\n");
  const std::string told = run_mien({"check", manifest}).errors;
  EXPECT_TRUE(told.starts_with(manifest + ":3:44: examples.ratings: no answer about ")) << told;
  EXPECT_TRUE(contains(told, "\"sad on sad-happy\"")) << told;
}

TEST(CommandLine, CheckTellsWhatARunWouldStumbleOver) {
  const Scratch scratch;
  const std::string head =
      "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\n"
      "output: {size: [64, 48], fps: 10, cycles: 1, quality: draft, video: [gif]}\n";
  const auto faults_of = [&](const std::string& rest) {
    const std::string file = scratch.write("m.yaml", head + rest).string();
    EXPECT_EQ(run_mien({"check", file, "--quick"}).code, 0);
    std::string errors = run_mien({"check", file}).errors;
    return errors.starts_with(file) ? errors.substr(file.size()) : errors;
  };
  EXPECT_EQ(faults_of("stimuli: [{id: a, weights: {normal: 1}}]\n"), "");
  const std::string fades = faults_of(
      "stimuli: [{id: a, weights: {normal: 1}, output: {presentation: {fade_in: 1, fade_out: 2}}}]"
      "\n");
  EXPECT_TRUE(fades.starts_with(
      ":5:64: stimuli[0].output.presentation: the fades last 3 s, but the film of \"a\" only 1."))
      << fades;
  const std::string light = faults_of(
      "equalize: [luminance]\nstimuli:\n  - {id: a, weights: {normal: 1}}\n"
      "  - {id: dots, weights: {normal: 1}, look: {figure: point-light}}\n");
  EXPECT_TRUE(
      contains(light, ":5:11: equalize: no exposure makes \"dots\" as bright as the others"))
      << light;
  EXPECT_EQ(faults_of("equalize: {luminance: {by: figure}}\nstimuli:\n"
                      "  - {id: a, weights: {normal: 1}}\n"
                      "  - {id: dots, weights: {normal: 1}, look: {figure: point-light}}\n"),
            "");
  scratch.write("no.bvh", "HIERARCHY\nROOT a\n");
  EXPECT_TRUE(contains(faults_of("stimuli: [{id: a, clip: no.bvh}]\n"), ":5:11: stimuli[0]: "));
}

TEST(CommandLine, TellsStimuliThatARaterCannotTellApart) {
  const Scratch scratch;
  std::string twice = small_manifest;
  twice.replace(twice.find("sad"), 3, "normal");
  const std::string file = scratch.write("m.yaml", twice).string();
  const std::string out = (scratch.path() / "out").string();
  const std::string remedy =
      "; change the motion or look of one of them; ignore this if the repetition is intended\n";
  const Ended check = run_mien({"check", file});
  EXPECT_EQ(check.code, 0);
  EXPECT_EQ(check.errors,
            "warning: " + file + ":7:5: stimuli[1]: \"b\" looks identical to \"a\"" + remedy);
  EXPECT_EQ(json::parse(run_mien({"check", file, "--json"}).output)["warnings"].size(), 1u);
  const std::string told = "warning: b: looks identical to \"a\"" + remedy;
  EXPECT_TRUE(contains(run_mien({"plan", file, "--out", out}).errors, told));
  const Ended run = run_mien({"run", file, "--out", out});
  EXPECT_EQ(run.code, 0);
  EXPECT_TRUE(contains(run.errors, told)) << run.errors;
  EXPECT_TRUE(contains(text_of(scratch.path() / "out/small/metrics/warnings.csv"),
                       "b,design,\"looks identical to \"\"a\"\";"));
  EXPECT_TRUE(contains(text_of(scratch.path() / "out/small/report.html"),
                       "<li>b: looks identical to &quot;a&quot;;"));
}

TEST(CommandLine, WarnsOfFormerNames) {
  const Scratch scratch;
  const std::string trail = "look: {figure: {trail: {before: 1, faintest: 0.2}}}\n";
  const std::string file = scratch.write("m.yaml", small_manifest + trail).string();
  const std::string told =
      "warning: " + file + ":8:36: look.figure.trail.faintest: now called min_opacity; rename it\n";
  const Ended check = run_mien({"check", file, "--quick"});
  EXPECT_EQ(check.code, 0);
  EXPECT_EQ(check.errors, told);
  const std::string out = (scratch.path() / "out").string();
  EXPECT_EQ(run_mien({"plan", file, "--out", out}).errors, told);
  // Every command that reads a manifest warns once, even if it then refuses this one.
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"run", file, "--out", out},
           {"clean", file, "--stale", "--out", out},
           {"clean", file, "--keep", "videos", "--dry-run", "--out", out},
           {"farm", "status", file, "--out", out},
           {"farm", "logs", file, "--out", out},
           {"farm", "export", file, "--format", "openjd", "--out", out},
           {"farm", "submit", file, "--dry-run", "--out", out},
           {"regress", file, "--out", out},
           {"study", "design", file},
           {"study", "simulate", file},
           {"study", "export", file, "--folder", (scratch.path() / "page").string()},
           {"study", "features", "--examples", file, "-o",
            (scratch.path() / "features").string()}}) {
    const std::string errors = run_mien(arguments).errors;
    const std::size_t first = errors.find(told);
    EXPECT_NE(first, errors.npos) << arguments[0] << ' ' << arguments[1] << ": " << errors;
    EXPECT_EQ(errors.find(told, first + 1), errors.npos) << arguments[0] << ' ' << arguments[1];
  }

  const Ended methods = run_mien({"study", "methods", "--examples", "builtin:walks-10", "--methods",
                                  "cardinal", "--wishes", "2"});
  EXPECT_EQ(methods.code, 0) << methods.errors;
  EXPECT_TRUE(contains(methods.errors, "warning: --wishes is now called --settings\n"));
}

TEST(CommandLine, CleanRemovesWhatTheManifestNoLongerMakes) {
  const Scratch scratch;
  const std::string manifest = scratch.write("m.yaml", small_manifest).string();
  const std::string out = (scratch.path() / "out").string();
  const fs::path made = scratch.path() / "out/small";
  ASSERT_EQ(run_mien({"run", manifest, "--out", out}).code, 0);
  EXPECT_FALSE(contains(run_mien({"plan", manifest, "--out", out}).output, "earlier runs"));
  std::string renamed = small_manifest;
  renamed.replace(renamed.find("id: b"), 5, "id: c");
  scratch.write("m.yaml", renamed);
  scratch.write("out/small/clips/mine.bvh", "mine");
  const Ended plan = run_mien({"plan", manifest, "--out", out});
  EXPECT_TRUE(contains(plan.output, "left over from earlier runs:\n  clips/b.bvh\n"))
      << plan.output;
  EXPECT_TRUE(contains(plan.output, "mien clean --stale " + manifest + " --out " + out));
  const json run = json::parse(run_mien({"run", manifest, "--out", out, "--json"}).output);
  EXPECT_EQ(run["stale"][0], "clips/b.bvh");
  EXPECT_EQ(run_mien({"clean", manifest, "--out", out}).code, 2);
  EXPECT_TRUE(fs::exists(made / "clips/b.bvh"));
  const Ended clean = run_mien({"clean", "--stale", manifest, "--out", out});
  EXPECT_TRUE(clean.output.starts_with("removed clips/b.bvh\n")) << clean.output;
  EXPECT_FALSE(fs::exists(made / "clips/b.bvh"));
  EXPECT_TRUE(fs::exists(made / "clips/c.bvh"));
  EXPECT_TRUE(fs::exists(made / "clips/mine.bvh"));
  const Ended again = run_mien({"run", manifest, "--out", out});
  EXPECT_TRUE(contains(again.output, "nothing to do")) << again.output;
  EXPECT_FALSE(contains(again.output, "earlier runs"));
}

TEST(CommandLine, PlanTellsWhatARunThenDoes) {
  const Scratch scratch;
  const std::string manifest = scratch.write("m.yaml", small_manifest).string();
  const std::string out = (scratch.path() / "out").string();
  const auto states = [&] {
    const json plan = json::parse(run_mien({"plan", manifest, "--out", out, "--json"}).output);
    std::string text;
    for (const json& task : plan["tasks"]) {
      text += task["id"].get<std::string>() + " " + task["state"].get<std::string>() + "\n";
    }
    return text;
  };
  EXPECT_EQ(states(),
            "motion:a due\nmotion:b due\nclip:a waiting\nfilm:a waiting\nclip:b waiting\n"
            "film:b waiting\ntables waiting\nfilms waiting\ndesign waiting\nreport waiting\n");
  EXPECT_FALSE(fs::exists(out));
  ASSERT_EQ(run_mien({"run", manifest, "--out", out, "--only", "b"}).code, 0);
  EXPECT_FALSE(fs::exists(scratch.path() / "out/small/clips/a.bvh"));
  EXPECT_TRUE(fs::exists(scratch.path() / "out/small/clips/b.bvh"));
  EXPECT_EQ(states(),
            "motion:a cached\nmotion:b cached\nclip:a due\nfilm:a due\nclip:b cached\n"
            "film:b cached\ntables due\nfilms waiting\ndesign waiting\nreport waiting\n");
}

TEST(CommandLine, LevelsOfANumberAreToldAndMadeAsIfTheyWereListed) {
  const Scratch scratch;
  std::string levels(small_manifest), listed = levels;
  levels +=
      "  - {id: sad, weights: {normal: 1}, modify: {emotion: sad, variation: 0.3}, levels: "
      "{factor: "
      "dose, of: modify.strength, values: {from: 0, to: 0.6, steps: 3}}}\n";
  for (const char* level : {"0", "0.3", "0.6"})
    listed += "  - {id: sad-" + std::string(level) + ", factors: {dose: " + level +
              "}, weights: {normal: 1}, modify: {emotion: sad, variation: 0.3, strength: " + level +
              "}}\n";
  const std::string file = scratch.write("m.yaml", levels).string();
  const std::string told = "sad: 3 levels of dose (modify.strength): 0, 0.3, 0.6\n";
  for (const char* command : {"check", "plan"})
    EXPECT_TRUE(contains(run_mien({command, file}).output, told)) << command;
  EXPECT_EQ(json::parse(run_mien({"plan", file, "--json"}).output).at("levels").size(), 1u);
  const fs::path one = scratch.path() / "one", other = scratch.path() / "other";
  EXPECT_EQ(run_mien({"run", file, "--out", one.string()}).code, 0);
  EXPECT_EQ(
      run_mien({"run", scratch.write("l.yaml", listed).string(), "--out", other.string()}).code, 0);
  for (const char* id : {"sad-0", "sad-0.3", "sad-0.6"}) {
    const std::string clip = "small/clips/" + std::string(id) + ".bvh";
    EXPECT_EQ(text_of(one / clip), text_of(other / clip)) << id;
  }
  // At a strength of 0 the motion is the unmodified one.
  EXPECT_EQ(text_of(one / "small/clips/sad-0.bvh"), text_of(one / "small/clips/a.bvh"));
  EXPECT_NE(text_of(one / "small/clips/sad-0.3.bvh"), text_of(one / "small/clips/a.bvh"));
  // The record makes the same again.
  const fs::path again = scratch.path() / "again";
  EXPECT_EQ(
      run_mien({"run", (one / "small/provenance.json").string(), "--out", again.string()}).code, 0);
  EXPECT_EQ(text_of(again / "small/clips/sad-0.3.bvh"), text_of(one / "small/clips/sad-0.3.bvh"));
}

TEST(CommandLine, RunSpeaksJsonOnStandardOutput) {
  const Scratch scratch;
  const std::string manifest = scratch.write("m.yaml", small_manifest).string();
  const std::string out = (scratch.path() / "out").string();
  const Ended ended = run_mien({"run", manifest, "--out", out, "--json"});
  ASSERT_EQ(ended.code, 0) << ended.errors;
  const json result = json::parse(ended.output);
  EXPECT_EQ(result["made"].size(), 10u);
  EXPECT_TRUE(result["failed"].empty());
  for (const json& artifact : result["artifacts"]) {
    const fs::path file = scratch.path() / "out/small" / artifact["path"].get<std::string>();
    EXPECT_EQ(fs::file_size(file), artifact["size"]) << file;
  }
  const json provenance = json::parse(text_of(scratch.path() / "out/small/provenance.json"));
  EXPECT_EQ(provenance["artifacts"].size(), result["artifacts"].size());
  EXPECT_FALSE(contains(provenance.dump(), scratch.path().string()));
}

TEST(CommandLine, OnlyRefusesUnknownIds) {
  const Scratch scratch;
  const std::string manifest = scratch.write("m.yaml", small_manifest).string();
  const Ended ended = run_mien({"run", manifest, "--only", "aa"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_EQ(ended.errors,
            "--only: there is no stimulus, overlay or sheet \"aa\"; did you mean \"a\"?\n");
}

TEST(CommandLine, AMotionFileThatCannotBeReadIsBadInputAndTheRestIsMade) {
  const Scratch scratch;
  scratch.write("broken.bvh", "HIERARCHY\nROOT\n");
  const std::string manifest =
      scratch.write("m.yaml", std::string(small_manifest) + "  - {id: c, clip: broken.bvh}\n")
          .string();
  const Ended ended = run_mien({"run", manifest, "--out", (scratch.path() / "out").string()});
  EXPECT_EQ(ended.code, 2);
  EXPECT_TRUE(contains(ended.errors, "broken.bvh:")) << ended.errors;
  EXPECT_TRUE(contains(ended.errors, "(motion:c)")) << ended.errors;
  EXPECT_TRUE(fs::exists(scratch.path() / "out/small/clips/a.bvh"));
  EXPECT_FALSE(fs::exists(scratch.path() / "out/small/provenance.json"));
}

TEST(CommandLine, AFolderThatCannotBeWrittenIsAFailure) {
  const Scratch scratch;
  const std::string manifest = scratch.write("m.yaml", small_manifest).string();
  const fs::path file = scratch.write("file", "");
  const Ended ended = run_mien({"run", manifest, "--out", (file / "out").string()});
  EXPECT_EQ(ended.code, 1);
  EXPECT_TRUE(ended.errors.starts_with("mien: ")) << ended.errors;
}

TEST(CommandLine, ARunThatWantsToBeAloneRefusesCompany) {
  const Scratch scratch;
  const std::string manifest = scratch.write("m.yaml", small_manifest).string();
  const fs::path study = scratch.path() / "out/small";
  std::vector<std::string> command = {"run", manifest, "--out", (scratch.path() / "out").string()};
  Running first(mien_with(command));
  const auto has_signed_in = [&] {
    if (!fs::exists(study / ".mien/workers")) return false;
    return std::ranges::any_of(
        fs::directory_iterator(study / ".mien/workers"),
        [](const fs::directory_entry& entry) { return entry.path().extension() != ".new"; });
  };
  while (!has_signed_in()) pause_for(0.005);
  first.send(SIGSTOP);
  ASSERT_TRUE(first.is_running());

  command.push_back("--exclusive");
  const Ended second = run_mien(command);
  EXPECT_EQ(second.code, 1);
  EXPECT_TRUE(contains(second.errors, "another process works in")) << second.errors;
  first.send(SIGCONT);
  EXPECT_EQ(first.wait().code, 0);
  EXPECT_EQ(run_mien(command).code, 0);
}

TEST(CommandLine, BlendsComparesConvertsAndTellsAboutMotions) {
  const Scratch scratch;
  const std::string mix = (scratch.path() / "mix.bvh").string();
  const std::string sad = (scratch.path() / "sad.bvh").string();
  const std::vector<std::string> blend = {"motion", "blend", "--examples", "builtin:walks-10"};
  const auto with = [](std::vector<std::string> list, const std::vector<std::string>& more) {
    list.insert(list.end(), more.begin(), more.end());
    return list;
  };
  ASSERT_EQ(run_mien(with(blend, {"--weights", "normal=1", "--cycles", "3", "-o", mix})).code, 0);
  ASSERT_EQ(run_mien(with(blend, {"--weights", "sad=1", "--cycles", "3", "-o", sad})).code, 0);
  const Ended unknown = run_mien(with(blend, {"--weights", "norml=1", "-o", mix}));
  EXPECT_EQ(unknown.code, 2);
  EXPECT_EQ(unknown.errors, "--weights: there is no example \"norml\"; did you mean \"normal\"?\n");

  const json info = json::parse(run_mien({"motion", "info", mix, "--json"}).output);
  EXPECT_EQ(info["up"], "+Y");
  EXPECT_GE(info["cycles"].size(), 1u);
  EXPECT_EQ(info["cycles"][0]["keytimes_s"].size(), 7u);
  EXPECT_TRUE(info["human"]);

  const json same = json::parse(run_mien({"motion", "compare", mix, mix, "--json"}).output);
  EXPECT_LT(same["D"], 1e-9);
  EXPECT_TRUE(same["match"]);
  const json other =
      json::parse(run_mien({"motion", "compare", mix, sad, "--json", "--align", "world"}).output);
  EXPECT_GT(other["D"], 0.01);
  EXPECT_EQ(other["per_time"].size(), 11u);
  EXPECT_EQ(other["per_joint"].size(), 20u);

  const std::string copy = (scratch.path() / "copy.bvh").string();
  ASSERT_EQ(run_mien({"motion", "convert", mix, copy}).code, 0);
  EXPECT_LT(json::parse(run_mien({"motion", "compare", mix, copy, "--json"}).output)["D"], 1e-6);
  EXPECT_EQ(run_mien({"motion", "convert", mix, (scratch.path() / "a.txt").string()}).code, 2);
  EXPECT_EQ(run_mien({"motion", "info", (scratch.path() / "none.bvh").string()}).code, 2);
}

TEST(CommandLine, LeavesWhatIsNoHumanUnscaledAndSaysSo) {
  const Scratch scratch;
  const fs::path bvh = scratch.path() / "stick.bvh";
  std::ofstream(bvh) << "HIERARCHY\nROOT low\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition "
                        "Zposition Zrotation Xrotation Yrotation\nJOINT high\n{\nOFFSET 0 170 0\n"
                        "CHANNELS 3 Zrotation Xrotation Yrotation\n}\n}\nMOTION\nFrames: 1\n"
                        "Frame Time: 0.1\n0 0 0 0 0 0 0 0 0\n";
  const fs::path glb = scratch.path() / "stick.glb";
  const Ended written = run_mien({"motion", "convert", bvh.string(), glb.string()});
  ASSERT_EQ(written.code, 0);
  EXPECT_NE(written.errors.find("shown as it is: unscaled"), std::string::npos) << written.errors;
  std::ifstream in(glb, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const json document = json::parse(bytes.substr(20, bytes.find("BIN") - 24));
  EXPECT_NEAR(document["nodes"][1]["translation"][1].get<double>(), 170.0, 1e-6);
}

/// A manifest with so many keys that nobody knows.
std::string with_unknown_keys(int count) {
  std::string text = small_manifest;
  for (int i = 0; i < count; ++i) text += "unknown_" + std::to_string(i) + ": 1\n";
  return text;
}

TEST(CommandLine, CountsTheFaultsThatJsonLeavesOut) {
  const Scratch scratch;
  const std::string file = (scratch.path() / "m.yaml").string();
  for (const int count : {3, 1000, 1203}) {
    std::ofstream(file) << with_unknown_keys(count);
    const Ended ended = run_mien({"check", file, "--json"});
    EXPECT_EQ(ended.code, 2);
    const json found = json::parse(ended.output);
    EXPECT_EQ(found["faults"].size(), std::min(count, 1000));
    EXPECT_EQ(found.contains("left_out"), count > 1000);
    if (count > 1000) {
      EXPECT_EQ(found["left_out"], count - 1000);
    }
  }
}

TEST(CommandLine, TakesTheMotionOfAFileThatIsNamed) {
  const Scratch scratch;
  const fs::path glb = scratch.path() / "walk.glb";
  ASSERT_EQ(run_mien({"motion", "blend", "--examples", "builtin:walks-10", "--weights", "normal=1",
                      "-o", glb.string()})
                .code,
            0);
  const json named = json::parse(run_mien({"motion", "info", glb.string(), "--json"}).output);
  ASSERT_EQ(named["takes"].size(), 1u);
  const std::string take = named["take"].get<std::string>();
  EXPECT_EQ(run_mien({"motion", "info", glb.string(), "--take", take}).code, 0);
  const Ended unknown = run_mien({"motion", "info", glb.string(), "--take", "Jump"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_NE(unknown.errors.find("there is no take \"Jump\"; it holds " + take), std::string::npos)
      << unknown.errors;
  EXPECT_EQ(run_mien({"motion", "info", glb.string()}).output.find("is shown"), std::string::npos);
  const fs::path bvh = scratch.path() / "walk.bvh";
  ASSERT_EQ(run_mien({"motion", "convert", glb.string(), bvh.string(), "--take", take}).code, 0);
  const Ended single = run_mien({"motion", "info", bvh.string(), "--take", take});
  EXPECT_EQ(single.code, 2);
  EXPECT_NE(single.errors.find("holds one motion"), std::string::npos) << single.errors;
  for (const std::vector<std::string>& comparison :
       {std::vector<std::string>{"motion", "compare"}, std::vector<std::string>{"regress"}}) {
    const auto of_takes = [&](const std::vector<std::string>& takes) {
      std::vector<std::string> arguments = comparison;
      arguments.insert(arguments.end(), {glb.string(), bvh.string()});
      for (const std::string& one : takes) arguments.insert(arguments.end(), {"--take", one});
      return run_mien(arguments);
    };
    EXPECT_LT(of_takes({take}).code, 2);  // of the file that may hold several
    EXPECT_EQ(of_takes({"Jump"}).code, 2);
    EXPECT_EQ(of_takes({take, take}).code, 2);  // the second file holds one
    EXPECT_EQ(of_takes({take, "", ""}).code, 2);
  }
}

/// The BVH with a frame of half a second later in its middle.
void put_leap_into(const fs::path& bvh, const fs::path& faulty) {
  std::ifstream in(bvh);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  const std::size_t middle = lines.size() - 40;
  lines[middle] = lines[middle + 15];
  std::ofstream out(faulty);
  for (const std::string& line : lines) out << line << '\n';
}

TEST(CommandLine, FindsFaultsOfMotions) {
  const Scratch scratch;
  const std::string walk = (scratch.path() / "walk.bvh").string();
  const std::string faulty = (scratch.path() / "faulty.bvh").string();
  ASSERT_EQ(run_mien({"motion", "blend", "--examples", "builtin:walks-10", "--weights", "normal=1",
                      "--cycles", "3", "-o", walk})
                .code,
            0);
  put_leap_into(walk, faulty);
  const Ended clean = run_mien({"motion", "lint", walk});
  EXPECT_EQ(clean.code, 0) << clean.errors;
  EXPECT_TRUE(contains(clean.output, ": 0 errors, 0 warnings")) << clean.output;

  const std::string picture = (scratch.path() / "faults.svg").string();
  const Ended found = run_mien({"motion", "lint", walk, faulty, "--json"});
  EXPECT_EQ(found.code, 1);
  const json motions = json::parse(found.output)["motions"];
  ASSERT_EQ(motions.size(), 2u);
  EXPECT_EQ(motions[0]["errors"], 0);
  EXPECT_GE(motions[1]["errors"], 1);
  EXPECT_EQ(motions[1]["findings"][0]["check"], "jump");
  EXPECT_EQ(motions[1]["findings"][0]["severity"], "error");

  EXPECT_EQ(run_mien({"motion", "lint", faulty, "--original", walk, "--timeline", picture}).code,
            1);
  EXPECT_TRUE(fs::exists(picture));
  EXPECT_TRUE(
      contains(run_mien({"motion", "lint", faulty, "--csv"}).output,
               "motion,check,joint,first,last,measured,threshold,unit,severity,sentence\n"));
  EXPECT_EQ(run_mien({"motion", "lint", walk, faulty, "--timeline", picture}).code, 2);
  EXPECT_EQ(run_mien({"motion", "lint", walk, "--timeline", "faults.gif"}).code, 2);
  EXPECT_EQ(run_mien({"motion", "lint", (scratch.path() / "none.bvh").string()}).code, 2);
}

TEST(CommandLine, ModifiesAMotionFile) {
  const Scratch scratch;
  // A name that a shell or a YAML file would stumble on.
  const std::string walk = (scratch.path() / "it's ${X}.bvh").string();
  ASSERT_EQ(run_mien({"motion", "blend", "--examples", "builtin:walks-10", "--weights", "normal=1",
                      "--cycles", "3", "-o", walk})
                .code,
            0);
  const std::string sad = (scratch.path() / "sad.bvh").string();
  const Ended ended = run_mien({"motion", "modify", walk, "[{emotion: sad}, {tempo: 0.9}]", sad});
  ASSERT_EQ(ended.code, 0) << ended.errors;
  const Ended compared = run_mien({"motion", "compare", walk, sad});
  EXPECT_EQ(compared.code, 0) << compared.errors;
  EXPECT_NE(compared.output, run_mien({"motion", "compare", walk, walk}).output);

  const Ended unknown = run_mien({"motion", "modify", walk, "sadd", sad + ".bvh"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_TRUE(contains(unknown.errors, "did you mean \"sad\"?")) << unknown.errors;
  EXPECT_FALSE(fs::exists(sad + ".bvh"));

  const std::string before = text_of(walk);
  EXPECT_EQ(run_mien({"motion", "modify", walk, "sad", walk}).code, 2);
  EXPECT_EQ(text_of(walk), before);

  const std::string recipes = (scratch.path() / "my.recipes.yaml").string();
  std::ofstream(recipes) << "recipes:\n  gloomy: {posture: {head-flexion: 15}}\n";
  EXPECT_EQ(run_mien({"motion", "modify", walk, "gloomy", sad, "--recipes", recipes}).code, 0);
}

TEST(CommandLine, RenderWarnsOfAPoseOfCalibration) {
  const auto data = real_data();
  if (!data) GTEST_SKIP() << "no real motions here (MIEN_DATA)";
  const Scratch scratch;
  const auto errors_of = [&](const char* file) {
    return run_mien({"render", (*data / "mocap/cmu" / file).string(), "-o",
                     (scratch.path() / "still.png").string(), "--size", "64x48", "--quality",
                     "draft", "--still"})
        .errors;
  };
  const char* sentence = "The take begins with a different pose, such as for calibration";
  EXPECT_TRUE(contains(errors_of("01_01.bvh"), sentence)) << errors_of("01_01.bvh");
  EXPECT_FALSE(contains(errors_of("02_01.amc"), sentence)) << errors_of("02_01.amc");
}

TEST(CommandLine, RendersAMotionFileByItself) {
  const Scratch scratch;
  const std::string walk = (scratch.path() / "walk.bvh").string();
  ASSERT_EQ(run_mien({"motion", "blend", "--examples", "builtin:walks-10", "--weights", "normal=1",
                      "-o", walk})
                .code,
            0);
  const fs::path video = scratch.path() / "walk.mp4";
  const Ended ended = run_mien({"render", walk, "-o", video.string(), "--size", "64x48", "--fps",
                                "10", "--quality", "draft"});
  ASSERT_EQ(ended.code, 0) << ended.errors;
  EXPECT_GT(fs::file_size(video), 500u);
  EXPECT_EQ(run_mien({"render", walk, "-o", video.string(), "--size", "64x47"}).code, 2);
  const fs::path gif = scratch.path() / "walk.gif";
  EXPECT_EQ(run_mien({"render", walk, "-o", gif.string(), "--size", "65x47", "--fps", "10",
                      "--quality", "draft", "--repeat"})
                .code,
            0);
  fs::remove(gif);
  EXPECT_EQ(run_mien({"render", walk, "-o", gif.string(), "--fps", "60"}).code, 2);
  EXPECT_EQ(run_mien({"render", walk, "-o", "walk.avi"}).code, 2);
  EXPECT_EQ(run_mien({"render", walk, "--camera", "top"}).code, 2);
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch.path()), {}), 2);

  const std::string picture = (scratch.path() / "a:still.png").string();
  const auto still = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"render", walk,    "-o", picture,     "--size",
                                          "64x48",  "--fps", "10", "--quality", "draft"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_mien(arguments).code;
  };
  EXPECT_EQ(still({"--still"}), 0);
  EXPECT_EQ(still({"--still", "0.2", "--crop", "10,10,20,20"}), 0);
  for (const std::vector<std::string>& bad : std::vector<std::vector<std::string>>{
           {"--still", "1e9"},
           {"--still", "-3"},
           {"--still", "nan"},
           {"--still", "--scale", "nan"},
           {"--still", "--shutter", "nan"},
           {"--still", "--scale", "0.05"},
           {"--still", "--crop", "60,0,20,20"},
           {"--still", "--background", "transparent", "--camera", "{view: side, stereo: {}}"},
           {"--still", "--background", "transparent", "--shutter", "90"}}) {
    EXPECT_EQ(still(bad), 2) << bad[0] << ' ' << bad.back();
  }
}

TEST(CommandLine, SimulatedAnswersAreTheSameEveryTimeAndMarked) {
  const std::vector<std::string> command = {
      "study", "simulate", "--examples", "builtin:walks-10", "--raters", "2", "--seed", "4"};
  const Ended first = run_mien(command);
  ASSERT_EQ(first.code, 0) << first.errors;
  EXPECT_TRUE(first.output.starts_with("participant,stimulus,scale,value,simulated\n"));
  EXPECT_EQ(first.output, run_mien(command).output);
}

TEST(CommandLine, WordsBecomeAnswersThatAManifestTakesToo) {
  const Scratch scratch;
  const std::string words =
      "participant,language,motion,verb,modifier1\n"
      "1,suomi,normal,kävelee,hitaasti\n1,suomi,brisk,juoksee,hyvin nopeasti\n";
  const std::string file = scratch.write("words.csv", words).string();
  const std::string lexicon = MIEN_SOURCE_DIR "/manifests/walking-words.scales.yaml";
  const std::string answers = (scratch.path() / "answers.csv").string();
  const std::string report = (scratch.path() / "report").string();
  const Ended ended =
      run_mien({"study", "words", file, "--lexicon", lexicon, "-o", answers, "--report", report});
  ASSERT_EQ(ended.code, 0) << ended.errors;
  EXPECT_NE(ended.output.find("finnish: 2 of 2 answers understood (100 %)"), std::string::npos);
  EXPECT_TRUE(fs::exists(report + "/coverage.csv"));
  EXPECT_TRUE(fs::exists(report + "/answers_per_stimulus.csv"));
  std::ifstream stream(answers);
  const std::string text((std::istreambuf_iterator<char>(stream)), {});
  EXPECT_NE(text.find("1,brisk,slow-fast,2\n"), std::string::npos);
  EXPECT_NE(text.find("1,normal,slow-fast,-1\n"), std::string::npos);
  const Ended refused = run_mien({"study", "words", answers, "--lexicon", lexicon, "-o", file});
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.errors.find("answers.csv:1:1: there is no column \"language\""),
            std::string::npos)
      << refused.errors;
}

TEST(CommandLine, VersionNamesTheLibraries) {
  const json versions = json::parse(run_mien({"version", "--json"}).output);
  EXPECT_TRUE(versions.contains("mien"));
  for (const char* library : {"Embree", "FFmpeg", "OpenImageIO", "Eigen", "CLI11", "yaml-cpp"}) {
    EXPECT_TRUE(versions["libraries"].contains(library)) << library;
  }
}

}  // namespace
}  // namespace mien::test
