#include "pipeline/study/results/comparisons.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include <gtest/gtest.h>

#include "pipeline/study/results/confusion.h"
#include "pipeline/study/results/group_comparisons.h"
#include "pipeline/study/results/pair_preferences.h"
#include "pipeline/study/results/result_tables.h"
#include "pipeline/study/results/summaries.h"
#include "pipeline/study/results/two_emotions.h"

namespace mien::pipeline {
namespace {

Scale between(const std::string& low, const std::string& high) {
  Scale scale;
  scale.id = low + "-" + high;
  scale.low = low;
  scale.high = high;
  return scale;
}

/// Three people, three stimuli of one setting, two scales; `values` by person, stimulus, scale.
AnswerSet small_study(const std::vector<std::vector<std::vector<double>>>& values) {
  AnswerSet answer_set;
  answer_set.scales = {between("sad", "happy"), between("weak", "strong")};
  answer_set.stimuli = {{"walk", "as-is", "neutral", "woman", {}},
                        {"sad", "modified", "sad", "woman", {}},
                        {"acted-sad", "acted", "sad", "woman", {}}};
  answer_set.correction = TestCorrection::none;
  for (std::size_t person = 0; person < values.size(); ++person) {
    answer_set.people.push_back("p" + std::to_string(person));
    for (std::size_t stimulus = 0; stimulus < values[person].size(); ++stimulus)
      for (std::size_t scale = 0; scale < values[person][stimulus].size(); ++scale)
        answer_set.ratings.push_back({person, stimulus, scale, values[person][stimulus][scale]});
  }
  return answer_set;
}

const std::vector<std::vector<std::vector<double>>> answers_of_three = {
    {{0, 1}, {-1, 0}, {-2, 0}}, {{1, 0}, {-2, 0}, {-1, 1}}, {{0, -1}, {0, 0}, {-2, -1}}};

const Comparison* found(const std::vector<Comparison>& all, ComparisonFamily family,
                        std::size_t stimulus, std::size_t scale) {
  for (const Comparison& c : all)
    if (c.family == family && c.stimulus == stimulus && c.scale == scale) return &c;
  return nullptr;
}

TEST(Comparisons, AreMadeFromTheFactorsOfStimuli) {
  const std::vector<Comparison> all = compare(small_study(answers_of_three));
  EXPECT_EQ(all.size(), 3u * 2u + 2u + 2u + 2u + 1u);
  const Comparison* modified = found(all, ComparisonFamily::modified_acted, 1, 0);
  ASSERT_NE(modified, nullptr);
  EXPECT_EQ(modified->against, 2u);
  EXPECT_EQ(modified->intended_end, -1);
  EXPECT_EQ(modified->within.people, 3);
  EXPECT_DOUBLE_EQ(modified->mean, -1.0);
  EXPECT_DOUBLE_EQ(modified->mean_against, -5.0 / 3.0);
  EXPECT_NEAR(modified->within.t.mean, (1.0 - 1.0 + 2.0) / 3.0, 1e-12);
  EXPECT_EQ(modified->within.wilcoxon.used, 3);
  const Comparison* neutral = found(all, ComparisonFamily::modified_neutral, 1, 0);
  ASSERT_NE(neutral, nullptr);
  EXPECT_NEAR(neutral->within.t.mean, (-1.0 - 3.0 + 0.0) / 3.0, 1e-12);
  EXPECT_EQ(neutral->within.wilcoxon.zeros, 1);
  EXPECT_EQ(found(all, ComparisonFamily::modified_acted, 1, 1)->intended_end, 0);
  EXPECT_NE(found(all, ComparisonFamily::acted_neutral, 2, 0), nullptr);
}

TEST(Comparisons, HoldAVideoAgainstItsSettingInBothWays) {
  const std::vector<Comparison> all = compare(small_study(answers_of_three));
  const Comparison* best = found(all, ComparisonFamily::best_seen, 2, 0);
  ASSERT_NE(best, nullptr);
  // The thesis' way: all nine answers, its own three among them.
  EXPECT_EQ(best->answers_against, 9);
  EXPECT_NEAR(best->mean_against, -7.0 / 9.0, 1e-12);
  // Within persons: against the mean of the person's other two.
  EXPECT_NEAR(best->within.t.mean, ((-2 + 0.5) + (-1 + 0.5) + (-2 - 0)) / 3.0, 1e-12);
}

TEST(Comparisons, StayWithinASetting) {
  AnswerSet answer_set = small_study(answers_of_three);
  answer_set.stimuli[2].setting = "man";
  const std::vector<Comparison> all = compare(answer_set);
  EXPECT_EQ(found(all, ComparisonFamily::modified_acted, 1, 0), nullptr);
  EXPECT_EQ(found(all, ComparisonFamily::best_seen, 2, 0), nullptr);  // alone there
  EXPECT_EQ(found(all, ComparisonFamily::best_seen, 1, 0)->answers_against, 6);
}

TEST(Comparisons, AreCorrectedWithinTheirFamily) {
  AnswerSet answer_set = small_study(answers_of_three);
  answer_set.correction = TestCorrection::holm;
  for (const Comparison& c : compare(answer_set)) {
    if (std::isnan(c.within.t.p)) continue;
    const bool is_alone = c.family != ComparisonFamily::best_seen;  // one own scale, one other
    if (is_alone) {
      EXPECT_DOUBLE_EQ(c.paired_adjusted, c.within.t.p);
    } else {
      EXPECT_GE(c.welch_adjusted, c.welch.p);
    }
  }
}

TEST(Comparisons, SayNothingWhereAFewPeopleDifferByTheSame) {
  const WithinParticipants alike = within_participants({1.0, 1.0});
  EXPECT_TRUE(std::isnan(alike.t.p));
  EXPECT_DOUBLE_EQ(alike.wilcoxon.p, 0.5);
  const WithinParticipants equal = within_participants({0.0, 0.0, 0.0});
  EXPECT_TRUE(std::isnan(equal.t.p));
  EXPECT_DOUBLE_EQ(equal.wilcoxon.p, 1.0);
  EXPECT_EQ(equal.wilcoxon.zeros, 3);
}

TEST(Comparisons, WithoutParticipantsHaveNoStatistics) {
  const WithinParticipants none = within_participants({});
  EXPECT_EQ(none.people, 0);
  for (const double p : {none.t.p, none.wilcoxon.p, none.pratt.p, none.wilcoxon_normal,
                         none.wilcoxon_normal_corrected, none.wilcoxon_zsplit})
    EXPECT_TRUE(std::isnan(p));
  EXPECT_TRUE(std::isnan(none.wilcoxon.rank_biserial));
}

TEST(Comparisons, OverSettingsTurnEachEmotionToItsEnd) {
  AnswerSet answer_set;
  answer_set.scales = {between("sad", "happy")};
  answer_set.stimuli = {{"w-sad", "modified", "sad", "woman", {}},
                        {"w-acted-sad", "acted", "sad", "woman", {}},
                        {"m-happy", "modified", "happy", "man", {}},
                        {"m-acted-happy", "acted", "happy", "man", {}}};
  answer_set.people = {"p", "q", "r"};
  // p saw both emotions, q sadness alone, r one side alone.
  answer_set.ratings = {{0, 0, 0, -1}, {0, 1, 0, -2}, {0, 2, 0, 2}, {0, 3, 0, 1},
                        {1, 0, 0, 0},  {1, 1, 0, -1}, {2, 0, 0, -2}};
  const std::vector<OverallComparison> all = compare_overall(answer_set);
  ASSERT_EQ(all.size(), 2u);  // all, and sad: of happy there is one person
  EXPECT_EQ(all[0].emotion, "");
  EXPECT_EQ(all[0].within.people, 2);
  EXPECT_DOUBLE_EQ(all[0].mean, (1.5 + 0.0) / 2.0);
  EXPECT_DOUBLE_EQ(all[0].mean_against, (1.5 + 1.0) / 2.0);
  EXPECT_DOUBLE_EQ(all[0].within.t.mean, (0.0 - 1.0) / 2.0);
  EXPECT_EQ(all[1].emotion, "sad");
  EXPECT_DOUBLE_EQ(all[1].within.t.mean, -1.0);
}

/// Four videos of one setting on one scale; `values` by person and video.
AnswerSet four_videos(const std::vector<std::vector<double>>& values) {
  AnswerSet answer_set;
  answer_set.scales = {between("sad", "happy")};
  answer_set.stimuli = {{"own", "acted", "sad", "woman", {}},
                        {"b", "acted", "happy", "woman", {}},
                        {"c", "acted", "tired", "woman", {}},
                        {"d", "acted", "weak", "woman", {}}};
  answer_set.correction = TestCorrection::none;
  for (std::size_t person = 0; person < values.size(); ++person) {
    answer_set.people.push_back("p" + std::to_string(person));
    for (std::size_t stimulus = 0; stimulus < values[person].size(); ++stimulus)
      answer_set.ratings.push_back({person, stimulus, 0, values[person][stimulus]});
  }
  return answer_set;
}

// 1 − 1/3, 0 + 2/3 and −1 + 1/3 have three different sizes as doubles.
TEST(Comparisons, RankEqualDifferencesOfMeansAsTies) {
  const Comparison c = *found(compare(four_videos({{1, 0, 0, 1}, {0, -1, 0, -1}, {-1, -1, -1, 1}})),
                              ComparisonFamily::best_seen, 0, 0);
  EXPECT_EQ(c.within.wilcoxon.tied, 3);
  EXPECT_EQ(c.within.wilcoxon.w_plus, 4.0);  // two of three ranks of 2
  EXPECT_DOUBLE_EQ(c.within.wilcoxon.p, 1.0);
}

/// V of whole numbers, by the definition: for each positive one, how many are smaller or equal.
double v_of(const std::vector<int>& differences) {
  double v = 0.0;
  for (const int own : differences) {
    if (own <= 0) continue;
    v += 0.5;
    for (const int other : differences)
      if (other != 0) v += std::abs(other) < own ? 1.0 : std::abs(other) == own ? 0.5 : 0.0;
  }
  return v;
}

TEST(Comparisons, RankMeansOfAnswersAsWholeNumbersDo) {
  std::mt19937 random(8);
  std::uniform_int_distribution<int> answers(-2, 2);
  for (int study = 0; study < 60; ++study) {
    std::vector<std::vector<double>> values;
    std::vector<int> thrice;  // three times the difference from the mean of the others
    for (int person = 0; person < 26; ++person) {
      const int own = answers(random), b = answers(random), c = answers(random),
                d = answers(random);
      // Half of the people on a scale of seven points, at thirds of a point.
      values.push_back({own / 3.0, b / 3.0, c / 3.0, d / 3.0});
      thrice.push_back(3 * own - b - c - d);
    }
    const Comparison c = *found(compare(four_videos(values)), ComparisonFamily::best_seen, 0, 0);
    EXPECT_EQ(c.within.wilcoxon.w_plus, v_of(thrice));
    EXPECT_EQ(c.within.wilcoxon.zeros, std::ranges::count(thrice, 0));
    int sum = 0;
    for (const int value : thrice) sum += value;
    EXPECT_EQ(c.within.t.mean, static_cast<double>(sum) / (9 * 26));
  }
}

TEST(Comparisons, OverSettingsCompareLikeWithLikeAlone) {
  AnswerSet answer_set;
  answer_set.scales = {between("sad", "happy")};
  answer_set.stimuli = {{"w-sad", "modified", "sad", "woman", {}},
                        {"w-acted-sad", "acted", "sad", "woman", {}},
                        {"m-sad", "modified", "sad", "man", {}},
                        {"m-acted-sad", "acted", "sad", "man", {}}};
  answer_set.people = {"p", "q", "r", "s"};
  // p and q judged both of the woman; r the modified woman and the acted man; s both of both, but
  // the man's far apart.
  answer_set.ratings = {{0, 0, 0, -1}, {0, 1, 0, -2}, {1, 0, 0, 0},  {1, 1, 0, -1}, {2, 0, 0, -2},
                        {2, 3, 0, 2},  {3, 0, 0, -1}, {3, 1, 0, -1}, {3, 2, 0, 2},  {3, 3, 0, -2}};
  const std::vector<OverallComparison> all = compare_overall(answer_set);
  ASSERT_EQ(all.size(), 2u);
  for (const OverallComparison& c : all) {
    EXPECT_EQ(c.within.people, 3);
    EXPECT_EQ(c.unmatched, 1);
    EXPECT_EQ(c.matched, 4);
    EXPECT_DOUBLE_EQ(c.within.t.mean, (-1.0 - 1.0 + (0.0 - 4.0) / 2.0) / 3.0);
    EXPECT_DOUBLE_EQ(c.mean - c.mean_against, c.within.t.mean);
  }
}

TEST(Comparisons, HoldModifiedVideosAgainstTheOneSeenMost) {
  const std::vector<Comparison> all = compare(small_study(answers_of_three));
  const Comparison* best = found(all, ComparisonFamily::modified_best, 1, 0);
  ASSERT_NE(best, nullptr);
  EXPECT_EQ(best->against, 2u);  // −5/3 of the acted one, 1/3 of the neutral one
  EXPECT_EQ(found(all, ComparisonFamily::modified_best, 1, 1), nullptr);  // not of its emotion
  EXPECT_EQ(found(all, ComparisonFamily::modified_best, 2, 0), nullptr);  // not modified
}

TEST(Comparisons, HoldLevelsOfOneFactorAgainstEachOther) {
  const auto stimulus = [](const std::string& id, const Factors& factors) {
    ReportedStimulus one;
    one.id = id;
    one.factors = factors;
    return one;
  };
  const auto woman = stimulus("w", {{"actor", "woman"}, {"action", "walk"}, {"made", "acted"}});
  const auto man = stimulus("m", {{"actor", "man"}, {"action", "walk"}, {"made", "acted"}});
  const auto knock = stimulus("k", {{"actor", "man"}, {"action", "knock"}, {"made", "acted"}});
  const auto other = stimulus("o", {{"actor", "man"}, {"action", "walk"}, {"made", "modified"}});
  const auto plain = stimulus("p", {{"actor", "man"}, {"made", "acted"}});
  EXPECT_EQ(differing_factor(woman, man), "actor");
  EXPECT_EQ(differing_factor(man, knock), "action");
  EXPECT_FALSE(differing_factor(woman, knock));  // in two
  EXPECT_FALSE(differing_factor(woman, other));  // in making
  EXPECT_FALSE(differing_factor(man, plain));    // one has no action
  EXPECT_FALSE(differing_factor(man, man));
}

TEST(Comparisons, WriteSmallProbabilitiesAsTheyAre) {
  std::vector<std::vector<double>> values;
  for (int person = 0; person < 60; ++person)
    values.push_back({person % 3 == 0 ? -1.0 : -2.0, 2, person % 2 == 0 ? 1.0 : 2.0, 2});
  Results results;
  results.answer_set = four_videos(values);
  results.comparisons = compare(results.answer_set);
  double least = 1.0;
  for (const WrittenTable& table : result_tables(results)) {
    const CsvTable csv = parse_csv(table.csv, std::string(table.form.path));
    for (std::size_t column = 0; column < csv.header.size(); ++column) {
      const std::string& name = csv.header[column].text;
      if (name != "p" && !name.starts_with("p_") && name.find("_p") == std::string::npos) continue;
      for (const auto& row : csv.rows) {
        EXPECT_NE(row[column].text, "0") << name;
        if (!row[column].text.empty()) least = std::min(least, number_in(csv, row[column]));
      }
    }
  }
  EXPECT_LT(least, 1e-13);
  EXPECT_GT(least, 0.0);
}

TEST(GroupComparisons, AreWelchsOfThePeoplesOwnMeans) {
  AnswerSet answer_set = four_videos({{1}, {2}, {0}, {-1}, {2}, {0}});
  answer_set.worded_questions = {"gender"};
  ParticipantTable people{
      parse_csv("participant,session,gender,age\np0,s,woman,20\np1,s,woman,20\np2,s,man,20\n"
                "p3,s,man,20\np4,s,woman,20\np5,s,other,20\n",
                "participants.csv")};
  const std::vector<GroupComparison> all = compare_groups(people, answer_set);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].one, "woman");
  EXPECT_EQ(all[0].other, "man");
  EXPECT_EQ(all[0].people_one, 3);
  EXPECT_EQ(all[0].people_other, 2);
  const TTest expected = welch_t_test({1, 2, 2}, {0, -1});
  EXPECT_DOUBLE_EQ(all[0].welch.t, expected.t);
  EXPECT_DOUBLE_EQ(all[0].welch.p, expected.p);
  answer_set.worded_questions.clear();
  EXPECT_TRUE(compare_groups(people, answer_set).empty());
}

