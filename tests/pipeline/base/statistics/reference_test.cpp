// Every statistic against what R says of the same numbers: reference/reference.R.

#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include "pipeline/base/statistics/agreement.h"
#include "pipeline/base/statistics/correlation.h"
#include "pipeline/base/statistics/p_correction.h"
#include "pipeline/base/statistics/proportion.h"
#include "pipeline/base/statistics/reference_values.h"
#include "pipeline/base/statistics/t_test.h"
#include "pipeline/base/statistics/wilcoxon.h"

namespace mien::pipeline {
namespace {

using test::Expected;
using test::sample;
using test::table_of_sample;

TEST(Reference, OfSignedRanksIsMetInEveryForm) {
  for (const std::string name : {"ratings", "few", "halves", "smooth"}) {
    const std::vector<double> differences = sample(name);
    for (const auto& [word, zeros] :
         {std::pair("wilcox", WilcoxonZeros::wilcox), std::pair("pratt", WilcoxonZeros::pratt),
          std::pair("zsplit", WilcoxonZeros::zsplit)}) {
      Expected expected(name + "/" + word);
      const Wilcoxon exact = wilcoxon(differences, WilcoxonMode::exact, zeros);
      const Wilcoxon plain = wilcoxon(differences, WilcoxonMode::published, zeros);
      expected.is("v", exact.w_plus);
      expected.is("used", exact.used);
      expected.is("zeros", exact.zeros);
      expected.is("p_exact", exact.p);
      expected.is("p_normal", plain.p);
      expected.is("z", plain.z);
      expected.is("p_corrected", wilcoxon(differences, WilcoxonMode::corrected, zeros).p);
      expected.is("rank_biserial", exact.rank_biserial);
    }
  }
}

TEST(Reference, OfHodgesAndLehmannIsMet) {
  for (const std::string name : {"ratings", "few", "halves", "smooth"}) {
    for (const auto& [word, level] :
         {std::pair("0.9", 0.9), std::pair("0.95", 0.95), std::pair("0.99", 0.99)}) {
      Expected expected(name + "/hodges-lehmann-" + word);
      const HodgesLehmann found = hodges_lehmann(sample(name), level);
      expected.is("estimate", found.estimate);
      expected.is("low", found.low);
      expected.is("high", found.high);
    }
  }
}

TEST(Reference, OfTTestsIsMet) {
  const std::vector<double> a = sample("a");
  const std::vector<double> b = sample("b");
  std::vector<double> differences;
  for (std::size_t i = 0; i < a.size(); ++i) differences.push_back(a[i] - b[i]);
  for (const auto& [word, level] : {std::pair("0.9", 0.9), std::pair("0.95", 0.95)}) {
    Expected paired(std::string("paired-") + word);
    const TTest of_differences = paired_t_test(differences);
    paired.is("t", of_differences.t);
    paired.is("degrees", of_differences.degrees);
    paired.is("p", of_differences.p);
    paired.is("mean", of_differences.mean);
    paired.is("low", of_differences.low(level));
    paired.is("high", of_differences.high(level));
    Expected welch(std::string("welch-") + word);
    const TTest of_two = welch_t_test(a, sample("c"));
    welch.is("t", of_two.t);
    welch.is("degrees", of_two.degrees);
    welch.is("p", of_two.p);
    welch.is("low", of_two.low(level));
    welch.is("high", of_two.high(level));
  }
  Expected effect("effect");
  effect.is("d", cohens_d(a, sample("c")));
  effect.is("g", hedges_g(a, sample("c")));
  effect.is("dz", cohens_dz(differences));
  effect.is("gz", hedges_gz(differences));
}

TEST(Reference, OfCorrelationsIsMet) {
  for (const auto& [word, level] : {std::pair("0.9", 0.9), std::pair("0.95", 0.95)}) {
    Expected expected(std::string("pearson-") + word);
    const Correlation found = pearson(sample("a"), sample("b"), level);
    expected.is("r", found.r);
    expected.is("t", found.t);
    expected.is("p", found.p);
    expected.is("low", found.low);
    expected.is("high", found.high);
  }
}

TEST(Reference, OfCorrectionsIsMet) {
  const std::vector<double> holm_values = holm(sample("p-values"));
  const std::vector<double> bh_values = benjamini_hochberg(sample("p-values"));
  Expected of_holm("holm");
  Expected of_bh("benjamini-hochberg");
  for (std::size_t i = 0; i < holm_values.size(); ++i) {
    of_holm.is(std::to_string(i + 1), holm_values[i]);
    of_bh.is(std::to_string(i + 1), bh_values[i]);
  }
}

TEST(Reference, OfSharesIsMet) {
  for (const auto& [k, n] :
       {std::pair(0, 10), std::pair(10, 10), std::pair(7, 40), std::pair(23, 40), std::pair(1, 3),
        std::pair(81, 263), std::pair(30, 300)}) {
    Expected expected(std::to_string(k) + " of " + std::to_string(n));
    const ShareInterval interval = wilson(k, n);
    expected.is("low", interval.low);
    expected.is("high", interval.high);
    const double chance = expected.at("chance");
    expected.is("p", binomial_test(k, n, chance));
  }
}

TEST(Reference, OfAgreementInFullTablesIsMet) {
  for (const std::string name : {"shrout-fleiss", "scale"}) {
    Expected expected(name);
    const Eigen::MatrixXd table = table_of_sample(name, expected);
    const Intraclass found = intraclass(table);
    EXPECT_TRUE(found.is_connected);
    expected.is("one", found.one);
    expected.is("one_k", found.one_k);
    expected.is("two", found.two);
    expected.is("two_k", found.two_k);
    expected.is("three", found.three);
    expected.is("three_k", found.three_k);
    expected.is("alpha", found.three_k);
    expected.is("alpha", cronbach_alpha(table));
  }
}

TEST(Reference, OfAgreementWithMissingCellsIsMet) {
  Expected expected("part");
  const Intraclass found = intraclass(table_of_sample("part", expected));
  expected.is("one", found.one);
  expected.is("one_k", found.one_k);
  expected.is("two", found.two);
  expected.is("two_k", found.two_k);
  expected.is("three", found.three);
  expected.is("three_k", found.three_k);
}

}  // namespace
}  // namespace mien::pipeline
