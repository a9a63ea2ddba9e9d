// The part of the program that is linked to FFmpeg's libraries.

#include "render/video/video_files.h"

#include "render/video/libav.h"
#include "render/video/libav_probe.h"
#include "render/video/libav_writer.h"

namespace mien::render {

namespace {

std::string version_text(unsigned v) {
  return std::to_string(AV_VERSION_MAJOR(v)) + "." + std::to_string(AV_VERSION_MINOR(v)) + "." +
         std::to_string(AV_VERSION_MICRO(v));
}

class LibavFiles final : public VideoFiles {
 public:
  std::unique_ptr<VideoEncoder> writer(const std::filesystem::path& path,
                                       const VideoFormat& format) const override {
    return libav_writer(path, format);
  }
  VideoSummary probe(const std::filesystem::path& path,
                     const std::function<void(const ShownPicture&)>& on_picture,
                     int row_step) const override {
    return libav_probe(path, on_picture, row_step);
  }
  VideoSummary probe_side_by_side(const std::filesystem::path& path,
                                  const std::function<void(const ShownPicture&)>& on_picture,
                                  int row_step, int threads) const override {
    return libav_probe_side_by_side(path, on_picture, row_step, threads);
  }
  Image8 first_picture_alone(const std::filesystem::path& path) const override {
    return libav_first_picture(path);
  }
  std::string libavcodec() const override { return version_text(avcodec_version()); }
  std::string libavformat() const override { return version_text(avformat_version()); }
  std::string libswscale() const override { return version_text(swscale_version()); }
};

}  // namespace

extern "C" const void* mien_part(int edition) {
  static const LibavFiles files;
  return edition == video_files_edition ? static_cast<const VideoFiles*>(&files) : nullptr;
}

}  // namespace mien::render
