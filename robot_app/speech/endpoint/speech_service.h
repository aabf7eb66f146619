// Speech by services of others that speak the interface of OpenAI, or to transcribe that of Google:
// better ears and voices than the offline ones, where a network is. Whoever uses them must be able
// to go on without: a service that is slow, absent or talks nonsense is a problem within the
// timeout.
//
//   SpeechService service;
//   service.url = "https://speech.example.org";
//   service.key = getenv("COPPICE_SPEECH_KEY");
//   const Expected<std::string> text = Transcribe(service, sound, "en");
#ifndef COPPICE_ROBOT_APP_SPEECH_ENDPOINT_SPEECH_SERVICE_H_
#define COPPICE_ROBOT_APP_SPEECH_ENDPOINT_SPEECH_SERVICE_H_

#include <chrono>
#include <cstdint>
#include <string>

#include "bt_core/base/outcome.h"
#include "robot_app/speech/sound/sound.h"

namespace coppice::robot::speech {

enum class ServiceInterface : std::uint8_t { kOpenAi, kGoogle };

struct SpeechService {
  ServiceInterface interface = ServiceInterface::kOpenAi;  ///< of Transcribe
  std::string url;    ///< http:// or https://, without /v1; empty: there is none
  std::string key;    ///< sent in the header; from the environment, never from a file
  std::string model;  ///< what the service calls it
  std::string voice;  ///< of Synthesized
  std::chrono::milliseconds timeout{2000};
};

/// POST /v1/audio/transcriptions or /v1/speech:recognize: the text of a sound, at most 1000 bytes.
/// Certificates are checked, no redirection is followed, a problem tells nothing of URL and key.
/// Blocks; any thread.
Expected<std::string> Transcribe(const SpeechService& service, const Sound& sound,
                                 const std::string& language);

/// POST /v1/audio/speech: a text as sound. Likewise.
Expected<Sound> Synthesized(const SpeechService& service, const std::string& text);

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_ENDPOINT_SPEECH_SERVICE_H_
