#include "pipeline/manifest/checks/animation_checks.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "pipeline/base/reading/field_writer.h"
#include "pipeline/manifest/checks/manifest_reader.h"

namespace mien::pipeline {
namespace {

ManifestReading parse(const std::string& modify) {
  return parse_manifest(
      "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\nstimuli:\n- id: a\n  weights: "
      "{normal: 1}\n  modify: " +
          modify + "\n",
      "m.yaml", [](const std::string&) { return std::nullopt; });
}

std::string faults_in(const std::string& modify) {
  std::string text;
  for (const Fault& fault : parse(modify).faults) text += to_string(fault) + "\n";
  return text;
}

TEST(AnimationChecks, ReadKeysAndConstraints) {
  const ManifestReading reading = parse(
      "{emotion: sad, keys: [{at: 1.2 s, right-hand: [-0.3, 1.4, 0.4], reach: 0.7}, {at: frame 40, "
      "look_at: [0, 1.6, 3], relative: room}, {at: 2, pelvis: [0, 0.9, 0]}], constraints: [{part: "
      "right-hand, stays: position, from: 1.0 s, to: frame 60}, {part: left-hand, within: {y: "
      "[0.8, "
      "1.6]}}, {angle: left-elbow-flexion, at_least: 20}]}");
  ASSERT_TRUE(reading.faults.empty()) << Faults(reading.faults).what();
  const ModificationStep& step = reading.manifest.stimuli[0].modify[0];
  ASSERT_EQ(step.keys.size(), 3u);
  EXPECT_EQ(step.keys[0].at, (motion::Moment{1.2, false}));
  EXPECT_EQ(step.keys[0].places[static_cast<std::size_t>(motion::BodyEnd::right_hand)],
            motion::Vec3(-0.3, 1.4, 0.4));
  EXPECT_EQ(step.keys[0].reach, 0.7);
  EXPECT_EQ(step.keys[1].at, (motion::Moment{40.0, true}));
  EXPECT_EQ(step.keys[1].look_at, motion::Vec3(0.0, 1.6, 3.0));
  EXPECT_EQ(step.keys[1].frame, motion::PlaceFrame::room);
  EXPECT_EQ(step.keys[2].at, (motion::Moment{2.0, false}));
  ASSERT_EQ(step.constraints.size(), 3u);
  EXPECT_EQ(step.constraints[0].to, (motion::Moment{60.0, true}));
  EXPECT_EQ(step.constraints[0].stays, motion::Stays::position);
  EXPECT_FALSE(step.constraints[1].within[0]);
  EXPECT_EQ((*step.constraints[1].within[1])[1], 1.6);
  EXPECT_EQ(step.constraints[2].angle, motion::RangeAngle::left_elbow_flexion);
}

TEST(AnimationChecks, WriteWhatTheyRead) {
  const std::string modify =
      "{constraints: [{part: left-hand, follows: [{at: 1, place: [0, 1, 0]}, {at: frame 50, place: "
      "[0, 1.2, 0.1]}], reach: 0.3}, {part: left-hand, distance_to: head, at_most: 0.4, from: 1 "
      "s}], "
      "keys: [{at: frame 7, left-foot: [0.1, 0.2, 0.3], relative: motion}]}";
  const ModificationStep step = parse(modify).manifest.stimuli[0].modify[0];
  const OrderedJson once = written(step, {});
  const ModificationStep again = parse(once.dump()).manifest.stimuli[0].modify[0];
  EXPECT_EQ(written(again, {}), once);
  EXPECT_EQ(once["keys"][0]["at"], "frame 7");
  EXPECT_EQ(once["constraints"][0]["follows"][1]["place"], (OrderedJson{0.0, 1.2, 0.1}));
  EXPECT_EQ(again.constraints[1].distance_to, motion::BodyEnd::head);
}

TEST(AnimationChecks, RefuseWhatCannotBeMeant) {
  const struct {
    const char* modify;
    const char* fault;
  } cases[] = {
      {"{keys: [{at: soon, left-hand: [0, 1, 0]}]}",
       "m.yaml:7:24: stimuli[0].modify.keys[0].at: \"soon\" is no moment; write seconds (1.2 or "
       "1.2 "
       "s) or a frame counted from 0 (frame 40)\n"},
      {"{keys: [{at: -1, left-hand: [0, 1, 0]}]}", "keys[0].at: -1 is out of range"},
      {"{keys: [{at: 1, left-hand: [0, 1]}]}", "left-hand: has 2 elements but must have 3"},
      {"{keys: [{left-hand: [0, 1, 0]}]}", "keys[0].at: missing"},
      {"{keys: [{at: 1, pelvis: [0, 1, 0], lefthand: [0, 1, 0]}]}", "did you mean \"left-hand\""},
      {"{keys: [{at: 1, reach: 0.5}]}",
       "m.yaml:7:19: stimuli[0].modify.keys[0]: places nothing; add a part of the body, such as "
       "right-hand: [-0.3, 1.4, 0.4]\n"},
      {"{keys: [{at: 1, look_at: [0, 1, 1], relative: motion}]}", "use relative: body or room"},
      {"{keys: [{at: 1, pelvis: [0, 1, 0]}, {at: 1 s, pelvis: [0, 0.9, 0]}]}",
       "keys[1].pelvis: another key places it at the same moment; omit one of them"},
      {"[{keys: [{at: 1, pelvis: [0, 1, 0]}]}, {emotion: sad}]",
       "stimuli[0].modify[0].keys: later steps would change what they place; move them to the last "
       "step"},
      {"{method: hsu, neutral: normal, styled: sad, keys: [{at: 1, pelvis: [0, 1, 0]}]}",
       "keys: a step with a method has no other changes; make a list of two steps"},
      {"[{freeze: legs}, {emotion: sad}]", "freeze: later steps would change what they place"},
      {"{method: hsu, neutral: normal, styled: sad, freeze: legs}",
       "freeze: a step with a method has no other changes"},
      {"{freeze: feet}", "freeze"},
      {"[{ends: loop}, {emotion: sad}]", "ends: later steps would change the ends; move it"},
      {"{method: hsu, neutral: normal, styled: sad, ends: loop}",
       "ends: a step with a method has no other changes"},
      {"{ends: hold}", "ends"},
      {"{hands: scale}",
       "hands: fingers are scaled with the paths of the body, but these stay as they are"},
      {"{paths: 1.5, hands: scales}", "hands"},
      {"{method: hsu, neutral: normal, styled: sad, hands: scale}",
       "hands: a step with a method has no other changes"},
      {"{ends: {before: -1}}", "before"},
      {"{ends: {after: 61}}", "after"},
      {"{ends: {}}", "ends"},
      {"{freeze: {at: 1}}", "parts: missing"},
      {"{freeze: {parts: legs, at: later}}", "is no moment"},
      {"{constraints: [{part: left-hand}]}", "constraints[0]: has no condition; give one of stays"},
      {"{constraints: [{part: left-hand, stays: position, place: [0, 1, 0]}]}",
       "has several conditions"},
      {"{constraints: [{stays: position}]}", "does not say for which part of the body it is"},
      {"{constraints: [{part: head, place: [0, 1, 0]}]}", "the head cannot be moved by itself"},
      {"{constraints: [{part: pelvis, stays: orientation}]}", "cannot be turned by itself"},
      {"{constraints: [{part: pelvis, distance_to: head, at_most: 1}]}",
       "neither of the two parts is a hand"},
      {"{constraints: [{part: left-hand, distance_to: left-hand, at_most: 1}]}",
       "is the part itself; name another part"},
      {"{constraints: [{part: left-hand, distance_to: head}]}",
       "has no limits; add at_least or at_most"},
      {"{constraints: [{part: left-hand, stays: position, at_most: 1}]}",
       "only distances and angles have limits"},
      {"{constraints: [{angle: head-turn, at_least: 20, at_most: 10}]}",
       "at_least: is more than at_most; exchange them"},
      {"{constraints: [{part: left-hand, within: {z: [1, 0]}}]}",
       "within.z: the least is more than the most"},
      {"{constraints: [{part: left-hand, stays: position, from: 2, to: 1}]}",
       "to: is before from; give from before to"},
      {"{constraints: [{part: left-ear, stays: position}]}",
       "\"left-ear\" is not one of the choices"},
  };
  for (const auto& [modify, fault] : cases) {
    const std::string told = faults_in(modify);
    EXPECT_NE(told.find(fault), std::string::npos) << modify << "\n" << told;
    EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), 1) << told;
  }
}

TEST(AnimationChecks, LetFingersBeScaledWithAnyChangeOfPaths) {
  for (const char* modify :
       {"{paths: 1.4, hands: scale}", "{gains: {middle: 2}, hands: scale}",
        "{emotion: sad, paths: 1.2, hands: scale}", "{emotion: sad, hands: keep}"}) {
    EXPECT_EQ(faults_in(modify), "") << modify;
  }
  EXPECT_NE(faults_in("{emotion: sad, hands: scale}"), "");
}

}  // namespace
}  // namespace mien::pipeline
