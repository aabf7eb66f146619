#include "robot_app/speech/ear/ear.h"

namespace coppice::robot::speech {

bool Ear::is_open(Time now) const {
  if (speaks_ || (shut_until_ && now < *shut_until_)) return false;
  return listening_ == Listening::kAlways || is_pressed_;
}

std::optional<Utterance> Ear::Hear(const std::vector<std::int16_t>& samples, Time now) {
  if (!is_open(now)) return std::nullopt;
  return activity_.Hear(samples);
}

std::optional<Utterance> Ear::HearWhole(const Sound& sound) const {
  VoiceActivity activity(settings_.activity);
  std::optional<Utterance> utterance = activity.Hear(Resampled(sound, kHearingRate).samples);
  return utterance && utterance->has_ended ? std::move(utterance) : activity.Finish();
}

void Ear::set_speaks(bool speaks, Time now) {
  if (speaks_ && !speaks) {
    shut_until_ =
        now + std::chrono::duration_cast<Duration>(std::chrono::duration<double>(settings_.tail));
  }
  if (speaks && !speaks_) activity_.Reset();
  speaks_ = speaks;
}

std::optional<Utterance> Ear::set_pressed(bool pressed, Time now) {
  const bool was_open = is_open(now);
  const bool is_released = is_pressed_ && !pressed;
  is_pressed_ = pressed;
  if (!is_released || !was_open || listening_ == Listening::kAlways) return std::nullopt;
  return activity_.Finish();
}

}  // namespace coppice::robot::speech
