#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace mien::test {

/// What a job template has that version 2023-09 of the Open Job Description specification does not
/// allow, in sentences; empty when it conforms. Rules of sections 1.1, 2.1, 3, 5, 6 and 7 for what
/// mien writes: no extensions, no environments, STRING parameters of the job, INT parameters of
/// tasks. Anything else is told as unknown.
std::vector<std::string> open_job_breaches(const nlohmann::json& job);

}  // namespace mien::test
