// Finds utterances in what a microphone hears, by its loudness above the noise of the place, both
// without the low frequencies.
//
//   VoiceActivity activity({});
//   if (auto utterance = activity.Hear(samples)) ...            // it has ended, or pauses
//   if (is_all_that_he_wants && activity.End(utterance->pause)) ...  // and has not gone on
//
// The noise is followed: it sinks at once and rises slowly, so that a machine that is switched on
// is no speech for ever. For one thread.
#ifndef COPPICE_ROBOT_APP_SPEECH_EAR_VOICE_ACTIVITY_H_
#define COPPICE_ROBOT_APP_SPEECH_EAR_VOICE_ACTIVITY_H_

#include <array>
#include <optional>
#include <vector>

#include "robot_app/speech/sound/sound.h"

namespace coppice::robot::speech {

/// What somebody has said until now, with a little of what was around it.
struct Utterance {
  Sound sound;
  bool has_ended = true;  ///< else he pauses; if nothing follows, the same comes when it has ended
  int pause = 0;          ///< its number if he pauses
};

struct ActivitySettings {
  double above_noise = 6;      ///< what is louder is speech [dB]
  double begins_after = 0.06;  ///< s of it, one after the other
  double ends_after = 0.6;     ///< s of silence
  double pauses_after = 0.15;  ///< s of silence; as much of it belongs to the utterance
  double before = 0.4;         ///< s of what was heard before belong to it
  double shortest = 0.18;      ///< s of speech, a "yes"; less was a noise
  double longest = 12;         ///< s; then it is over
};

class VoiceActivity {
 public:
  explicit VoiceActivity(const ActivitySettings& settings) : settings_(settings) {}

  /// More of the sound, at kHearingRate. The utterance that has ended or pauses with it, if any.
  std::optional<Utterance> Hear(const std::vector<std::int16_t>& samples);
  /// The utterance up to now, if there is one: a button was released.
  std::optional<Utterance> Finish();
  /// Ends the utterance that has paused, if nothing has been heard of it since.
  bool End(int pause);
  /// Forgets what was heard, but for the noise.
  void Reset();

  bool hears() const { return in_speech_; }
  double level() const { return level_ - noise_; }  ///< of the last 10 ms, above the noise [dB]

 private:
  struct HighPass {
    double before = 0, after = 0;
  };

  void Frame(const std::int16_t* samples);
  double LevelOf(const std::int16_t* samples);
  bool has_ended() const;
  int frames_of_pause() const;
  bool has_paused() const;
  Utterance SoFar(bool has_ended) const;

  ActivitySettings settings_;
  std::vector<std::int16_t> rest_;   // less than a frame
  std::vector<std::int16_t> heard_;  // the utterance, or what may be the beginning of one
  std::array<HighPass, 2> passes_{};
  double noise_ = 30, level_ = 30;  // dB of the smallest step
  bool knows_noise_ = false;
  bool in_speech_ = false;
  int loud_ = 0, quiet_ = 0;  // frames, one after the other
  int speech_ = 0;            // loud frames of the utterance
  int pause_ = 0;             // number of the last one
};

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_EAR_VOICE_ACTIVITY_H_
