#include "pipeline/study/adaptive/next_films.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "motion/error.h"
#include "pipeline/base/statistics/gaussian_process.h"
#include "pipeline/base/statistics/named_random.h"

namespace mien::pipeline {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

/// Examples at random places of a space of three parameters.
MatrixXd random_places(int count, std::uint64_t seed) {
  return MatrixXd::NullaryExpr(count, 3, [&](Index i, Index j) {
    return uniform(seed, "place/" + std::to_string(i) + "/" + std::to_string(j));
  });
}

/// What all people together would answer: a smooth function of the parameters.
double true_rating(const RowVectorXd& place) {
  return 2.0 * place[0] + std::sin(3.0 * place[1]) + place[0] * place[1] - 0.5 * place[2];
}

/// The mean answer of some people, whose answers have a standard deviation of 0.4.
constexpr double answer_deviation = 0.4;
double rated(const RowVectorXd& place, int answers, std::uint64_t seed, const std::string& film) {
  return true_rating(place) + answer_deviation / std::sqrt(answers) * normal(seed, film);
}

RatedFilms rated_films(const std::vector<FilmCandidate>& candidates,
                       const std::vector<std::size_t>& films, int answers, std::uint64_t seed) {
  RatedFilms result{.scale = "sad-happy", .answer_variance = answer_deviation * answer_deviation};
  const auto count = static_cast<Index>(films.size());
  result.places.resize(count, candidates.front().place.size());
  result.mean.resize(count);
  result.answers.setConstant(count, answers);
  for (Index i = 0; i < count; ++i) {
    const std::size_t film = films[static_cast<std::size_t>(i)];
    result.places.row(i) = candidates[film].place;
    result.mean[i] = rated(candidates[film].place, answers, seed, std::to_string(film));
  }
  return result;
}

/// Root mean square error of expected ratings over all candidates.
double error_with(const std::vector<FilmCandidate>& candidates, const RatedFilms& films) {
  GroupedObservations o;
  o.predictors = films.places;
  o.values = films.mean;
  o.noise_variance = films.answer_variance * films.answers.cast<double>().cwiseInverse();
  for (Index i = 0; i < films.mean.size(); ++i) o.group.push_back(static_cast<int>(i));
  MatrixXd places(static_cast<Index>(candidates.size()), films.places.cols());
  for (std::size_t c = 0; c < candidates.size(); ++c)
    places.row(static_cast<Index>(c)) = candidates[c].place;
  const RowVectorXd mean = places.colwise().mean();
  const RowVectorXd spread =
      (places.rowwise() - mean).array().square().colwise().mean().sqrt().matrix();
  const auto standardised = [&](MatrixXd z) {
    z.rowwise() -= mean;
    for (Index d = 0; d < z.cols(); ++d) z.col(d) /= spread[d];
    return z;
  };
  o.predictors = standardised(o.predictors);
  const VectorXd expected =
      jointly_predicted(fit_process({{0, 1, 2}}, o), standardised(places)).mean;
  double sum = 0.0;
  for (std::size_t c = 0; c < candidates.size(); ++c)
    sum += std::pow(expected[static_cast<Index>(c)] - true_rating(candidates[c].place), 2);
  return std::sqrt(sum / static_cast<double>(candidates.size()));
}

std::vector<std::size_t> first_films() { return {0, 1, 2, 3}; }

TEST(FilmCandidates, AreTheExamplesAndDistinctBlendsOfTwoOrThree) {
  const MatrixXd examples = random_places(7, 1);
  const auto candidates = film_candidates(examples, 300, true, 5);
  ASSERT_EQ(candidates.size(), 300u);
  std::set<std::vector<double>> distinct;
  std::set<std::ptrdiff_t> parts;
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    const auto& [weights, place] = candidates[c];
    EXPECT_NEAR(weights.sum(), 1.0, 1e-12);
    EXPECT_GE(weights.minCoeff(), 0.0);
    EXPECT_TRUE(((100.0 * weights).array().round() / 100.0).matrix().isApprox(weights, 1e-12));
    EXPECT_TRUE(place.isApprox(weights.transpose() * examples, 1e-12));
    const auto used = (weights.array() > 0.0).count();
    if (c < 7)
      EXPECT_EQ(weights[static_cast<Index>(c)], 1.0);
    else
      parts.insert(used);
    distinct.emplace(weights.begin(), weights.end());
  }
  EXPECT_EQ(distinct.size(), 300u);
  EXPECT_EQ(parts, (std::set<std::ptrdiff_t>{2, 3}));
  const auto again = film_candidates(examples, 300, true, 5);
  for (std::size_t c = 0; c < candidates.size(); ++c)
    EXPECT_EQ(again[c].weights, candidates[c].weights);
  EXPECT_NE(film_candidates(examples, 300, true, 6)[20].weights, candidates[20].weights);
}

