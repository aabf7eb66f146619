#include "robot_app/assistance/page/page_http.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "bt_core/base/json_library.h"

namespace coppice::robot::assistance {

std::string_view SessionOf(std::string_view cookies) {
  while (!cookies.empty()) {
    const std::size_t end = std::min(cookies.find(';'), cookies.size());
    std::string_view pair = cookies.substr(0, end);
    cookies.remove_prefix(std::min(end + 1, cookies.size()));
    while (!pair.empty() && pair.front() == ' ') pair.remove_prefix(1);
    const std::size_t equals = pair.find('=');
    if (equals != std::string_view::npos && pair.substr(0, equals) == kSessionCookie) {
      return pair.substr(equals + 1);
    }
  }
  return {};
}

std::string SetSessionCookie(const std::string& session, bool is_https) {
  return std::string(kSessionCookie) + "=" + session + "; Path=/; HttpOnly; SameSite=Strict" +
         (is_https ? "; Secure" : "") + (session.empty() ? "; Max-Age=0" : "");
}

std::string TokenOf(std::string_view body) {
  try {
    return ParseLimitedJson(body).at("token").get<std::string>();
  } catch (const std::exception&) {
    return "";
  }
}

}  // namespace coppice::robot::assistance
