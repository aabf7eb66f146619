#include "robot_app/assistance/channels/http_request.h"

#include "robot_app/common/web/curl_handle.h"

namespace coppice::robot::assistance {
namespace {

constexpr std::size_t kMostReplyBytes = 1 << 20;

}  // namespace

Expected<std::string> Exchange(const HttpRequest& request, const std::atomic<bool>& cancelled) {
  CurlHandle curl(request.url, "http,https", request.timeout, cancelled);
  curl.Set(CURLOPT_CUSTOMREQUEST, request.method.c_str());
  if (request.method != "GET") {
    curl.Set(CURLOPT_POSTFIELDSIZE, static_cast<long>(request.body.size()));
    curl.Set(CURLOPT_POSTFIELDS, request.body.c_str());
    curl.AddHeader("Content-Type: application/json");
  }
  if (!request.bearer.empty()) curl.SetBearer(request.bearer);
  return curl.PerformForBody(kMostReplyBytes);
}

std::string UrlPart(const std::string& text) {
  constexpr char kDigits[] = "0123456789ABCDEF";
  std::string part;
  for (const char c : text) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                          (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.' || c == '~';
    if (is_plain) {
      part += c;
    } else {
      const auto byte = static_cast<unsigned char>(c);
      part += {'%', kDigits[byte >> 4], kDigits[byte & 15]};
    }
  }
  return part;
}

}  // namespace coppice::robot::assistance
