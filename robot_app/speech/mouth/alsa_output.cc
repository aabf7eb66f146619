#include "robot_app/speech/mouth/alsa_output.h"

#include <alsa/asoundlib.h>

#include <algorithm>
#include <memory>

namespace coppice::robot::speech {
namespace {

constexpr unsigned kLatency = 60'000;  // of the card's buffer [us]

struct Close {
  void operator()(snd_pcm_t* card) const { snd_pcm_close(card); }
};
using Card = std::unique_ptr<snd_pcm_t, Close>;

Expected<Card> OpenCard(const std::string& device, int rate) {
  snd_pcm_t* opened = nullptr;
  int error = snd_pcm_open(&opened, device.c_str(), SND_PCM_STREAM_PLAYBACK, 0);
  Card card(opened);
  if (error == 0) {
    error = snd_pcm_set_params(opened, SND_PCM_FORMAT_S16, SND_PCM_ACCESS_RW_INTERLEAVED, 1,
                               static_cast<unsigned>(rate), 1, kLatency);
  }
  if (error < 0) return Problem{"the sound card \"" + device + "\": " + snd_strerror(error)};
  return card;
}

// Of the frames that were handed to the card, those that it has played.
double Heard(snd_pcm_t* card, std::size_t written, int rate) {
  snd_pcm_sframes_t waiting = 0;
  if (snd_pcm_delay(card, &waiting) < 0) waiting = 0;
  const auto left = static_cast<std::size_t>(std::max<snd_pcm_sframes_t>(waiting, 0));
  return static_cast<double>(written - std::min(written, left)) / rate;
}

void Play(Card card, const Sound& sound, const std::atomic<bool>& stop,
          std::atomic<double>& played) {
  const auto chunk = static_cast<std::size_t>(sound.rate / 50);
  std::size_t written = 0;
  while (written < sound.samples.size() && !stop) {
    const std::size_t count = std::min(chunk, sound.samples.size() - written);
    const auto taken = snd_pcm_writei(card.get(), sound.samples.data() + written, count);
    if (taken >= 0) {
      written += static_cast<std::size_t>(taken);
    } else if (snd_pcm_recover(card.get(), static_cast<int>(taken), 1) < 0) {
      break;  // the card has gone: nobody hears the rest
    }
    played = Heard(card.get(), written, sound.rate);
  }
  if (stop) {
    snd_pcm_drop(card.get());
  } else {
    snd_pcm_drain(card.get());
    played = sound.seconds();
  }
}

}  // namespace

Outcome AlsaOutput::Start(const Sound& sound) {
  Stop();
  Expected<Card> card = OpenCard(device_, sound.rate);
  if (!card) return Problem{card.problem()};
  stop_ = false;
  played_ = 0;
  thread_ = std::thread([this, sound, card = *std::move(card)]() mutable {
    Play(std::move(card), sound, stop_, played_);
  });
  return {};
}

void AlsaOutput::Stop() {
  stop_ = true;
  if (thread_.joinable()) thread_.join();
}

}  // namespace coppice::robot::speech
