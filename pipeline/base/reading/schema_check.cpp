#include <list>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "pipeline/base/reading/schema.h"

namespace mien::pipeline {

namespace {

using nlohmann::json;
using Adapter = valijson::adapters::NlohmannJsonAdapter;

/// A value of the document together with its path and schema.
struct Located {
  const json* value = nullptr;
  SchemaNode schema;
  std::string path;
};

/// Follows the validator's context: "<root>", "[stimuli]", "[2]", …
std::optional<Located> locate(const json& document, const json& schema,
                              const std::vector<std::string>& context) {
  Located here{&document, root_of(schema), ""};
  for (std::size_t i = 1; i < context.size(); ++i) {
    const std::string key = context[i].substr(1, context[i].size() - 2);
    const SchemaNode node = resolved_schema(here.schema, *here.value);
    if (here.value->is_object() && here.value->contains(key)) {
      here = {&(*here.value)[key], member_schema(node, key), member_path(here.path, key)};
    } else if (here.value->is_array()) {
      const std::size_t index = std::stoul(key);
      if (index >= here.value->size()) return std::nullopt;
      here = {&(*here.value)[index], element_schema(node), element_path(here.path, index)};
    } else {
      return std::nullopt;
    }
  }
  return here;
}

/// A schema compiled for the validator, which takes longer than most validations.
struct CompiledSchema {
  explicit CompiledSchema(const json& given) : schema(given) {
    valijson::SchemaParser().populateSchema(Adapter(schema), compiled);
  }

  json schema;
  valijson::Schema compiled;
};

/// Cache of compiled schemas; a program uses few. Thread-safe.
class CompiledSchemas {
 public:
  valijson::ValidationResults validate(const json& document, const json& schema) {
    if (const CompiledSchema* own = kept(schema)) return validate(document, *own);
    return validate(document, CompiledSchema(schema));
  }

 private:
  static constexpr std::size_t most = 16;

  static valijson::ValidationResults validate(const json& document, const CompiledSchema& schema) {
    valijson::Validator validator;
    valijson::ValidationResults results;
    validator.validate(schema.compiled, Adapter(document), &results);
    return results;
  }

  /// The cached compiled schema, added if necessary; null if the cache is full.
  const CompiledSchema* kept(const json& schema) {
    const std::lock_guard lock(mutex_);
    for (const CompiledSchema& one : schemas_)
      if (one.schema == schema) return &one;
    return schemas_.size() < most ? &schemas_.emplace_back(schema) : nullptr;
  }

  std::mutex mutex_;
  std::list<CompiledSchema> schemas_;  // which stay where they are
};

valijson::ValidationResults validate(const json& document, const json& schema) {
  static auto& schemas = *new CompiledSchemas;  // taking them apart at the end takes a while
  return schemas.validate(document, schema);
}

}  // namespace

std::vector<Fault> check_schema(const json& document, const json& schema, const Places& places) {
  const valijson::ValidationResults results = validate(document, schema);
  std::map<std::string, Located> faulty;
  for (const auto& error : results)
    if (auto located = locate(document, schema, error.context))
      faulty.emplace(located->path, *located);
  std::vector<Fault> faults;
  for (const auto& [path, located] : faulty) {
    std::vector<Fault> here = explain(*located.value, located.schema, path, places);
    faults.insert(faults.end(), here.begin(), here.end());
  }
  // The validator's own words, should it ever find what the sentences above do not cover.
  if (faults.empty() && results.numErrors() > 0)
    faults.push_back(
        {place_of(places, ""), "", results.begin()->description, "see manifests/mien.schema.json"});
  return faults;
}

}  // namespace mien::pipeline
