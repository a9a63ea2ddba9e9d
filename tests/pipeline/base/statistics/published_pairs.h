#pragma once

#include <vector>

#include "pipeline/base/statistics/pair_counts.h"

namespace mien::pipeline::test {

/// Citations between Biometrika, Communications in Statistics, JASA and JRSS-B (Stigler 1994).
inline const std::vector<PairCount> citations = {{0, 1, 730, 33},  {0, 2, 498, 320},
                                                 {0, 3, 221, 284}, {1, 2, 68, 813},
                                                 {1, 3, 17, 276},  {2, 3, 142, 325}};

/// The eastern division of the American League in 1987, the home team first (Agresti 2002, table
/// 10.11): Baltimore, Boston, Cleveland, Detroit, Milwaukee, New York, Toronto.
inline const std::vector<PairCount> baseball = {
    {4, 3, 4, 3}, {4, 6, 4, 2}, {4, 5, 4, 3}, {4, 1, 6, 1}, {4, 2, 4, 2}, {4, 0, 6, 0},
    {3, 4, 3, 3}, {3, 6, 4, 2}, {3, 5, 4, 3}, {3, 1, 6, 0}, {3, 2, 6, 1}, {3, 0, 4, 3},
    {6, 4, 2, 5}, {6, 3, 4, 3}, {6, 5, 2, 4}, {6, 1, 4, 3}, {6, 2, 4, 2}, {6, 0, 6, 0},
    {5, 4, 3, 3}, {5, 3, 5, 1}, {5, 6, 2, 5}, {5, 1, 4, 3}, {5, 2, 4, 2}, {5, 0, 6, 1},
    {1, 4, 5, 1}, {1, 3, 2, 5}, {1, 6, 3, 3}, {1, 5, 4, 2}, {1, 2, 5, 2}, {1, 0, 6, 0},
    {2, 4, 2, 5}, {2, 3, 3, 3}, {2, 6, 3, 4}, {2, 5, 4, 3}, {2, 1, 4, 2}, {2, 0, 2, 4},
    {0, 4, 2, 5}, {0, 3, 1, 5}, {0, 6, 1, 6}, {0, 5, 2, 4}, {0, 1, 1, 6}, {0, 2, 3, 4}};

/// Strength of flavour of nine samples, with ties (Springall 1973). The order in which they were
/// tasted was not published; here the one with the larger number is the first.
inline const std::vector<PairCount> flavours = {
    {1, 0, 2, 16, 7}, {2, 0, 0, 21, 1}, {3, 0, 5, 10, 10}, {4, 0, 2, 15, 7}, {5, 0, 0, 22, 2},
    {6, 0, 12, 3, 9}, {7, 0, 13, 9, 5}, {8, 0, 10, 12, 3}, {2, 1, 6, 11, 5}, {3, 1, 17, 2, 7},
    {4, 1, 9, 6, 8},  {5, 1, 8, 12, 6}, {6, 1, 24, 2, 0},  {7, 1, 16, 3, 5}, {8, 1, 15, 2, 7},
    {3, 2, 22, 2, 4}, {4, 2, 14, 4, 5}, {5, 2, 11, 4, 7},  {6, 2, 24, 1, 3}, {7, 2, 22, 0, 3},
    {8, 2, 17, 2, 6}, {4, 3, 3, 14, 9}, {5, 3, 2, 18, 4},  {6, 3, 12, 6, 5}, {7, 3, 10, 6, 6},
    {8, 3, 8, 9, 11}, {5, 4, 5, 11, 9}, {6, 4, 20, 0, 2},  {7, 4, 15, 2, 5}, {8, 4, 13, 5, 9},
    {6, 5, 27, 1, 0}, {7, 5, 19, 1, 5}, {8, 5, 18, 2, 2},  {7, 6, 2, 13, 8}, {8, 6, 2, 21, 5},
    {8, 7, 6, 8, 8}};

}  // namespace mien::pipeline::test