TEST(GroupComparisons, TellPeopleWhoShareAnIdApartByTheirSessions) {
  AnswerSet answer_set = four_videos({{1}, {2}, {0}, {-1}});
  answer_set.people = {"p0/a", "p0/b", "p1/a", "p1/b"};
  for (const std::string id : {"p0", "p1"})
    for (const std::string session : {"a", "b"})
      answer_set.person_of_session[{id, session}] = id + "/" + session;
  answer_set.worded_questions = {"gender"};
  const ParticipantTable people{parse_csv(
      "participant,session,gender\np0,a,woman\np1,b,man\np0,b,man\np1,a,woman\n", "people.csv")};
  const std::vector<GroupComparison> all = compare_groups(people, answer_set);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].people_one, 2);
  EXPECT_EQ(all[0].people_other, 2);
  EXPECT_EQ(people_by_answer(people, "gender", answer_set).at("woman"),
            (std::vector<std::size_t>{0, 2}));
  EXPECT_TRUE(ungrouped_sentences(people, answer_set).empty());

  const ParticipantTable without{parse_csv("participant,gender\np0,woman\np1,man\n", "people.csv")};
  EXPECT_TRUE(people_by_answer(without, "gender", answer_set).empty());
  const std::vector<std::string> told = ungrouped_sentences(without, answer_set);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_NE(told[0].find("no column session"), std::string::npos) << told[0];
}

