#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/base/documents/csv.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/production/synthesis/repertoire.h"
#include "pipeline/study/adaptive/film_space.h"
#include "pipeline/study/questionnaire/orders.h"

#include "real_data.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

/// The real ratings of 30 captured walks on five scales.
struct RealRatings {
  Eigen::MatrixXd places;          ///< features, one row per walk
  std::vector<RatedFilms> scales;  ///< of all walks
};

RealRatings real_ratings(const fs::path& data) {
  const Manifest manifest = load_manifest(
      fs::path(MIEN_SOURCE_DIR) / "manifests/real-walks.yaml", [&](const std::string& name) {
        return name == "MIEN_DATA" ? std::optional(data.string()) : std::nullopt;
      });
  const Repertoire repertoire = load_repertoire(manifest);
  const FilmSpace space = film_space(repertoire);
  const CsvTable table = read_csv(data / "mocap/bandai-namco-1/ratings.csv");
  std::map<std::string, std::map<std::string, std::vector<double>>> values;  // scale, walk
  const int stimulus = require_column(table, "stimulus"), scale = require_column(table, "scale"),
            value = require_column(table, "value");
  for (const auto& row : table.rows) {
    std::string name = row[static_cast<std::size_t>(stimulus)].text;
    constexpr std::string_view prefix = "dataset-1_walk_";
    if (!name.starts_with(prefix)) continue;
    values[row[static_cast<std::size_t>(scale)].text][name.substr(prefix.size())].push_back(
        number_in(table, row[static_cast<std::size_t>(value)]));
  }
  RealRatings real{.places = space.places};
  const auto walks = static_cast<Eigen::Index>(space.examples.size());
  for (const auto& [id, by_walk] : values) {
    RatedFilms films{.scale = id,
                     .places = space.places,
                     .mean = Eigen::VectorXd(walks),
                     .answers = Eigen::VectorXi(walks)};
    double squares = 0.0;
    int freedom = 0;
    for (Eigen::Index w = 0; w < walks; ++w) {
      const std::vector<double>& of = by_walk.at(space.examples[static_cast<std::size_t>(w)]);
      films.mean[w] = std::accumulate(of.begin(), of.end(), 0.0) / static_cast<double>(of.size());
      films.answers[w] = static_cast<int>(of.size());
      for (const double one : of) squares += std::pow(one - films.mean[w], 2);
      freedom += static_cast<int>(of.size()) - 1;
    }
    films.answer_variance = squares / freedom;
    real.scales.push_back(films);
  }
  return real;
}

std::vector<RatedFilms> rated_among(const RealRatings& real,
                                    const std::vector<std::size_t>& walks) {
  std::vector<RatedFilms> rated;
  for (const RatedFilms& all : real.scales) {
    RatedFilms some{.scale = all.scale, .answer_variance = all.answer_variance};
    const auto count = static_cast<Eigen::Index>(walks.size());
    some.places.resize(count, all.places.cols());
    some.mean.resize(count);
    some.answers.resize(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto walk = static_cast<Eigen::Index>(walks[static_cast<std::size_t>(i)]);
      some.places.row(i) = all.places.row(walk);
      some.mean[i] = all.mean[walk];
      some.answers[i] = all.answers[walk];
    }
    rated.push_back(some);
  }
  return rated;
}

/// The error of the expected ratings of all walks, root mean square in standard deviations of the
/// mean ratings, and the walk that is chosen next.
struct Round {
  double error = 0.0;
  std::size_t next = 0;
};

Round round_after(const RealRatings& real, const std::vector<FilmCandidate>& candidates,
                  const std::vector<std::size_t>& walks) {
  const NextFilms chosen =
      next_films(candidates, rated_among(real, walks), {.films = 1, .apart = 1e-6});
  double squares = 0.0;
  int count = 0;
  for (std::size_t s = 0; s < real.scales.size(); ++s) {
    const Eigen::VectorXd& mean = real.scales[s].mean;
    const double deviation = std::sqrt((mean.array() - mean.mean()).square().mean());
    for (Eigen::Index w = 0; w < mean.size(); ++w) {
      if (std::ranges::find(walks, static_cast<std::size_t>(w)) != walks.end()) continue;
      squares += std::pow((chosen.known[s].mean[w] - mean[w]) / deviation, 2);
      ++count;
    }
  }
  return {std::sqrt(squares / count), chosen.films.front().candidate};
}

TEST(RealRatings, OfWalksThatAreLeftOutAreFoundSoonerThanByRandomChoice) {
  const auto data = test::real_data();
  if (!data) GTEST_SKIP() << "no real motion capture: name it with MIEN_DATA";
  const RealRatings real = real_ratings(*data);
  const std::vector<FilmCandidate> candidates = film_candidates(real.places, 30, false, 1);
  ASSERT_EQ(candidates.size(), 30u);
  constexpr int orders = 12;
  std::map<std::size_t, double> chosen_error, random_error;
  for (int order = 0; order < orders; ++order) {
    const std::vector<std::size_t> random =
        random_order(30, static_cast<std::uint64_t>(order), "real walks");
    std::vector<std::size_t> chosen(random.begin(), random.begin() + 4), drawn = chosen;
    for (std::size_t count = 4; count <= 24; ++count) {
      const Round by_choice = round_after(real, candidates, chosen);
      chosen_error[count] += by_choice.error / orders;
      random_error[count] += round_after(real, candidates, drawn).error / orders;
      chosen.push_back(by_choice.next);
      drawn.push_back(random[count]);
    }
  }
  for (const auto& [count, error] : chosen_error)
    std::printf("%zu walks: chosen %.3f, random %.3f\n", count, error, random_error[count]);
}

}  // namespace
}  // namespace mien::pipeline
