#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace mien::test {

/// Violations of version 2023-09 of the Open Job Description specification in a job template, as
/// sentences; empty if it conforms. Rules of sections 1.1, 2.1, 3, 5, 6 and 7 for what mien writes:
/// no extensions, no environments, STRING parameters of the job, INT parameters of tasks. Anything
/// else is reported as unknown.
std::vector<std::string> open_job_breaches(const nlohmann::json& job);

}  // namespace mien::test