TEST(GroupComparisons, LeaveNobodyOutBecauseOfVisitorsWithTheSameId) {
  AnswerSet answer_set = four_videos({{1}, {2}});
  answer_set.person_of_session = {{{"p0", "a"}, "p0"}, {{"p1", "b"}, "p1"}};
  const ParticipantTable people{
      parse_csv("participant,session,gender\np0,a,woman\np1,b,woman\np0,left,man\n", "people.csv")};
  const auto groups = people_by_answer(people, "gender", answer_set);
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_EQ(groups.at("woman"), (std::vector<std::size_t>{0, 1}));
}

TEST(GroupComparisons, NameThoseWhoAreInNoGroup) {
  AnswerSet answer_set = four_videos({{1}, {2}, {0}, {1}, {1}});
  for (const std::string& id : answer_set.people) answer_set.person_of_session[{id, "a"}] = id;
  answer_set.factorial.between = "gender";
  answer_set.worded_questions = {"gender", "hand"};
  const std::vector<std::string> told = ungrouped_sentences(
      {parse_csv("participant,session,gender,hand\np0,a,woman,left\np1,b,man,left\n"
                 "p2,a,woman,left\np2,a,woman,\np3,a,,\n",
                 "people.csv")},
      answer_set);
  const auto holds = [&](const std::string& beginning, const std::string& words) {
    return std::ranges::any_of(told, [&](const std::string& sentence) {
      return sentence.starts_with(beginning) && sentence.find(words) != std::string::npos;
    });
  };
  EXPECT_TRUE(holds("participants \"p1\", \"p4\" are in no group by \"gender\", \"hand\", because ",
                    "no row with the id and session"));
  EXPECT_TRUE(holds("participant \"p2\" is in no group by \"gender\", because ", "several rows"));
  EXPECT_TRUE(holds("participant \"p3\" is in no group by \"gender\", because ", "not answered"));
  EXPECT_EQ(told.size(), 3u);
  const std::vector<std::string> none = ungrouped_sentences({}, answer_set);
  ASSERT_EQ(none.size(), 1u);
  EXPECT_NE(none[0].find("no groups by \"gender\""), std::string::npos) << none[0];
}

