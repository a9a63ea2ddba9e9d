#include "pipeline/study/results/participant_flow.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "pipeline/study/results/two_emotions.h"

namespace mien::pipeline {
namespace {

int count_of(const std::vector<FlowStage>& flow, const std::string& stage) {
  const auto found = std::ranges::find(flow, stage, &FlowStage::stage);
  return found == flow.end() ? -1 : found->sessions;
}

TEST(ParticipantFlow, CountsWhoLeftWhere) {
  const Manifest manifest = two_emotion_study(4);
  const AnswerSet answers = collect_answers(manifest, answers_to(manifest));
  const ParticipantTable table = {parse_csv(
      "participant,session,finished,ended,screening_fault\n"
      "p001,a,1,completed,\np002,b,1,completed,\np003,c,0,,\np004,d,1,completed,\n"
      "p005,e,0,screened_out,age\np006,f,0,screened_out,age\np007,g,0,screened_out,window\n",
      "participants.csv")};
  const std::vector<FlowStage> flow = participant_flow(answers, table);
  EXPECT_EQ(count_of(flow, "consented"), 7);
  EXPECT_EQ(count_of(flow, "turned away by the screening"), 3);
  EXPECT_EQ(count_of(flow, "turned away by the screening: age"), 2);
  EXPECT_EQ(count_of(flow, "turned away by the screening: window"), 1);
  EXPECT_EQ(count_of(flow, "did not reach the last page"), 1);
  EXPECT_EQ(count_of(flow, "reached the last page"), 3);
  EXPECT_EQ(count_of(flow, "gave answers"), 4);
  EXPECT_EQ(count_of(flow, "of these, left out of the analysis"), 0);
  EXPECT_EQ(count_of(flow, "analysed"), 4);
}

TEST(ParticipantFlow, IsNotToldFromATableWithoutEnds) {
  const Manifest manifest = two_emotion_study(4);
  const AnswerSet answers = collect_answers(manifest, answers_to(manifest));
  EXPECT_TRUE(participant_flow(answers, {}).empty());
  EXPECT_TRUE(
      participant_flow(answers, {parse_csv("participant,finished\np001,1\n", "p.csv")}).empty());
}

}  // namespace
}  // namespace mien::pipeline
