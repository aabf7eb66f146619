#include "robot_app/speech/ear/voice_activity.h"

#include <algorithm>
#include <cmath>

namespace coppice::robot::speech {
namespace {

constexpr std::size_t kFrame = kHearingRate / 100;
constexpr double kFramesPerSecond = 100;
constexpr double kRise = 0.02;        // of the noise in each frame: 2 dB in a second
constexpr double kFall = 0.2;         // of the way down to a quieter frame
constexpr double kLoudestStart = 45;  // dB; a recording may begin with speech
constexpr double kQuietest = 20;      // dB; a microphone that is off is no quiet place

double Level(const std::int16_t* samples) {
  double power = 1;
  for (std::size_t i = 0; i < kFrame; ++i) {
    power += static_cast<double>(samples[i]) * samples[i] / kFrame;
  }
  return 10 * std::log10(power);
}

}  // namespace

// True when an utterance has ended.
bool VoiceActivity::Frame(const std::int16_t* samples) {
  level_ = Level(samples);
  if (!knows_noise_) noise_ = std::clamp(level_, kQuietest, kLoudestStart);
  knows_noise_ = true;
  noise_ += level_ < noise_ ? kFall * (level_ - noise_) : kRise;
  noise_ = std::max(noise_, kQuietest);
  const bool is_loud = level_ > noise_ + settings_.above_noise;
  loud_ = is_loud ? loud_ + 1 : 0;
  quiet_ = is_loud ? 0 : quiet_ + 1;
  heard_.insert(heard_.end(), samples, samples + kFrame);
  if (in_speech_) {
    speech_ += is_loud ? 1 : 0;
    return quiet_ >= settings_.ends_after * kFramesPerSecond ||
           static_cast<double>(heard_.size()) > settings_.longest * kHearingRate;
  }
  in_speech_ = loud_ >= settings_.begins_after * kFramesPerSecond;
  if (in_speech_) {
    speech_ = loud_;
    return false;
  }
  const auto most = static_cast<std::size_t>(settings_.before * kHearingRate);
  if (heard_.size() > most) {
    heard_.erase(heard_.begin(), heard_.end() - static_cast<std::ptrdiff_t>(most));
  }
  return false;
}

std::optional<Sound> VoiceActivity::Hear(const std::vector<std::int16_t>& samples) {
  rest_.insert(rest_.end(), samples.begin(), samples.end());
  std::optional<Sound> ended;
  std::size_t at = 0;
  for (; at + kFrame <= rest_.size(); at += kFrame) {
    if (!Frame(rest_.data() + at)) continue;
    if (auto utterance = Finish()) ended = std::move(utterance);
  }
  rest_.erase(rest_.begin(), rest_.begin() + static_cast<std::ptrdiff_t>(at));
  return ended;
}

std::optional<Sound> VoiceActivity::Finish() {
  const bool is_utterance = in_speech_ && speech_ >= settings_.shortest * kFramesPerSecond;
  const double silence = (quiet_ - settings_.before * kFramesPerSecond) * kFrame;
  const auto end = heard_.size() - static_cast<std::size_t>(std::clamp(
                                       silence, 0.0, static_cast<double>(heard_.size())));
  Sound sound{kHearingRate, std::move(heard_)};
  Reset();
  if (!is_utterance) return std::nullopt;
  sound.samples.resize(end);
  return sound;
}

void VoiceActivity::Reset() {
  heard_.clear();
  in_speech_ = false;
  loud_ = quiet_ = speech_ = 0;
}

}  // namespace coppice::robot::speech
