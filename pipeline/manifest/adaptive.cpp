#include "pipeline/manifest/adaptive.h"

#include "pipeline/base/reading/field_reader.h"
#include "pipeline/base/reading/field_writer.h"

namespace mien::pipeline {

void MotionSpaceForm::read(const DocumentValue& given, MotionSpace& space) {
  space = {};
  for (const auto& [word, kind] : space_words) {
    const nlohmann::json* found = member(given.value, word);
    if (found == nullptr) continue;
    space.kind = kind;
    const std::string key(word);
    if (kind == MotionSpace::Kind::components)
      assign(found, space.components);
    else if (kind == MotionSpace::Kind::recipe)
      pipeline::read({*found, member_path(given.path, key), given.context}, space.recipe);
    else
      pipeline::read({*found, member_path(given.path, key), given.context}, space.names);
  }
}

OrderedJson MotionSpaceForm::write(const MotionSpace& space, const WritingOptions& how) {
  const std::string key(word_of(space_words, space.kind));
  if (space.kind == MotionSpace::Kind::components) return {{key, space.components}};
  if (space.kind == MotionSpace::Kind::recipe) return {{key, written(space.recipe, how)}};
  return {{key, space.names.empty() ? OrderedJson("all") : written(space.names, how)}};
}

}  // namespace mien::pipeline
