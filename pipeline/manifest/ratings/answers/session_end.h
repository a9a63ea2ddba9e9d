#pragma once

#include "motion/text/words.h"

namespace mien::pipeline {

/// How a participant's session ends.
enum class SessionEnd {
  completed,
  screened_out,      ///< turned away before the first trial, such as on a phone
  refused,           ///< no consent
  withdrawn,         ///< withdrew; the answers are deleted
  failed_attention,  ///< completed, with more failed attention checks than the analysis allows
};

inline constexpr Words<SessionEnd> session_end_words = {
    {"completed", SessionEnd::completed},
    {"screened_out", SessionEnd::screened_out},
    {"refused", SessionEnd::refused},
    {"withdrawn", SessionEnd::withdrawn},
    {"failed_attention", SessionEnd::failed_attention}};

}  // namespace mien::pipeline
