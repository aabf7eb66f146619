#include "bt_core/live/limited_json.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

namespace coppice {

nlohmann::json ParseLimitedJson(std::string_view text) {
  return nlohmann::json::parse(text, [](int depth, nlohmann::json::parse_event_t, nlohmann::json&) {
    if (depth > kMaxJsonDepth) throw std::invalid_argument("the JSON is nested too deep");
    return true;
  });
}

}  // namespace coppice
