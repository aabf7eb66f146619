#include "robot_app/speech/endpoint/speech_service.h"

#include <memory>

#include "bt_core/base/json.h"
#include "robot_app/common/web/curl_handle.h"
#include "robot_app/speech/sound/wav_file.h"

namespace coppice::robot::speech {
namespace {

constexpr std::size_t kMostReplyBytes = std::size_t{16} << 20;  // two minutes of 48 kHz
constexpr std::size_t kMostText = 1000;                         // bytes
const std::atomic<bool> kNeverCancelled{false};

Expected<std::string> Post(CurlHandle& curl, const SpeechService& service) {
  curl.Set(CURLOPT_CONNECTTIMEOUT_MS, static_cast<long>(service.timeout.count()));
  if (!service.key.empty()) curl.SetBearer(service.key);
  return curl.PerformForBody(kMostReplyBytes);
}

CurlHandle Handle(const SpeechService& service, const char* path) {
  return {service.url + path, "http,https", service.timeout, kNeverCancelled};
}

struct FreeForm {
  void operator()(curl_mime* form) const { curl_mime_free(form); }
};
using Form = std::unique_ptr<curl_mime, FreeForm>;

void AddField(curl_mime* form, const char* name, const std::string& value) {
  curl_mimepart* const part = curl_mime_addpart(form);
  curl_mime_name(part, name);
  curl_mime_data(part, value.data(), value.size());
}

void AddFile(curl_mime* form, const std::string& bytes) {
  curl_mimepart* const part = curl_mime_addpart(form);
  curl_mime_name(part, "file");
  curl_mime_data(part, bytes.data(), bytes.size());
  curl_mime_filename(part, "speech.wav");
  curl_mime_type(part, "audio/wav");
}

}  // namespace

Expected<std::string> Transcribe(const SpeechService& service, const Sound& sound,
                                 const std::string& language) {
  CurlHandle curl = Handle(service, "/v1/audio/transcriptions");
  const Form form(curl_mime_init(curl.get()));
  AddFile(form.get(), WavOf(sound));
  AddField(form.get(), "model", service.model);
  AddField(form.get(), "language", language);
  AddField(form.get(), "response_format", "json");
  curl.Set(CURLOPT_MIMEPOST, form.get());
  const Expected<std::string> reply = Post(curl, service);
  if (!reply) return Problem{reply.problem()};
  const auto json = ParseJson(*reply);
  const JsonValue* const text = json ? json->Find("text") : nullptr;
  if (text == nullptr || !text->is(JsonValue::Kind::kString)) {
    return Problem{"expected {\"text\": ...} from the service"};
  }
  if (text->text.size() > kMostText) return Problem{"the service heard more than a person says"};
  return text->text;
}

Expected<Sound> Synthesized(const SpeechService& service, const std::string& text) {
  CurlHandle curl = Handle(service, "/v1/audio/speech");
  const std::string body = JsonObject()
                               .AddText("model", service.model)
                               .AddText("input", text)
                               .AddText("voice", service.voice)
                               .AddText("response_format", "wav")
                               .Finish();
  curl.Set(CURLOPT_POSTFIELDSIZE, static_cast<long>(body.size()));
  curl.Set(CURLOPT_POSTFIELDS, body.c_str());
  curl.AddHeader("Content-Type: application/json");
  const Expected<std::string> reply = Post(curl, service);
  if (!reply) return Problem{reply.problem()};
  Expected<Sound> sound = ParseWav(*reply);
  if (!sound) return Problem{"the service sent no WAV file"};
  return sound;
}

}  // namespace coppice::robot::speech
