// The voice of each language: a service where there is one that answers, else espeak-ng.
#ifndef COPPICE_ROBOT_APP_SPEECH_MOUTH_VOICES_H_
#define COPPICE_ROBOT_APP_SPEECH_MOUTH_VOICES_H_

#include <functional>
#include <map>
#include <string>

#include "robot_app/speech/endpoint/service_pause.h"
#include "robot_app/speech/mouth/synthesizer.h"

namespace coppice::robot::speech {

struct VoiceSettings {
  std::string english = "en-us";  ///< voices of espeak-ng
  std::string german = "de";
  int words_per_minute = 150;
  SpeechService service;
};

/// Speaks a text in a language, "en" or "de". Any thread, several at a time.
class Voices {
 public:
  /// `on_problem` is told when the service fails; on the thread that calls.
  Voices(VoiceSettings settings, std::function<void(const std::string&)> on_problem)
      : settings_(std::move(settings)), on_problem_(std::move(on_problem)) {}

  Expected<Speech> Speak(const std::string& text, const std::string& language);

 private:
  const VoiceSettings settings_;
  const std::function<void(const std::string&)> on_problem_;
  Synthesizer offline_;
  ServicePause pause_;
};

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_MOUTH_VOICES_H_
