// The shipped study of pairs of people, small: made, checked, asked about, packed and regressed.

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "end_to_end/program.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  for (const char letter : line) {
    if (letter == ',')
      fields.emplace_back();
    else
      fields.back() += letter;
  }
  return fields;
}

/// A value of a table without quoted fields, by the text of its first columns.
std::string value_in(const fs::path& table, const std::string& row, const std::string& column) {
  std::istringstream text(text_of(table));
  std::string header, line;
  std::getline(text, header);
  const std::vector<std::string> names = fields_of(header);
  while (std::getline(text, line)) {
    if (!line.starts_with(row)) continue;
    for (std::size_t i = 0; i < names.size(); ++i)
      if (names[i] == column) return fields_of(line).at(i);
  }
  return "no row " + row;
}

/// manifests/greeting.yaml with small pictures, made once.
class Greeting : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    scratch_ = new Scratch();
    std::string text = text_of(fs::path(MIEN_SOURCE_DIR) / "manifests/greeting.yaml");
    text = std::regex_replace(text, std::regex("size: \\[640, 360\\], fps: 30"),
                              "size: [96, 54], fps: 10");
    scratch_->write("greeting.yaml", text);
    const Ended made = run_mien({"run", manifest(), "--out", out("out")});
    ASSERT_EQ(made.code, 0) << made.errors;
    errors_ = made.errors;
  }

  static void TearDownTestSuite() { delete scratch_; }

  static std::string out(const std::string& name) { return (scratch_->path() / name).string(); }
  static std::string manifest() { return out("greeting.yaml"); }
  static fs::path study() { return scratch_->path() / "out/greeting"; }

  static Scratch* scratch_;
  static std::string errors_;
};

Scratch* Greeting::scratch_ = nullptr;
std::string Greeting::errors_;

TEST_F(Greeting, MakesAFilmOfEachPairAndAMotionOfEachPerson) {
  for (const char* id : {"greet", "pass", "greet-mismatched", "greet-dots"}) {
    EXPECT_TRUE(fs::exists(study() / "videos" / (std::string(id) + ".mp4"))) << id;
    EXPECT_FALSE(fs::exists(study() / "clips" / (std::string(id) + ".bvh"))) << id;
    for (const char* person : {".a", ".b"})
      EXPECT_TRUE(fs::exists(study() / "clips" / (std::string(id) + person + ".bvh"))) << id;
  }
  EXPECT_TRUE(fs::exists(study() / "sheets/greet.a_pass.a.pdf"));
  EXPECT_TRUE(fs::exists(study() / "sheets/pairs.png"));
  // The motion that is exchanged is the other's to the last byte, but for its name.
  const std::string taken = text_of(study() / "clips/greet-mismatched.b.bvh");
  EXPECT_EQ(taken, text_of(study() / "clips/pass.b.bvh"));
  EXPECT_NE(taken, text_of(study() / "clips/greet.b.bvh"));
}

TEST_F(Greeting, TellsWhereEverybodyIsAndHowNearTheirHandsCome) {
  const fs::path people = study() / "metrics/people.csv";
  EXPECT_EQ(value_in(people, "greet,a", "x_m"), "-2.8");
  EXPECT_EQ(value_in(people, "greet,a", "turn_deg"), "90");
  EXPECT_EQ(value_in(people, "greet,b", "turn_deg"), "-90");
  EXPECT_LT(std::stod(value_in(people, "greet,a", "nearest_hand_m")), 0.06);
  EXPECT_GT(std::stod(value_in(people, "pass,a", "nearest_hand_m")), 0.2);
  EXPECT_EQ(value_in(people, "greet-mismatched,b", "swapped_from"), "pass");
  EXPECT_EQ(value_in(people, "greet,b", "swapped_from"), "");
  EXPECT_EQ(value_in(study() / "metrics/stimuli.csv", "greet,", "source"), "people");
  EXPECT_EQ(value_in(study() / "metrics/clips.csv", "pass.b,", "source"), "path");
  // The friendly pair keeps its distance.
  EXPECT_EQ(errors_.find("deep in each other"), std::string::npos) << errors_;
  EXPECT_NE(text_of(study() / "report.html").find("id=\"greet.b\""), std::string::npos);
  EXPECT_NE(text_of(study() / "methods.md").find("Four stimuli show several people (8 in all"),
            std::string::npos);
}

