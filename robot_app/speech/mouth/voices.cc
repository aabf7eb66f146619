#include "robot_app/speech/mouth/voices.h"

namespace coppice::robot::speech {

Expected<Speech> Voices::Speak(const std::string& text, const std::string& language) {
  if (!settings_.service.url.empty() && pause_.may_be_asked()) {
    Expected<Sound> sound = Synthesized(settings_.service, text);
    if (sound) return Speech{*std::move(sound), {}};
    pause_.Failed();
    on_problem_("the voice of the service: " + sound.problem());
  }
  return offline_.Speak(
      text, {language == "de" ? settings_.german : settings_.english, settings_.words_per_minute});
}

}  // namespace coppice::robot::speech
