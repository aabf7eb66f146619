// JSON as values of nlohmann::json, for rooms that build and search large ones: the same texts as
// json.h reads, from strangers, so nothing that is nested so deep that handling it would need more
// stack than a thread has, and nothing of so many values that they take many times the text.
#ifndef COPPICE_BT_CORE_BASE_JSON_LIBRARY_H_
#define COPPICE_BT_CORE_BASE_JSON_LIBRARY_H_

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "bt_core/base/json.h"
#include "bt_core/base/strong_index.h"

namespace coppice {

/// For what our own programs have written, or the like [values].
inline constexpr std::size_t kMostOwnJsonValues = 2'000'000;

/// Throws std::exception.
nlohmann::json ParseLimitedJson(std::string_view text, std::size_t most_values = kMostJsonValues);

/// The same of MessagePack; what cannot be read is a discarded value.
nlohmann::json ReadLimitedMessagePack(std::string_view bytes);

/// An index is written as its number; the library calls this.
template <class Json, class Tag>
void to_json(Json& json, StrongIndex<Tag> index) {
  json = static_cast<std::uint32_t>(index);
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_BASE_JSON_LIBRARY_H_
