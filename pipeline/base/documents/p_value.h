#pragma once

#include <string>

namespace mien::pipeline {

/// A p value for tables: the shortest decimal that reads back as the same ("0.034", "3.2e-15"),
/// "< 1e-300" where it is smaller than that or too small for a double, and "" where it is not known
/// (NaN). Never "0": nothing that was tested has that probability.
std::string p_of_table(double p);

/// The same with the three places that people read: "0.034", "3.2e-15", "< 1e-300", "–".
std::string p_for_people(double p);

}  // namespace mien::pipeline
