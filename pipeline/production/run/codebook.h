#pragma once

#include <string>
#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// Returns the forms of all tables that a run can write.
std::vector<TableForm> all_table_forms();

/// Returns the forms of the tables that a run of this study writes.
std::vector<TableForm> table_forms_of(const Manifest& manifest);

/// Returns metrics/codebook.json: the meaning of the rows and columns of the study's tables, with
/// factors by name.
std::string codebook_json(const Manifest& manifest);

/// Returns the codebook of all tables as Markdown, which is manifests/TABLES.md.
std::string codebook_markdown();

}  // namespace mien::pipeline
