#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "motion/skeleton/recording.h"

namespace mien::motion {

struct AcclaimOptions {
  /// The ASF file; if empty, see `find_asf`.
  std::optional<std::filesystem::path> skeleton = std::nullopt;
  /// If the AMC file has no :SAMPLES-PER-SECOND; if empty, 120, the rate of the CMU database.
  std::optional<double> frames_per_second = std::nullopt;
};

/// Reads an Acclaim motion (AMC) with its skeleton (ASF), as in the CMU motion capture database.
///
/// Each bone becomes a joint of the same name, located at the start of the bone; the end of a bone
/// without children becomes the joint's `tip`. With C the axis frame (the product of the rotations
/// of the axis line) and M the product of the rotations rx, ry and rz of a frame, the rotation of
/// the joint is C·M·C⁻¹, so that all joint frames are parallel to the world frame at rest.
/// Rotations are applied in the order in which they are listed, the first one innermost: "rx ry rz"
/// means Rz·Ry·Rx. The numbers of the axis line are always angles about x, y and z, whatever its
/// order.
///
/// Units: with a `:units length` u other than 1, values are converted as in the CMU database (value
/// / u is in inches), and the recording is in metres: value · 0.0254 / u. If the length is 1 or
/// missing, values remain in file units.
///
/// Throws mien::Error with file, line and column for faults in either file, for example a frame in
/// which a bone is missing or occurs twice, frame numbers that do not increase by one, bones that
/// are not connected by the hierarchy, or bones other than the root that have degrees of freedom
/// other than rotations.
Recording read_amc(const std::filesystem::path& path, const AcclaimOptions& options = {});

/// The skeleton of an AMC file, in the same folder: for `02_01.amc` it is `02.asf`, otherwise
/// `02_01.asf`, otherwise the only .asf file. Throws mien::Error if there is no .asf file, or
/// several of which none has such a name.
std::filesystem::path find_asf(const std::filesystem::path& amc);

/// A file in memory; the name is used in error messages.
struct NamedText {
  std::string_view text;
  std::string file_name;
};

/// As `read_amc`, from texts in memory.
Recording parse_amc(const NamedText& amc, const NamedText& asf,
                    std::optional<double> frames_per_second = std::nullopt);

}  // namespace mien::motion
