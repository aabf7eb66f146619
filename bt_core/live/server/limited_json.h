// JSON from strangers: the same as nlohmann::json reads, but nothing that is nested so deep that
// handling it would need more stack than a thread has.
#ifndef COPPICE_BT_CORE_LIVE_SERVER_LIMITED_JSON_H_
#define COPPICE_BT_CORE_LIVE_SERVER_LIMITED_JSON_H_

#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace coppice {

inline constexpr int kMaxJsonDepth = 64;

/// Throws std::exception.
nlohmann::json ParseLimitedJson(std::string_view text);

/// The same of MessagePack; what cannot be read is a discarded value.
nlohmann::json ReadLimitedMessagePack(std::string_view bytes);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_SERVER_LIMITED_JSON_H_
