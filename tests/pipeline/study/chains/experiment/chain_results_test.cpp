#include "pipeline/study/chains/experiment/chain_results.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>

#include <boost/math/distributions/normal.hpp>

#include "motion/live/live_core.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/manifest/reading/manifest_yaml.h"
#include "pipeline/study/chains/experiment/chain_dataset.h"
#include "pipeline/study/chains/experiment/chain_example.h"
#include "pipeline/study/chains/experiment/simulated_chains.h"
#include "pipeline/study/chains/experiment/word_prototypes.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

/// The answers of simulated people, written and read.
ChainAnswers read_back(const ChainExample& example, const std::vector<ChainAnswer>& answers) {
  const test::TemporaryFolder folder;
  write_file(folder.path() / "steps.csv", chain_steps_csv(answers, example.study.design));
  return read_chain_answers({folder.path() / "steps.csv"}, example.study);
}

std::vector<ChainAnswer> simulated(const ChainExample& example) {
  return simulated_chains(example.study, example.manifest.adaptive->across_participants,
                          usual_truth(example.study));
}

ChainResults results_of(const ChainExample& example) {
  return chain_results(example.study, read_back(example, simulated(example)),
                       {.across_participants = example.manifest.adaptive->across_participants});
}

/// Mean and standard deviation of a normal distribution that is truncated to a range.
std::pair<double, double> truncated(double mean, double deviation, const DimensionRange& range) {
  const boost::math::normal unit;
  const double a = (range.low - mean) / deviation, b = (range.high - mean) / deviation;
  const double z = cdf(unit, b) - cdf(unit, a);
  const double shift = (pdf(unit, a) - pdf(unit, b)) / z;
  const double variance = 1.0 + (a * pdf(unit, a) - b * pdf(unit, b)) / z - shift * shift;
  return {mean + deviation * shift, deviation * std::sqrt(variance)};
}

TEST(ChainResults, FindAKnownDistributionWithASlider) {
  const ChainExample example(
      "{participants: 40, method: gibbs, words: [sad, happy], space: {groups: all}, "
      "iterations: 12}");
  const ChainResults results = results_of(example);
  EXPECT_TRUE(results.simulated);
  EXPECT_EQ(results.incomplete, 0);
  const auto truth = usual_truth(example.study);
  for (const WordSamples& word : results.words) {
    ASSERT_EQ(word.chains, 40);
    ASSERT_EQ(word.samples, 240);
    for (std::size_t d = 0; d < word.dimensions.size(); ++d) {
      const WordTruth& of = truth.at(word.word);
      const DimensionRange& range = results.design.space[d];
      const auto [mean, deviation] = truncated(of.mean[d], of.deviation[d], range);
      EXPECT_NEAR(word.dimensions[d].mean.mean, mean, 0.05 * (range.high - range.low));
      EXPECT_NEAR(word.dimensions[d].deviation / deviation, 1.0, 0.2);
      EXPECT_LT(word.dimensions[d].r_hat, 1.1);
    }
  }
}

TEST(ChainResults, FindAKnownDistributionWithChoices) {
  const ChainExample example(
      "{participants: 20, method: mcmc, words: [sad], space: {groups: [quickness, largeness]}, "
      "iterations: 90, deviation: 0.25}");
  const ChainResults results = results_of(example);
  const WordTruth of = usual_truth(example.study).at("sad");
  for (std::size_t d = 0; d < 2; ++d) {
    const DimensionRange& range = results.design.space[d];
    const auto [mean, deviation] = truncated(of.mean[d], of.deviation[d], range);
    const DimensionSamples& found = results.words[0].dimensions[d];
    EXPECT_NEAR(found.mean.mean, mean, 0.05 * (range.high - range.low));
    EXPECT_NEAR(found.deviation / deviation, 1.0, 0.25);
  }
}