TEST(BestSeen, NamesTheVideoFarthestTowardsEachEnd) {
  const AnswerSet answer_set = small_study(answers_of_three);
  const std::vector<BestSeen> best = best_seen(answer_set, compare(answer_set));
  ASSERT_EQ(best.size(), 4u);
  EXPECT_EQ(best[0].end, "sad");
  EXPECT_EQ(best[0].comparison.stimulus, 2u);
  EXPECT_EQ(best[1].end, "happy");
  EXPECT_EQ(best[1].comparison.stimulus, 0u);
}

TEST(PointsRule, GivesOnePointHalfWayAndTwoAtTheEnd) {
  const Scale scale = between("sad", "happy");
  EXPECT_EQ(points_of(scale, -2).low, 2.0);
  EXPECT_EQ(points_of(scale, -1).low, 1.0);
  EXPECT_EQ(points_of(scale, -1).high, 0.0);
  EXPECT_EQ(points_of(scale, 0).low + points_of(scale, 0).high, 0.0);
  EXPECT_EQ(points_of(scale, 2).high, 2.0);
  Scale seven = scale;
  seven.least = 1;
  seven.most = 7;
  EXPECT_EQ(points_of(seven, 7).high, 2.0);
  EXPECT_EQ(points_of(seven, 2.5).low, 1.0);
}

