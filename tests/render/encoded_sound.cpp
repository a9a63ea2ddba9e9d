extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/channel_layout.h>
}

#include <algorithm>
#include <stdexcept>

#include "render/sounds.h"

namespace mien::render::test {

namespace {

void require_done(int code) {
  if (code < 0) throw std::runtime_error("encoding a sound for a test failed");
}

void store_sample(AVFrame& frame, std::size_t place, std::size_t plane, float sample) {
  switch (frame.format) {
    case AV_SAMPLE_FMT_S16:
    case AV_SAMPLE_FMT_S16P:
      reinterpret_cast<std::int16_t*>(frame.data[plane])[place] =
          static_cast<std::int16_t>(std::lround(32767.0 * static_cast<double>(sample)));
      break;
    default:
      reinterpret_cast<float*>(frame.data[plane])[place] = sample;
  }
}

}  // namespace

void write_encoded(const std::filesystem::path& file, const Sound& sound,
                   const std::string& encoder, int rate) {
  AVFormatContext* output = nullptr;
  require_done(avformat_alloc_output_context2(&output, nullptr, nullptr, file.c_str()));
  const AVCodec* codec = avcodec_find_encoder_by_name(encoder.c_str());
  if (codec == nullptr) throw std::runtime_error("no encoder " + encoder);
  AVCodecContext* context = avcodec_alloc_context3(codec);
  context->sample_rate = rate;
  context->sample_fmt = encoder == "flac"      ? AV_SAMPLE_FMT_S16
                        : encoder == "libopus" ? AV_SAMPLE_FMT_FLT
                                               : AV_SAMPLE_FMT_FLTP;
  context->bit_rate = 128'000;
  context->time_base = {1, rate};
  av_channel_layout_default(&context->ch_layout, sound.channels);
  if (output->oformat->flags & AVFMT_GLOBALHEADER) context->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
  require_done(avcodec_open2(context, codec, nullptr));
  AVStream* stream = avformat_new_stream(output, nullptr);
  stream->time_base = context->time_base;
  require_done(avcodec_parameters_from_context(stream->codecpar, context));
  require_done(avio_open(&output->pb, file.c_str(), AVIO_FLAG_WRITE));
  require_done(avformat_write_header(output, nullptr));
  AVPacket* packet = av_packet_alloc();
  const auto drain = [&] {
    while (avcodec_receive_packet(context, packet) >= 0) {
      packet->stream_index = 0;
      av_packet_rescale_ts(packet, context->time_base, stream->time_base);
      require_done(av_interleaved_write_frame(output, packet));
    }
  };
  const auto channels = static_cast<std::size_t>(sound.channels);
  const bool is_planar = context->sample_fmt == AV_SAMPLE_FMT_FLTP;
  for (std::int64_t at = 0; at < sound.frames();) {
    const std::int64_t count = std::min<std::int64_t>(context->frame_size, sound.frames() - at);
    AVFrame* frame = av_frame_alloc();
    frame->format = context->sample_fmt;
    frame->sample_rate = rate;
    frame->nb_samples = static_cast<int>(count);
    frame->pts = at;
    av_channel_layout_copy(&frame->ch_layout, &context->ch_layout);
    require_done(av_frame_get_buffer(frame, 0));
    for (std::size_t i = 0; i < static_cast<std::size_t>(count) * channels; ++i) {
      const float sample = sound.samples[static_cast<std::size_t>(at) * channels + i];
      store_sample(*frame, is_planar ? i / channels : i, is_planar ? i % channels : 0, sample);
    }
    require_done(avcodec_send_frame(context, frame));
    av_frame_free(&frame);
    drain();
    at += count;
  }
  avcodec_send_frame(context, nullptr);
  drain();
  require_done(av_write_trailer(output));
  av_packet_free(&packet);
  avcodec_free_context(&context);
  avio_closep(&output->pb);
  avformat_free_context(output);
}

}  // namespace mien::render::test
