#include "robot_app/speech/ear/ear.h"

namespace coppice::robot::speech {
namespace {

Duration Seconds(double seconds) {
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

bool Ear::is_open(Time now) const {
  if (speaks_ || (shut_until_ && now < *shut_until_)) return false;
  return listening_ == Listening::kAlways || (held_until_ && now < *held_until_);
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
    shut_until_ = now + Seconds(settings_.tail);
  }
  if (speaks && !speaks_) activity_.Reset();
  speaks_ = speaks;
}

std::optional<Utterance> Ear::set_pressed(bool pressed, Time now) {
  const bool was_open = is_open(now);
  held_until_ = pressed ? std::optional(now + Seconds(settings_.held)) : std::nullopt;
  if (listening_ == Listening::kAlways) return std::nullopt;
  if (!was_open) activity_.Reset();  // what was begun before nobody has ended
  return was_open && !pressed ? activity_.Finish() : std::nullopt;
}

}  // namespace coppice::robot::speech
