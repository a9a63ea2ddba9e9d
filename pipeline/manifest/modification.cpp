#include "pipeline/manifest/modification.h"

namespace mien::pipeline {

std::string_view name_of(OnFault choice) {
  for (const auto& [word, meaning] : fault_words) {
    if (meaning == choice) return word;
  }
  return "warn";
}

}  // namespace mien::pipeline
