#include "render/video/sound_reader.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>

extern "C" {
#include <libavutil/channel_layout.h>
#include <libswresample/swresample.h>
}

#include "render/video/libav.h"
#include "render/video/sound_stream.h"

namespace mien::render {

namespace {

constexpr char sound_formats[] = "wav,flac,ogg,mp3";
constexpr std::int64_t most_frames = static_cast<std::int64_t>(longest_sound_seconds) * sound_rate;

struct FreeResampler {
  void operator()(SwrContext* resampler) const { swr_free(&resampler); }
};
using Resampler = std::unique_ptr<SwrContext, FreeResampler>;

/// Opens a file; only in some formats, if they are given.
Input open_file_with_sound(const std::string& path, const char* formats) {
  av_log_set_level(AV_LOG_QUIET);
  AVDictionary* options = nullptr;
  if (formats != nullptr) av_dict_set(&options, "format_whitelist", formats, 0);
  AVFormatContext* opened = nullptr;
  const int code = avformat_open_input(&opened, ("file:" + path).c_str(), nullptr, &options);
  av_dict_free(&options);
  // Other formats are refused as an invalid argument.
  const bool is_unknown = code == AVERROR(EINVAL) || code == AVERROR_INVALIDDATA;
  if (formats != nullptr && is_unknown)
    throw Error(path + ": is not a sound file; save it as WAV, FLAC, Opus, Ogg Vorbis or MP3");
  checked(code, path + ": opening");
  Input input(opened);
  checked(avformat_find_stream_info(input.get(), nullptr), path + ": reading");
  return input;
}

/// Decodes one stream of sound, converted to sound_rate.
class SoundDecoder {
 public:
  SoundDecoder(const AVStream& stream, std::string path)
      : stream_(stream), path_(std::move(path)), frame_(av_frame_alloc()) {
    const AVCodec* decoder = avcodec_find_decoder(stream.codecpar->codec_id);
    if (!decoder) throw Error(path_ + ": no decoder for this sound");
    codec_.reset(avcodec_alloc_context3(decoder));
    checked(avcodec_parameters_to_context(codec_.get(), stream.codecpar), path_);
    codec_->pkt_timebase = stream.time_base;
    codec_->err_recognition = AV_EF_EXPLODE;
    codec_->thread_count = 1;
    const PlainProcessor plain;
    checked(avcodec_open2(codec_.get(), decoder, nullptr), path_ + ": opening the decoder");
  }

  void take(const AVPacket* packet) {
    checked(avcodec_send_packet(codec_.get(), packet), fault_at_this_time());
    for (;;) {
      const int code = avcodec_receive_frame(codec_.get(), frame_.get());
      if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return;
      checked(code, fault_at_this_time());
      convert(*frame_);
      av_frame_unref(frame_.get());
    }
  }

  /// Takes the last of what the decoder and the conversion hold back.
  Sound finish() {
    take(nullptr);
    if (sound_.samples.empty() && decoded_ == 0) throw Error(path_ + ": has no sound");
    append(nullptr, 0);
    // The conversion's end is as long as its filter.
    const std::int64_t frames =
        static_cast<std::int64_t>(std::llround(static_cast<double>(decoded_) * sound_rate / rate_));
    sound_.samples.resize(static_cast<std::size_t>(frames * sound_.channels));
    return std::move(sound_);
  }

  double start_seconds() const { return start_seconds_; }

 private:
  std::string fault_at_this_time() const {
    const double seconds = rate_ > 0 ? static_cast<double>(decoded_) / rate_ : 0.0;
    return path_ + ": decoding the sound at " + std::to_string(seconds) + " s";
  }

  void open_resampler(const AVFrame& frame) {
    rate_ = frame.sample_rate;
    const int channels = frame.ch_layout.nb_channels;
    if (channels < 1 || channels > 2) {
      throw Error(path_ + ": has " + std::to_string(channels) +
                  " channels; mix it down to one or two");
    }
    if (rate_ < 1) throw Error(path_ + ": has no sample rate");
    sound_.channels = channels;
    AVChannelLayout layout = {};
    av_channel_layout_default(&layout, channels);
    SwrContext* made = nullptr;
    checked(swr_alloc_set_opts2(&made, &layout, AV_SAMPLE_FMT_FLT, sound_rate, &layout,
                                static_cast<AVSampleFormat>(frame.format), rate_, 0, nullptr),
            path_);
    resampler_.reset(made);
    av_opt_set_sample_fmt(made, "internal_sample_fmt", AV_SAMPLE_FMT_DBLP, 0);
    const PlainProcessor plain;
    checked(swr_init(made), path_ + ": converting the sound");
    format_ = frame.format;
    if (frame.pts != AV_NOPTS_VALUE)
      start_seconds_ = static_cast<double>(frame.pts) * av_q2d(stream_.time_base);
  }

