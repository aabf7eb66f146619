// What people write back to the robot by the channel that asked them.
#ifndef COPPICE_ROBOT_APP_ASSISTANCE_CHANNELS_CHAT_ANSWER_H_
#define COPPICE_ROBOT_APP_ASSISTANCE_CHANNELS_CHAT_ANSWER_H_

#include <cstdint>
#include <string>
#include <vector>

#include "bt_core/base/clock.h"

namespace coppice::robot::assistance {

/// Not yet checked: anybody may write to a chat program.
struct ChatAnswer {
  std::string from;           ///< address on the channel, as Way::to
  std::uint32_t request = 0;  ///< 0: not said
  bool fixed = false;
  Time written{};       ///< nanoseconds since 1970; 0 for a button, which says its request
  std::string pressed;  ///< what the channel calls the press of a button; empty: it was written
};

class ChatListener {
 public:
  virtual ~ChatListener() = default;
  /// What has come since the last call. Never waits.
  virtual std::vector<ChatAnswer> TakeAnswers() = 0;
  /// Why nothing can come, one line each.
  virtual std::vector<std::string> TakeProblems() = 0;
};

}  // namespace coppice::robot::assistance

#endif  // COPPICE_ROBOT_APP_ASSISTANCE_CHANNELS_CHAT_ANSWER_H_
