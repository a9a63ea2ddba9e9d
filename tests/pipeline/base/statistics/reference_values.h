// What R says of the same numbers: reference/reference.R, and other scripts with tables of their
// own.

#pragma once

#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include "pipeline/base/documents/csv.h"

namespace mien::pipeline::test {

inline constexpr double reference_tolerance = 1e-9;

inline std::filesystem::path reference_folder() {
  return std::filesystem::path(MIEN_SOURCE_DIR) / "tests/pipeline/base/statistics/reference";
}

inline double value_in(const CsvTable& table, const CsvField& field) {
  return field.text == "NA" ? std::nan("") : number_in(table, field);
}

inline const CsvTable& reference_table(const std::string& file) {
  static std::map<std::string, CsvTable> tables;
  const auto found = tables.find(file);
  if (found != tables.end()) return found->second;
  return tables.emplace(file, read_csv(reference_folder() / file)).first->second;
}

inline std::vector<double> sample(const std::string& name,
                                  const std::string& file = "samples.csv") {
  const CsvTable& table = reference_table(file);
  std::vector<double> values;
  for (const auto& row : table.rows)
    if (row[0].text == name) values.push_back(value_in(table, row[1]));
  EXPECT_FALSE(values.empty()) << name;
  return values;
}

/// What R says about something, under its names; all of them must be looked at.
class Expected {
 public:
  explicit Expected(const std::string& name, const std::string& file = "expected.csv")
      : name_(name) {
    const CsvTable& table = reference_table(file);
    for (const auto& row : table.rows)
      if (row[0].text == name) values_[row[1].text].push_back(value_in(table, row[2]));
    EXPECT_FALSE(values_.empty()) << name;
  }

  ~Expected() {
    for (const auto& [quantity, values] : values_)
      EXPECT_TRUE(seen_.contains(quantity)) << name_ << ": " << quantity << " is not tested";
  }

  void is(const std::string& quantity, double value, double within = reference_tolerance) {
    seen_[quantity] = true;
    ASSERT_TRUE(values_.contains(quantity)) << name_ << ": " << quantity;
    for (const double expected : values_.at(quantity))
      EXPECT_NEAR(value, expected, within) << name_ << ": " << quantity;
  }

  double at(const std::string& quantity) {
    seen_[quantity] = true;
    return values_.at(quantity).front();
  }

 private:
  std::string name_;
  std::map<std::string, std::vector<double>> values_;
  std::map<std::string, bool> seen_;
};

inline Eigen::MatrixXd table_of_sample(const std::string& name, Expected& expected) {
  const auto rows = static_cast<Eigen::Index>(expected.at("rows"));
  const auto columns = static_cast<Eigen::Index>(expected.at("columns"));
  const std::vector<double> values = sample(name);
  Eigen::MatrixXd table(rows, columns);
  for (Eigen::Index i = 0; i < rows; ++i)
    for (Eigen::Index k = 0; k < columns; ++k)
      table(i, k) = values[static_cast<std::size_t>(i * columns + k)];
  return table;
}

}  // namespace mien::pipeline::test
