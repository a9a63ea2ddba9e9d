#include "render/video/libav_probe.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include "render/image_files/picture_limits.h"
#include "render/video/libav.h"
#include "render/video/yuv.h"

namespace mien::render {

namespace {

constexpr int decoder_threads = 2;  // no influence on the pictures

/// Decoders look at the beginning, and take memory for pictures of the size that the file names.
void find_streams(AVFormatContext& input, const std::string& path) {
  const std::string most = std::to_string(max_picture_values);
  std::vector<AVDictionary*> options(input.nb_streams, nullptr);
  for (AVDictionary*& one : options) av_dict_set(&one, "max_pixels", most.c_str(), 0);
  const int code = avformat_find_stream_info(&input, options.data());
  for (AVDictionary*& one : options) av_dict_free(&one);
  checked(code, path + ": reading");
}

Input open_input(const std::string& path) {
  av_log_set_level(AV_LOG_QUIET);
  AVFormatContext* input = nullptr;
  checked(avformat_open_input(&input, ("file:" + path).c_str(), nullptr, nullptr),
          path + ": opening");
  Input owner(input);
  find_streams(*input, path);
  return owner;
}

CodecContext open_decoder(const AVStream* stream, const std::string& path, int threads) {
  const AVCodec* decoder = avcodec_find_decoder(stream->codecpar->codec_id);
  if (!decoder) throw Error(path + ": no decoder for this video");
  require_readable_size(path, stream->codecpar->width, stream->codecpar->height, 3);
  CodecContext codec(avcodec_alloc_context3(decoder));
  checked(avcodec_parameters_to_context(codec.get(), stream->codecpar), path);
  codec->err_recognition = AV_EF_EXPLODE;
  codec->thread_count = threads;
  codec->max_pixels = static_cast<std::int64_t>(max_picture_values);
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

double duration_of(const AVFrame& frame) {
#if LIBAVUTIL_VERSION_MAJOR >= 58
  return static_cast<double>(frame.duration);
#else
  return static_cast<double>(frame.pkt_duration);
#endif
}

bool is_key(const AVFrame& frame) {
#if LIBAVUTIL_VERSION_MAJOR >= 58
  return (frame.flags & AV_FRAME_FLAG_KEY) != 0;
#else
  return frame.key_frame != 0;
#endif
}

std::uint32_t big_endian(const unsigned char* bytes, int count) {
  std::uint32_t value = 0;
  for (int i = 0; i < count; ++i) value = value << 8 | bytes[i];
  return value;
}

/// The times of an animated PNG as the sums of the fractions that it has; FFmpeg adds up what it
/// has rounded.
void take_exact_times(const std::string& path, VideoSummary& summary) {
  std::ifstream file(path, std::ios::binary);
  unsigned char chunk[8 + 24];
  double time = 0.0;
  summary.times.clear();
  for (std::streamoff at = 8;;) {
    file.seekg(at);
    if (!file.read(reinterpret_cast<char*>(chunk), 8)) break;
    if (std::memcmp(chunk + 4, "fcTL", 4) == 0) {
      if (!file.read(reinterpret_cast<char*>(chunk + 8), 24)) break;
      summary.times.push_back(time);
      const auto parts = static_cast<double>(big_endian(chunk + 30, 2));
      time += static_cast<double>(big_endian(chunk + 28, 2)) / (parts == 0.0 ? 100.0 : parts);
    }
    at += 12 + static_cast<std::streamoff>(big_endian(chunk, 4));
  }
  summary.duration_seconds = time;
}

/// The rows 0, step, 2 · step … of a picture.
Image8 rows_of(const Image8& picture, int step) {
  Image8 rows(picture.width, (picture.height + step - 1) / step);
  for (int y = 0; y < rows.height; ++y)
    std::copy_n(picture.at(0, step * y), 3 * picture.width, rows.at(0, y));
  return rows;
}

template <class Sized>
std::string size_text(const Sized& sized) {
  return std::to_string(sized.width) + " x " + std::to_string(sized.height);
}

/// Decoded frames one by one: their order, times and pictures.
struct Decoding {
  const std::string& path;
  const AVStream* stream;
  const std::function<void(const TimedPicture&)>& on_picture;
  VideoSummary& summary;
  int row_step = 1;
  Scaler scaler = nullptr;

  void take(const AVFrame& frame) {
    const int index = summary.frames++;
    const AVCodecParameters& first = *stream->codecpar;
    if (frame.width != first.width || frame.height != first.height)
      throw Error(path + ": frame " + std::to_string(index) + " has " + size_text(frame) +
                  " pixels, and the video " + size_text(first) +
                  "; encode it again with the same size for all frames");
    const double tick = av_q2d(stream->time_base);
    const double seconds = static_cast<double>(frame.best_effort_timestamp) * tick;
    const double duration = duration_of(frame) * tick;
    if (index == 0) summary.starts_with_key_frame = is_key(frame);
    summary.times.push_back(seconds);
    summary.duration_seconds = seconds + duration;
    if (on_picture) on_picture({index, seconds, duration, to_rgb(frame)});
  }

  Image8 to_rgb(const AVFrame& frame) {
    if (frame.format == AV_PIX_FMT_YUV420P && frame.width % 2 == 0 && frame.height % 2 == 0) {
      return rgb_from_yuv({frame.width,
                           frame.height,
                           {frame.data[0], frame.data[1], frame.data[2]},
                           {frame.linesize[0], frame.linesize[1], frame.linesize[2]}},
                          row_step);
    }
    if (!scaler) {
      scaler = make_scaler(frame.width, frame.height, static_cast<AVPixelFormat>(frame.format),
                           AV_PIX_FMT_RGB24, false);
    }
    Image8 image(frame.width, frame.height);
    std::uint8_t* rows[1] = {image.channels.data()};
    const int strides[1] = {3 * frame.width};
    sws_scale(scaler.get(), frame.data, frame.linesize, 0, frame.height, rows, strides);
    return row_step == 1 ? image : rows_of(image, row_step);
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

/// A file opened for decoding.
struct OpenVideo {
  std::string name;
  Input input;
  const AVStream* stream;
  CodecContext codec;

  explicit OpenVideo(const std::filesystem::path& path)
      : name(path.string()),
        input(open_input(name)),
        stream(input->streams[checked(
            av_find_best_stream(input.get(), AVMEDIA_TYPE_VIDEO, -1, -1, nullptr, 0),
            name + ": no video")]),
        codec(open_decoder(stream, name, decoder_threads)) {}

  VideoSummary facts() const {
    VideoSummary facts;
    facts.container = named(input->iformat->name);
    facts.codec = named(avcodec_get_name(stream->codecpar->codec_id));
    facts.pixel_format = named(av_get_pix_fmt_name(codec->pix_fmt));
    facts.width = stream->codecpar->width;
    facts.height = stream->codecpar->height;
    facts.rate = {stream->avg_frame_rate.num, std::max(1, stream->avg_frame_rate.den)};
    facts.primaries = named(av_color_primaries_name(stream->codecpar->color_primaries));
    facts.transfer = named(av_color_transfer_name(stream->codecpar->color_trc));
    facts.matrix = named(av_color_space_name(stream->codecpar->color_space));
    facts.range = named(av_color_range_name(stream->codecpar->color_range));
    facts.tick_seconds = av_q2d(stream->time_base);
    facts.index_at_front = has_index_at_front(name);
    return facts;
  }

  void record_packet(const AVPacket& packet, VideoSummary& summary) const {
    const AVCodecParameters& how = *stream->codecpar;
    const bool has_lengths = how.extradata_size > 0 && how.extradata[0] == 1;  // its version
    const std::span bytes(packet.data, static_cast<std::size_t>(packet.size));
    summary.packet_hashes.push_back(
        packet_hash(named(avcodec_get_name(how.codec_id)), bytes, has_lengths));
  }

  /// The next packet of the video, or none.
  Packet read() const {
    Packet packet(av_packet_alloc());
    for (;;) {
      const int code = av_read_frame(input.get(), packet.get());
      if (code == AVERROR_EOF) return nullptr;
      checked(code, name + ": reading");
      if (packet->stream_index == stream->index) return packet;
      av_packet_unref(packet.get());
    }
  }

  /// Decodes the file, or no more than `most` packets of it.
  void decode(Decoding& decoding, int most) {
    const Frame frame(av_frame_alloc());
    for (; most > 0; --most) {
      const Packet packet = read();
      if (packet == nullptr) break;
      record_packet(*packet, decoding.summary);
      checked(avcodec_send_packet(codec.get(), packet.get()), name + ": decoding");
      receive_all(*codec, *frame, decoding);
    }
    checked(avcodec_send_packet(codec.get(), nullptr), name + ": decoding");
    receive_all(*codec, *frame, decoding);
  }
};

constexpr int shortest_stretch = 12;  // frames

/// Some packets that decode by themselves, and what came of them.
struct Stretch {
  int first = 0;  // frame
  std::vector<Packet> packets;
  VideoSummary found;  // of its frames alone
  std::exception_ptr failure;
};

/// Reads a video in stretches, which are decoded side by side.
class StretchReader {
 public:
  StretchReader(const OpenVideo& video, const std::function<void(const TimedPicture&)>& on_picture,
                int row_step)
      : video_(video), on_picture_(on_picture), row_step_(row_step) {}

  /// The next one, or none at the end. To be called by one thread at a time. What cannot be read
  /// fails in its place.
  std::optional<Stretch> read() {
    if (ended_) return std::nullopt;
    Stretch stretch;
    stretch.first = read_;
    try {
      if (read_ == 0) waiting_ = video_.read();
      while (waiting_ != nullptr) {
        const bool is_key = (waiting_->flags & AV_PKT_FLAG_KEY) != 0;
        if (is_key && std::ssize(stretch.packets) >= shortest_stretch) break;
        stretch.packets.push_back(std::move(waiting_));
        waiting_ = video_.read();
      }
    } catch (...) {
      stretch.failure = std::current_exception();
      waiting_ = nullptr;
    }
    ended_ = waiting_ == nullptr;
    read_ += static_cast<int>(stretch.packets.size());
    return stretch;
  }

  /// Called by several threads concurrently.
  void decode(Stretch& stretch) {
    try {
      CodecContext codec = take_decoder();
      stretch.found.frames = stretch.first;
      Decoding decoding{video_.name, video_.stream, on_picture_, stretch.found, row_step_};
      const Frame frame(av_frame_alloc());
      for (const Packet& packet : stretch.packets) {
        video_.record_packet(*packet, stretch.found);
        checked(avcodec_send_packet(codec.get(), packet.get()), video_.name + ": decoding");
        receive_all(*codec, *frame, decoding);
      }
      checked(avcodec_send_packet(codec.get(), nullptr), video_.name + ": decoding");
      receive_all(*codec, *frame, decoding);
      stretch.found.frames -= stretch.first;
      require_all(stretch);
      give_back(std::move(codec));
    } catch (...) {
      stretch.failure = std::current_exception();  // before what could not be read, if that failed
    }
    stretch.packets.clear();
  }

 private:
  void require_all(const Stretch& stretch) const {
    if (stretch.found.frames == std::ssize(stretch.packets)) return;
    throw Error(video_.name + ": " + std::to_string(stretch.found.frames) + " of " +
                std::to_string(stretch.packets.size()) + " frames decode from frame " +
                std::to_string(stretch.first) + " on");
  }

  CodecContext take_decoder() {
    {
      const std::lock_guard lock(mutex_);
      if (!decoders_.empty()) {
        CodecContext codec = std::move(decoders_.back());
        decoders_.pop_back();
        return codec;
      }
    }
    return open_decoder(video_.stream, video_.name, 1);
  }

  void give_back(CodecContext codec) {
    avcodec_flush_buffers(codec.get());
    const std::lock_guard lock(mutex_);
    decoders_.push_back(std::move(codec));
  }

  const OpenVideo& video_;
  const std::function<void(const TimedPicture&)>& on_picture_;
  int row_step_;
  int read_ = 0;        // packets, except the one that waits
  bool ended_ = false;  // there is nothing more to read
  Packet waiting_;
  std::mutex mutex_;
  std::vector<CodecContext> decoders_;  // not in use
};

void append(VideoSummary& summary, const VideoSummary& next) {
  if (next.frames == 0) return;
  if (summary.frames == 0) summary.starts_with_key_frame = next.starts_with_key_frame;
  summary.frames += next.frames;
  summary.times.insert(summary.times.end(), next.times.begin(), next.times.end());
  summary.packet_hashes.insert(summary.packet_hashes.end(), next.packet_hashes.begin(),
                               next.packet_hashes.end());
  summary.duration_seconds = next.duration_seconds;
}

bool are_steady(const VideoSummary& video) {
  for (std::size_t i = 0; i < video.times.size(); ++i) {
    const double expected = static_cast<double>(i) / video.rate.per_second();
    if (std::abs(video.times[i] - expected) > 0.501 * video.tick_seconds) return false;
  }
  return true;
}

}  // namespace

VideoSummary libav_probe(const std::filesystem::path& path,
                         const std::function<void(const TimedPicture&)>& on_picture, int row_step) {
  OpenVideo video(path);
  VideoSummary summary = video.facts();
  Decoding decoding{video.name, video.stream, on_picture, summary, row_step};
  video.decode(decoding, std::numeric_limits<int>::max());
  if (summary.codec == "apng") take_exact_times(video.name, summary);
  summary.steady_timestamps = are_steady(summary);
  return summary;
}

VideoSummary libav_probe_in_parallel(const std::filesystem::path& path,
                                     const std::function<void(const TimedPicture&)>& on_picture,
                                     int row_step, int threads) {
  const OpenVideo video(path);
  VideoSummary summary = video.facts();
  StretchReader reader(video, on_picture, row_step);
  const auto read = [&](tbb::flow_control& control) -> std::shared_ptr<Stretch> {
    if (auto stretch = reader.read()) return std::make_shared<Stretch>(std::move(*stretch));
    control.stop();
    return nullptr;
  };
  const auto decode = [&](std::shared_ptr<Stretch> stretch) {
    reader.decode(*stretch);
    return stretch;
  };
  const auto take = [&](const std::shared_ptr<Stretch>& stretch) {
    if (stretch->failure) std::rethrow_exception(stretch->failure);
    append(summary, stretch->found);
  };
  using Handed = std::shared_ptr<Stretch>;
  tbb::task_arena arena(threads);
  arena.execute([&] {
    tbb::parallel_pipeline(
        static_cast<std::size_t>(arena.max_concurrency()),
        tbb::make_filter<void, Handed>(tbb::filter_mode::serial_in_order, read) &
            tbb::make_filter<Handed, Handed>(tbb::filter_mode::parallel, decode) &
            tbb::make_filter<Handed, void>(tbb::filter_mode::serial_in_order, take));
  });
  summary.steady_timestamps = are_steady(summary);
  return summary;
}

Image8 libav_decode_first_picture(const std::filesystem::path& path) {
  OpenVideo video(path);
  VideoSummary summary;
  Image8 first;
  const std::function<void(const TimedPicture&)> keep = [&](const TimedPicture& shown) {
    if (shown.index == 0) first = shown.picture;
  };
  Decoding decoding{video.name, video.stream, keep, summary};
  video.decode(decoding, 1);
  if (summary.frames == 0) throw Error(video.name + ": the first frame does not decode alone");
  return first;
}

}  // namespace mien::render
