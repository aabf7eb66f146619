// JSON as values of nlohmann::json, for rooms that build and search large ones: the same texts as
// json.h reads, from strangers, so nothing that is nested so deep that handling it would need more
// stack than a thread has.
#ifndef COPPICE_BT_CORE_BASE_JSON_LIBRARY_H_
#define COPPICE_BT_CORE_BASE_JSON_LIBRARY_H_

#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace coppice {

/// Throws std::exception.
nlohmann::json ParseLimitedJson(std::string_view text);

/// The same of MessagePack; what cannot be read is a discarded value.
nlohmann::json ReadLimitedMessagePack(std::string_view bytes);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_BASE_JSON_LIBRARY_H_
