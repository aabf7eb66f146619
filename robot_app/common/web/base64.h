// Bytes as text (RFC 4648, section 4), with padding.
#ifndef COPPICE_ROBOT_APP_COMMON_WEB_BASE64_H_
#define COPPICE_ROBOT_APP_COMMON_WEB_BASE64_H_

#include <optional>
#include <string>
#include <string_view>

namespace coppice::robot {

std::string ToBase64(std::string_view bytes);
/// Nothing if the text is none.
std::optional<std::string> FromBase64(std::string_view text);

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_WEB_BASE64_H_
