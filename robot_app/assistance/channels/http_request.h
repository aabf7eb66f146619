// HTTP requests to services of others, by libcurl.
#ifndef COPPICE_ROBOT_APP_ASSISTANCE_CHANNELS_HTTP_REQUEST_H_
#define COPPICE_ROBOT_APP_ASSISTANCE_CHANNELS_HTTP_REQUEST_H_

#include <atomic>
#include <chrono>
#include <string>

#include "bt_core/base/outcome.h"

namespace coppice::robot::assistance {

struct HttpRequest {
  std::string method = "POST";
  std::string url;     ///< http:// or https://
  std::string body;    ///< JSON; none for GET
  std::string bearer;  ///< goes into the header Authorization; may be empty
  std::chrono::seconds timeout{15};
};

/// The body of the reply, at most 1 MiB; a problem, also if the status is none of 2xx, tells
/// nothing of the URL. Follows no redirections and checks certificates. Returns early once
/// `cancelled`. Blocks; any thread.
Expected<std::string> Exchange(const HttpRequest& request, const std::atomic<bool>& cancelled);

/// A text as a part of a path or query.
std::string UrlPart(const std::string& text);

}  // namespace coppice::robot::assistance

#endif  // COPPICE_ROBOT_APP_ASSISTANCE_CHANNELS_HTTP_REQUEST_H_
