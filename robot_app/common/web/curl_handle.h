// One transfer of libcurl. Included by .cc files only.
#ifndef COPPICE_ROBOT_APP_COMMON_WEB_CURL_HANDLE_H_
#define COPPICE_ROBOT_APP_COMMON_WEB_CURL_HANDLE_H_

#include <curl/curl.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "bt_core/base/outcome.h"

namespace coppice::robot {

class CurlHandle {
 public:
  /// `protocols`: those that may be spoken, as "http,https".
  CurlHandle(const std::string& url, const char* protocols, std::chrono::milliseconds timeout,
             const std::atomic<bool>& cancelled)
      : handle_((Initialize(), curl_easy_init())) {
    if (!handle_) throw std::bad_alloc();
    Set(CURLOPT_URL, url.c_str());
    Set(CURLOPT_PROTOCOLS_STR, protocols);
    Set(CURLOPT_NOSIGNAL, 1L);
    Set(CURLOPT_NOPROXY, "127.0.0.1,localhost,[::1]");
    Set(CURLOPT_CONNECTTIMEOUT, 5L);
    Set(CURLOPT_TIMEOUT_MS, static_cast<long>(timeout.count()));
    Set(CURLOPT_NOPROGRESS, 0L);
    Set(CURLOPT_XFERINFODATA, const_cast<std::atomic<bool>*>(&cancelled));
    Set(CURLOPT_XFERINFOFUNCTION, &IsCancelled);
    Set(CURLOPT_HEADERFUNCTION, &CountHeader);
    Set(CURLOPT_HEADERDATA, &header_bytes_);
    Set(CURLOPT_ERRORBUFFER, error_);
  }
  ~CurlHandle() {
    curl_slist_free_all(headers_);
    curl_slist_free_all(recipients_);
    curl_easy_cleanup(handle_);
  }
  CurlHandle(const CurlHandle&) = delete;
  CurlHandle& operator=(const CurlHandle&) = delete;

  template <class Value>
  void Set(CURLoption option, Value value) {
    curl_easy_setopt(handle_, option, value);
  }

  /// A token that is sent along.
  void SetBearer(const std::string& token) {
    Set(CURLOPT_HTTPAUTH, static_cast<long>(CURLAUTH_BEARER));
    Set(CURLOPT_XOAUTH2_BEARER, token.c_str());
  }

  /// `line` has no end of line in it.
  void AddHeader(const std::string& line) {
    headers_ = curl_slist_append(headers_, line.c_str());
    Set(CURLOPT_HTTPHEADER, headers_);
  }

  void AddRecipient(const std::string& address) {
    recipients_ = curl_slist_append(recipients_, address.c_str());
    Set(CURLOPT_MAIL_RCPT, recipients_);
  }

  Outcome Perform() {
    const CURLcode code = curl_easy_perform(handle_);
    if (code == CURLE_OK) return {};
    return Problem{error_[0] ? error_ : curl_easy_strerror(code)};
  }

  /// The body of an HTTP answer of a good status, cut off with a problem behind `most_bytes`.
  Expected<std::string> PerformForBody(std::size_t most_bytes) {
    Body body{{}, most_bytes};
    Set(CURLOPT_WRITEFUNCTION, &Append);
    Set(CURLOPT_WRITEDATA, &body);
    const Outcome sent = Perform();
    if (body.is_cut) {
      return Problem{"the answer is longer than " + std::to_string(most_bytes) + " bytes"};
    }
    if (!sent) return Problem{sent.problem()};
    long status = 0;
    curl_easy_getinfo(handle_, CURLINFO_RESPONSE_CODE, &status);
    if (status >= 200 && status <= 299) return std::move(body.text);
    return Problem{"the service answered with status " + std::to_string(status)};
  }

  CURL* get() { return handle_; }

 private:
  struct Body {
    std::string text;
    std::size_t most;
    bool is_cut = false;
  };

  static std::size_t Append(const char* data, std::size_t size, std::size_t count, void* target) {
    Body& body = *static_cast<Body*>(target);
    body.is_cut = size * count > body.most - body.text.size();
    if (body.is_cut) return 0;
    body.text.append(data, size * count);
    return size * count;
  }
  // libcurl keeps them all, and sets no limit to those that come behind the body.
  static std::size_t CountHeader(const char*, std::size_t size, std::size_t count, void* target) {
    std::size_t& bytes = *static_cast<std::size_t*>(target);
    bytes += size * count;
    return bytes <= kMostHeaderBytes ? size * count : 0;
  }
  static void Initialize() {
    static const CURLcode code = curl_global_init(CURL_GLOBAL_DEFAULT);
    if (code != CURLE_OK) throw std::runtime_error("libcurl cannot be used");
  }
  static int IsCancelled(void* flag, curl_off_t, curl_off_t, curl_off_t, curl_off_t) {
    return *static_cast<const std::atomic<bool>*>(flag) ? 1 : 0;
  }

  static constexpr std::size_t kMostHeaderBytes = std::size_t{256} << 10;

  CURL* const handle_;
  curl_slist* headers_ = nullptr;
  curl_slist* recipients_ = nullptr;
  std::size_t header_bytes_ = 0;
  char error_[CURL_ERROR_SIZE] = {};
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_WEB_CURL_HANDLE_H_
