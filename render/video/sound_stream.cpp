#include "render/video/sound_stream.h"

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <span>
#include <utility>

extern "C" {
#include <libavutil/channel_layout.h>
#include <libavutil/cpu.h>
}

namespace mien::render {

namespace {

std::mutex& processor_mutex() {
  static std::mutex mutex;
  return mutex;
}

struct SoundChoice {
  const char* encoder;  ///< FFmpeg's name of the encoder
  AVSampleFormat format;
  int bits_per_channel;  ///< per second
};

SoundChoice choice_of_sound(VideoKind kind) {
  if (sound_codec_of(kind) == "aac") return {"aac", AV_SAMPLE_FMT_FLTP, 128'000};
  return {"libopus", AV_SAMPLE_FMT_FLT, 96'000};
}

/// AAC without what replaces the sound by another that is heard alike: noise, and one channel for
/// two.
void set_encoder_options(AVCodecContext& codec) {
  if (codec.codec_id != AV_CODEC_ID_AAC) return;
  for (const char* option : {"aac_pns", "aac_is"}) {
    checked(av_opt_set(&codec, option, "0", AV_OPT_SEARCH_CHILDREN),
            std::string("sound: the encoder's option ") + option);
  }
}

}  // namespace

PlainProcessor::PlainProcessor() : flags_((processor_mutex().lock(), av_get_cpu_flags())) {
  av_force_cpu_flags(0);
}

PlainProcessor::~PlainProcessor() {
  av_force_cpu_flags(flags_);
  processor_mutex().unlock();
}

SoundStream::SoundStream(AVFormatContext& file, std::string path, VideoKind kind,
                         const Sound& sound)
    : file_(file), path_(std::move(path)), kind_(kind), sound_(sound) {
  const SoundChoice choice = choice_of_sound(kind);
  const AVCodec* encoder = avcodec_find_encoder_by_name(choice.encoder);
  if (!encoder) throw Error(path_ + ": this FFmpeg has no encoder " + choice.encoder);
  codec_.reset(avcodec_alloc_context3(encoder));
  codec_->sample_rate = sound_rate;
  codec_->sample_fmt = choice.format;
  codec_->bit_rate = std::int64_t{choice.bits_per_channel} * sound.channels;
  codec_->time_base = {1, sound_rate};
  codec_->thread_count = 1;
  codec_->flags |= AV_CODEC_FLAG_BITEXACT;
  if (file_.oformat->flags & AVFMT_GLOBALHEADER) codec_->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
  av_channel_layout_default(&codec_->ch_layout, sound.channels);
  set_encoder_options(*codec_);
  {
    const PlainProcessor plain;
    checked(avcodec_open2(codec_.get(), encoder, nullptr), path_ + ": opening the sound's encoder");
  }
  stream_ = avformat_new_stream(&file_, nullptr);
  if (!stream_) throw Error(path_ + ": no memory for a stream");
  stream_->time_base = codec_->time_base;
  checked(avcodec_parameters_from_context(stream_->codecpar, codec_.get()), path_);
  packet_.reset(av_packet_alloc());
  receipt_.hash = hash_of(sound);
  // Matroska's readers subtract the encoder's delay from the times that it stores; older versions
  // of FFmpeg do not add it. MP4 stores an edit list instead.
  const bool adds_delay = LIBAVFORMAT_VERSION_MAJOR >= 60;
  if (codec_->codec_id == AV_CODEC_ID_OPUS && !adds_delay) time_shift_ = codec_->initial_padding;
}

void SoundStream::send(std::int64_t count) {
  const Frame frame(av_frame_alloc());
  frame->format = codec_->sample_fmt;
  frame->sample_rate = sound_rate;
  frame->nb_samples = static_cast<int>(count);
  frame->pts = sent_;
  checked(av_channel_layout_copy(&frame->ch_layout, &codec_->ch_layout), path_);
  checked(av_frame_get_buffer(frame.get(), 0), path_ + ": no memory for a sound");
  const auto channels = static_cast<std::size_t>(sound_.channels);
  const float* source = sound_.samples.data() + static_cast<std::size_t>(sent_) * channels;
  const bool is_planar = av_sample_fmt_is_planar(codec_->sample_fmt) != 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count) * channels; ++i) {
    const std::size_t plane = is_planar ? i % channels : 0;
    const std::size_t place = is_planar ? i / channels : i;
    reinterpret_cast<float*>(frame->data[plane])[place] = source[i];
  }
  checked(avcodec_send_frame(codec_.get(), frame.get()), path_ + ": encoding the sound");
  sent_ += count;
  drain();
}

void SoundStream::drain() {
  for (;;) {
    const int code = avcodec_receive_packet(codec_.get(), packet_.get());
    if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return;
    checked(code, path_ + ": encoding the sound");
    const std::span bytes(packet_->data, static_cast<std::size_t>(packet_->size));
    receipt_.packet_hashes.push_back(packet_hash(sound_codec_of(kind_), bytes, false));
    packet_->stream_index = stream_->index;
    packet_->pts += time_shift_;
    packet_->dts += time_shift_;
    av_packet_rescale_ts(packet_.get(), codec_->time_base, stream_->time_base);
    checked(av_interleaved_write_frame(&file_, packet_.get()), path_ + ": writing");
  }
}

void SoundStream::write_until(std::int64_t frame) {
  const std::int64_t end = std::min(frame, sound_.frames());
  while (sent_ < end) send(std::min(std::int64_t{codec_->frame_size}, sound_.frames() - sent_));
}

void SoundStream::finish() {
  write_until(sound_.frames());
  checked(avcodec_send_frame(codec_.get(), nullptr), path_ + ": encoding the sound");
  drain();
}

}  // namespace mien::render
