// The part of the program that is linked to FFmpeg's libraries.

#include "render/video/video_files.h"

#include <optional>

extern "C" {
#include <libswresample/swresample.h>
}

#include "render/video/colour_table.h"
#include "render/video/libav.h"
#include "render/video/libav_probe.h"
#include "render/video/loudness.h"
#include "render/video/sound_reader.h"
#include "render/video/stream_encoder.h"
#include "render/video/yuv.h"

namespace mien::render {

namespace {

void require(bool holds, const std::string& path, const char* wrong) {
  if (!holds) throw Error(path + ": " + wrong);
}

/// Where the frames of a GIF wait for its colours: beside it, lossless.
std::filesystem::path waiting_place(std::filesystem::path path) { return path += ".frames.mkv"; }

class LibavWriter final : public VideoEncoder {
 public:
  LibavWriter(const std::filesystem::path& path, const VideoFormat& format, const Sound* sound)
      : path_(path),
        format_(format),
        waiting_(format.kind == VideoKind::gif ? waiting_place(path) : std::filesystem::path()),
        stream_(waiting_.empty() ? path : waiting_, stream_format(), sound) {
    if (format.kind == VideoKind::gif) colours_.emplace();
    scaler_ = make_scaler(format.width, format.height, AV_PIX_FMT_RGB24,
                          pixel_format_of(stream_format().kind), true);
  }

  ~LibavWriter() override {
    std::error_code ignored;
    if (!waiting_.empty()) std::filesystem::remove(waiting_, ignored);
  }

  void write(const Image8& frame) override {
    require(frame.width == format_.width && frame.height == format_.height, path_.string(),
            "a frame differs in size from the video");
    AVFrame& picture = stream_.picture();
    convert(frame, picture);
    stream_.send();
    if (colours_) colours_->add(frame);
    receipt_.frames.push_back(hash_of(frame));
  }

  void finish() override {
    if (finished_) return;
    require(!receipt_.frames.empty(), path_.string(), "a video without frames");
    stream_.finish();
    if (!colours_) receipt_.packet_hashes = stream_.packet_hashes();
    receipt_.sound = stream_.sound_receipt();
    if (colours_) write_indexed(ColourTable(*colours_));
    finished_ = true;
  }

  const VideoReceipt& receipt() const override { return receipt_; }

 private:
  VideoFormat stream_format() const {
    VideoFormat result = format_;
    if (result.kind == VideoKind::gif) result.kind = VideoKind::mkv;
    return result;
  }

  /// Drafts by our own conversion, which takes a third of the time; other qualities use bicubic
  /// chroma.
  void convert(const Image8& frame, AVFrame& picture) {
    if (format_.effort == VideoEffort::fast && picture.format == AV_PIX_FMT_YUV420P &&
        frame.width % 2 == 0 && frame.height % 2 == 0) {
      return yuv_from_rgb(frame, {{picture.data[0], picture.data[1], picture.data[2]},
                                  {picture.linesize[0], picture.linesize[1], picture.linesize[2]}});
    }
    const std::uint8_t* rows[1] = {frame.channels.data()};
    const int strides[1] = {3 * frame.width};
    sws_scale(scaler_.get(), rows, strides, 0, frame.height, picture.data, picture.linesize);
  }

  /// A second pass over the frames, now that their colours are known.
  void write_indexed(ColourTable table) {
    StreamEncoder gif(path_, format_, nullptr);
    const auto index = [&](const TimedPicture& shown) {
      AVFrame& picture = gif.picture();
      table.copy_entries(reinterpret_cast<std::uint32_t*>(picture.data[1]));
      table.index(shown.picture, picture.data[0], picture.linesize[0]);
      gif.send();
    };
    libav_probe(waiting_, index, 1);
    gif.finish();
  }

  std::filesystem::path path_;
  VideoFormat format_;
  std::filesystem::path waiting_;  // empty unless the colours must be known first
  StreamEncoder stream_;           // of the video, or of the frames that wait
  Scaler scaler_;
  std::optional<ColourHistogram> colours_;
  VideoReceipt receipt_;
  bool finished_ = false;
};

std::string version_text(unsigned v) {
  return std::to_string(AV_VERSION_MAJOR(v)) + "." + std::to_string(AV_VERSION_MINOR(v)) + "." +
         std::to_string(AV_VERSION_MICRO(v));
}

class LibavFiles final : public VideoFiles {
 public:
  std::unique_ptr<VideoEncoder> writer(const std::filesystem::path& path, const VideoFormat& format,
                                       const Sound* sound) const override {
    const std::string name = path.string();
    const VideoTraits& traits = traits_of(format.kind);
    require(format.width > 0 && format.height > 0, name, "a video has a width and a height");
    require(!traits.even_size || (format.width % 2 == 0 && format.height % 2 == 0), name,
            "this kind of video needs an even width and height");
    require(sound == nullptr || !sound_codec_of(format.kind).empty(), name,
            "this kind of video has no sound");
    return std::make_unique<LibavWriter>(path, format, sound);
  }
  Sound read_sound(const std::filesystem::path& file) const override {
    return libav_read_sound(file);
  }
  std::optional<VideoSound> sound_of_video(const std::filesystem::path& file) const override {
    return libav_sound_of_video(file);
  }
  Loudness loudness(const Sound& sound) const override { return ebur128_loudness(sound); }
  std::string sound_libraries() const override {
    return "libswresample " + version_text(swresample_version()) + ", libebur128 " +
           ebur128_version();
  }
  VideoSummary probe(const std::filesystem::path& path,
                     const std::function<void(const TimedPicture&)>& on_picture,
                     int row_step) const override {
    return libav_probe(path, on_picture, row_step);
  }
  VideoSummary probe_in_parallel(const std::filesystem::path& path,
                                 const std::function<void(const TimedPicture&)>& on_picture,
                                 int row_step, int threads) const override {
    return libav_probe_in_parallel(path, on_picture, row_step, threads);
  }
  Image8 decode_first_picture(const std::filesystem::path& path) const override {
    return libav_decode_first_picture(path);
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