TEST(Confusion, IsTheShareOfPointsAsReckonedByHand) {
  const std::vector<Confusion> all = confusions_of(small_study(answers_of_three));
  ASSERT_EQ(all.size(), 3u);  // acted, modified, all
  const Confusion& acted = all[0];
  EXPECT_EQ(acted.of, "acted");
  ASSERT_EQ(acted.rows.size(), 1u);
  const ConfusionRow& sad = acted.rows[0];
  // sad 2 + 1 + 2; weak 0 + 0 + 1; strong 0 + 1 + 0
  EXPECT_EQ(sad.points, (std::vector<double>{5, 0, 1, 1}));
  EXPECT_DOUBLE_EQ(sad.recall, 5.0 / 7.0);
  EXPECT_EQ(sad.judged, 3);
  EXPECT_EQ(sad.hits, 2);  // of the second person, sad and strong have a point each
  EXPECT_DOUBLE_EQ(acted.chance, 0.25);
  EXPECT_EQ(sad.decided, 2);
  EXPECT_NEAR(sad.p, 1.0 / 16.0, 1e-12);
  // The modified one: sad 1 + 2 + 0, nothing of the third.
  EXPECT_EQ(all[1].rows[0].showings, 3);
  EXPECT_EQ(all[1].rows[0].judged, 2);
  EXPECT_DOUBLE_EQ(all[1].rows[0].recall, 1.0);
  // All: the neutral row has no column of its own.
  EXPECT_EQ(all[2].rows[0].own, -1);
  EXPECT_EQ(all[2].rows[1].showings, 6);
}

