#include "pipeline/study/adaptive/film_rounds.h"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "pipeline/study/adaptive/film_worlds.h"
#include "pipeline/study/adaptive/rating_process.h"

namespace mien::pipeline {
namespace {

using Eigen::Index;

std::vector<FilmCandidate> world_candidates(std::uint64_t seed) {
  return film_candidates(world_places(10, seed), 80, true, seed);
}

std::vector<std::size_t> from_to(std::size_t from, std::size_t to) {
  std::vector<std::size_t> films(to - from);
  std::iota(films.begin(), films.end(), from);
  return films;
}

/// Two rounds, the first of 12 films, the second of 8.
RatedFilms two_rounds(const std::vector<FilmCandidate>& candidates, std::uint64_t seed,
                      double own = 0.0) {
  RatedFilms rated = world_films(candidates, from_to(0, 20), seed, own);
  for (std::size_t f = 12; f < 20; ++f) rated.rounds[f] = 2;
  return rated;
}

std::vector<Index> rows(Index from, Index to) {
  std::vector<Index> all(static_cast<std::size_t>(to - from));
  std::iota(all.begin(), all.end(), from);
  return all;
}

TEST(FilmRounds, KnowAfterEachWhatTheNextFilmsAreChosenFrom) {
  const auto candidates = world_candidates(1);
  const RatedFilms rated = two_rounds(candidates, 1);
  const auto rounds = film_rounds(candidates, {rated});
  ASSERT_EQ(rounds.size(), 2u);
  EXPECT_EQ(rounds[0].number, 1);
  EXPECT_EQ(rounds[0].films, 12);
  EXPECT_EQ(rounds[0].answers, 120);
  EXPECT_EQ(rounds[1].films, 8);
  EXPECT_EQ(rounds[1].scales[0].answers, 80);
  const NextFilms after_first =
      next_films(candidates, {films_among(rated, rows(0, 12))}, {.films = 1});
  const NextFilms after_both = next_films(candidates, {rated}, {.films = 1});
  EXPECT_NEAR(rounds[0].scales[0].deviation, after_first.known_now[0], 1e-9);
  EXPECT_NEAR(rounds[1].scales[0].deviation, after_both.known_now[0], 1e-9);
  EXPECT_LT(rounds[1].scales[0].deviation, rounds[0].scales[0].deviation);
}

// The second round by hand: the films of the first predict its means.
TEST(FilmRounds, PredictALaterRoundFromThoseBefore) {
  const auto candidates = world_candidates(2);
  const RatedFilms rated = two_rounds(candidates, 2);
  const NextFilms known = next_films(candidates, {films_among(rated, rows(0, 12))}, {.films = 1});
  double squares = 0.0, otherwise = 0.0;
  for (Index f = 12; f < 20; ++f) {
    squares += std::pow(rated.mean[f] - known.known[0].mean[f], 2);
    otherwise += std::pow(rated.mean[f] - rated.mean.head(12).mean(), 2);
  }
  const ScaleRound found = film_rounds(candidates, {rated})[1].scales[0];
  EXPECT_NEAR(found.error, std::sqrt(squares / 8.0), 1e-9);
  EXPECT_NEAR(found.explained, 1.0 - squares / otherwise, 1e-9);
  EXPECT_GT(found.explained, 0.5);
}

// The ratings of the later rounds do not change what is said of the first.
TEST(FilmRounds, OfThePastStayAsTheyWere) {
  const auto candidates = world_candidates(3);
  RatedFilms rated = two_rounds(candidates, 3);
  const auto now = film_rounds(candidates, {rated});
  const ScaleRound before = now[0].scales[0];
  for (Index f = 12; f < 20; ++f) rated.mean[f] += 3.0;
  const auto after = film_rounds(candidates, {rated});
  EXPECT_EQ(after[0].scales[0].deviation, before.deviation);
  EXPECT_EQ(after[0].scales[0].error, before.error);
  EXPECT_GT(after[1].scales[0].error, 2.0);
  EXPECT_LT(after[1].scales[0].explained, now[1].scales[0].explained - 0.3);
  EXPECT_LT(after[1].scales[0].covered, 0.5);
}

// Over forty worlds whose films differ by more than their parameters say, the intervals hold what
// they promise.
TEST(FilmRounds, CoverAboutNinetyPercent) {
  double covered_first = 0.0, covered_second = 0.0;
  constexpr int worlds = 40;
  for (std::uint64_t world = 1; world <= worlds; ++world) {
    const auto candidates = world_candidates(world);
    const auto rounds = film_rounds(candidates, {two_rounds(candidates, world, 0.3)});
    covered_first += rounds[0].covered / worlds;
    covered_second += rounds[1].covered / worlds;
  }
  EXPECT_GT(covered_first, 0.82);
  EXPECT_LT(covered_first, 0.97);
  EXPECT_GT(covered_second, 0.80);
  EXPECT_LT(covered_second, 0.97);
}

TEST(FilmRounds, ExplainNothingWhereParametersSayNothing) {
  double explained = 0.0;
  constexpr int worlds = 20;
  for (std::uint64_t world = 1; world <= worlds; ++world) {
    const auto candidates = world_candidates(world);
    RatedFilms rated = two_rounds(candidates, world);
    for (Index f = 0; f < 20; ++f) rated.mean[f] = normal(world, "noise/" + std::to_string(f));
    explained += film_rounds(candidates, {rated})[1].explained / worlds;
  }
  EXPECT_LT(explained, 0.1);
}

TEST(FilmRounds, SayNothingOfTooFewFilms) {
  const auto candidates = world_candidates(4);
  RatedFilms rated = world_films(candidates, from_to(0, 6), 4);
  rated.rounds = {1, 1, 2, 2, 2, 3};
  RatedFilms other = films_among(rated, rows(1, 6));  // one film of the first round
  other.scale = "slow-fast";
  const auto rounds = film_rounds(candidates, {rated, other});
  ASSERT_EQ(rounds.size(), 3u);
  EXPECT_TRUE(std::isnan(rounds[0].scales[0].deviation));
  EXPECT_TRUE(std::isnan(rounds[0].explained));
  EXPECT_TRUE(std::isnan(rounds[1].scales[0].error));  // two films cannot predict
  EXPECT_FALSE(std::isnan(rounds[1].scales[0].deviation));
  EXPECT_FALSE(std::isnan(rounds[2].scales[0].error));
  EXPECT_EQ(rounds[0].films, 2);
  EXPECT_EQ(rounds[0].answers, 30);
  EXPECT_EQ(rounds[0].scales[1].films, 1);
}

}  // namespace
}  // namespace mien::pipeline
