// What the supervisor page's server reads from and adds to HTTP, without sockets.
#ifndef COPPICE_ROBOT_APP_ASSISTANCE_PAGE_PAGE_HTTP_H_
#define COPPICE_ROBOT_APP_ASSISTANCE_PAGE_PAGE_HTTP_H_

#include <string>
#include <string_view>

namespace coppice::robot::assistance {

inline constexpr const char* kSessionCookie = "coppice_session";

/// What the page may do in a browser: nothing but its own scripts, styles and connection.
inline constexpr const char* kContentSecurityPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob:; "
    "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// The session of a header field Cookie (RFC 6265); empty if there is none.
std::string_view SessionOf(std::string_view cookies);

/// The header field Set-Cookie that gives, or with an empty session takes, a session. The cookie
/// ends with the browser; scripts and other sites do not get at it.
std::string SetSessionCookie(const std::string& session, bool is_https);

/// The token in the body {"token": "..."}; empty if there is none.
std::string TokenOf(std::string_view body);

}  // namespace coppice::robot::assistance

#endif  // COPPICE_ROBOT_APP_ASSISTANCE_PAGE_PAGE_HTTP_H_
