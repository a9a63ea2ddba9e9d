#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "motion/text/words.h"
#include "pipeline/base/documents/concerns.h"
#include "pipeline/base/documents/fault.h"

namespace mien::pipeline {

struct Manifest;
struct Stimulus;

/// What is done where a sound and its film differ in length by more than half a frame. A sound that
/// ends earlier is followed by silence, except with `error`.
enum class SoundLength {
  error,  ///< the film is not made
  cut,    ///< the sound ends with the film
  hold,   ///< the film's last picture is held until the sound ends
};

inline constexpr Words<SoundLength> sound_length_words = {
    {"error", SoundLength::error}, {"cut", SoundLength::cut}, {"hold", SoundLength::hold}};

inline std::string_view name_of(SoundLength length) { return word_of(sound_length_words, length); }

/// `audio:` of a stimulus, as it is written. Either the file or `from` is given.
struct StatedSound {
  std::filesystem::path file;  ///< resolved
  std::string from;            ///< id of the stimulus whose sound is taken
  double offset = 0.0;         ///< time of the sound file at which the film begins, seconds
  double gain = 0.0;           ///< decibels
  SoundLength length = SoundLength::error;
};

void fields_of(auto&& field, MaybeConst<StatedSound> auto& sound) {
  field("file", sound.file, concerns::shown | concerns::alone);
  field("from", sound.from, concerns::shown);
  field("offset", sound.offset, concerns::shown);
  field("gain", sound.gain, concerns::shown);
  field("length", sound.length, concerns::shown, sound_length_words);
}

/// The sound of a stimulus's videos (resolve_sounds).
struct StimulusSound {
  std::filesystem::path file;
  double offset = 0.0;  ///< seconds
  double gain = 0.0;    ///< decibels
  SoundLength length = SoundLength::error;
  std::string of;  ///< id of the stimulus that states the file
};

/// How sounds are assigned to other stimuli.
enum class SoundMismatch { derange };

inline constexpr Words<SoundMismatch> sound_mismatch_words = {{"derange", SoundMismatch::derange}};

/// `mismatch:`: stimuli that exchange their sounds, so that none keeps its own.
struct Mismatch {
  SoundMismatch audio = SoundMismatch::derange;
  std::uint64_t seed = 0;
  std::vector<std::string> stimuli;  ///< ids; empty: all stimuli with a sound
};

void fields_of(auto&& field, MaybeConst<Mismatch> auto& mismatch) {
  field("audio", mismatch.audio, concerns::shown | concerns::required, sound_mismatch_words);
  field("seed", mismatch.seed, concerns::shown);
  field("stimuli", mismatch.stimuli, concerns::shown);
}

/// The integrated loudness of broadcasts in Europe (EBU R 128), LUFS.
inline constexpr double broadcast_lufs = -23.0;

/// `loudness: true`, or a target in LUFS: `loudness: -27`.
struct LoudnessForm {
  static void read(const DocumentValue& given, std::optional<double>& target_lufs);
  static nlohmann::ordered_json write(const std::optional<double>& target_lufs,
                                      const WritingOptions&);
};

/// Gives each stimulus its sound: that of its file, or of the stimulus that it names, exchanged as
/// `mismatch:` says. Returns faults if a named stimulus does not exist, has no sound or takes its
/// own from another, if values contradict each other, and if fewer than two different sounds are to
/// be exchanged or one belongs to more than half of the stimuli.
std::vector<Fault> resolve_sounds(Manifest& manifest);

/// Returns an exchange in which no place gets what it has: the place from which each takes, in
/// random order that depends only on the seed and the names. Places with equal `owned` have the
/// same thing. If all differ, all such exchanges are equally likely. Empty if there is none,
/// because more than half of the places have the same thing, or fewer than two places.
std::vector<std::size_t> derangement(const std::vector<std::string>& names,
                                     const std::vector<std::string>& owned, std::uint64_t seed);

/// "matched", "mismatched" for a sound that another stimulus states, or empty without a sound.
std::string sound_level(const Stimulus& stimulus);

}  // namespace mien::pipeline
