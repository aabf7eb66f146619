#include "robot_app/assistance/channels/web_channels.h"

#include <nlohmann/json.hpp>

#include "robot_app/assistance/channels/message_text.h"
#include "robot_app/assistance/channels/telegram_answers.h"

namespace coppice::robot::assistance {
namespace {

std::string PlainText(const OutgoingMessage& message) {
  return OneLine(message.headline) + "\n" +
         WithLink(MessageText(message.text), OneLine(message.link));
}

}  // namespace

HttpRequest MakeTelegramRequest(const ChannelConfig& config, const OutgoingMessage& message) {
  nlohmann::json body = {{"chat_id", OneLine(message.to)},
                         {"text", PlainText(message)},
                         {"disable_web_page_preview", true},
                         {"disable_notification", message.kind == "all-clear"}};
  const bool asks = message.kind == "question" || message.kind == "reminder";
  if (config.answers && asks && message.request != 0) {
    const auto button = [&](const char* text, bool fixed) {
      return nlohmann::json{{"text", text},
                            {"callback_data", TelegramButton(message.request, fixed)}};
    };
    body["reply_markup"]["inline_keyboard"] = {{button("Fixed", true), button("Not fixed", false)}};
  }
  HttpRequest request;
  request.url = config.url + "/bot" + UrlPart(config.secret) + "/sendMessage";
  request.body = body.dump();
  return request;
}

HttpRequest MakeMatrixRequest(const ChannelConfig& config, const OutgoingMessage& message) {
  HttpRequest request;
  request.method = "PUT";
  request.url = config.url + "/_matrix/client/v3/rooms/" + UrlPart(message.to) +
                "/send/m.room.message/" + UrlPart(message.id);
  request.bearer = config.secret;
  request.body = nlohmann::json{{"msgtype", "m.text"}, {"body", PlainText(message)}}.dump();
  return request;
}

HttpRequest MakeWebhookRequest(const ChannelConfig& config, const OutgoingMessage& message) {
  const nlohmann::json body = {{"kind", message.kind},
                               {"to", MessageText(message.to)},
                               {"name", OneLine(message.name)},
                               {"headline", OneLine(message.headline)},
                               {"text", MessageText(message.text)},
                               {"link", OneLine(message.link)},
                               {"subject", OneLine(message.subject)},
                               {"request", message.request},
                               {"id", message.id}};
  HttpRequest request;
  request.url = config.url;
  request.bearer = config.secret;
  request.body = body.dump();
  return request;
}

}  // namespace coppice::robot::assistance
