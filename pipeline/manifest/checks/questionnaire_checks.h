#pragma once

#include <string>
#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// Reads a text for participants at that path of the manifest, where it names a file; what cannot
/// be read is added to the faults.
void complete_text(const std::string& path, TextSource& source, FaultList& list);

/// Reads the texts and the scales that the questionnaire names by their files. Faults: what cannot
/// be read.
std::vector<Fault> complete_questionnaire(Manifest& manifest);

/// Stimuli, scales and factors that are not there, and settings that exclude each other. The
/// study's scales must have been read.
std::vector<Fault> check_questionnaire(const Manifest& manifest);

}  // namespace mien::pipeline
