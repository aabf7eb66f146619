// The way back: the bytes of a ROS message from the JSON that MessageToJson made of it.
//
// What was left out comes from its file; where there is none, the array is empty (one of fixed
// length: zeros), and the result says so.
#ifndef COPPICE_ROBOT_APP_STORAGE_MESSAGES_JSON_TO_MESSAGE_H_
#define COPPICE_ROBOT_APP_STORAGE_MESSAGES_JSON_TO_MESSAGE_H_

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "bt_core/base/outcome.h"
#include "robot_app/storage/messages/message_layout.h"

namespace coppice::robot::storage {

struct MessageBytes {
  std::string bytes;
  bool is_whole = true;  ///< false: something was left out and could not be found
};

/// Reads what JsonRules::keep has kept; nothing if it is not there.
using ReadKept = std::function<std::optional<std::string>(const std::string& file)>;

/// A problem names the member that does not fit the type.
Expected<MessageBytes> JsonToMessage(const MessageLayout& layout, std::string_view json,
                                     const ReadKept& read);

}  // namespace coppice::robot::storage

#endif  // COPPICE_ROBOT_APP_STORAGE_MESSAGES_JSON_TO_MESSAGE_H_
