// The ear: which of the sound of a microphone is an utterance for the robot.
//
// It is shut while the mouth speaks and a moment longer, so the robot never hears itself. Two ways
// to listen: always, or only while somebody holds the button of the tablet (push to talk), where a
// place is too loud for the first.
//
//   Ear ear({}, Listening::kAlways);
//   ear.set_speaks(mouth.speaks(), now);
//   if (auto utterance = ear.Hear(samples, now)) listener.Listen(*utterance, language, who);
//   if (heard.pause && !ear.End(*heard.pause)) return;          // of the listener: he goes on
//
// For one thread.
#ifndef COPPICE_ROBOT_APP_SPEECH_EAR_EAR_H_
#define COPPICE_ROBOT_APP_SPEECH_EAR_EAR_H_

#include <optional>
#include <vector>

#include "bt_core/base/clock.h"
#include "robot_app/speech/ear/voice_activity.h"

namespace coppice::robot::speech {

enum class Listening : std::uint8_t { kAlways, kPushToTalk };

struct EarSettings {
  ActivitySettings activity;
  double tail = 0.4;  ///< s after the mouth's last sound until the ear opens: the echo of the room
  double held = 5;    ///< s for which a button counts as held when nobody says so any more
};

class Ear {
 public:
  Ear(const EarSettings& settings, Listening listening)
      : settings_(settings), listening_(listening), activity_(settings.activity) {}

  /// Samples at kHearingRate that have just come. An utterance, when it pauses and when it has
  /// ended.
  std::optional<Utterance> Hear(const std::vector<std::int16_t>& samples, Time now);

  /// The utterance in a sound of any rate that somebody has recorded, if there is one.
  std::optional<Utterance> HearWhole(const Sound& sound) const;

  /// Ends the utterance that has paused: what was said is all that is wanted. False if he goes on,
  /// or if it is over already.
  bool End(int pause) { return activity_.End(pause); }

  /// Whether the mouth speaks; what was heard up to now is dropped.
  void set_speaks(bool speaks, Time now);
  /// Whether the button is held, to be said again and again while it is: who says nothing more may
  /// have ended, and nobody is heard for ever. When it is released, the utterance has ended.
  std::optional<Utterance> set_pressed(bool pressed, Time now);

  bool is_open(Time now) const;
  bool hears() const { return activity_.hears(); }
  double level() const { return activity_.level(); }  ///< dB above the noise

 private:
  EarSettings settings_;
  Listening listening_;
  VoiceActivity activity_;
  bool speaks_ = false;
  std::optional<Time> shut_until_, held_until_;
};

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_EAR_EAR_H_