TEST(FilmCandidates, AreAsManyAsThereAre) {
  EXPECT_EQ(film_candidates(random_places(7, 1), 300, false, 5).size(), 7u);
  EXPECT_EQ(film_candidates(random_places(1, 1), 300, true, 5).size(), 1u);
  // Two examples have 99 blends in steps of a hundredth.
  EXPECT_LE(film_candidates(random_places(2, 1), 500, true, 5).size(), 101u);
}

// The choice of each film by brute force: the process is made anew with each film as if it had been
// rated, and the variances are added up.
TEST(NextFilms, AreThoseAfterWhichTheLeastIsUnknown) {
  const auto candidates = film_candidates(random_places(6, 2), 40, true, 3);
  const RatedFilms films = rated_films(candidates, first_films(), 10, 4);
  MatrixXd places(40, 3);
  for (Index c = 0; c < 40; ++c) places.row(c) = candidates[static_cast<std::size_t>(c)].place;
  const RowVectorXd mean = places.colwise().mean();
  const RowVectorXd spread =
      (places.rowwise() - mean).array().square().colwise().mean().sqrt().matrix();
  for (Index c = 0; c < 40; ++c) places.row(c) = (places.row(c) - mean).cwiseQuotient(spread);
  GroupedObservations o;
  o.predictors = places.topRows(4);
  o.values = films.mean;
  o.noise_variance.setConstant(4, films.answer_variance / 10.0);
  o.group = {0, 1, 2, 3};
  const GaussianProcess process = fit_process({{0, 1, 2}}, o);
  std::vector<std::size_t> expected;
  std::vector<double> left;
  for (int step = 0; step < 3; ++step) {
    double least = 1e300;
    std::size_t best = 0;
    for (Index c = 0; c < 40; ++c) {
      GroupedObservations more = o;
      const Index n = o.predictors.rows();
      more.predictors.conservativeResize(n + 1, 3);
      more.predictors.row(n) = places.row(c);
      more.values.conservativeResize(n + 1);
      more.values[n] = 0.0;  // variances do not depend on it
      more.noise_variance.conservativeResize(n + 1);
      more.noise_variance[n] = films.answer_variance / 5.0;
      more.group.push_back(static_cast<int>(n));
      const double sum =
          jointly_predicted(process_with({{0, 1, 2}}, more, process.parameters), places)
              .covariance.trace();
      const bool is_free =
          c >= 4 && std::ranges::find(expected, static_cast<std::size_t>(c)) == expected.end();
      if (is_free && sum < least) {
        least = sum;
        best = static_cast<std::size_t>(c);
      }
    }
    expected.push_back(best);
    left.push_back(std::sqrt(least / 40.0));
    const Index n = o.predictors.rows();
    o.predictors.conservativeResize(n + 1, 3);
    o.predictors.row(n) = places.row(static_cast<Index>(best));
    o.values.conservativeResize(n + 1);
    o.values[n] = 0.0;
    o.noise_variance.conservativeResize(n + 1);
    o.noise_variance[n] = films.answer_variance / 5.0;
    o.group.push_back(static_cast<int>(n));
  }
  const NextFilms next =
      next_films(candidates, {films}, {.films = 3, .aim = {}, .answers = 5, .apart = 1e-6});
  std::vector<std::size_t> found;
  for (const NextFilm& film : next.films) found.push_back(film.candidate);
  EXPECT_EQ(found, expected);
  EXPECT_NEAR(next.known_then[0], left.back(), 1e-6);
  EXPECT_LT(next.known_then[0], next.known_now[0]);
  EXPECT_GT(next.films[0].gain, next.films[2].gain);
}

