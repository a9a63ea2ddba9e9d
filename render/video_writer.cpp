#include <cmath>
#include <stdexcept>

#include "render/libav.h"
#include "render/video.h"

namespace mien::render {

namespace {

/// Part of the result: x264 cuts its work by the number of threads.
constexpr int encoder_threads = 4;
constexpr int key_frame_distance = 60;

}  // namespace

FrameRate frame_rate(double per_second) {
  if (!(per_second > 0.0) || !std::isfinite(per_second)) {
    throw std::invalid_argument("frame_rate: not positive");
  }
  const double whole = std::round(per_second);
  if (whole >= 1.0 && std::abs(per_second - whole) < 1e-6 * whole) {
    return {static_cast<int>(whole), 1};
  }
  const double ntsc = std::round(per_second * 1.001);
  if (std::abs(per_second - ntsc / 1.001) < 1e-4 * per_second) {
    return {static_cast<int>(ntsc) * 1000, 1001};
  }
  FrameRate best{static_cast<int>(std::max(1.0, whole)), 1};
  for (int denominator = 1; denominator <= 1000; ++denominator) {
    const FrameRate rate{static_cast<int>(std::round(per_second * denominator)), denominator};
    if (rate.numerator > 0 && std::abs(rate.per_second() - per_second) <
                                  std::abs(best.per_second() - per_second) - 1e-12) {
      best = rate;
    }
  }
  return best;
}

struct VideoWriter::Encoder {
  std::string path;
  VideoFormat format;
  Output file;
  CodecContext codec;
  Scaler scaler;
  Frame picture;
  Packet packet;
  AVStream* stream = nullptr;
  std::int64_t frames = 0;
  bool finished = false;

  void open_codec();
  void open_file();
  void drain();
};

void VideoWriter::Encoder::open_codec() {
  const AVCodec* x264 = avcodec_find_encoder_by_name("libx264");
  if (!x264) throw Error(path + ": this FFmpeg has no libx264");
  codec.reset(avcodec_alloc_context3(x264));
  codec->width = format.width;
  codec->height = format.height;
  codec->pix_fmt = AV_PIX_FMT_YUV420P;
  codec->time_base = {format.rate.denominator, format.rate.numerator};
  codec->framerate = {format.rate.numerator, format.rate.denominator};
  codec->gop_size = key_frame_distance;
  codec->max_b_frames = 0;
  codec->thread_count = encoder_threads;
  codec->color_primaries = AVCOL_PRI_BT709;
  codec->color_trc = AVCOL_TRC_BT709;
  codec->colorspace = AVCOL_SPC_BT709;
  codec->color_range = AVCOL_RANGE_MPEG;
  codec->chroma_sample_location = AVCHROMA_LOC_LEFT;
  codec->flags |= AV_CODEC_FLAG_BITEXACT;
  if (file->oformat->flags & AVFMT_GLOBALHEADER) codec->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
  av_opt_set(codec->priv_data, "preset", "medium", 0);
  av_opt_set(codec->priv_data, "crf", std::to_string(format.crf).c_str(), 0);
  // Plain C would be the same bytes on any processor too; x264's vector code is bit-exact by
  // design.
  checked(avcodec_open2(codec.get(), x264, nullptr), path + ": opening the encoder");
}

void VideoWriter::Encoder::open_file() {
  stream = avformat_new_stream(file.get(), nullptr);
  if (!stream) throw Error(path + ": no memory for a stream");
  stream->time_base = codec->time_base;
  stream->avg_frame_rate = codec->framerate;
  checked(avcodec_parameters_from_context(stream->codecpar, codec.get()), path);
  checked(avio_open(&file->pb, path.c_str(), AVIO_FLAG_WRITE), path + ": opening for writing");
  AVDictionary* options = nullptr;
  av_dict_set(&options, "movflags", "+faststart", 0);
  const int code = avformat_write_header(file.get(), &options);
  av_dict_free(&options);
  checked(code, path + ": writing the header");
}

void VideoWriter::Encoder::drain() {
  for (;;) {
    const int code = avcodec_receive_packet(codec.get(), packet.get());
    if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return;
    checked(code, path + ": encoding");
    packet->duration = 1;
    packet->stream_index = stream->index;
    av_packet_rescale_ts(packet.get(), codec->time_base, stream->time_base);
    checked(av_interleaved_write_frame(file.get(), packet.get()), path + ": writing");
  }
}

VideoWriter::VideoWriter(const std::filesystem::path& path, const VideoFormat& format)
    : encoder_(std::make_unique<Encoder>()) {
  Encoder& e = *encoder_;
  e.path = path.string();
  e.format = format;
  if (format.width < 2 || format.height < 2 || format.width % 2 || format.height % 2) {
    throw Error(e.path + ": H.264 needs an even width and height");
  }
  av_log_set_level(AV_LOG_QUIET);
  AVFormatContext* file = nullptr;
  checked(avformat_alloc_output_context2(&file, nullptr, "mp4", e.path.c_str()), e.path);
  e.file.reset(file);
  e.file->flags |= AVFMT_FLAG_BITEXACT;
  e.open_codec();
  e.open_file();
  e.scaler = make_scaler(format.width, format.height, AV_PIX_FMT_RGB24, AV_PIX_FMT_YUV420P, true);
  e.packet.reset(av_packet_alloc());
  e.picture.reset(av_frame_alloc());
  e.picture->format = AV_PIX_FMT_YUV420P;
  e.picture->width = format.width;
  e.picture->height = format.height;
  checked(av_frame_get_buffer(e.picture.get(), 0), e.path + ": no memory for a frame");
}

VideoWriter::~VideoWriter() = default;
VideoWriter::VideoWriter(VideoWriter&&) noexcept = default;
VideoWriter& VideoWriter::operator=(VideoWriter&&) noexcept = default;

void VideoWriter::write(const Image8& frame) {
  Encoder& e = *encoder_;
  if (frame.width != e.format.width || frame.height != e.format.height) {
    throw Error(e.path + ": a frame has another size than the video");
  }
  checked(av_frame_make_writable(e.picture.get()), e.path);
  const std::uint8_t* rows[1] = {frame.channels.data()};
  const int strides[1] = {3 * frame.width};
  sws_scale(e.scaler.get(), rows, strides, 0, frame.height, e.picture->data, e.picture->linesize);
  e.picture->pts = e.frames++;
  checked(avcodec_send_frame(e.codec.get(), e.picture.get()), e.path + ": encoding");
  e.drain();
}

void VideoWriter::finish() {
  Encoder& e = *encoder_;
  if (e.finished) return;
  if (e.frames == 0) throw Error(e.path + ": a video without frames");
  checked(avcodec_send_frame(e.codec.get(), nullptr), e.path + ": encoding");
  e.drain();
  checked(av_write_trailer(e.file.get()), e.path + ": writing the index");
  checked(avio_closep(&e.file->pb), e.path + ": closing");
  e.finished = true;
}

}  // namespace mien::render
