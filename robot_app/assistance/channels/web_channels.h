// Messages as HTTP requests: the Bot API of Telegram, the client-server API of Matrix, and one
// JSON object for whatever else there is.
#ifndef COPPICE_ROBOT_APP_ASSISTANCE_CHANNELS_WEB_CHANNELS_H_
#define COPPICE_ROBOT_APP_ASSISTANCE_CHANNELS_WEB_CHANNELS_H_

#include <string>
#include <utility>

#include "robot_app/assistance/channels/http_request.h"
#include "robot_app/assistance/channels/message_channel.h"

namespace coppice::robot::assistance {

/// https://core.telegram.org/bots/api#sendmessage; `to` is the id of a chat. A question
/// has a button for each answer (telegram_answers.h).
HttpRequest MakeTelegramRequest(const ChannelConfig& config, const OutgoingMessage& message);

/// https://spec.matrix.org/latest/client-server-api/ (PUT .../send/m.room.message/...); `to` is the
/// id of a room. The id of the message keeps a repeated request from being shown twice.
HttpRequest MakeMatrixRequest(const ChannelConfig& config, const OutgoingMessage& message);

/// POST of {"kind", "to", "name", "headline", "text", "link", "subject", "request", "id"}.
HttpRequest MakeWebhookRequest(const ChannelConfig& config, const OutgoingMessage& message);

class WebChannel : public MessageChannel {
 public:
  using Maker = HttpRequest (*)(const ChannelConfig& config, const OutgoingMessage& message);
  WebChannel(ChannelConfig config, Maker maker) : config_(std::move(config)), maker_(maker) {}
  Outcome Send(const OutgoingMessage& message, const std::atomic<bool>& cancelled) override {
    const Expected<std::string> reply = Exchange(maker_(config_, message), cancelled);
    return reply ? Outcome() : Problem{reply.problem()};
  }

 private:
  const ChannelConfig config_;
  const Maker maker_;
};

}  // namespace coppice::robot::assistance

#endif  // COPPICE_ROBOT_APP_ASSISTANCE_CHANNELS_WEB_CHANNELS_H_
