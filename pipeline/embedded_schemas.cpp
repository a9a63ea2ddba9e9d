#include "pipeline/schema.h"

#include "embedded/manifest_schema.h"
#include "embedded/scales_schema.h"

namespace mien::pipeline {

std::string_view manifest_schema_text() { return embedded_manifest_schema; }
std::string_view scales_schema_text() { return embedded_scales_schema; }

nlohmann::json manifest_schema() { return nlohmann::json::parse(manifest_schema_text()); }
nlohmann::json scales_schema() { return nlohmann::json::parse(scales_schema_text()); }

}  // namespace mien::pipeline