TEST(SimulatedChoices, AreByTheRatioOfProbabilities) {
  const ChainExample example(
      "{participants: 20, method: mcmc, words: [sad], space: {groups: [quickness, largeness]}, "
      "iterations: 90, deviation: 0.25}");
  const WordTruth truth = usual_truth(example.study).at("sad");
  const auto utility = [&](const std::vector<double>& point) {
    double sum = 0.0;
    for (std::size_t d = 0; d < point.size(); ++d)
      sum -= 0.5 * std::pow((point[d] - truth.mean[d]) / truth.deviation[d], 2);
    return sum;
  };
  double expected = 0.0, variance = 0.0;
  int chosen = 0;
  for (const ChainAnswer& one : simulated(example)) {
    const double p =
        1.0 / (1.0 + std::exp(utility(one.answer.point) - utility(one.answer.proposal)));
    expected += p;
    variance += p * (1.0 - p);
    chosen += one.answer.chose_proposal ? 1 : 0;
  }
  EXPECT_NEAR(chosen, expected, 3.5 * std::sqrt(variance));
}

TEST(ChainResults, OfManyPeopleComeNearTheMiddle) {
  const ChainExample example(shared_chains);
  const ChainResults results = results_of(example);
  ASSERT_EQ(results.paths.size(), 4u);
  for (const ChainPath& path : results.paths) {
    EXPECT_TRUE(path.is_complete);
    EXPECT_TRUE(path.name.participant.empty());
    ASSERT_EQ(path.points.size(), 6u);
  }
}

/// In how many of a number of studies the 90 % interval of a prototype has the true mean.
double share_of_intervals_with_the_truth(int studies) {
  int with = 0, all = 0;
  for (int study = 0; study < studies; ++study) {
    ChainExample example(
        "{participants: 8, method: gibbs, words: [sad], space: {groups: [quickness, largeness]}, "
        "iterations: 8, practice: 0}");
    example.study.design.seed = static_cast<std::uint64_t>(study);
    example.study.sessions =
        plan_chains(example.manifest, example.study.design, example.study.dimensions.at_examples);
    const auto truth = usual_truth(example.study);
    const ChainAnswers answers = read_back(example, simulated_chains(example.study, false, truth));
    const ChainResults results = chain_results(example.study, answers, {});
    for (std::size_t d = 0; d < 2; ++d) {
      const double mean =
          truncated(truth.at("sad").mean[d], truth.at("sad").deviation[d], results.design.space[d])
              .first;
      const IntervalEnds ends = chain_mean(results.words[0].dimensions[d].values, 0.9).ends;
      with += ends.low <= mean && mean <= ends.high ? 1 : 0;
      ++all;
    }
  }
  return static_cast<double>(with) / all;
}

TEST(ChainIntervals, HoldTheTruthAsOftenAsTheySay) {
  // 40 intervals: 0.9 ± 3 standard errors.
  const double share = share_of_intervals_with_the_truth(20);
  EXPECT_GE(share, 0.75);
}

TEST(ChainIntervals, HoldTheTruthAsOftenAsTheySayIn200Studies) {
  const double share = share_of_intervals_with_the_truth(200);
  RecordProperty("share", std::to_string(share));
  EXPECT_GE(share, 0.85);
  EXPECT_LE(share, 0.95);
}

TEST(ChainAnswers, AreWhatWasWritten) {
  for (const char* adaptive : {own_chains, own_choices, shared_chains}) {
    const ChainExample example(adaptive);
    const std::vector<ChainAnswer> written = simulated(example);
    const ChainAnswers read = read_back(example, written);
    std::vector<const ChainAnswer*> counted;
    for (const ChainAnswer& one : written)
      if (!one.is_practice) counted.push_back(&one);
    ASSERT_EQ(read.answers.size(), counted.size());
    for (std::size_t i = 0; i < counted.size(); ++i) {
      EXPECT_EQ(read.answers[i].of.answer.point, counted[i]->answer.point);
      EXPECT_EQ(read.answers[i].of.answer.value, counted[i]->answer.value);
      EXPECT_EQ(read.answers[i].of.answer.proposal, counted[i]->answer.proposal);
      EXPECT_EQ(read.answers[i].of.answer.chose_proposal, counted[i]->answer.chose_proposal);
    }
  }
}

