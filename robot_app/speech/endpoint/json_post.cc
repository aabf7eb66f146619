#include "robot_app/speech/endpoint/json_post.h"

namespace coppice::robot::speech {
namespace {

constexpr std::size_t kMostReplyBytes = std::size_t{1} << 20;
const std::atomic<bool> kNeverCancelled{false};

}  // namespace

CurlHandle HandleOf(const SpeechService& service, const char* path) {
  return {service.url + path, "http,https", service.timeout, kNeverCancelled};
}

void SetJson(CurlHandle& curl, const std::string& body) {
  curl.Set(CURLOPT_POSTFIELDSIZE, static_cast<long>(body.size()));
  curl.Set(CURLOPT_POSTFIELDS, body.c_str());
  curl.AddHeader("Content-Type: application/json");
}

Expected<std::string> ReplyTo(CurlHandle& curl, const SpeechService& service, std::size_t most) {
  curl.Set(CURLOPT_CONNECTTIMEOUT_MS, static_cast<long>(service.timeout.count()));
  if (!service.key.empty()) {
    if (service.interface == ServiceInterface::kGoogle) {
      curl.AddHeader("X-Goog-Api-Key: " + service.key);
    } else {
      curl.SetBearer(service.key);
    }
  }
  return curl.PerformForBody(most);
}

Expected<JsonValue> PostJson(const SpeechService& service, const char* path,
                             const std::string& body) {
  CurlHandle curl = HandleOf(service, path);
  SetJson(curl, body);
  const Expected<std::string> reply = ReplyTo(curl, service, kMostReplyBytes);
  if (!reply) return Problem{reply.problem()};
  auto json = ParseJson(*reply);
  if (!json) return Problem{"expected JSON from the service"};
  return *std::move(json);
}

}  // namespace coppice::robot::speech