// The choice of the first films by brute force: the variances that are left once films are rated,
// from the covariance of what is usual before anything is known.
TEST(NextFilms, AreChosenByTheirParametersAloneWhereNothingIsRated) {
  const auto candidates = film_candidates(random_places(6, 2), 40, true, 3);
  MatrixXd places(40, 3);
  for (Index c = 0; c < 40; ++c) places.row(c) = candidates[static_cast<std::size_t>(c)].place;
  const RowVectorXd mean = places.colwise().mean();
  const RowVectorXd spread =
      (places.rowwise() - mean).array().square().colwise().mean().sqrt().matrix();
  for (Index c = 0; c < 40; ++c) places.row(c) = (places.row(c) - mean).cwiseQuotient(spread);
  MatrixXd prior(40, 40);
  for (Index a = 0; a < 40; ++a)
    for (Index b = 0; b < 40; ++b)
      prior(a, b) =
          1.0 + std::exp(-0.7 - 0.5 * (places.row(a) - places.row(b)).squaredNorm() / 3.0);
  const double noise = std::exp(-2.0) + std::exp(-3.0) + 2.0 / 5.0;
  const auto left_after = [&](const std::vector<Index>& films) {
    MatrixXd observed = prior(films, films);
    observed.diagonal().array() += noise;
    const MatrixXd shared = prior(films, Eigen::all);
    return (prior - shared.transpose() * observed.ldlt().solve(shared)).trace();
  };
  std::vector<Index> expected;
  for (int step = 0; step < 4; ++step) {
    Index best = 0;
    double least = 1e300;
    for (Index c = 0; c < 40; ++c) {
      if (std::ranges::find(expected, c) != expected.end()) continue;
      std::vector<Index> films = expected;
      films.push_back(c);
      if (const double left = left_after(films); left < least) {
        least = left;
        best = c;
      }
    }
    expected.push_back(best);
  }
  const NextFilms first = next_films(candidates, {}, {.films = 4, .answers = 5, .apart = 1e-6});
  ASSERT_EQ(first.films.size(), 4u);
  for (std::size_t f = 0; f < 4; ++f)
    EXPECT_EQ(static_cast<Index>(first.films[f].candidate), expected[f]);
  EXPECT_NEAR(first.films[0].gain, 1.0 - left_after({expected[0]}) / prior.trace(), 1e-9);
  EXPECT_TRUE(first.known_now.empty() && first.known.empty() && first.films[0].mean.empty());
  EXPECT_THROW(next_films(candidates, {}, {.aim = {.scale = "sad-happy"}}), Error);
}

TEST(NextFilms, AreApartFromThoseThatArePlanned) {
  const auto candidates = film_candidates(random_places(6, 2), 40, true, 3);
  const NextOptions options{.films = 3, .apart = 0.4};
  const NextFilms first = next_films(candidates, {}, options);
  NextOptions again = options;
  again.planned.resize(3, 3);
  for (Index f = 0; f < 3; ++f)
    again.planned.row(f) = candidates[first.films[static_cast<std::size_t>(f)].candidate].place;
  MatrixXd places(40, 3);
  for (Index c = 0; c < 40; ++c) places.row(c) = candidates[static_cast<std::size_t>(c)].place;
  const Standardisation by = standardisation_of(places);
  const MatrixXd planned = by.of(again.planned);
  places = by.of(places);
  const NextFilms second = next_films(candidates, {}, again);
  ASSERT_FALSE(second.films.empty());
  for (const NextFilm& film : second.films)
    for (Index f = 0; f < 3; ++f)
      EXPECT_GE((places.row(static_cast<Index>(film.candidate)) - planned.row(f)).norm(),
                0.4 * std::sqrt(3.0));
}

