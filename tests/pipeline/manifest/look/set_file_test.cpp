#include "pipeline/manifest/look/set_file.h"

#include <gtest/gtest.h>

#include "motion/error.h"
#include "pipeline/base/documents/fault.h"

namespace mien::pipeline {
namespace {

std::string faults_of_set(const std::string& yaml) {
  try {
    parse_set(yaml, "my.set.yaml");
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(SetFile, EverySetOfTheProgramIsReadAndCanBeStaged) {
  for (const std::string& name : set_names()) {
    const scenes::SetPlan plan = read_set(name, {});
    EXPECT_EQ(plan.name, name);
    EXPECT_FALSE(plan.lights.empty()) << name;
    EXPECT_NO_THROW(render::validate(scenes::static_scene(plan, {}))) << name;
  }
  EXPECT_FALSE(read_set("void", {}).ground);
  EXPECT_TRUE(read_set("treadmill", {}).belt && read_set("treadmill", {}).in_place);
  EXPECT_EQ(read_set("corridor", {}).walls.size(), 2u);
  EXPECT_EQ(read_set("lab-grid", {}).ground->major_every, 10);
}

TEST(SetFile, TheStudioIsWhatItAlwaysWas) {
  const scenes::SetPlan plan = read_set("studio", {});
  ASSERT_TRUE(plan.ground);
  EXPECT_EQ(plan.ground->albedo[0], 0.70f);
  EXPECT_EQ(plan.ground->line_albedo[1], 0.53f);
  EXPECT_EQ(plan.ground->line_spacing, 0.5f);
  EXPECT_EQ(plan.ground->line_width, 0.010f);
  EXPECT_EQ(plan.ground->fade_end, 30.0f);
  EXPECT_EQ(plan.sky.horizon[1], 0.365f);
  ASSERT_EQ(plan.lights.size(), 1u);
  EXPECT_EQ(plan.lights[0].azimuth_degrees, -28.0);
  EXPECT_EQ(plan.lights[0].strength, 0.58);
}

TEST(SetFile, TellsEveryFaultWithItsPlace) {
  EXPECT_EQ(faults_of_set("background: \"#808080\"\ngruond: {colour: \"#808080\"}\n"),
            "my.set.yaml:2:1: gruond: unknown key; did you mean \"ground\"?");
  EXPECT_EQ(faults_of_set("background: grey\n"),
            "my.set.yaml:1:13: background: \"grey\" is no colour; write # and six hexadecimal "
            "digits, for "
            "example #808080");
  EXPECT_EQ(faults_of_set("name: x\n"),
            "my.set.yaml:1:1: background: missing; add it, for example background: #808080");
  EXPECT_EQ(
      faults_of_set("background: \"#808080\"\nground: {colour: \"#808080\", fade: [30, 6]}\n"),
      "my.set.yaml:2:35: ground.fade: fading of the floor ends before it begins; write the smaller "
      "value first");
  EXPECT_EQ(faults_of_set("background: \"#808080\"\nground: {colour: [1.4, 1, 1]}\n"),
            "my.set.yaml:2:19: ground.colour[0]: 1.4 is out of range; use a number from 0 to 1");
  EXPECT_EQ(faults_of_set("background: \"#808080\"\nbelt: {colour: \"#808080\"}\n"),
            "my.set.yaml:2:1: belt: a belt requires a figure walking in place; add in_place: true");
}

}  // namespace
}  // namespace mien::pipeline
