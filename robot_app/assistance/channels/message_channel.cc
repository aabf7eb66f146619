#include "robot_app/assistance/channels/message_channel.h"

#include <iostream>

#include "robot_app/assistance/channels/mail_channel.h"
#include "robot_app/assistance/channels/message_text.h"
#include "robot_app/assistance/channels/web_channels.h"

namespace coppice::robot::assistance {
namespace {

class ConsoleChannel : public MessageChannel {
 public:
  Outcome Send(const OutgoingMessage& message, const std::atomic<bool>&) override {
    std::cout << "\n*** " + OneLine(message.name) + ": " + OneLine(message.headline) + "\n*** " +
                     OneLine(WithLink(message.text, message.link)) + "\n"
              << std::flush;
    return {};
  }
};

}  // namespace

std::unique_ptr<MessageChannel> MakeChannel(const ChannelConfig& config) {
  switch (config.kind) {
    case ChannelConfig::Kind::kSmtp:
      return std::make_unique<MailChannel>(config);
    case ChannelConfig::Kind::kTelegram:
      return std::make_unique<WebChannel>(config, MakeTelegramRequest);
    case ChannelConfig::Kind::kMatrix:
      return std::make_unique<WebChannel>(config, MakeMatrixRequest);
    case ChannelConfig::Kind::kWebhook:
      return std::make_unique<WebChannel>(config, MakeWebhookRequest);
    case ChannelConfig::Kind::kConsole:
      break;
  }
  return std::make_unique<ConsoleChannel>();
}

}  // namespace coppice::robot::assistance