// Over twenty worlds, the best of four films is far nearer to the best that can be made than the
// best of four random ones.
TEST(NextFilms, AreChosenByExpectedImprovement) {
  for (const double sign : {1.0, -1.0}) {
    double missed = 0.0, missed_by_random = 0.0;
    for (std::uint64_t world = 1; world <= 20; ++world) {
      const auto candidates = film_candidates(random_places(8, world), 200, true, world);
      const RatedFilms films = rated_films(candidates, {0, 1, 2, 3, 4}, 40, world);
      NextOptions options{.films = 4, .aim = {"sad-happy", sign > 0.0}, .answers = 40};
      const NextFilms next = next_films(candidates, {films}, options);
      ASSERT_EQ(next.films.size(), 4u);
      double best = -1e9, found = -1e9, found_by_random = -1e9;
      for (std::size_t c = 0; c < candidates.size(); ++c) {
        const double value = sign * true_rating(candidates[c].place);
        best = std::max(best, value);
        if (c % 50 == world % 50) found_by_random = std::max(found_by_random, value);
      }
      for (const NextFilm& film : next.films)
        found = std::max(found, sign * true_rating(candidates[film.candidate].place));
      missed += best - found;
      missed_by_random += best - found_by_random;
      EXPECT_GE(next.films[0].gain, next.films[1].gain);
      EXPECT_GE(next.films[3].gain, 0.0);
    }
    EXPECT_LT(missed, 0.4 * missed_by_random) << missed << " against " << missed_by_random;
  }
}

// Over ten worlds, films that are chosen two at a time, the first four among them, need at most
// 60 % of the number that random ones need for the same error.
TEST(NextFilms, LearnWithFewerThanRandomOnes) {
  double chosen_needed = 0.0, random_needed = 0.0;
  for (std::uint64_t world = 1; world <= 10; ++world) {
    const auto candidates = film_candidates(random_places(12, world), 150, true, world);
    constexpr std::size_t most = 40;
    std::vector<double> random_error, chosen_error;
    std::vector<std::size_t> random_order, chosen;
    for (const NextFilm& film :
         next_films(candidates, {}, {.films = 4, .answers = 8, .apart = 1e-6}).films)
      chosen.push_back(film.candidate);
    for (std::size_t draw = 0; random_order.size() < most; ++draw) {
      const auto film =
          static_cast<std::size_t>(150.0 * uniform(world, "random/" + std::to_string(draw)));
      if (std::ranges::find(random_order, film) == random_order.end()) random_order.push_back(film);
    }
    for (std::size_t n = 4; n <= most; n += 2) {
      random_error.push_back(error_with(
          candidates,
          rated_films(candidates, {random_order.begin(), random_order.begin() + n}, 8, world)));
      const RatedFilms films = rated_films(candidates, chosen, 8, world);
      chosen_error.push_back(error_with(candidates, films));
      for (const NextFilm& film :
           next_films(candidates, {films}, {.films = 2, .aim = {}, .answers = 8, .apart = 1e-6})
               .films)
        chosen.push_back(film.candidate);
    }
    // Films that random ones need for the error that they have at 24, and chosen ones for the same.
    const double aim = random_error[10];
    std::size_t at = 0;
    while (at < chosen_error.size() && chosen_error[at] > aim) ++at;
    chosen_needed += 4.0 + 2.0 * static_cast<double>(at);
    random_needed += 24.0;
  }
  EXPECT_LE(chosen_needed, 0.6 * random_needed) << chosen_needed / random_needed;
}

// Scales count equally whatever their units: 1 to 7, or 0 to 100.
TEST(NextFilms, DoNotDependOnTheUnitsOfAScale) {
  const auto candidates = film_candidates(random_places(8, 2), 100, true, 3);
  const auto chosen = [&](double unit) {
    const RatedFilms films = rated_films(candidates, {0, 1, 2, 3, 4}, 10, 4);
    RatedFilms other = films;
    other.scale = "slow-fast";
    other.mean = unit * films.places.col(2).array().square();
    other.answer_variance *= unit * unit;
    std::vector<std::size_t> found;
    for (const NextFilm& film : next_films(candidates, {films, other}, {.films = 6}).films)
      found.push_back(film.candidate);
    return found;
  };
  EXPECT_EQ(chosen(1.0), chosen(100.0));
  EXPECT_EQ(chosen(1.0), chosen(0.01));
}

