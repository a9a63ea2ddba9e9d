#include "pipeline/production/design/confounds.h"

#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "pipeline/base/documents/csv.h"
#include "pipeline/manifest/checks/manifest_reader.h"

namespace mien::pipeline {
namespace {

std::size_t place_of_property(std::string_view id) {
  std::size_t i = 0;
  while (stimulus_properties[i].id != id) ++i;
  return i;
}

/// Stimuli with these levels of actor and mood, and the same values of all properties.
struct DesignedStudy {
  Manifest manifest;
  std::vector<PropertyValues> values;

  explicit DesignedStudy(const std::vector<std::pair<std::string, std::string>>& levels) {
    for (const auto& [actor, mood] : levels) {
      Stimulus& stimulus = manifest.stimuli.emplace_back();
      stimulus.path = "stimuli[" + std::to_string(manifest.stimuli.size() - 1) + "]";
      stimulus.id = "s" + std::to_string(manifest.stimuli.size());
      stimulus.factors = {{"actor", actor}, {"mood", mood}};
      PropertyValues& same = values.emplace_back();
      for (PropertyValue& value : same) value = {"a", 2.0};
    }
  }

  void set(std::string_view property, const std::vector<std::string>& texts) {
    for (std::size_t i = 0; i < texts.size(); ++i)
      values[i][place_of_property(property)].text = texts[i];
  }
  void set(std::string_view property, const std::vector<double>& numbers) {
    for (std::size_t i = 0; i < numbers.size(); ++i)
      values[i][place_of_property(property)].number = numbers[i];
  }

  FactorProperty relation(const std::string& factor, std::string_view property) const {
    for (const FactorProperty& one : factor_properties(manifest, values))
      if (one.factor == factor && one.property->id == property) return one;
    ADD_FAILURE() << "no relation of " << factor << " and " << property;
    return {};
  }