/// What reading and following says of the written answers after a change.
std::string refusal(const ChainExample& example, std::vector<ChainAnswer> answers,
                    const std::function<void(std::vector<ChainAnswer>&)>& change) {
  change(answers);
  try {
    chain_paths(example.study, example.manifest.adaptive->across_participants,
                read_back(example, answers));
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST(ChainAnswers, AreRefusedWhereTheyDoNotFollow) {
  const ChainExample example(own_chains);
  const std::vector<ChainAnswer> answers = simulated(example);
  const auto says = [&](const std::function<void(std::vector<ChainAnswer>&)>& change) {
    return refusal(example, answers, change);
  };
  EXPECT_EQ(says([](auto&) {}), "");
  // Rows 1 and 2 of each participant are practice; row 4 is the second step of a chain.
  EXPECT_NE(says([](auto& rows) {
              rows[3].answer.point[0] += 0.001;
            }).find("steps.csv:5:1: the point is not the one"),
            std::string::npos);
  EXPECT_NE(says([](auto& rows) { rows.erase(rows.begin() + 3); }).find("step 1 of this chain"),
            std::string::npos);
  EXPECT_NE(says([](auto& rows) {
              rows[2].answer.point[0] += 0.01;
            }).find("no chain of the experiment starts"),
            std::string::npos);
  EXPECT_NE(says([](auto& rows) { rows[3].answer.value = 2.0; }).find("its range is"),
            std::string::npos);
  EXPECT_NE(says([](auto& rows) { rows[3].answer.word = "glad"; }).find("no word"),
            std::string::npos);
  EXPECT_NE(says([](auto& rows) { rows[3].design = "other"; }).find("not the design"),
            std::string::npos);
  EXPECT_NE(says([](auto& rows) { rows[3].simulated = false; }).find("simulated and real"),
            std::string::npos);
  EXPECT_NE(says([](auto& rows) { rows[3].answer.step = 99; }).find("it has 0 to 15"),
            std::string::npos);
}

TEST(ChainAnswers, OfTwoFilesAreReadOnceAndMayNotContradictEachOther) {
  const ChainExample example(own_chains);
  std::vector<ChainAnswer> answers = simulated(example);
  const test::TemporaryFolder folder;
  const auto first = folder.path() / "a.csv", second = folder.path() / "b.csv";
  write_file(first, chain_steps_csv(answers, example.study.design));
  write_file(second, chain_steps_csv(answers, example.study.design));
  const ChainAnswers twice = read_chain_answers({first, second}, example.study);
  EXPECT_EQ(twice.answers.size(), read_chain_answers({first}, example.study).answers.size());
  answers[3].answer.value = example.study.design.space[answers[3].answer.dimension].low;
  write_file(second, chain_steps_csv(answers, example.study.design));
  try {
    chain_paths(example.study, false, read_chain_answers({first, second}, example.study));
    FAIL() << "one of two different answers was dropped";
  } catch (const Faults& faults) {
    EXPECT_NE(std::string(faults.what()).find("b.csv:5:1: this step has been answered before"),
              std::string::npos)
        << faults.what();
  }
}

TEST(ChainAnswers, OfOneStepAreOfDifferentPeopleAndOneDimension) {
  const ChainExample example(shared_chains);
  const std::vector<ChainAnswer> answers = simulated(example);
  const auto of_first_step = [](std::vector<ChainAnswer>& rows, int person) -> ChainAnswer& {
    return *std::ranges::find_if(rows, [&](const ChainAnswer& one) {
      return !one.is_practice && one.answer.word == "sad" && one.answer.chain == 1 &&
             one.answer.step == 0 && one.answer.person == person;
    });
  };
  EXPECT_NE(refusal(example, answers, [&](auto& rows) { of_first_step(rows, 2).answer.person = 1; })
                .find("answered before"),
            std::string::npos);
  EXPECT_NE(refusal(example, answers,
                    [&](auto& rows) {
                      ChainRecord& record = of_first_step(rows, 2).answer;
                      record.dimension = 1 - record.dimension;
                      record.value = 0.5;
                    })
                .find("another dimension"),
            std::string::npos);
}

TEST(ChainAnswers, OfWhoLeftEarlyAreNotUsed) {
  const ChainExample example(own_chains);
  std::vector<ChainAnswer> answers = simulated(example);
  std::erase_if(answers,
                [](const ChainAnswer& one) { return one.participant == "p002" && one.trial > 20; });
  const ChainResults results = chain_results(example.study, read_back(example, answers), {});
  EXPECT_EQ(results.incomplete, 1);
  EXPECT_EQ(results.words[0].chains + results.words[1].chains, 7);
}

TEST(ChainAnswers, OfInattentiveParticipantsAreNotUsed) {
  const ChainExample example(checked_chains);
  std::vector<ChainAnswer> answers = simulated(example);
  const auto fail = [&](const std::string& participant, int count) {
    for (ChainAnswer& one : answers) {
      if (one.participant != participant || one.expected.empty() || count-- <= 0) continue;
      const DimensionRange& range = example.study.design.space[one.answer.dimension];
      one.answer.value = std::midpoint(range.low, range.high);
    }
  };
  fail("p002", 2);
  fail("p003", 1);
  const ChainAnswers read = read_back(example, answers);
  EXPECT_EQ(read.failed_checks.at("p002"), 2);
  const ChainResults results = chain_results(example.study, read, {.max_failed_checks = 1});
  EXPECT_EQ(results.inattentive, std::vector<std::string>{"p002"});
  for (const WordSamples& word : results.words) EXPECT_EQ(word.chains, 3);
  EXPECT_EQ(chain_results(example.study, read, {.max_failed_checks = 0}).inattentive.size(), 2u);
  EXPECT_EQ(chain_results(example.study, read, {.max_failed_checks = 2}).words[0].chains, 4);
}

TEST(AttentionChecks, ArePassedAtTheEndOrTheSideThatTheyAskFor) {
  ChainDesign design{.dimensions = {"a"}, .space = {{0.2, 0.6}}};
  const auto slid = [&](double value, bool is_reversed, const char* expected) {
    return passes_check(design, expected,
                        {.dimension = 0, .slider = {.is_reversed = is_reversed}, .value = value});
  };
  EXPECT_TRUE(slid(0.2, false, "left"));
  EXPECT_TRUE(slid(0.219, false, "left"));
  EXPECT_FALSE(slid(0.221, false, "left"));
  EXPECT_FALSE(slid(0.2, false, "right"));
  EXPECT_TRUE(slid(0.6, true, "left"));
  EXPECT_TRUE(slid(0.2, true, "right"));
  EXPECT_FALSE(slid(0.4, true, "right"));
  design.method = ChainMethod::mcmc;
  for (const bool is_first : {true, false})
    for (const bool is_chosen : {true, false}) {
      const ChainRecord record{
          .proposal = {0.3}, .is_proposal_first = is_first, .chose_proposal = is_chosen};
      // The first motion is at the left.
      EXPECT_EQ(passes_check(design, "left", record), is_first == is_chosen);
      EXPECT_EQ(passes_check(design, "right", record), is_first != is_chosen);
    }
}

TEST(ChainResults, EndOnceChainsAgree) {
  const ChainExample example(chains_until);
  const ChainResults results = results_of(example);
  const ChainEnd& end = *example.manifest.adaptive->until;
  for (const WordSamples& word : results.words) {
    // Half of the sweeps are samples, as many as R̂ was computed from.
    const int sweeps = word.discarded + word.samples / word.chains;
    EXPECT_GE(sweeps, end.at_least);
    EXPECT_LT(sweeps, end.at_most);
    EXPECT_EQ(word.discarded, sweeps / 2);
    for (const DimensionSamples& of : word.dimensions) EXPECT_LE(of.r_hat, end.r_hat);
  }
  // One sweep less was not enough, or too few.
  const ChainResults& all = results;
  for (const WordSamples& word : all.words) {
    const int sweeps = word.discarded + word.samples / word.chains;
    if (sweeps == end.at_least) continue;
    std::vector<std::vector<std::vector<double>>> paths;
    for (const ChainPath& path : all.paths)
      if (path.name.word == word.word) {
        paths.push_back(path.points);
        paths.back().resize(2 * static_cast<std::size_t>(sweeps - 1));
      }
    EXPECT_FALSE(have_converged(paths, 2, end.r_hat)) << word.word;
  }
}

TEST(WordRatings, AreHighestForWhatLooksLikeThePrototype) {
  const ChainExample example(
      "{participants: 20, method: gibbs, words: [sad, angry], space: {groups: all}, "
      "iterations: 8}");
  const ChainResults results = results_of(example);
  const ScaleSet scales = word_scales(example.manifest);
  ASSERT_EQ(scales.scales.size(), 2u);
  EXPECT_EQ(scales.scales[0].low, "not sad");
  const CsvTable table =
      parse_csv(word_ratings_csv(example.study, results, scales), "words.ratings.csv");
  std::map<std::string, std::vector<double>> values;
  for (const auto& row : table.rows) {
    if (row[2].text == "sad") values[row[1].text].push_back(number_in(table, row[3]));
    EXPECT_EQ(row[4].text, "1");
  }
  ASSERT_EQ(values.size(), 10u);
  std::map<std::string, double> means;
  for (const auto& [example_name, given] : values) {
    ASSERT_EQ(given.size(), 20u);
    means[example_name] = std::accumulate(given.begin(), given.end(), 0.0) / 20.0;
  }
  // The simulated people took the example for the word.
  for (const auto& [name, mean] : means) EXPECT_LE(mean, means["sad"] + 0.02) << name;
  EXPECT_GT(means["sad"], 1.5);
  EXPECT_LT(means["brisk"], 0.5);
}

TEST(WordRatings, MakeAdjectivesOfWords) {
  const ChainExample example(own_chains);
  const ChainResults results = results_of(example);
  const ScaleSet scales = word_scales(example.manifest);
  const test::TemporaryFolder folder;
  write_file(folder.path() / "words.ratings.csv", word_ratings_csv(example.study, results, scales));
  write_file(folder.path() / "words.scales.yaml",
             "name: words\nscales:\n  sad: {low: not sad, high: sad}\n  happy: {low: not happy, "
             "high: happy}\n");
  const ManifestReading read = parse_manifest(
      "mien: 1\nstudy: film\nexamples: {set: builtin:walks-10, ratings: words.ratings.csv, "
      "scales: words.scales.yaml}\nstimuli:\n  - {id: a, adjectives: {sad: 0.8}}\n",
      folder.path() / "film.yaml", [](const std::string&) { return std::nullopt; });
  ASSERT_TRUE(read.faults.empty()) << Faults(read.faults).what();
  Motions motions(read.manifest);
  const Eigen::VectorXd weights = motions.of("a").weights;
  const auto& names = motions.repertoire().names;
  Eigen::Index most = 0;
  weights.maxCoeff(&most);
  EXPECT_EQ(weights.size(), 10);
  EXPECT_NE(names[static_cast<std::size_t>(most)].name, "happy");
}

TEST(WordPrototypes, AreAManifestThatIsReady) {
  for (const char* adaptive :
       {own_chains, "{participants: 3, method: gibbs, words: [sad], space: {features: all}}",
        "{participants: 3, method: gibbs, words: [sad], space: {weights: [sad, happy, tired]}}",
        "{participants: 3, method: gibbs, words: [sad], space: {components: 2}}"}) {
    const ChainExample example(adaptive);
    const ChainResults results = results_of(example);
    const test::TemporaryFolder folder;
    write_file(folder.path() / "words.scales.yaml",
               "name: words\nscales:\n  sad: {low: not sad, high: sad}\n  happy: {low: not happy, "
               "high: happy}\n");
    const Manifest prototypes = prototype_manifest(example.manifest, example.study, results,
                                                   folder.path() / "words.scales.yaml");
    const ManifestReading again =
        parse_manifest(manifest_yaml(prototypes, folder.path()), folder.path() / "p.yaml",
                       [](const std::string&) { return std::nullopt; });
    EXPECT_TRUE(again.faults.empty()) << adaptive << Faults(again.faults).what();
    ASSERT_EQ(again.manifest.stimuli.size(), example.study.design.words.size());
    // The film is the motion that the participants saw of this point.
    Motions motions(again.manifest);
    motion::LiveCore core(example.study.bundle);
    const motion::LiveMotion seen = core.make({.kind = example.study.dimensions.kind,
                                               .sliders = example.study.design.dimensions,
                                               .values = results.words[0].prototype()});
    const Eigen::VectorXd& made = motions.of("sad").weights;
    ASSERT_EQ(made.size(), seen.weights.size());
    EXPECT_LT((made - seen.weights).cwiseAbs().maxCoeff(), 0.02) << adaptive;
  }
}

TEST(ChainAnswers, OfMoreParticipantsThanPlannedAreOfTheSameDesign) {
  const ChainExample example(own_chains);
  Motions motions(example.manifest);
  const ChainStudy more = chain_study(example.manifest, motions, 9);
  EXPECT_EQ(more.experiment.at("design"), example.study.experiment.at("design"));
  const ChainResults results = chain_results(
      example.study, read_back(example, simulated_chains(more, false, usual_truth(more))), {});
  EXPECT_EQ(results.words[0].chains, 9);
}

TEST(ChainDataset, HasEveryRowOnceAndDescribesItsColumns) {
  const ChainExample example(checked_chains);
  std::vector<ChainAnswer> answers = simulated(example);
  const test::TemporaryFolder folder;
  const auto first = folder.path() / "a.csv", second = folder.path() / "b.csv";
  const std::string all = chain_steps_csv(answers, example.study.design);
  write_file(first, all);
  EXPECT_EQ(joined_steps_csv({first}), all);
  EXPECT_EQ(joined_steps_csv({first, first}), all);
  // In two files that overlap.
  const std::vector<ChainAnswer> later(answers.begin() + 10, answers.end());
  answers.resize(20);
  write_file(first, chain_steps_csv(answers, example.study.design));
  write_file(second, chain_steps_csv(later, example.study.design));
  EXPECT_EQ(joined_steps_csv({first, second}), all);

  const ChainResults results = results_of(example);
  const auto files = chain_dataset("sad-walks 2", {first}, chain_tables(results), true);
  ASSERT_EQ(files.size(), 3u);
  EXPECT_EQ(files[0].first, "data/study-sadwalks2_description-steps_data.csv");
  const auto description = nlohmann::json::parse(files[1].second);
  EXPECT_EQ(description.at("@type"), "Dataset");
  EXPECT_TRUE(description.at("description").get<std::string>().starts_with("SIMULATED"));
  const CsvTable table = parse_csv(files[0].second, "steps.csv");
  ASSERT_EQ(description.at("variableMeasured").size(), table.header.size());
  for (std::size_t i = 0; i < table.header.size(); ++i)
    EXPECT_EQ(description.at("variableMeasured")[i].at("name"), table.header[i].text);
  // Everything else that lies at the top is named.
  for (const WrittenTable& one : chain_tables(results))
    EXPECT_NE(files[2].second.find(std::string(one.form.path) + "\n"), std::string::npos);
}

TEST(WordScales, AreInTheLanguagesOfThePages) {
  const Manifest manifest = chain_manifest(
      "{participants: 4, method: gibbs, language: {browser: [de, en, ja]}, words: {tired: {de: "
      "müde, en: tired, ja: 疲れた}}, space: {groups: all}}");
  const Scale scale = word_scales(manifest).scales.front();
  EXPECT_EQ(scale.low, "not tired");
  EXPECT_EQ(scale.high, "tired");
  EXPECT_EQ(scale.japanese_high, "疲れた");
  ASSERT_EQ(scale.words.size(), 1u);
  EXPECT_EQ(scale.words.front().first, "de");
  EXPECT_EQ(scale.words.front().second[0], "nicht müde");
}

TEST(WordPrototypes, HaveANameThatManifestsPermit) {
  ChainExample example(own_chains);
  example.manifest.study = std::string(64, 's');
  const Manifest prototypes = prototype_manifest(example.manifest, example.study,
                                                 results_of(example), "/words.scales.yaml");
  EXPECT_EQ(prototypes.study.size(), 64u);
  EXPECT_TRUE(prototypes.study.ends_with("s-simulated-prototypes"));
}

TEST(ChainPlots, NameWordsAndDimensionsAndSaySimulated) {
  const ChainExample example(own_chains);
  const ChainResults results = results_of(example);
  for (const Plot& plot :
       {chains_plot(results), prototypes_plot(results), densities_plot(results)}) {
    const auto canvas = Canvas::svg(plot.width, plot.height);
    plot.draw(*canvas);
    std::string all;
    for (const DrawnText& text : canvas->texts()) {
      all += text.text + "\n";
      EXPECT_GE(text.box.x, 0.0) << text.text;
      EXPECT_LE(text.box.right(), plot.width) << text.text;
      EXPECT_LE(text.box.bottom(), plot.height) << text.text;
    }
    for (const char* named : {"sad", "happy", "quickness", "largeness", "Simulated answers"})
      EXPECT_NE(all.find(named), std::string::npos) << named;
  }
}

}  // namespace
}  // namespace mien::pipeline
