#pragma once

#include <string>
#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// Every table that a run can write.
std::vector<TableForm> all_table_forms();

/// The tables that a run of this study writes.
std::vector<TableForm> table_forms_of(const Manifest& manifest);

/// metrics/codebook.json: what the rows and columns of the study's tables are, factors by their
/// names.
std::string codebook_json(const Manifest& manifest);

/// The codebook of all tables as Markdown, which is manifests/TABLES.md.
std::string codebook_markdown();

}  // namespace mien::pipeline
