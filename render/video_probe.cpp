#include <cmath>
#include <cstring>
#include <fstream>

#include "render/libav.h"
#include "render/video.h"

namespace mien::render {

namespace {

Input open_input(const std::string& path) {
  av_log_set_level(AV_LOG_QUIET);
  AVFormatContext* input = nullptr;
  checked(avformat_open_input(&input, path.c_str(), nullptr, nullptr), path + ": opening");
  Input owner(input);
  checked(avformat_find_stream_info(input, nullptr), path + ": reading");
  return owner;
}

CodecContext open_decoder(const AVStream* stream, const std::string& path) {
  const AVCodec* decoder = avcodec_find_decoder(stream->codecpar->codec_id);
  if (!decoder) throw Error(path + ": no decoder for this video");
  CodecContext codec(avcodec_alloc_context3(decoder));
  checked(avcodec_parameters_to_context(codec.get(), stream->codecpar), path);
  codec->err_recognition = AV_EF_EXPLODE;
  checked(avcodec_open2(codec.get(), decoder, nullptr), path + ": opening the decoder");
  return codec;
}

std::string named(const char* name) { return name ? name : ""; }

/// Whether the index box of an MP4 file precedes the pictures.
bool has_index_at_front(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  for (;;) {
    unsigned char head[8];
    if (!file.read(reinterpret_cast<char*>(head), sizeof head)) return false;
    if (std::memcmp(head + 4, "moov", 4) == 0) return true;
    if (std::memcmp(head + 4, "mdat", 4) == 0) return false;
    const std::uint32_t size = (std::uint32_t{head[0]} << 24) | (std::uint32_t{head[1]} << 16) |
                               (std::uint32_t{head[2]} << 8) | std::uint32_t{head[3]};
    if (size < 8) return false;
    file.seekg(static_cast<std::streamoff>(size) - 8, std::ios::cur);
  }
}

/// Decoded frames one by one: their order, times and pictures.
struct Decoding {
  const std::string& path;
  const AVStream* stream;
  const std::function<void(int, const Image8&)>& on_frame;
  VideoSummary& summary;
  Scaler scaler = nullptr;

  void take(const AVFrame& frame) {
    const int index = summary.frames++;
    const double seconds =
        static_cast<double>(frame.best_effort_timestamp) * av_q2d(stream->time_base);
    const double start = stream->start_time == AV_NOPTS_VALUE
                             ? 0.0
                             : static_cast<double>(stream->start_time) * av_q2d(stream->time_base);
    const double expected = index / summary.rate.per_second();
    if (std::abs(seconds - start - expected) > 1e-6) summary.steady_timestamps = false;
    if (index == 0) {
#if LIBAVUTIL_VERSION_MAJOR >= 58
      summary.starts_with_key_frame = (frame.flags & AV_FRAME_FLAG_KEY) != 0;
#else
      summary.starts_with_key_frame = frame.key_frame != 0;
#endif
      if (std::abs(start) > 1e-6) summary.steady_timestamps = false;
    }
    if (on_frame) on_frame(index, to_rgb(frame));
  }

  Image8 to_rgb(const AVFrame& frame) {
    if (!scaler) {
      scaler = make_scaler(frame.width, frame.height, static_cast<AVPixelFormat>(frame.format),
                           AV_PIX_FMT_RGB24, false);
    }
    Image8 image(frame.width, frame.height);
    std::uint8_t* rows[1] = {image.channels.data()};
    const int strides[1] = {3 * frame.width};
    sws_scale(scaler.get(), frame.data, frame.linesize, 0, frame.height, rows, strides);
    return image;
  }
};

void receive_all(AVCodecContext& codec, AVFrame& frame, Decoding& decoding) {
  for (;;) {
    const int code = avcodec_receive_frame(&codec, &frame);
    if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return;
    checked(code, decoding.path + ": decoding frame " + std::to_string(decoding.summary.frames));
    decoding.take(frame);
    av_frame_unref(&frame);
  }
}

}  // namespace

VideoSummary probe(const std::filesystem::path& path,
                   const std::function<void(int, const Image8&)>& on_frame) {
  const std::string name = path.string();
  const Input input = open_input(name);
  const int index =
      checked(av_find_best_stream(input.get(), AVMEDIA_TYPE_VIDEO, -1, -1, nullptr, 0),
              name + ": no video");
  const AVStream* stream = input->streams[index];
  const CodecContext codec = open_decoder(stream, name);

  VideoSummary summary;
  summary.container = named(input->iformat->name);
  summary.codec = named(avcodec_get_name(stream->codecpar->codec_id));
  summary.pixel_format = named(av_get_pix_fmt_name(codec->pix_fmt));
  summary.width = stream->codecpar->width;
  summary.height = stream->codecpar->height;
  summary.rate = {stream->avg_frame_rate.num, std::max(1, stream->avg_frame_rate.den)};
  summary.primaries = named(av_color_primaries_name(stream->codecpar->color_primaries));
  summary.transfer = named(av_color_transfer_name(stream->codecpar->color_trc));
  summary.matrix = named(av_color_space_name(stream->codecpar->color_space));
  summary.range = named(av_color_range_name(stream->codecpar->color_range));
  summary.index_at_front = has_index_at_front(name);
  summary.steady_timestamps = true;

  const Packet packet(av_packet_alloc());
  const Frame frame(av_frame_alloc());
  Decoding decoding{name, stream, on_frame, summary};
  for (;;) {
    const int code = av_read_frame(input.get(), packet.get());
    if (code == AVERROR_EOF) break;
    checked(code, name + ": reading");
    if (packet->stream_index == index) {
      checked(avcodec_send_packet(codec.get(), packet.get()), name + ": decoding");
      receive_all(*codec, *frame, decoding);
    }
    av_packet_unref(packet.get());
  }
  checked(avcodec_send_packet(codec.get(), nullptr), name + ": decoding");
  receive_all(*codec, *frame, decoding);
  summary.duration_seconds = summary.frames / summary.rate.per_second();
  return summary;
}

std::string video_libraries() {
  const auto version = [](unsigned v) {
    return std::to_string(AV_VERSION_MAJOR(v)) + "." + std::to_string(AV_VERSION_MINOR(v)) + "." +
           std::to_string(AV_VERSION_MICRO(v));
  };
  return "libavcodec " + version(avcodec_version()) + ", libavformat " +
         version(avformat_version()) + ", libswscale " + version(swscale_version());
}

}  // namespace mien::render
