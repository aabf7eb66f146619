#include "robot_app/assistance/channels/http_request.h"

#include "robot_app/common/web/curl_handle.h"

namespace coppice::robot::assistance {
namespace {

constexpr std::size_t kMostReplyBytes = 1 << 20;

std::size_t Append(const char* data, std::size_t size, std::size_t count, void* target) {
  auto& body = *static_cast<std::string*>(target);
  if (body.size() + size * count > kMostReplyBytes) return 0;
  body.append(data, size * count);
  return size * count;
}

}  // namespace

Expected<std::string> Exchange(const HttpRequest& request, const std::atomic<bool>& cancelled) {
  std::string body;
  CurlHandle curl(request.url, "http,https", request.timeout, cancelled);
  curl.Set(CURLOPT_CUSTOMREQUEST, request.method.c_str());
  if (request.method != "GET") {
    curl.Set(CURLOPT_POSTFIELDSIZE, static_cast<long>(request.body.size()));
    curl.Set(CURLOPT_POSTFIELDS, request.body.c_str());
    curl.AddHeader("Content-Type: application/json");
  }
  if (!request.bearer.empty()) {
    curl.Set(CURLOPT_HTTPAUTH, static_cast<long>(CURLAUTH_BEARER));
    curl.Set(CURLOPT_XOAUTH2_BEARER, request.bearer.c_str());
  }
  curl.Set(CURLOPT_WRITEFUNCTION, &Append);
  curl.Set(CURLOPT_WRITEDATA, &body);
  if (const Outcome sent = curl.Perform(); !sent) return Problem{sent.problem()};
  long status = 0;
  curl_easy_getinfo(curl.get(), CURLINFO_RESPONSE_CODE, &status);
  if (status >= 200 && status <= 299) return body;
  return Problem{"the service answered with status " + std::to_string(status)};
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