TEST_F(Greeting, HasTheSameBytesWhenItIsMadeAgain) {
  const Ended again = run_mien({"run", manifest(), "--out", out("again"), "--jobs", "3"});
  ASSERT_EQ(again.code, 0) << again.errors;
  int compared = 0;
  for (const char* folder : {"videos", "clips", "metrics"}) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(study() / folder)) {
      if (!entry.is_regular_file()) continue;
      const fs::path other = out("again") / fs::relative(entry.path(), out("out"));
      EXPECT_EQ(text_of(entry.path()), text_of(other)) << entry.path();
      ++compared;
    }
  }
  EXPECT_GT(compared, 20);
}

TEST_F(Greeting, IsAskedAboutVerifiedAndPacked) {
  const Ended answers = run_mien({"study", "simulate", manifest(), "-o", out("answers.csv")});
  ASSERT_EQ(answers.code, 0) << answers.errors;
  const std::string rows = text_of(out("answers.csv"));
  EXPECT_NE(rows.find("greet-mismatched"), std::string::npos);
  EXPECT_EQ(rows.find("greet.a"), std::string::npos);
  const Ended page =
      run_mien({"study", "export", manifest(), "--out", out("out"), "-o", out("page")});
  EXPECT_EQ(page.code, 0) << page.errors;
  const Ended report =
      run_mien({"study", "report", out("answers.csv"), manifest(), "-o", out("report")});
  EXPECT_EQ(report.code, 0) << report.errors;
  const Ended verified = run_mien({"verify", study().string()});
  EXPECT_EQ(verified.code, 0) << verified.output << verified.errors;
  const Ended packed = run_mien({"pack", study().string(), "-o", out("greeting.tar")});
  EXPECT_EQ(packed.code, 0) << packed.errors;
}

TEST_F(Greeting, IsRegressedWithEachPersonAsAStimulus) {
  // Without equalization, by which one film depends on the others.
  const std::string text =
      std::regex_replace(text_of(manifest()), std::regex("\nequalize: [^\n]*"), "");
  const std::string baseline = out("baseline"), file = out("plain.yaml");
  scratch_->write("plain.yaml", text);
  const Ended approved =
      run_mien({"regress", "approve", file, "--out", out("plain"), "--baseline", baseline,
                "--reason", "first", "--without-videos", "--only", "greet,pass"});
  ASSERT_EQ(approved.code, 0) << approved.errors;
  const auto regressed = [&] {
    return run_mien({"regress", file, "--out", out("plain"), "--baseline", baseline,
                     "--without-videos", "--json", "--only", "greet,pass"});
  };
  const auto changed = [](const Ended& ended) {
    const auto report = nlohmann::json::parse(ended.output);
    std::set<std::string> ids;
    for (const auto& stimulus : report.at("stimuli"))
      if (stimulus.at("verdict") != "same") ids.insert(stimulus.at("id").get<std::string>());
    return ids;
  };
  const Ended same = regressed();
  EXPECT_EQ(same.code, 0) << same.errors;
  EXPECT_EQ(nlohmann::json::parse(same.output).at("stimuli").size(), 4u);
  EXPECT_TRUE(changed(same).empty());
  // One of the two begins elsewhere, and both are in the pictures of each.
  scratch_->write("plain.yaml",
                  std::regex_replace(text, std::regex("x: 2.8, z: 0.5, turn: -90\\}, start"),
                                     "x: 2.9, z: 0.5, turn: -90}, start"));
  const Ended other = regressed();
  EXPECT_EQ(other.code, 1) << other.errors;
  EXPECT_EQ(changed(other), (std::set<std::string>{"pass.a", "pass.b"}));
  EXPECT_NE(other.output.find("\"root\": \"people"), std::string::npos) << other.output;
}

}  // namespace
}  // namespace mien::test
