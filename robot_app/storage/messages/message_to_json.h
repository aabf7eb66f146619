// A ROS message as JSON: its fields as members, so that a database can look into it.
//
//   const Expected<std::string> json = MessageToJson(layout, bytes, {});
//   {"header":{"seq":7,"stamp":{"secs":12,"nsecs":5},"frame_id":"map"},"x":0.1}
//
// As rosbridge does (github.com/RobotWebTools/rosbridge_suite, ROSBRIDGE_PROTOCOL.md): time and
// duration have secs and nsecs, an array of bytes is a text in base64. What JSON cannot say is said
// so that JsonToMessage brings back the same bytes: "NaN", "Infinity" and "-Infinity" for numbers
// that are none, {"base64": ...} for texts that are not UTF-8 or contain a zero byte. float32 has
// as few digits as it needs. Lost are the sign of a zero and what kind of NaN it was.
//
// A long array becomes {"left_out":"uint8","length":921600}, and "file" if it was kept in one.
#ifndef COPPICE_ROBOT_APP_STORAGE_MESSAGES_MESSAGE_TO_JSON_H_
#define COPPICE_ROBOT_APP_STORAGE_MESSAGES_MESSAGE_TO_JSON_H_

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "bt_core/base/outcome.h"
#include "robot_app/storage/messages/message_layout.h"

namespace coppice::robot::storage {

struct JsonRules {
  std::size_t longest_array = 1000;                 ///< elements
  std::size_t longest_json = std::size_t{4} << 20;  ///< bytes
  /// Keeps the bytes of an array of numbers that is left out; returns where they are, or empty.
  std::function<std::string(std::string_view bytes)> keep = {};
};

/// A problem if the bytes are too few or too many for the type, or the JSON would be too long.
/// Takes no more time and memory than the bytes and longest_json call for, whatever the bytes say.
Expected<std::string> MessageToJson(const MessageLayout& layout, std::string_view bytes,
                                    const JsonRules& rules);

}  // namespace coppice::robot::storage

#endif  // COPPICE_ROBOT_APP_STORAGE_MESSAGES_MESSAGE_TO_JSON_H_
