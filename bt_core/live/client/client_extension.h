// A client of a robot with Coppice: the extension of the live protocol (docs/live.md).
#ifndef COPPICE_BT_CORE_LIVE_CLIENT_CLIENT_EXTENSION_H_
#define COPPICE_BT_CORE_LIVE_CLIENT_CLIENT_EXTENSION_H_

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "bt_core/live/client/client_history.h"
#include "bt_core/live/client/client_session.h"

namespace coppice {

class ClientExtension final : public ClientSession {
 public:
  /// Says hello. The history outlives the session and goes on in the next one.
  ClientExtension(const LiveClientOptions& options, LiveListener& listener, ClientHistory& history,
                  Sender sender);

  Duration OnTime(Duration now) override;
  void OnMessage(const Parts& parts, Duration now) override;
  void Send(const LiveCommand& command, LiveClient::ReplyHandler on_reply) override;
  void Leave() override;
  void Abandon(const std::string& why) override;
  bool has_answered() const override { return heard_ > Duration(0); }
  bool is_live() const override { return is_subscribed_; }

 private:
  using ReplyHandler = std::function<void(const std::string& json)>;

  void Ask(const std::string& json, ReplyHandler on_reply);
  void SendWithoutReply(const std::string& json);
  void OnHello(const std::string& json);
  void Subscribe();
  void OnSubscribed(const std::string& json);
  void OnHooks(const std::string& json);
  void TellLive();
  void OnReply(const Parts& parts);
  void OnFrames(const Parts& parts);
  void OnNotice(const Parts& parts);
  void TellNotices();
  void OnPicture(LivePicture picture);
  void OnTrees(const std::vector<std::string>& trees);
  bool ChooseTree();

  const LiveClientOptions& options_;
  LiveListener& listener_;
  ClientHistory& history_;
  const Sender sender_;
  LiveConnection connection_;
  std::uint32_t number_ = 0;
  std::map<std::uint32_t, ReplyHandler> pending_;  // by the number of the request
  std::uint32_t subscription_ = 0;
  bool is_subscribing_ = false;
  bool is_subscribed_ = false;
  PictureSet pictures_;
  std::vector<LiveNotice> early_notices_;  // those that came before the tree
  Duration heard_{0};
  Duration looked_{0};  // when it was last asked what is due
  Duration next_ping_{0};
  bool pinged_ = false;  // since the robot was heard last
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_CLIENT_CLIENT_EXTENSION_H_
