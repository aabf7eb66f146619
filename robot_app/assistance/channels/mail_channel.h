// E-mail by SMTP (RFC 5321), sent by libcurl. With a password the connection must be encrypted,
// unless the mail server is on this computer.
#ifndef COPPICE_ROBOT_APP_ASSISTANCE_CHANNELS_MAIL_CHANNEL_H_
#define COPPICE_ROBOT_APP_ASSISTANCE_CHANNELS_MAIL_CHANNEL_H_

#include <string>
#include <utility>

#include "robot_app/assistance/channels/message_channel.h"

namespace coppice::robot::assistance {

class MailChannel : public MessageChannel {
 public:
  explicit MailChannel(ChannelConfig config) : config_(std::move(config)) {}
  Outcome Send(const OutgoingMessage& message, const std::atomic<bool>& cancelled) override;

 private:
  const ChannelConfig config_;
};

}  // namespace coppice::robot::assistance

#endif  // COPPICE_ROBOT_APP_ASSISTANCE_CHANNELS_MAIL_CHANNEL_H_
