// Ways to get a message to a person.
#ifndef COPPICE_ROBOT_APP_ASSISTANCE_CHANNELS_MESSAGE_CHANNEL_H_
#define COPPICE_ROBOT_APP_ASSISTANCE_CHANNELS_MESSAGE_CHANNEL_H_

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

#include "bt_core/base/outcome.h"
#include "robot_app/assistance/assistance_config.h"

namespace coppice::robot::assistance {

/// Texts may hold anything, in UTF-8 or not; a channel sends nothing that its protocol would take
/// for something else.
struct OutgoingMessage {
  std::string to;        ///< address on the channel
  std::string name;      ///< of the person
  std::string headline;  ///< one line
  std::string text;
  std::string link;  ///< may be empty
  std::string kind;  ///< question, reminder, all-clear, notice
  std::string subject;
  std::uint32_t request = 0;
  std::string id;  ///< of this message, new each time it is tried: letters, digits, '-'
};

class MessageChannel {
 public:
  virtual ~MessageChannel() = default;
  /// Sends it. Blocks for at most 15 s; less when `cancelled`. Called by one thread at a time.
  virtual Outcome Send(const OutgoingMessage& message, const std::atomic<bool>& cancelled) = 0;
};

std::unique_ptr<MessageChannel> MakeChannel(const ChannelConfig& config);

}  // namespace coppice::robot::assistance

#endif  // COPPICE_ROBOT_APP_ASSISTANCE_CHANNELS_MESSAGE_CHANNEL_H_
