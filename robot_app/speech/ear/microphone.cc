#include "robot_app/speech/ear/microphone.h"

#include <alsa/asoundlib.h>

#include <memory>

#include "robot_app/speech/sound/sound.h"

namespace coppice::robot::speech {
namespace {

constexpr unsigned kLatency = 100'000;  // of the card's buffer [us]
constexpr std::chrono::milliseconds kLook{100};
constexpr int kLooksBetweenTries = 50;

struct Close {
  void operator()(snd_pcm_t* card) const { snd_pcm_close(card); }
};

}  // namespace

Microphone::Microphone(std::string device, OnSamples on_samples, OnProblem on_problem)
    : device_(std::move(device)),
      on_samples_(std::move(on_samples)),
      on_problem_(std::move(on_problem)),
      thread_([this] { Run(); }) {}

Microphone::~Microphone() {
  stop_ = true;
  thread_.join();
}

void Microphone::Run() {
  while (!stop_) {
    on_problem_(Record());
    for (int i = 0; i < kLooksBetweenTries && !stop_; ++i) std::this_thread::sleep_for(kLook);
  }
}

// Until it is stopped or the card has gone; says why.
std::string Microphone::Record() {
  snd_pcm_t* opened = nullptr;
  int error = snd_pcm_open(&opened, device_.c_str(), SND_PCM_STREAM_CAPTURE, 0);
  const std::unique_ptr<snd_pcm_t, Close> card(opened);
  if (error == 0) {
    error = snd_pcm_set_params(opened, SND_PCM_FORMAT_S16, SND_PCM_ACCESS_RW_INTERLEAVED, 1,
                               kHearingRate, 1, kLatency);
  }
  std::vector<std::int16_t> samples(kHearingRate / 50);
  while (error >= 0 && !stop_) {
    const auto count = snd_pcm_readi(opened, samples.data(), samples.size());
    error = count < 0 ? snd_pcm_recover(opened, static_cast<int>(count), 1) : 0;
    if (count > 0) on_samples_({samples.begin(), samples.begin() + count});
  }
  return stop_ ? std::string() : "the microphone \"" + device_ + "\": " + snd_strerror(error);
}

}  // namespace coppice::robot::speech
