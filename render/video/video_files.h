#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "render/video/sound_file.h"
#include "render/video/video.h"

namespace mien::render {

// Reading and writing of video files by FFmpeg. Its libraries take 0.02 s to load, more than all
// others that mien is linked to, so they are linked to a plug-in that is loaded when the first
// video is read or written. The types below and those of video.h are the whole interface between
// the program and the plug-in.

/// Implementation of VideoWriter.
class VideoEncoder {
 public:
  virtual ~VideoEncoder() = default;
  virtual void write(const Image8& frame) = 0;
  virtual void finish() = 0;
  virtual const VideoReceipt& receipt() const = 0;
};

/// Implementation of the functions of video.h and sound_file.h; its video readers support all kinds
/// except WebP.
class VideoFiles {
 public:
  virtual ~VideoFiles() = default;
  virtual std::unique_ptr<VideoEncoder> writer(const std::filesystem::path& path,
                                               const VideoFormat& format,
                                               const Sound* sound) const = 0;
  virtual VideoSummary probe(const std::filesystem::path& path,
                             const std::function<void(const TimedPicture&)>& on_picture,
                             int row_step) const = 0;
  virtual VideoSummary probe_in_parallel(const std::filesystem::path& path,
                                         const std::function<void(const TimedPicture&)>& on_picture,
                                         int row_step, int threads) const = 0;
  virtual Image8 decode_first_picture(const std::filesystem::path& path) const = 0;

  virtual Sound read_sound(const std::filesystem::path& file) const = 0;
  virtual std::optional<VideoSound> sound_of_video(const std::filesystem::path& file) const = 0;
  virtual Loudness loudness(const Sound& sound) const = 0;
  virtual std::string sound_libraries() const = 0;

  /// Versions, "59.37.100".
  virtual std::string libavcodec() const = 0;
  virtual std::string libavformat() const = 0;
  virtual std::string libswscale() const = 0;
};

/// Version of the types above (load_part.h).
inline constexpr int video_files_edition = 2;

/// Loads the plug-in when it is first called. Throws Error when it is missing.
const VideoFiles& video_files();

}  // namespace mien::render