  void convert(const AVFrame& frame) {
    if (!resampler_) open_resampler(frame);
    if (frame.sample_rate != rate_ || frame.ch_layout.nb_channels != sound_.channels ||
        frame.format != format_)
      throw Error(path_ + ": changes its rate or channels; save it with the same throughout");
    append(frame.extended_data, frame.nb_samples);
    decoded_ += frame.nb_samples;
    if (sound_.frames() > most_frames) {
      throw Error(path_ + ": lasts longer than " +
                  std::to_string(static_cast<int>(longest_sound_seconds)) +
                  " s; cut out what is to be heard");
    }
  }

  void append(std::uint8_t** planes, int count) {
    const auto channels = static_cast<std::size_t>(sound_.channels);
    const int room = checked(swr_get_out_samples(resampler_.get(), count), path_);
    const std::size_t before = sound_.samples.size();
    sound_.samples.resize(before + static_cast<std::size_t>(room) * channels);
    auto* place = reinterpret_cast<std::uint8_t*>(sound_.samples.data() + before);
    const int made = checked(swr_convert(resampler_.get(), &place, room,
                                         const_cast<const std::uint8_t**>(planes), count),
                             path_ + ": converting the sound");
    sound_.samples.resize(before + static_cast<std::size_t>(made) * channels);
  }

  const AVStream& stream_;
  std::string path_;
  Frame frame_;
  CodecContext codec_;
  Resampler resampler_;
  Sound sound_;
  int rate_ = 0;
  int format_ = 0;
  std::int64_t decoded_ = 0;  // sample frames at the file's rate
  double start_seconds_ = 0.0;
};

/// Decodes a stream, passing each of its packets to `on_packet` first.
template <class OnPacket>
VideoSound decoded_stream(AVFormatContext& input, int index, const std::string& path,
                          const OnPacket& on_packet) {
  const AVStream& stream = *input.streams[index];
  SoundDecoder decoder(stream, path);
  const Packet packet(av_packet_alloc());
  for (;;) {
    const int code = av_read_frame(&input, packet.get());
    if (code == AVERROR_EOF) break;
    checked(code, path + ": reading");
    if (packet->stream_index == index) {
      on_packet(*packet);
      decoder.take(packet.get());
    }
    av_packet_unref(packet.get());
  }
  VideoSound found;
  found.codec = avcodec_get_name(stream.codecpar->codec_id);
  found.sound = decoder.finish();
  found.start_seconds = decoder.start_seconds();
  return found;
}

}  // namespace

Sound libav_read_sound(const std::filesystem::path& file) {
  const std::string path = file.string();
  const Input input = open_file_with_sound(path, sound_formats);
  const int index = av_find_best_stream(input.get(), AVMEDIA_TYPE_AUDIO, -1, -1, nullptr, 0);
  if (index < 0) throw Error(path + ": has no sound");
  Sound sound = decoded_stream(*input, index, path, [](const AVPacket&) {}).sound;
  if (sound.samples.empty()) throw Error(path + ": has no sound");
  return sound;
}

std::optional<VideoSound> libav_sound_of_video(const std::filesystem::path& file) {
  const std::string path = file.string();
  const Input input = open_file_with_sound(path, nullptr);
  const int index = av_find_best_stream(input.get(), AVMEDIA_TYPE_AUDIO, -1, -1, nullptr, 0);
  if (index < 0) return std::nullopt;
  std::vector<std::uint64_t> hashes;
  const std::string codec = avcodec_get_name(input->streams[index]->codecpar->codec_id);
  VideoSound found = decoded_stream(*input, index, path, [&](const AVPacket& packet) {
    hashes.push_back(
        packet_hash(codec, {packet.data, static_cast<std::size_t>(packet.size)}, false));
  });
  found.packet_hashes = std::move(hashes);
  return found;
}

}  // namespace mien::render
