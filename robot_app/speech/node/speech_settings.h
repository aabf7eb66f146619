// What coppice-speech can be told: its parameters and the secrets of its environment.
#ifndef COPPICE_ROBOT_APP_SPEECH_NODE_SPEECH_SETTINGS_H_
#define COPPICE_ROBOT_APP_SPEECH_NODE_SPEECH_SETTINGS_H_

#include <memory>
#include <string>

#include "bt_core/base/clock.h"
#include "robot_app/common/parameters.h"
#include "robot_app/speech/ear/ear.h"
#include "robot_app/speech/ear/listener.h"
#include "robot_app/speech/mouth/sound_output.h"
#include "robot_app/speech/mouth/voices.h"

namespace coppice::robot::speech {

struct SpeechSettings {
  std::string knowledge;  ///< the database; empty: the robot speaks and answers nothing
  std::string site;
  std::string places;
  std::string language = "en";  ///< that it speaks with who has said nothing yet
  std::string output = "none";
  std::string microphone = "none";
  bool push_to_talk = false;
  bool answers_aloud = true;
  bool ends_early = true;  ///< answers a whole request that is sure without waiting
  double least_confidence = knowledge::kSureEnough;  ///< that it was meant; else it asks back
  EarSettings ear;
  VoiceSettings voices;
  SpeechService transcription, understanding;
  std::string interface = "openai";  ///< of the transcription: openai or google
  double service_timeout = 1.5;      ///< s
};

Parameters ParametersOf(SpeechSettings& settings);

/// Puts the secrets and what follows from others into their places.
void Complete(SpeechSettings& settings);

/// "none", "folder:PATH" or "alsa:DEVICE"; `clock` is for the first two. A problem for another
/// text.
Expected<std::unique_ptr<SoundOutput>> MakeOutput(const std::string& output, Clock& clock);
/// The device of "alsa:DEVICE", empty for "none".
Expected<std::string> DeviceOf(const std::string& microphone);

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_NODE_SPEECH_SETTINGS_H_
