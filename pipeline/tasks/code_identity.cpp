#include "pipeline/tasks/code_identity.h"

#include "code_hashes.h"
#include "program_version.h"

namespace mien::pipeline {

std::string_view motion_code() { return motion_code_hash; }
std::string_view film_code() { return film_code_hash; }
std::string_view sheet_code() { return sheet_code_hash; }
std::string_view study_code() { return study_code_hash; }
std::string_view program_version() { return program_version_text; }
std::string_view release_date() { return release_date_text; }

}  // namespace mien::pipeline
