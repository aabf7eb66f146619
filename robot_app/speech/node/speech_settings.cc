#include "robot_app/speech/node/speech_settings.h"

#include <cstdlib>

#include "robot_app/speech/mouth/alsa_output.h"

namespace coppice::robot::speech {
namespace {

constexpr char kNone[] = "none", kFolder[] = "folder:", kAlsa[] = "alsa:";

bool Begins(const std::string& text, const std::string& with) {
  return text.compare(0, with.size(), with) == 0 && text.size() > with.size();
}

std::string Secret(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace

Parameters ParametersOf(SpeechSettings& settings) {
  SpeechService& mouth = settings.voices.service;
  SpeechService& ear = settings.transcription;
  SpeechService& mind = settings.understanding;
  ActivitySettings& activity = settings.ear.activity;
  return {{"knowledge", &settings.knowledge, "database of what it knows; none: only speaks"},
          {"site", &settings.site, "a folder, or sample: fills it if it is empty"},
          {"places", &settings.places, "of the ways to what is nearest; none: beelines"},
          {"language", &settings.language, "en or de: for who has said nothing yet"},
          {"output", &settings.output, "alsa:DEVICE, folder:PATH (WAV files), or none"},
          {"microphone", &settings.microphone, "alsa:DEVICE or none"},
          {"push_to_talk", &settings.push_to_talk, "hears only while /speech/listen says so"},
          {"answers_aloud", &settings.answers_aloud, "says what it answers to speech"},
          {"least_confidence", &settings.least_confidence, 0, 1,
           "that it was meant; else it asks back"},
          {"above_noise", &activity.above_noise, 1, 60, "louder than this is speech [dB]"},
          {"ends_after", &activity.ends_after, 0.1, 5, "of silence an utterance has ended [s]"},
          {"ends_early", &settings.ends_early, "a sure and whole request has ended at once"},
          {"tail", &settings.ear.tail, 0, 5, "the ear stays shut after the mouth [s]"},
          {"voice_en", &settings.voices.english, "a voice of espeak-ng"},
          {"voice_de", &settings.voices.german, "a voice of espeak-ng"},
          {"words_per_minute", &settings.voices.words_per_minute, 80, 400, "of espeak-ng"},
          {"speech_url", &mouth.url, "of a service for the voice; none: espeak-ng"},
          {"speech_model", &mouth.model, "what the service calls it"},
          {"speech_voice", &mouth.voice, "what the service calls it"},
          {"transcription_url", &ear.url, "of a service for the ear; none: pocketsphinx"},
          {"transcription_interface", &settings.interface, "of that service: openai or google"},
          {"transcription_model", &ear.model, "what the service calls it"},
          {"understanding_url", &mind.url, "of a service; none: it understands itself"},
          {"understanding_model", &mind.model, "what the service calls it"},
          {"service_timeout", &settings.service_timeout, 0.1, 1.8, "then it goes on offline [s]"}};
}

void Complete(SpeechSettings& settings) {
  const auto timeout = std::chrono::duration_cast<std::chrono::milliseconds>(
      std::chrono::duration<double>(settings.service_timeout));
  settings.voices.service.timeout = settings.transcription.timeout = timeout;
  settings.understanding.timeout = timeout;
  const bool is_google = settings.interface == "google";
  settings.transcription.interface =
      is_google ? ServiceInterface::kGoogle : ServiceInterface::kOpenAi;
  settings.voices.service.key = Secret("COPPICE_SPEECH_KEY");
  settings.transcription.key = Secret("COPPICE_TRANSCRIPTION_KEY");
  settings.understanding.key = Secret("COPPICE_UNDERSTANDING_KEY");
}

Expected<std::unique_ptr<SoundOutput>> MakeOutput(const std::string& output, Clock& clock) {
  if (output == kNone) return std::unique_ptr<SoundOutput>(new ClockedOutput(clock));
  if (Begins(output, kFolder)) {
    return std::unique_ptr<SoundOutput>(
        new ClockedOutput(clock, output.substr(sizeof kFolder - 1)));
  }
  if (Begins(output, kAlsa)) {
    return std::unique_ptr<SoundOutput>(new AlsaOutput(output.substr(sizeof kAlsa - 1)));
  }
  return Problem{"~output must be none, folder:PATH or alsa:DEVICE, not \"" + output + "\""};
}

Expected<std::string> DeviceOf(const std::string& microphone) {
  if (microphone == kNone) return std::string();
  if (Begins(microphone, kAlsa)) return microphone.substr(sizeof kAlsa - 1);
  return Problem{"~microphone must be none or alsa:DEVICE, not \"" + microphone + "\""};
}

}  // namespace coppice::robot::speech
