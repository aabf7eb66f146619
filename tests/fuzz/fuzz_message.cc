#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "bt_core/base/json_library.h"
#include "robot_app/storage/messages/json_to_message.h"
#include "robot_app/storage/messages/message_to_json.h"
#include "tests/fuzz/fuzz_targets.h"

namespace coppice::fuzz {
namespace {

using namespace robot::storage;

constexpr std::size_t kLongestJson = std::size_t{1} << 20;

// A part of the request to a server: it may break out of its quotes nowhere.
void CheckJson(const std::string& json) {
  try {
    ParseLimitedJson(json);
  } catch (const std::exception&) {
    std::abort();
  }
}

}  // namespace

int FuzzMessage(std::string_view bytes) {
  const std::size_t end = bytes.find('\0');
  const auto layout = ParseDefinition("a/B", bytes.substr(0, end));
  if (!layout) return 0;
  JsonRules rules;
  rules.longest_array = 50;
  rules.longest_json = kLongestJson;
  const std::string message(end == std::string_view::npos ? "" : bytes.substr(end + 1));
  const auto json = MessageToJson(*layout, message, rules);
  if (!json) return 1;
  if (json->size() > kLongestJson / 8) return 2;  // may be more values than are read
  CheckJson(*json);
  const auto back = JsonToMessage(*layout, *json, {});
  if (back && back->is_whole && back->bytes.size() != message.size()) std::abort();
  return 2;
}

}  // namespace coppice::fuzz
