#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "motion/skeleton/recording.h"

namespace mien::motion {

struct AcclaimOptions {
  /// The ASF file; when not given, see `find_asf`.
  std::optional<std::filesystem::path> skeleton = std::nullopt;
  /// When not given, the AMC's :SAMPLES-PER-SECOND, else 120, the rate of the CMU database.
  std::optional<double> frames_per_second = std::nullopt;
};

/// Reads an Acclaim motion (AMC) with its skeleton (ASF), as in the CMU motion capture database.
///
/// A bone becomes a joint of its name at the bone's start; `tip` is the end of a bone without
/// children. With axis frame C (the product of the axis line's rotations) and M the product of the
/// rx, ry, rz of a frame, the joint's rotation is C·M·C⁻¹, so that all joints' frames are parallel
/// to the world's at rest. Rotations apply in the order they are listed, the first innermost:
/// "rx ry rz" is Rz·Ry·Rx. The axis line's numbers are about x, y and z whatever its order.
///
/// Unit: `:units length` u other than 1 follows the rule of the CMU database, value / u inches, and
/// the recording is in metres: value · 0.0254 / u. With length 1 or none it stays in file units.
///
/// Throws mien::Error with file, line and column for faults in either file: among others a frame
/// that lacks a bone or has it twice, frame numbers that do not count up by one, bones that the
/// hierarchy does not connect, and degrees of freedom other than rotations below the root.
Recording read_amc(const std::filesystem::path& path, const AcclaimOptions& options = {});

/// The skeleton of an AMC file: in its folder, `02.asf` for `02_01.amc`, else `walk.asf` for
/// `walk.amc`, else the only .asf file. Throws mien::Error when there is none or no telling.
std::filesystem::path find_asf(const std::filesystem::path& amc);

/// A file in memory; the name serves error messages.
struct NamedText {
  std::string_view text;
  std::string file_name;
};

/// As `read_amc`, from texts in memory.
Recording parse_amc(const NamedText& amc, const NamedText& asf,
                    std::optional<double> frames_per_second = std::nullopt);

}  // namespace mien::motion
