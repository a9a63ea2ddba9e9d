#include <optional>

#include "render/video/colour_table.h"
#include "render/video/stream_encoder.h"
#include "render/video/video.h"
#include "render/video/yuv.h"

namespace mien::render {

namespace {

void require(bool holds, const std::string& path, const char* wrong) {
  if (!holds) throw Error(path + ": " + wrong);
}

/// Where the frames of a GIF wait for its colours: beside it, lossless.
std::filesystem::path waiting_place(std::filesystem::path path) { return path += ".frames.mkv"; }

}  // namespace

struct VideoWriter::Encoder {
  std::filesystem::path path;
  VideoFormat format;
  std::filesystem::path waiting;  ///< empty unless the colours must be known first
  StreamEncoder stream;           ///< of the video, or of the frames that wait
  Scaler scaler;
  std::optional<ColourHistogram> colours;
  VideoReceipt receipt;
  bool finished = false;

  Encoder(const std::filesystem::path& where, const VideoFormat& how)
      : path(where),
        format(how),
        waiting(how.kind == VideoKind::gif ? waiting_place(where) : std::filesystem::path()),
        stream(waiting.empty() ? where : waiting, stream_format()) {
    if (format.kind == VideoKind::gif) colours.emplace();
    scaler = make_scaler(format.width, format.height, AV_PIX_FMT_RGB24,
                         pixel_format_of(stream_format().kind), true);
  }

  ~Encoder() {
    std::error_code ignored;
    if (!waiting.empty()) std::filesystem::remove(waiting, ignored);
  }

  VideoFormat stream_format() const {
    VideoFormat result = format;
    if (result.kind == VideoKind::gif) result.kind = VideoKind::mkv;
    return result;
  }

  void write(const Image8& frame) {
    AVFrame& picture = stream.picture();
    convert(frame, picture);
    stream.send();
    if (colours) colours->add(frame);
    receipt.frames.push_back(hash_of(frame));
  }

  /// Drafts by our own conversion, which takes a third of the time; bicubic colours are for keeps.
  void convert(const Image8& frame, AVFrame& picture) {
    if (format.effort == VideoEffort::fast && picture.format == AV_PIX_FMT_YUV420P &&
        frame.width % 2 == 0 && frame.height % 2 == 0) {
      return yuv_from_rgb(frame, {{picture.data[0], picture.data[1], picture.data[2]},
                                  {picture.linesize[0], picture.linesize[1], picture.linesize[2]}});
    }
    const std::uint8_t* rows[1] = {frame.channels.data()};
    const int strides[1] = {3 * frame.width};
    sws_scale(scaler.get(), rows, strides, 0, frame.height, picture.data, picture.linesize);
  }

  void finish() {
    stream.finish();
    if (!colours) receipt.coded = stream.coded();
    if (colours) write_indexed(ColourTable(*colours));
  }

  /// A second pass over the frames, now that their colours are known.
  void write_indexed(ColourTable table) {
    StreamEncoder gif(path, format);
    probe(waiting, [&](int, const Image8& frame) {
      AVFrame& picture = gif.picture();
      table.copy_entries(reinterpret_cast<std::uint32_t*>(picture.data[1]));
      table.index(frame, picture.data[0], picture.linesize[0]);
      gif.send();
    });
    gif.finish();
  }
};

VideoWriter::VideoWriter(const std::filesystem::path& path, const VideoFormat& format) {
  const std::string name = path.string();
  const VideoTraits& traits = traits_of(format.kind);
  require(format.width > 0 && format.height > 0, name, "a video has a width and a height");
  require(!traits.even_size || (format.width % 2 == 0 && format.height % 2 == 0), name,
          "this kind of video needs an even width and height");
  encoder_ = std::make_unique<Encoder>(path, format);
}

VideoWriter::~VideoWriter() = default;
VideoWriter::VideoWriter(VideoWriter&&) noexcept = default;
VideoWriter& VideoWriter::operator=(VideoWriter&&) noexcept = default;

void VideoWriter::write(const Image8& frame) {
  Encoder& e = *encoder_;
  require(frame.width == e.format.width && frame.height == e.format.height, e.path.string(),
          "a frame has another size than the video");
  e.write(frame);
}

void VideoWriter::finish() {
  Encoder& e = *encoder_;
  if (e.finished) return;
  require(!e.receipt.frames.empty(), e.path.string(), "a video without frames");
  e.finish();
  e.finished = true;
}

const VideoReceipt& VideoWriter::receipt() const { return encoder_->receipt; }

}  // namespace mien::render