TEST(NextFilms, AreOfWhatIsNotRatedYetAndOfEveryScale) {
  const auto candidates = film_candidates(random_places(6, 2), 10, true, 3);
  const RatedFilms films = rated_films(candidates, {0, 1, 2, 3, 4, 5, 6, 7}, 10, 4);
  RatedFilms other = films;
  other.scale = "slow-fast";
  const NextFilms next =
      next_films(candidates, {films, other}, {.films = 5, .aim = {}, .answers = 12, .apart = 1e-6});
  ASSERT_EQ(next.films.size(), 2u);  // no more can be made
  EXPECT_EQ(std::min(next.films[0].candidate, next.films[1].candidate), 8u);
  EXPECT_EQ(next.films[0].mean.size(), 2u);
  EXPECT_NEAR(next.films[0].mean[0], next.films[0].mean[1], 1e-9);
  other.places.row(7).array() += 0.2;  // the last film is rated on the first scale only
  EXPECT_EQ(
      next_films(candidates, {films, other}, {.films = 5, .aim = {}, .answers = 12, .apart = 1e-6})
          .films.size(),
      3u);
}

TEST(NextFilms, AreApartFromEachOtherAndFromRatedOnes) {
  const auto candidates = film_candidates(random_places(8, 2), 200, true, 3);
  MatrixXd places(200, 3);
  for (Index c = 0; c < 200; ++c) places.row(c) = candidates[static_cast<std::size_t>(c)].place;
  const RowVectorXd spread = (places.rowwise() - places.colwise().mean())
                                 .array()
                                 .square()
                                 .colwise()
                                 .mean()
                                 .sqrt()
                                 .matrix();
  const RatedFilms films = rated_films(candidates, {0, 1, 2, 3}, 10, 4);
  for (const char* scale : {"", "sad-happy"}) {
    const NextFilms next = next_films(
        candidates, {films}, {.films = 8, .aim = {scale, true}, .answers = 10, .apart = 0.5});
    ASSERT_EQ(next.films.size(), 8u);
    std::vector<Index> shown = {0, 1, 2, 3};
    for (const NextFilm& film : next.films) {
      const auto here = static_cast<Index>(film.candidate);
      for (const Index other : shown)
        EXPECT_GE(
            (places.row(here) - places.row(other)).cwiseQuotient(spread).norm() / std::sqrt(3.0),
            0.5);
      shown.push_back(here);
    }
  }
}

// Films that cannot be chosen count for what is learned.
TEST(NextFilms, AreAmongTheAvailableOnes) {
  const auto candidates = film_candidates(random_places(8, 2), 60, true, 3);
  const RatedFilms films = rated_films(candidates, {0, 1, 2, 3}, 10, 4);
  NextOptions options{.films = 6, .apart = 1e-6};
  const NextFilms free = next_films(candidates, {films}, options);
  options.available.assign(60, true);
  for (std::size_t f = 0; f < 3; ++f) options.available[free.films[f].candidate] = false;
  const NextFilms bound = next_films(candidates, {films}, options);
  ASSERT_EQ(bound.films.size(), 6u);
  for (const NextFilm& film : bound.films) EXPECT_TRUE(options.available[film.candidate]);
  EXPECT_EQ(bound.known_now, free.known_now);
  EXPECT_LT(bound.films[0].gain, free.films[0].gain);
  options.available.assign(60, false);
  EXPECT_THROW(next_films(candidates, {films}, options), Error);
}

TEST(NextFilms, AreRefusedWhereNothingIsKnown) {
  const auto candidates = film_candidates(random_places(6, 2), 8, true, 3);
  const auto refusal = [&](const RatedFilms& films, const NextOptions& options) {
    try {
      next_films(candidates, {films}, options);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refusal(rated_films(candidates, {0, 1}, 9, 1), {}).find("only 2 films are rated"),
            std::string::npos);
  EXPECT_NE(
      refusal(rated_films(candidates, {0, 1, 2, 3, 4, 5, 6, 7}, 9, 1), {}).find("is rated already"),
      std::string::npos);
  EXPECT_NE(refusal(rated_films(candidates, {0, 1, 2}, 9, 1), {.aim = {.scale = "dull-quick"}})
                .find("no film is rated on dull-quick"),
            std::string::npos);
}

}  // namespace
}  // namespace mien::pipeline
