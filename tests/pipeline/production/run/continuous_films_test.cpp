#include "pipeline/production/run/continuous_films.h"

#include <gtest/gtest.h>

#include "pipeline/base/documents/fault.h"
#include "pipeline/study/questionnaire/asked_study.h"

namespace mien::pipeline {
namespace {

std::string fault_of_films(const std::string& members, const VideoSeconds& seconds) {
  try {
    check_continuous_films(test::asked_study(2, "participants: 2, scales: [sad-happy], " + members),
                           seconds);
  } catch (const Faults& faults) {
    return faults.what();
  }
  return "";
}

TEST(ContinuousFilms, LastLongerThanLeadAndLagAndAtMostTenMinutes) {
  const std::string asked = "trials: continuous, continuous: {lead: 2}";
  EXPECT_EQ(fault_of_films(asked, {{"a1", 2.0}, {"b2", 600.0}}), "");
  EXPECT_NE(fault_of_films(asked, {{"a1", 1.9}, {"b2", 5.0}})
                .find("the film of \"a1\" lasts 1.9 s and is over before the lead of 2 s"),
            std::string::npos);
  EXPECT_NE(fault_of_films(asked, {{"a1", 5.0}, {"b2", 600.5}}).find("at most 600 s"),
            std::string::npos);
  EXPECT_NE(fault_of_films(asked + ", analysis: {lag: 3}", {{"a1", 4.5}})
                .find("the lead of 2 s and the lag of 3 s"),
            std::string::npos);
  EXPECT_EQ(fault_of_films("trials: rating", {{"a1", 0.5}, {"b2", 900.0}}), "");
}

}  // namespace
}  // namespace mien::pipeline
