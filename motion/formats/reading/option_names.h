#pragma once

namespace mien::motion {

// What users call the options of readers (ReadOptions), for messages: the key of a manifest and the
// option of the command line.
inline constexpr char rate_option[] = "fps: (--recorded-fps on the command line)";
inline constexpr char joints_option[] = "joints: (--joints on the command line)";
inline constexpr char subject_option[] = "subject: (--subject on the command line)";

}  // namespace mien::motion
