#include "pipeline/production/synthesis/parameter_request.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/manifest/determinants.h"
#include "pipeline/production/synthesis/synthesis.h"

namespace mien::pipeline {
namespace {

const std::string head =
    "mien: 1\nstudy: s\nexamples: {set: builtin:walks-27, ratings: builtin}\nstimuli:\n";

Manifest parsed(const std::string& stimuli) {
  ManifestReading reading =
      parse_manifest(head + stimuli, "m.yaml", [](const std::string&) { return std::nullopt; });
  EXPECT_TRUE(reading.faults.empty()) << to_string(reading.faults.front());
  return std::move(reading.manifest);
}

const Repertoire& repertoire() {
  static const Repertoire loaded = load_repertoire(parsed("  - {id: a, weights: {normal: 1}}\n"));
  return loaded;
}

double value_of(const NamedValues& values, const std::string& name) {
  for (const auto& [other, value] : values) {
    if (other == name) return value;
  }
  return NAN;
}

/// How far the groups that are not requested wander while quickness goes from low to high.
double wandering(const std::string& hold) {
  const char* others[] = {"clearness", "activeness", "largeness"};
  double least[] = {1.0, 1.0, 1.0}, most[] = {0.0, 0.0, 0.0};
  for (const double quickness : {0.4, 0.45, 0.5, 0.55, 0.6}) {
    const Manifest manifest = parsed(
        "  - {id: a, adjectives: {quickness: " + std::to_string(quickness) + "}" + hold + "}\n");
    const Synthesis made = synthesize(manifest.stimuli[0], repertoire());
    EXPECT_NEAR(made.reached[0].second, quickness, 1e-6);
    const NamedValues rated = rated_values(made, repertoire());
    for (int i = 0; i < 3; ++i) {
      least[i] = std::min(least[i], value_of(rated, others[i]));
      most[i] = std::max(most[i], value_of(rated, others[i]));
    }
  }
  return std::max({most[0] - least[0], most[1] - least[1], most[2] - least[2]});
}

TEST(Hold, KeepsWhatIsNotAskedFor) {
  EXPECT_GT(wandering(""), 0.05);
  EXPECT_LT(wandering(", hold: others"), 0.01);
}

TEST(Hold, KeepsValuesThatAreGiven) {
  const Manifest manifest = parsed(
      "  - {id: a, adjectives: {quickness: 0.5}, hold: {largeness: 0.55}}\n"
      "  - {id: b, adjectives: {quickness: 0.5}, hold: {largeness: 0.45}}\n");
  for (const Stimulus& stimulus : manifest.stimuli) {
    const Synthesis made = synthesize(stimulus, repertoire());
    EXPECT_NEAR(made.held_reached[0].second, made.held[0].second, 1e-4);
    EXPECT_NEAR(made.reached[0].second, 0.5, 1e-6);
  }
}

TEST(Hold, KeepsWhatTheReferenceHas) {
  const Manifest manifest = parsed(
      "  - {id: r, role: reference, weights: {sad-slow: 1}}\n"
      "  - {id: a, adjectives: {quickness: 0.4}, hold: [largeness]}\n");
  const Synthesis reference = synthesize(manifest.stimuli[0], repertoire());
  const Synthesis made = synthesize(manifest.stimuli[1], repertoire());
  const double wanted = value_of(rated_values(reference, repertoire()), "largeness");
  EXPECT_NEAR(made.held[0].second, wanted, 1e-12);
}

TEST(Hold, KeepsWhatAFoilAsReferenceHas) {
  const Manifest manifest = parsed(
      "  - {id: a, adjectives: {quickness: 0.4}, hold: [largeness]}\n"
      "  - {id: s, weights: {sad-slow: 1}, modify: {posture: {head-flexion: 10}, tempo: 0.9}}\n"
      "  - {id: r, role: reference, foil: {of: s, differ: posture}}\n");
  const auto& table = repertoire().parameters;
  const double sad =
      table.values(table.find("largeness"),
                   std::ranges::find(repertoire().names, "sad-slow", &RatedExample::name) -
                       repertoire().names.begin());
  EXPECT_NEAR(synthesize(manifest.stimuli[0], repertoire()).held[0].second, sad, 1e-12);
}

// Made anew when the reference changes, because what is held does.
TEST(Hold, IsInTheKeyWithItsReference) {
  const auto key_of = [](const std::string& reference, const std::string& hold) {
    const Manifest manifest =
        parsed("  - {id: r, role: reference, weights: {" + reference +
               ": 1}}\n  - {id: a, adjectives: {quickness: 0.4}" + hold + "}\n");
    KeyBuilder key;
    FileKeys files;
    add_motion(key, manifest.stimuli[1], files);
    return key.key();
  };
  EXPECT_NE(key_of("sad", ", hold: others"), key_of("happy", ", hold: others"));
  EXPECT_EQ(key_of("sad", ""), key_of("happy", ""));
  EXPECT_EQ(key_of("sad", ", hold: {largeness: 0.5}"), key_of("happy", ", hold: {largeness: 0.5}"));
}

TEST(Hold, TellsWhatItCouldNotKeep) {
  const Manifest manifest =
      parsed("  - {id: a, adjectives: {quickness: 0.7}, hold: {activeness: 0.1}}\n");
  const Synthesis made = synthesize(manifest.stimuli[0], repertoire());
  EXPECT_NEAR(made.reached[0].second, 0.7, 1e-6);
  ASSERT_EQ(made.warnings.size(), 1u);
  EXPECT_NE(made.warnings[0].find("activeness"), std::string::npos) << made.warnings[0];
}

std::string first_fault(const std::string& stimuli) {
  const ManifestReading reading =
      parse_manifest(head + stimuli, "m.yaml", [](const std::string&) { return std::nullopt; });
  return reading.faults.empty() ? "" : to_string(reading.faults.front());
}

TEST(Hold, IsOfAdjectivesAloneAndNotOfWhatIsAskedFor) {
  EXPECT_NE(first_fault("  - {id: a, weights: {sad: 1}, hold: others}\n").find("adjectives"),
            std::string::npos);
  EXPECT_NE(first_fault("  - {id: a, adjectives: {quickness: 0.4}, hold: [quickness]}\n")
                .find("already requested"),
            std::string::npos);
  EXPECT_NE(first_fault("  - {id: a, adjectives: {quickness: 0.4}, hold: {quickness: 0.5}}\n")
                .find("already requested"),
            std::string::npos);
}

/// The range that a sentence tells.
std::pair<double, double> range_in(const std::string& sentence) {
  const std::string before = "feasible range ";
  std::istringstream text(sentence.substr(sentence.find(before) + before.size()));
  double least = NAN, most = NAN;
  std::string to;
  text >> least >> to >> most;
  return {least, most};
}

// Wishes that exclude each other: what a blend has lies in the range that blends are told to have.
TEST(FeasibleParameters, AreToldInARangeThatTheBlendIsIn) {
  int impossible = 0;
  for (const char* method : {"reach", "cardinal", "knn"}) {
    for (const double quickness : {0.1, 0.5, 0.95}) {
      for (const double activeness : {0.1, 0.5, 0.9}) {
        const Manifest manifest = parsed(fmt::format(
            "  - {{id: a, adjectives: {{quickness: {}, activeness: {}, largeness: 0.9}}, "
            "interpolation: {{method: {}}}}}\n",
            quickness, activeness, method));
        const Synthesis made = synthesize(manifest.stimuli[0], repertoire());
        ASSERT_EQ(made.feasible.size(), 3u);
        for (std::size_t i = 0; i < 3; ++i) {
          if (made.feasible[i].range.miss <= 0.005) continue;
          ++impossible;
          const std::string sentence = to_sentence(made.feasible[i]);
          const auto [least, most] = range_in(sentence);
          EXPECT_GE(made.reached[i].second, least - 0.005) << method << ": " << sentence;
          EXPECT_LE(made.reached[i].second, most + 0.005) << method << ": " << sentence;
        }
      }
    }
  }
  EXPECT_GT(impossible, 20);
}

// Whatever the range says is made, and nothing beyond it.
TEST(FeasibleParameters, AreThoseThatCanBeMade) {
  const auto made_with = [](double quickness) {
    Stimulus stimulus;
    stimulus.id = "a";
    stimulus.adjectives = {{"quickness", quickness}, {"largeness", 0.5}};
    return synthesize(stimulus, repertoire());
  };
  const motion::ParameterRange range = made_with(0.5).feasible.at(0).range;
  EXPECT_LT(range.most, 0.95);
  EXPECT_NEAR(made_with(range.most - 1e-4).reached[0].second, range.most - 1e-4, 1e-6);
  EXPECT_NEAR(made_with(range.least + 1e-4).reached[0].second, range.least + 1e-4, 1e-6);
  const Synthesis beyond = made_with(range.most + 0.1);
  EXPECT_FALSE(beyond.feasible[0].is_feasible());
  ASSERT_FALSE(beyond.warnings.empty());
  EXPECT_NE(beyond.warnings[0].find("with largeness 0.50"), std::string::npos)
      << beyond.warnings[0];
}

// What is requested takes precedence over what is held: the range is that of what is made.
TEST(FeasibleParameters, GiveUpWhatIsHeldWhereItAloneForbids) {
  const Manifest manifest = parsed("  - {id: a, adjectives: {quickness: 0.6}, hold: others}\n");
  const Synthesis made = synthesize(manifest.stimuli[0], repertoire());
  ASSERT_EQ(made.feasible.size(), 1u);
  EXPECT_TRUE(made.feasible[0].is_feasible());
  EXPECT_NEAR(made.reached[0].second, 0.6, 1e-3);
  EXPECT_LE(made.feasible[0].range.least, made.reached[0].second);
  EXPECT_GE(made.feasible[0].range.most, made.reached[0].second);
}

// No blend of these has p and q at 0.9 together, so nothing is said to be met beside them.
TEST(FeasibleParameters, SayThatTheOthersCannotBeHad) {
  ParameterTable table;
  table.names = {"p", "q", "r"};
  table.values.resize(3, 3);
  table.values << 0.0, 1.0, 0.0,  //
      0.0, 0.0, 1.0,              //
      0.2, 0.4, 0.6;
  ParameterRequest wish;
  wish.sliders.sliders = table.names;
  wish.settings.resize(3);
  wish.settings << 0.9, 0.9, 0.5;
  const FeasibleParameter r = feasible_parameters(wish, table).at(2);
  EXPECT_GT(r.range.miss, 0.5);
  EXPECT_FALSE(r.is_feasible());
  EXPECT_NE(to_sentence(r).find("; no blend has "), std::string::npos) << to_sentence(r);
}

TEST(FeasibilityTable, HasALineAParameterAndMarksWhatIsNotFeasible) {
  const FeasibleParameter fine{
      .name = "pace", .requested = 0.5, .range = {.least = 0.4, .most = 0.6}};
  FeasibleParameter beyond = fine;
  beyond.requested = 0.9;
  beyond.others = {{"size", 0.25}};
  beyond.ignores_held = true;
  EXPECT_EQ(feasibility_table({}), "");
  EXPECT_EQ(feasibility_table({{"a", fine}, {"long-name", beyond}}),
            "stimulus   parameter  requested  feasible range  condition\n"
            "a          pace            0.50  0.40 to 0.60\n"
            "long-name  pace          ! 0.90  0.40 to 0.60    others as requested: size 0.25; held "
            "parameters free\n"
            "! requested value outside the feasible range\n");
}

TEST(Synthesis, TellsWhenAMotionIsNearlyOneCapture) {
  const auto notes_at = [](double share) {
    Stimulus stimulus;
    stimulus.id = "a";
    const auto row = [](const char* name) {
      return repertoire().parameters.values.row(repertoire().parameters.find(name));
    };
    for (const char* name : {"quickness", "clearness", "activeness", "largeness"}) {
      const double own = row(name)[3];
      stimulus.adjectives.emplace_back(name, share * own + (1.0 - share) * row(name).mean());
    }
    return synthesize(stimulus, repertoire()).notes;
  };
  ASSERT_EQ(notes_at(1.0).size(), 1u);
  EXPECT_NE(notes_at(1.0)[0].find(repertoire().names[3].name), std::string::npos);
  EXPECT_TRUE(notes_at(0.0).empty());
}

}  // namespace
}  // namespace mien::pipeline
