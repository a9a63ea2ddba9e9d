#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "motion/formats/reading/read_options.h"
#include "motion/points/point_recording.h"

namespace mien::motion {

// Motion in the Brain Imaging Data Structure (BIDS 1.9 and later, "Motion"): positions in
// `…_motion.tsv`, which has no header, a column for each row of `…_channels.tsv`; and
// `…_motion.json` with the frame rate.

/// Reads the positions of a `…_motion.tsv`. Beside it, under the same name, lie `…_channels.tsv`
/// and `…_motion.json`; the latter may also lie up to three folders above, under a name that has
/// the task only, or task and tracksys (inheritance principle).
///
/// - Points are the tracked points that have channels of type POS and components x, y and z, in
///   metres, centimetres or millimetres; the recording is in the unit of the first. Other channels,
///   such as orientations and latencies, are left out with a note.
/// - "n/a", empty, NaN and the MissingValues of the JSON file are missing.
/// - The rate is SamplingFrequencyEffective, or else SamplingFrequency.
///
/// Throws mien::Error with file, line and column for a file that is missing, columns that do not
/// match the channels, no positions, and no rate.
PointRecording read_bids_motion(const std::filesystem::path& motion_tsv,
                                const ReadOptions& options = {});

/// The three files in memory, and their names for messages.
struct BidsMotionTexts {
  std::string_view motion;
  std::string motion_file;
  std::string_view channels;
  std::string channels_file;
  std::string_view sidecar;  ///< JSON; may be empty, if the options state the rate
  std::string sidecar_file;
};

PointRecording parse_bids_motion(const BidsMotionTexts& texts, const ReadOptions& options = {});

/// Whether a file is named as motion in BIDS: "…_motion.tsv", also "…_motion.tsv.gz".
bool is_bids_motion(const std::filesystem::path& path);

/// Labels for names of BIDS files. Characters other than letters and digits are left out.
struct BidsLabels {
  std::string subject = "01";
  std::string session;  ///< may be empty
  std::string task = "motion";
  std::string tracking_system = "points";
};

/// The recording as BIDS motion: names and contents of `sub-…_task-…_tracksys-…_motion.tsv`,
/// `…_channels.tsv` and `…_motion.json`, to be put into `sub-…[/ses-…]/motion`. Positions are in
/// metres to 0.1 µm, or, if the unit is not known, as they are with the unit "n/a"; what is missing
/// is "n/a". In names of points, tabs and line ends become spaces. `read_bids_motion` reads them.
std::vector<std::pair<std::string, std::string>> to_bids_motion(const PointRecording& recording,
                                                                const BidsLabels& labels = {});

/// As above, the contents alone, for a motion file of this name, which gives the labels; acq and
/// run may be among them. Throws mien::Error if BIDS does not allow the name.
std::vector<std::string> bids_motion_texts(const PointRecording& recording,
                                           const std::filesystem::path& motion_tsv);

/// Throws mien::Error unless a motion file may have this name in BIDS:
/// "sub-01_task-walk_tracksys-markers_motion.tsv".
void require_bids_motion_name(const std::filesystem::path& file);

}  // namespace mien::motion
