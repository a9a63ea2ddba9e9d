#include "pipeline/study/adaptive/film_plane.h"

#include <gtest/gtest.h>

#include "pipeline/study/adaptive/film_worlds.h"
#include "pipeline/study/adaptive/rating_process.h"

namespace mien::pipeline {
namespace {

std::vector<FilmCandidate> at(const Eigen::MatrixXd& places) {
  return film_candidates(places, static_cast<std::size_t>(places.rows()), false, 1);
}

TEST(FilmPlane, KeepsDistancesOfTwoParameters) {
  const auto candidates = at(world_places(30, 1).leftCols(2));
  const FilmPlane plane = film_plane(candidates);
  EXPECT_NEAR(plane.explained[0] + plane.explained[1], 1.0, 1e-12);
  EXPECT_GE(plane.explained[0], plane.explained[1]);
  const Eigen::MatrixXd places = places_of(candidates);
  const Eigen::MatrixXd standardised = plane.by.of(places);
  const Eigen::MatrixX2d points = plane.at(places);
  EXPECT_NEAR((points.row(0) - points.row(7)).norm(),
              (standardised.row(0) - standardised.row(7)).norm(), 1e-12);
  // Shares of the variance are those of the points.
  EXPECT_NEAR(points.col(0).squaredNorm() / points.squaredNorm(), plane.explained[0], 1e-12);
  EXPECT_NEAR(points.col(0).dot(points.col(1)), 0.0, 1e-9);
}

TEST(FilmPlane, FindsTheDirectionInWhichFilmsDiffer) {
  Eigen::MatrixXd places = world_places(40, 2);
  places.col(1) = -2.0 * places.col(0);
  places.col(1) += 0.02 * places.col(2);
  const FilmPlane plane = film_plane(at(places));
  EXPECT_NEAR(plane.explained[0], 2.0 / 3.0, 0.05);
  EXPECT_NEAR(plane.axes(0, 0), 0.707, 0.03);
  EXPECT_NEAR(plane.axes(1, 0), -0.707, 0.03);
  EXPECT_GT(plane.axes(2, 1), 0.9);
  const std::vector<std::string> names = {"swing", "lean", "tempo"};
  EXPECT_EQ(component_text(plane, 0, names), "+ swing, − lean");
  EXPECT_EQ(component_text(plane, 1, names), "+ tempo");
}

TEST(FilmPlane, OfOneParameterIsALine) {
  const FilmPlane plane = film_plane(at(world_places(10, 3).leftCols(1)));
  EXPECT_NEAR(plane.explained[0], 1.0, 1e-12);
  EXPECT_EQ(plane.explained[1], 0.0);
  EXPECT_TRUE(plane.axes.col(1).isZero());
  EXPECT_EQ(plane.axes(0, 0), 1.0);
}

}  // namespace
}  // namespace mien::pipeline
