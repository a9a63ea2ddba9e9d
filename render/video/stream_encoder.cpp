#include "render/video/stream_encoder.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <span>
#include <utility>

namespace mien::render {

namespace {

/// Fixed, because encoders divide their work by the number of threads: the bytes depend on it.
constexpr int encoder_threads = 2;
constexpr int key_frame_distance = 60;

/// How FFmpeg encodes a kind of video.
struct EncoderChoice {
  const char* encoder;    ///< FFmpeg's name of the encoder
  const char* container;  ///< FFmpeg's name of the file format
  AVPixelFormat pixels;   ///< format of the frames that the encoder is given
};

/// The table is in the order of VideoKind.
const EncoderChoice& choice_of(VideoKind kind) {
  static constexpr EncoderChoice choices[] = {{"libx264", "mp4", AV_PIX_FMT_YUV420P},
                                              {"libx264rgb", "mp4", AV_PIX_FMT_RGB24},
                                              {"libvpx-vp9", "webm", AV_PIX_FMT_YUV420P},
                                              {"libaom-av1", "webm", AV_PIX_FMT_YUV420P},
                                              {"ffv1", "matroska", AV_PIX_FMT_BGR0},
                                              {"libwebp_anim", "webp", AV_PIX_FMT_BGRA},
                                              {"gif", "gif", AV_PIX_FMT_PAL8},
                                              {"apng", "apng", AV_PIX_FMT_RGB24}};
  static_assert(std::size(choices) == static_cast<std::size_t>(VideoKind::apng) + 1);
  return choices[static_cast<std::size_t>(kind)];
}

/// Sets options of an encoder; an unknown one is a programming error.
void set(AVCodecContext& codec,
         std::initializer_list<std::pair<const char*, const char*>> options) {
  for (const auto& [name, value] : options) {
    checked(av_opt_set(&codec, name, value, AV_OPT_SEARCH_CHILDREN),
            std::string("video: the encoder's option ") + name);
  }
}

void tag(AVCodecContext& codec, bool is_rgb) {
  codec.color_primaries = AVCOL_PRI_BT709;
  codec.color_trc = is_rgb ? AVCOL_TRC_IEC61966_2_1 : AVCOL_TRC_BT709;
  codec.colorspace = is_rgb ? AVCOL_SPC_RGB : AVCOL_SPC_BT709;
  codec.color_range = is_rgb ? AVCOL_RANGE_JPEG : AVCOL_RANGE_MPEG;
  if (!is_rgb) codec.chroma_sample_location = AVCHROMA_LOC_LEFT;
}

/// x264 as it is the same on all machines and whatever else they do: no vector code that rounds
/// otherwise, no thread of its own that looks ahead. At 1920 x 1080 each frame that it looks ahead
/// takes 6 MB, and threads with a frame each, instead of a slice of one, 15 MB.
constexpr const char* x264_params =
    "cpu-independent=1:sync-lookahead=0:rc-lookahead=4:sliced-threads=1";

/// Frames that a frame is predicted from, one less than of preset medium. Each takes 10 MB at
/// 1920 x 1080; files are larger by 0.6 %.
constexpr int x264_references = 2;

/// AV1 divides a picture into tiles of whole blocks of 128 pixels.
const char* av1_tiles(const AVCodecContext& codec) {
  return std::min(codec.width, codec.height) > 128 ? "2x2" : "1x1";
}

void set_quality(AVCodecContext& codec, VideoKind kind, bool fast) {
  switch (kind) {
    case VideoKind::mp4:
      codec.max_b_frames = 0;  // players that ignore edit lists show the right times
      if (!fast) codec.refs = x264_references;
      return set(codec, {{"preset", fast ? "ultrafast" : "medium"},
                         {"crf", fast ? "18" : "16"},
                         {"x264-params", x264_params}});
    case VideoKind::mp4_lossless:
      codec.max_b_frames = 0;
      if (!fast) codec.refs = x264_references;
      return set(
          codec,
          {{"preset", fast ? "ultrafast" : "medium"}, {"qp", "0"}, {"x264-params", x264_params}});
    case VideoKind::webm:
      return set(codec, {{"crf", "18"},
                         {"b", "0"},
                         {"deadline", "good"},
                         {"cpu-used", fast ? "5" : "2"},
                         {"tile-columns", "2"},
                         {"lag-in-frames", "16"}});
    case VideoKind::webm_av1:
      return set(codec, {{"crf", "18"},
                         {"b", "0"},
                         {"usage", fast ? "realtime" : "good"},
                         {"cpu-used", fast ? "8" : "6"},
                         {"tiles", av1_tiles(codec)},
                         {"lag-in-frames", fast ? "0" : "16"}});
    case VideoKind::mkv:
      codec.gop_size = 1;  // any frame can be cut out
      codec.slices = 4;
      codec.level = 3;
      return set(codec, {{"slicecrc", "1"}});
    case VideoKind::webp:
      return set(codec, {{"lossless", "0"}, {"quality", "92"}});
    case VideoKind::gif:
      return;
    case VideoKind::apng:
      return set(codec, {{"pred", fast ? "up" : "mixed"}});
  }
}

AVDictionary* container_options(const VideoFormat& format) {
  AVDictionary* options = nullptr;
  const auto repeat = [&](const char* option, const char* once) {
    av_dict_set(&options, option, format.loops ? "0" : once, 0);
  };
  if (format.kind == VideoKind::mp4 || format.kind == VideoKind::mp4_lossless)
    av_dict_set(&options, "movflags", "+faststart", 0);
  if (format.kind == VideoKind::webp) repeat("loop", "1");
  if (format.kind == VideoKind::gif) repeat("loop", "-1");
  if (format.kind == VideoKind::apng) repeat("plays", "1");
  return options;
}

}  // namespace

AVPixelFormat pixel_format_of(VideoKind kind) { return choice_of(kind).pixels; }

StreamEncoder::StreamEncoder(const std::filesystem::path& path, const VideoFormat& format,
                             const Sound* sound)
    : path_(path.string()), format_(format) {
  av_log_set_level(AV_LOG_QUIET);
  AVFormatContext* file = nullptr;
  const std::string url = "file:" + path_;  // whatever the name looks like
  checked(
      avformat_alloc_output_context2(&file, nullptr, choice_of(format.kind).container, url.c_str()),
      path_);
  file_.reset(file);
  file_->flags |= AVFMT_FLAG_BITEXACT;
  open_codec();
  open_streams(sound);
  open_file();
  packet_.reset(av_packet_alloc());
  picture_.reset(av_frame_alloc());
  picture_->format = codec_->pix_fmt;
  picture_->width = format.width;
  picture_->height = format.height;
  picture_->color_primaries = codec_->color_primaries;
  picture_->color_trc = codec_->color_trc;
  picture_->colorspace = codec_->colorspace;
  picture_->color_range = codec_->color_range;
  checked(av_frame_get_buffer(picture_.get(), 0), path_ + ": no memory for a frame");
}

void StreamEncoder::open_codec() {
  const EncoderChoice choice = choice_of(format_.kind);
  const AVCodec* encoder = avcodec_find_encoder_by_name(choice.encoder);
  if (!encoder) throw Error(path_ + ": this FFmpeg has no " + choice.encoder);
  codec_.reset(avcodec_alloc_context3(encoder));
  codec_->width = format_.width;
  codec_->height = format_.height;
  codec_->pix_fmt = choice.pixels;
  codec_->time_base = {format_.rate.denominator, format_.rate.numerator};
  codec_->framerate = {format_.rate.numerator, format_.rate.denominator};
  codec_->gop_size = key_frame_distance;
  codec_->thread_count = encoder_threads;
  codec_->flags |= AV_CODEC_FLAG_BITEXACT;
  if (file_->oformat->flags & AVFMT_GLOBALHEADER) codec_->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
  tag(*codec_, choice.pixels != AV_PIX_FMT_YUV420P);
  set_quality(*codec_, format_.kind, format_.effort == VideoEffort::fast);
  checked(avcodec_open2(codec_.get(), encoder, nullptr), path_ + ": opening the encoder");
}

void StreamEncoder::open_streams(const Sound* sound) {
  stream_ = avformat_new_stream(file_.get(), nullptr);
  if (!stream_) throw Error(path_ + ": no memory for a stream");
  stream_->time_base = codec_->time_base;
  stream_->avg_frame_rate = codec_->framerate;
  checked(avcodec_parameters_from_context(stream_->codecpar, codec_.get()), path_);
  if (sound == nullptr) return;
  sound_.emplace(*file_, path_, format_.kind, *sound);
  file_->max_interleave_delta = 0;  // encoders of pictures may hold back more seconds than usual
}

void StreamEncoder::open_file() {
  checked(avio_open(&file_->pb, file_->url, AVIO_FLAG_WRITE), path_ + ": opening for writing");
  AVDictionary* options = container_options(format_);
  const int code = avformat_write_header(file_.get(), &options);
  av_dict_free(&options);
  checked(code, path_ + ": writing the header");
}

void StreamEncoder::record_packet() {
  if (packet_->pts != static_cast<std::int64_t>(packet_hashes_.size())) {
    throw Error(path_ + ": the encoder gives frame " + std::to_string(packet_->pts) +
                " where frame " + std::to_string(packet_hashes_.size()) + " comes next");
  }
  const std::span bytes(packet_->data, static_cast<std::size_t>(packet_->size));
  packet_hashes_.push_back(packet_hash(traits_of(format_.kind).codec, bytes, false));
}

void StreamEncoder::drain() {
  for (;;) {
    const int code = avcodec_receive_packet(codec_.get(), packet_.get());
    if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return;
    checked(code, path_ + ": encoding");
    if (has_packet_per_frame(format_.kind)) record_packet();
    packet_->duration = 1;
    packet_->stream_index = stream_->index;
    av_packet_rescale_ts(packet_.get(), codec_->time_base, stream_->time_base);
    checked(av_interleaved_write_frame(file_.get(), packet_.get()), path_ + ": writing");
  }
}

AVFrame& StreamEncoder::picture() {
  checked(av_frame_make_writable(picture_.get()), path_);
  return *picture_;
}

void StreamEncoder::send() {
  picture_->pts = frames_++;
  checked(avcodec_send_frame(codec_.get(), picture_.get()), path_ + ": encoding");
  drain();
  if (sound_) sound_->write_until(av_rescale_q(frames_, codec_->time_base, {1, sound_rate}));
}

std::optional<SoundReceipt> StreamEncoder::sound_receipt() const {
  return sound_ ? std::optional(sound_->receipt()) : std::nullopt;
}

void StreamEncoder::set_last_duration() {
  const std::int64_t last = av_rescale_q(frames_ - 1, codec_->time_base, stream_->time_base);
  const std::int64_t end = av_rescale_q(frames_, codec_->time_base, stream_->time_base);
  checked(av_opt_set_int(file_->priv_data, "final_delay", end - last, 0),
          path_ + ": the last frame's length");
}

void StreamEncoder::finish() {
  if (frames_ == 0) throw Error(path_ + ": a video without frames");
  checked(avcodec_send_frame(codec_.get(), nullptr), path_ + ": encoding");
  drain();
  if (has_packet_per_frame(format_.kind) &&
      static_cast<std::int64_t>(packet_hashes_.size()) != frames_) {
    throw Error(path_ + ": the encoder gave " + std::to_string(packet_hashes_.size()) + " of " +
                std::to_string(frames_) + " frames");
  }
  if (sound_) sound_->finish();
  if (format_.kind == VideoKind::gif) set_last_duration();
  checked(av_write_trailer(file_.get()), path_ + ": writing the index");
  checked(avio_closep(&file_->pb), path_ + ": closing");
}

}  // namespace mien::render
