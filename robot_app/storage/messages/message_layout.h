// How the bytes of a ROS message lie, read from the definition that comes with its connection: so
// messages of any type are understood without their headers.
//
//   const Expected<MessageLayout> layout = ParseDefinition("nav_msgs/Odometry", definition);
//   layout->fields[layout->messages[0].first].name     // "header"
//
// Format: http://wiki.ros.org/msg and, for the definitions of the types within, the output of
// gendeps --cat. Values; any thread.
#ifndef COPPICE_ROBOT_APP_STORAGE_MESSAGES_MESSAGE_LAYOUT_H_
#define COPPICE_ROBOT_APP_STORAGE_MESSAGES_MESSAGE_LAYOUT_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/base/outcome.h"

namespace coppice::robot::storage {

enum class FieldKind : std::uint8_t {
  kBool,
  kInt8,   // "byte" too
  kUint8,  // "char" too
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kInt64,
  kUint64,
  kFloat32,
  kFloat64,
  kTime,
  kDuration,
  kString,
  kMessage
};

/// As it is written in definitions: "float32".
const char* Word(FieldKind kind);
/// Of one value; 0 for texts and messages, whose size is not a matter of the kind.
std::size_t SizeOf(FieldKind kind);

struct MessageField {
  enum class Count : std::uint8_t { kOne, kFixed, kAny };

  std::string name;
  FieldKind kind = FieldKind::kBool;
  Count count = Count::kOne;
  std::uint32_t length = 1;   ///< of kFixed
  std::uint32_t message = 0;  ///< of kMessage: which of MessageLayout::messages
};

/// Messages and their fields as flat tables. A message within one comes before or after it; none
/// contains itself.
struct MessageLayout {
  struct Message {
    std::string type;         ///< "geometry_msgs/Pose"
    std::uint32_t first = 0;  ///< its fields are [first, end)
    std::uint32_t end = 0;
    /// In bytes, if every message of the type is as long. A product that is beyond 64 bits counts
    /// as the largest number.
    std::optional<std::uint64_t> size = std::nullopt;
  };

  std::vector<Message> messages;  ///< the first one is the type itself
  std::vector<MessageField> fields;

  /// In bytes, of one element of the field; nothing if they differ.
  std::optional<std::uint64_t> SizeOfOne(const MessageField& field) const;
};

inline constexpr std::size_t kLongestDefinition = std::size_t{256} << 10;  // bytes
inline constexpr std::size_t kLongestTypeName = 255;  // databases take no longer keys than some kB
inline constexpr int kDeepestMessage = 32;            // messages within messages

/// Letters, digits, "_" and "/", as in "geometry_msgs/Pose": it needs no quotes anywhere.
bool IsTypeName(std::string_view text);

/// A problem names the type and the line.
Expected<MessageLayout> ParseDefinition(const std::string& type, std::string_view definition);

}  // namespace coppice::robot::storage

#endif  // COPPICE_ROBOT_APP_STORAGE_MESSAGES_MESSAGE_LAYOUT_H_