// With two scales of five points, one end alone is ahead of the others in two thirds of the
// presentations only.
TEST(Confusion, FindsNothingMoreOftenThanStatedInAnswersAtRandom) {
  std::mt19937_64 random(5);
  const auto answer = [&] { return static_cast<double>(random() % 5) - 2.0; };
  constexpr int studies = 400, people = 40;
  int found = 0;
  double hits = 0.0, decided = 0.0, judged = 0.0;
  for (int study = 0; study < studies; ++study) {
    AnswerSet answer_set = small_study({});
    answer_set.people.assign(people, "p");
    for (std::size_t person = 0; person < people; ++person)
      for (const std::size_t scale : {0u, 1u})
        answer_set.ratings.push_back(
            {.person = person, .stimulus = 1, .scale = scale, .value = answer()});
    const ConfusionRow row = confusions_of(answer_set).back().rows.front();
    ASSERT_EQ(row.emotion, "sad");
    found += row.p < 0.05 ? 1 : 0;
    hits += row.hits;
    decided += row.decided;
    judged += row.judged;
  }
  EXPECT_NEAR(hits / decided, 0.25, 0.02);
  EXPECT_LT(hits / judged, 0.2);
  EXPECT_LT(found, 0.05 * studies + 4.0 * std::sqrt(0.05 * 0.95 * studies));
}

// Half of the points, but never the most.
TEST(Confusion, IsNotAboveChanceByPointsAlone) {
  AnswerSet answer_set = small_study({});
  answer_set.people.assign(24, "p");
  for (std::size_t person = 0; person < 24; ++person) {
    answer_set.ratings.push_back({.person = person, .stimulus = 1, .scale = 0, .value = -1.0});
    answer_set.ratings.push_back({.person = person, .stimulus = 1, .scale = 1, .value = -2.0});
  }
  const ConfusionRow row = confusions_of(answer_set).back().rows.front();
  EXPECT_GT(row.recall, 0.25);
  EXPECT_EQ(row.hits, 0);
  EXPECT_LT(row.p, 0.01);
  EXPECT_FALSE(row.is_above(0.25));
}

