#include "robot_app/speech/endpoint/speech_service.h"

#include <cstring>
#include <memory>

#include "bt_core/base/json.h"
#include "robot_app/common/web/base64.h"
#include "robot_app/common/web/curl_handle.h"
#include "robot_app/speech/endpoint/json_post.h"
#include "robot_app/speech/sound/wav_file.h"

namespace coppice::robot::speech {
namespace {

constexpr std::size_t kMostReplyBytes = std::size_t{16} << 20;  // two minutes of 48 kHz
constexpr std::size_t kMostText = 1000;                         // bytes
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

Expected<std::string> TextIn(const JsonValue* text) {
  if (text->text.size() > kMostText) return Problem{"the service heard more than a person says"};
  return text->text;
}

bool IsText(const JsonValue* value) {
  return value != nullptr && value->is(JsonValue::Kind::kString);
}

Expected<std::string> TranscribeAsOpenAi(const SpeechService& service, const Sound& sound,
                                         const std::string& language) {
  CurlHandle curl = HandleOf(service, "/v1/audio/transcriptions");
  const Form form(curl_mime_init(curl.get()));
  AddFile(form.get(), WavOf(sound));
  AddField(form.get(), "model", service.model);
  AddField(form.get(), "language", language);
  AddField(form.get(), "response_format", "json");
  curl.Set(CURLOPT_MIMEPOST, form.get());
  const Expected<std::string> reply = ReplyTo(curl, service, kMostReplyBytes);
  if (!reply) return Problem{reply.problem()};
  const auto json = ParseJson(*reply);
  const JsonValue* const text = json ? json->Find("text") : nullptr;
  if (!IsText(text)) return Problem{"expected {\"text\": ...} from the service"};
  return TextIn(text);
}

std::string BytesOf(const Sound& sound) {
  std::string bytes(sound.samples.size() * sizeof(std::int16_t), '\0');
  std::memcpy(bytes.data(), sound.samples.data(), bytes.size());
  return bytes;
}

std::string RecognizeRequest(const SpeechService& service, const Sound& sound,
                             const std::string& language) {
  JsonObject config;
  config.AddText("encoding", "LINEAR16")
      .Add("sampleRateHertz", static_cast<std::uint64_t>(sound.rate))
      .AddText("languageCode", language == "de" ? "de-DE" : "en-US");
  if (!service.model.empty()) config.AddText("model", service.model);
  const std::string audio = JsonObject().AddText("content", ToBase64(BytesOf(sound))).Finish();
  return JsonObject().Add("config", config.Finish()).Add("audio", audio).Finish();
}

// Its results are parts of what was said, one after the other; none: nobody spoke.
Expected<std::string> TranscribeAsGoogle(const SpeechService& service, const Sound& sound,
                                         const std::string& language) {
  const auto json =
      PostJson(service, "/v1/speech:recognize", RecognizeRequest(service, sound, language));
  if (!json) return Problem{json.problem()};
  if (!json->is(JsonValue::Kind::kObject)) return Problem{"expected an object from the service"};
  JsonValue whole;
  const JsonValue* const results = json->Find("results");
  if (results == nullptr) return whole.text;
  for (const JsonValue& result : results->children) {
    const JsonValue* const alternatives = result.Find("alternatives");
    const bool has_any = alternatives != nullptr && !alternatives->children.empty();
    const JsonValue* const text =
        has_any ? alternatives->children.front().Find("transcript") : nullptr;
    if (!IsText(text)) return Problem{"expected a transcript in each result of the service"};
    whole.text += text->text;
  }
  return TextIn(&whole);
}

}  // namespace

Expected<std::string> Transcribe(const SpeechService& service, const Sound& sound,
                                 const std::string& language) {
  const bool is_google = service.interface == ServiceInterface::kGoogle;
  return is_google ? TranscribeAsGoogle(service, sound, language)
                   : TranscribeAsOpenAi(service, sound, language);
}

Expected<Sound> Synthesized(const SpeechService& service, const std::string& text) {
  CurlHandle curl = HandleOf(service, "/v1/audio/speech");
  const std::string body = JsonObject()
                               .AddText("model", service.model)
                               .AddText("input", text)
                               .AddText("voice", service.voice)
                               .AddText("response_format", "wav")
                               .Finish();
  SetJson(curl, body);
  const Expected<std::string> reply = ReplyTo(curl, service, kMostReplyBytes);
  if (!reply) return Problem{reply.problem()};
  Expected<Sound> sound = ParseWav(*reply);
  if (!sound) return Problem{"the service sent no WAV file"};
  return sound;
}

}  // namespace coppice::robot::speech