  /// What is wrong, a line each.
  std::string warnings() const {
    std::string text;
    for (const DesignWarning& one :
         confound_warnings(manifest, factor_properties(manifest, values)))
      text += one.path + ": " + one.wrong + "\n";
    return text;
  }
};

DesignedStudy crossed() {
  return DesignedStudy({{"k", "sad"}, {"k", "happy"}, {"t", "sad"}, {"t", "happy"}});
}

TEST(Confounds, AreTextsThatAreConstantWithinLevelsAndDifferBetweenThem) {
  DesignedStudy study = crossed();
  EXPECT_EQ(study.warnings(), "");
  study.set("set", std::vector<std::string>{"studio", "studio", "void", "void"});
  EXPECT_EQ(study.relation("actor", "set").relation, PropertyRelation::follows);
  EXPECT_EQ(study.relation("mood", "set").relation, PropertyRelation::varies);
  EXPECT_EQ(study.relation("actor", "camera").relation, PropertyRelation::same);
  EXPECT_EQ(study.warnings(),
            "stimuli[0].factors.actor: the set differs between the levels of the factor \"actor\" "
            "and is constant within them (k: studio; t: void)\n");
}

TEST(Confounds, AreSoundsOfLevelsOrThatOnlySomeLevelsHaveSound) {
  DesignedStudy study = crossed();
  study.set("sound", std::vector<std::string>{"low.wav", "low.wav", "high.wav", "high.wav"});
  EXPECT_EQ(study.relation("mood", "sound").relation, PropertyRelation::varies);
  EXPECT_EQ(study.warnings(),
            "stimuli[0].factors.actor: the sound differs between the levels of the factor "
            "\"actor\" and is constant within them (k: low.wav; t: high.wav)\n");
  study.set("sound", std::vector<std::string>{"a.wav", "b.wav", "c.wav", "d.wav"});
  EXPECT_EQ(study.warnings(), "");
  EXPECT_EQ(study.relation("actor", "sound").levels[0].text, "a.wav; b.wav");
  study.set("sound", std::vector<std::string>{"a.wav", "b.wav", "without", "without"});
  EXPECT_EQ(study.warnings(),
            "stimuli[0].factors.actor: the sound differs between the levels of the factor "
            "\"actor\" and is constant within them (k: with; t: without)\n");
}

TEST(Confounds, AreNumbersThatDifferLessThanAPercentWithinLevels) {
  DesignedStudy study = crossed();
  study.set("duration", std::vector<double>{2.0, 2.015, 3.0, 2.98});
  EXPECT_EQ(study.relation("actor", "duration").relation, PropertyRelation::follows);
  EXPECT_EQ(study.relation("mood", "duration").relation, PropertyRelation::varies);
  study.set("duration", std::vector<double>{2.0, 2.05, 3.0, 2.98});
  EXPECT_EQ(study.relation("actor", "duration").relation, PropertyRelation::varies);
  study.set("duration", std::vector<double>{2.0, 2.005, 2.01, 2.015});
  EXPECT_EQ(study.relation("actor", "duration").relation, PropertyRelation::same);
}

TEST(Confounds, GiveTheShareOfVarianceThatLevelsExplain) {
  DesignedStudy study = crossed();
  study.set("speed", std::vector<double>{1.0, 3.0, 5.0, 7.0});
  // Sums of squares: 20 in all, 2 · 2 · 2² between actors, 4 · 1² between moods.
  const FactorProperty actor = study.relation("actor", "speed");
  EXPECT_NEAR(actor.explained, 16.0 / 20.0, 1e-12);
  EXPECT_NEAR(study.relation("mood", "speed").explained, 4.0 / 20.0, 1e-12);
  EXPECT_EQ(actor.levels[1].level, "t");
  EXPECT_EQ(actor.levels[1].stimuli, 2);
  EXPECT_EQ(actor.levels[1].lowest, 5.0);
  EXPECT_EQ(actor.levels[1].mean, 6.0);
  EXPECT_EQ(actor.levels[1].highest, 7.0);
  study.set("speed", std::vector<double>{1.0, 1.0, 1.0, 1.0});
  EXPECT_TRUE(std::isnan(study.relation("actor", "speed").explained));
}

TEST(Confounds, OfSingleMotionsAreThoseOfTheirLookOnly) {
  DesignedStudy study({{"k", "sad"}, {"k", "happy"}});
  study.manifest.stimuli[0].factors = {{"mood", "sad"}};
  study.manifest.stimuli[1].factors = {{"mood", "happy"}};
  study.set("speed", std::vector<double>{0.7, 1.4});
  EXPECT_EQ(study.warnings(), "");
  study.set("camera", std::vector<std::string>{"side", "front"});
  EXPECT_NE(study.warnings().find("the camera differs"), std::string::npos);
}

TEST(Confounds, AreNotToldWhereTheyAreIntended) {
  DesignedStudy study = crossed();
  study.set("figure", std::vector<std::string>{"stick", "stick", "mannequin", "mannequin"});
  EXPECT_NE(study.warnings(), "");
  study.manifest.design.varies = {{"mood", {"figure"}}};
  EXPECT_NE(study.warnings(), "");
  study.manifest.design.varies = {{"actor", {"speed", "figure"}}};
  EXPECT_EQ(study.warnings(), "");
  EXPECT_EQ(study.relation("actor", "figure").relation, PropertyRelation::intended);
  study.manifest.design.varies.clear();
  for (Stimulus& stimulus : study.manifest.stimuli) stimulus.factors[0].first = "figure";
  EXPECT_EQ(study.warnings(), "");
}

TEST(Confounds, AreFactorsThatCannotBeToldApart) {
  DesignedStudy study({{"k", "sad"}, {"k", "sad"}, {"t", "happy"}, {"t", "happy"}});
  EXPECT_EQ(
      study.warnings(),
      "stimuli[0].factors.mood: the factors \"actor\" and \"mood\" cannot be told apart: each "
      "level of one occurs with one level of the other only\n");
  study.manifest.design.varies = {{"mood", {"actor"}}};
  EXPECT_EQ(study.warnings(), "");
  EXPECT_EQ(DesignedStudy({{"k", "sad"}, {"k", "happy"}, {"t", "happy"}}).warnings(), "");
  EXPECT_EQ(DesignedStudy({{"k", "sad"}, {"k", "sad"}, {"l", "sad"}, {"t", "happy"}}).warnings(),
            "")
      << "actors are nested in moods";
}

TEST(Confounds, LeaveOutWhatIsNotKnown) {
  DesignedStudy study = crossed();
  study.set("luminance", std::vector<double>{NAN, 0.5, 0.5, 0.5});
  for (const FactorProperty& one : factor_properties(study.manifest, study.values))
    EXPECT_STRNE(one.property->id, "luminance");
}

TEST(Confounds, AreATableOfAllPropertiesAndLevels) {
  DesignedStudy study = crossed();
  study.set("speed", std::vector<double>{1.0, 3.0, 5.0, 7.0});
  const CsvTable table =
      parse_csv(confounds_csv(factor_properties(study.manifest, study.values)), "confounds.csv");
  EXPECT_EQ(table.rows.size(), 2 * 2 * std::size(stimulus_properties));
}

std::string design_faults(const std::string& design) {
  const ManifestReading reading = parse_manifest(
      "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\nstimuli:\n"
      "  - {id: a, weights: {sad: 1}, factors: {actor: k}}\n"
      "design: " +
          design + "\n",
      "/nowhere/m.yaml", [](const std::string&) { return std::nullopt; });
  return reading.faults.empty() ? "" : Faults(reading.faults).what();
}

TEST(Design, RefusesUnknownFactorsAndProperties) {
  EXPECT_EQ(design_faults("{varies: {actor: [figure, speed]}, alike: [actor], threshold_m: 0.02}"),
            "");
  const auto holds = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  };
  EXPECT_TRUE(holds(design_faults("{varies: {aktor: [figure]}}"),
                    "m.yaml:6:19: design.varies.aktor: unknown factor; did you mean \"actor\"?"));
  EXPECT_TRUE(holds(design_faults("{varies: {actor: [figur]}}"),
                    "m.yaml:6:27: design.varies.actor[0]: unknown property \"figur\"; did you mean "
                    "\"figure\"?"));
  EXPECT_TRUE(holds(design_faults("{alike: [aktor]}"), "unknown factor \"aktor\""));
  EXPECT_TRUE(holds(design_faults("{threshold_m: -1}"), "m.yaml:6:23: design.threshold_m"));
}

}  // namespace
}  // namespace mien::pipeline
