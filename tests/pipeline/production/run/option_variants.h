#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

namespace mien::test {

/// Two tiny manifests that differ in the value of one option alone.
struct OptionVariants {
  nlohmann::json first;
  nlohmann::json second;
};

/// Options that no two manifests can differ in: there is one value, or none that is said alone.
bool has_one_value(const std::string& path);

/// For the option at a path of the manifest's schema ("stimuli[].output.fps"), whose node it is.
/// Files that they name lie in `folder` (see `write_variant_files`).
OptionVariants variants_of(const std::string& path, const nlohmann::json& node);

/// What the manifests name: motions in one/ and two/, sets, scales, recipes, ratings, characters.
void write_variant_files(const std::filesystem::path& folder);

}  // namespace mien::test