TEST(Comparisons, HaveNoIntervalThatIsNotOneOfNinetyFivePercent) {
  for (int people = 1; people <= 8; ++people) {
    std::vector<double> differences;
    for (int i = 0; i < people; ++i) differences.push_back(0.1 * i * i - 0.5);
    const HodgesLehmann location = within_participants(differences).location;
    EXPECT_TRUE(std::isfinite(location.estimate)) << people;
    EXPECT_EQ(std::isfinite(location.low), people >= 6) << people;
    EXPECT_EQ(std::isfinite(location.high), people >= 6) << people;
  }
}

TEST(Confusion, OfChoicesCountsThem) {
  AnswerSet answer_set = small_study({});
  answer_set.people = {"p", "q"};
  answer_set.choices = {{"sad", "sad"}, {"happy", "happy"}};
  answer_set.chosen = {{0, 1, "sad"}, {1, 1, "happy"}, {0, 2, "sad"}, {1, 2, "sad"}};
  const std::vector<Confusion> all = confusions_of(answer_set);
  ASSERT_FALSE(all.empty());
  EXPECT_FALSE(all.back().by_points);
  EXPECT_EQ(all.back().rows[0].points, (std::vector<double>{3, 1}));
  EXPECT_EQ(all.back().rows[0].hits, 3);
}

TEST(EndCorrelations, SplitTheScalesAtTheirMiddle) {
  const AnswerSet answer_set = small_study(answers_of_three);
  const std::vector<EndCorrelation> all = end_correlations(answer_set);
  ASSERT_EQ(all.size(), 6u);
  EXPECT_TRUE(all[0].same_scale);
  EXPECT_LT(all[0].correlation.r, 0.0);
  EXPECT_EQ(all[0].correlation.pairs, 9);
  const Correlation direct = pearson({0, 1, 2, 0, 2, 1, 0, 0, 2}, {0, 0, 0, 0, 0, 0, 1, 0, 1});
  EXPECT_NEAR(all[1].correlation.r, direct.r, 1e-12);  // sad, weak
}

TEST(Summaries, CountTheAnswersAtEachPlace) {
  const std::vector<RatingSummary> all = summaries_of(small_study(answers_of_three));
  ASSERT_EQ(all.size(), 6u);
  EXPECT_EQ(all[2].stimulus, 1u);
  EXPECT_EQ(all[2].counts, (std::vector<int>{1, 1, 1, 0, 0}));
  EXPECT_DOUBLE_EQ(all[2].mean, -1.0);
  EXPECT_DOUBLE_EQ(all[2].median, -1.0);
  EXPECT_DOUBLE_EQ(all[2].deviation, 1.0);
}

TEST(Reliability, UsesWhatEverybodySaw) {
  AnswerSet answer_set = small_study(answers_of_three);
  const std::vector<Reliability> full = reliability_of(answer_set);
  ASSERT_EQ(full.size(), 2u);
  EXPECT_EQ(full[0].complete_people, 3);
  EXPECT_NEAR(full[0].alpha, full[0].intraclass.three_k, 1e-12);
  answer_set.ratings.erase(answer_set.ratings.begin());
  EXPECT_EQ(reliability_of(answer_set)[0].complete_people, 2);
  EXPECT_EQ(reliability_of(answer_set)[0].intraclass.answers, 8);
}

TEST(Preferences, AreCountedWhicheverSideTheyStoodOn) {
  AnswerSet answer_set = small_study({});
  answer_set.preferences = {{0, 1, 0, "sad-happy"}, {1, 0, 1, "sad-happy"}, {2, 1, 0, "sad-happy"}};
  const std::vector<PreferenceCount> counts = preferences_of(answer_set);
  ASSERT_EQ(counts.size(), 1u);
  EXPECT_EQ(counts[0].one, 0u);
  EXPECT_EQ(counts[0].for_one, 1);
  EXPECT_EQ(counts[0].trials, 3);
  EXPECT_DOUBLE_EQ(counts[0].p, 1.0);
}

}  // namespace
}  // namespace mien::pipeline
