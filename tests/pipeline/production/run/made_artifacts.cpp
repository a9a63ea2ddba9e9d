#include "pipeline/production/run/made_artifacts.h"

#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>

#include "pipeline/production/run/run.h"
#include "pipeline/temporary_folder.h"

namespace mien::test {

KeyedArtifacts made_artifacts(const pipeline::Manifest& manifest) {
  const TemporaryFolder store;
  pipeline::Production production(manifest, {.quality = {}, .only = {}, .jobs = 1});
  const pipeline::RunResult result = pipeline::run(production, store.path(), 1, {}, {});
  KeyedArtifacts artifacts;
  for (const pipeline::TaskOutcome& outcome : result.outcomes) {
    EXPECT_TRUE(outcome.error.empty()) << outcome.error;
    for (const pipeline::Receipt& product : outcome.products)
      artifacts[product.path] = {product.key, product.hash};
  }
  return artifacts;
}

void expect_none_stale(const KeyedArtifacts& first, const KeyedArtifacts& second,
                       const std::string& change) {
  for (const auto& [file, artifact] : second) {
    const auto other = first.find(file);
    if (other == first.end() || other->second.first != artifact.first) continue;
    EXPECT_EQ(other->second.second, artifact.second) << change << " changes " << file;
  }
}

TriedPart tried_part(int usual_step) {
  const char* stated = std::getenv("MIEN_ALL_OPTIONS");
  if (stated == nullptr) return {0, usual_step};
  int part = 1, of = 1;
  if (std::sscanf(stated, "%d/%d", &part, &of) != 2 || part < 1 || part > of) return {};
  return {part - 1, of};
}

}  // namespace mien::test
