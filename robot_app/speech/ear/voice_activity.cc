#include "robot_app/speech/ear/voice_activity.h"

#include <algorithm>
#include <cmath>

namespace coppice::robot::speech {
namespace {

constexpr std::size_t kFrame = kHearingRate / 100;
constexpr double kFramesPerSecond = 100;
constexpr double kRise = 0.1;  // of the noise in each frame: 10 dB in a second
constexpr double kRiseInSpeech = 0.02;
constexpr double kFall = 0.2;         // of the way down to a quieter frame
constexpr double kLoudestStart = 45;  // dB; a recording may begin with speech
constexpr double kQuietest = 20;      // dB; a microphone that is off is no quiet place
// Of a high pass of 300 Hz: noise rumbles, and from one frame to the next its rumble is now louder
// than speech and now not there.
constexpr double kHighPass = 0.89;

}  // namespace

double VoiceActivity::LevelOf(const std::int16_t* samples) {
  double power = 1;
  for (std::size_t i = 0; i < kFrame; ++i) {
    double value = samples[i];
    for (HighPass& pass : passes_) {
      pass.after = kHighPass * (pass.after + value - pass.before);
      pass.before = value;
      value = pass.after;
    }
    power += value * value / kFrame;
  }
  return 10 * std::log10(power);
}

void VoiceActivity::Frame(const std::int16_t* samples) {
  level_ = LevelOf(samples);
  if (!knows_noise_) noise_ = std::clamp(level_, kQuietest, kLoudestStart);
  knows_noise_ = true;
  noise_ += level_ < noise_ ? kFall * (level_ - noise_) : in_speech_ ? kRiseInSpeech : kRise;
  noise_ = std::max(noise_, kQuietest);
  const bool is_loud = level_ > noise_ + settings_.above_noise;
  loud_ = is_loud ? loud_ + 1 : 0;
  quiet_ = is_loud ? 0 : quiet_ + 1;
  heard_.insert(heard_.end(), samples, samples + kFrame);
  if (in_speech_) {
    speech_ += is_loud ? 1 : 0;
    return;
  }
  in_speech_ = loud_ >= settings_.begins_after * kFramesPerSecond;
  if (in_speech_) {
    speech_ = loud_;
    return;
  }
  const auto most = static_cast<std::size_t>(settings_.before * kHearingRate);
  if (heard_.size() > most) {
    heard_.erase(heard_.begin(), heard_.end() - static_cast<std::ptrdiff_t>(most));
  }
}

bool VoiceActivity::has_ended() const {
  return in_speech_ && (quiet_ >= settings_.ends_after * kFramesPerSecond ||
                        static_cast<double>(heard_.size()) > settings_.longest * kHearingRate);
}

int VoiceActivity::frames_of_pause() const {
  return static_cast<int>(std::lround(settings_.pauses_after * kFramesPerSecond));
}

bool VoiceActivity::has_paused() const {
  return in_speech_ && quiet_ == frames_of_pause() &&
         speech_ >= settings_.shortest * kFramesPerSecond;
}

std::optional<Utterance> VoiceActivity::Hear(const std::vector<std::int16_t>& samples) {
  rest_.insert(rest_.end(), samples.begin(), samples.end());
  std::optional<Utterance> utterance;
  std::size_t at = 0;
  for (; at + kFrame <= rest_.size(); at += kFrame) {
    Frame(rest_.data() + at);
    if (has_paused()) {
      ++pause_;
      utterance = SoFar(false);
    }
    if (!has_ended()) continue;
    if (auto ended = Finish()) utterance = std::move(ended);
  }
  rest_.erase(rest_.begin(), rest_.begin() + static_cast<std::ptrdiff_t>(at));
  return utterance;
}

Utterance VoiceActivity::SoFar(bool has_ended) const {
  const double silence = (quiet_ - settings_.pauses_after * kFramesPerSecond) * kFrame;
  const double most = static_cast<double>(heard_.size());
  const auto end = heard_.end() - static_cast<std::ptrdiff_t>(std::clamp(silence, 0.0, most));
  return {{kHearingRate, {heard_.begin(), end}}, has_ended, pause_};
}

std::optional<Utterance> VoiceActivity::Finish() {
  std::optional<Utterance> utterance;
  if (in_speech_ && speech_ >= settings_.shortest * kFramesPerSecond) utterance = SoFar(true);
  Reset();
  return utterance;
}

bool VoiceActivity::End(int pause) {
  if (!in_speech_ || pause != pause_ || quiet_ < frames_of_pause()) return false;
  Reset();
  return true;
}

void VoiceActivity::Reset() {
  ++pause_;  // what may still be said of the last one comes too late
  heard_.clear();
  in_speech_ = false;
  loud_ = quiet_ = speech_ = 0;
}

}  // namespace coppice::robot::speech
