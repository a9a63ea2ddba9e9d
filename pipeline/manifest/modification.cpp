#include "pipeline/manifest/modification.h"

namespace mien::pipeline {

std::string_view name_of(OnFault choice) { return word_of(fault_words, choice); }

}  // namespace mien::pipeline
