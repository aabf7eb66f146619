// A client of a robot that knows the Groot2 protocol only, such as one with BehaviorTree.CPP 4. It
// polls, one request at a time, as the protocol wants it.
#ifndef COPPICE_BT_CORE_LIVE_GROOT2_CLIENT_GROOT2_H_
#define COPPICE_BT_CORE_LIVE_GROOT2_CLIENT_GROOT2_H_

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "bt_core/live/client/client_session.h"
#include "bt_core/live/groot2/groot2_history.h"
#include "bt_core/live/groot2/groot2_hook_json.h"

namespace coppice {

class ClientGroot2 final : public ClientSession {
 public:
  /// The history outlives the session and goes on in the next one, if it is the same run.
  ClientGroot2(const LiveClientOptions& options, LiveListener& listener, Groot2History& history,
               Sender sender);

  Duration OnTime(Duration now) override;
  void OnMessage(const Parts& parts, Duration now) override;
  void Send(const LiveCommand& command, LiveClient::ReplyHandler on_reply) override;
  void Abandon(const std::string& why) override;
  void Leave() override;
  bool has_answered() const override { return heard_; }
  bool is_live() const override { return is_live_; }

 private:
  struct Answer {
    Expected<std::string> payload;  ///< the bytes that came, or what the robot says against it
    bool is_of_robot = true;        ///< else the problem is why nobody waits for one any more
  };
  struct Request {
    char type;
    std::string body;
    std::function<void(const Answer&)> on_answer;
  };
  /// One that this client has set, or is about to, or has found.
  struct KnownHook {
    HookId id;
    std::uint16_t uid;
    Hook hook;
    bool is_foreign;
    bool stands = false;  ///< the tree stopped here and was not continued since

    bool IsAt(std::uint16_t other_uid, HookPosition position) const {
      return uid == other_uid && hook.position == position;
    }
  };

  void Ask(char type, std::string body, std::function<void(const Answer&)> on_answer);
  void SendNext(Duration now);
  void Greet();
  void AskForTree();
  void AskForStart();
  void BeginLive();
  void Poll(Duration now);
  void AskForBoards();
  void AskForHooks();
  void TakeHooks(const std::vector<groot2::ListedHook>& listed);
  void TellForeignHooks();
  void Check(const Outcome& outcome);
  void OnNotification(const std::string& uid_text);
  void AddHook(const Hook& hook, LiveClient::ReplyHandler on_reply);
  void Forget(HookId id);
  void RemoveHooks(HookId id, const LiveClient::ReplyHandler& on_reply);
  void Continue(std::optional<Status> result, const LiveClient::ReplyHandler& on_reply);

  const LiveClientOptions& options_;
  LiveListener& listener_;
  Groot2History& history_;
  const Sender sender_;
  bool is_live_ = false;
  std::uint32_t number_ = 0;
  std::deque<Request> requests_;  // the first one may be under way
  bool is_waiting_ = false;
  Duration asked_{0};
  bool heard_ = false;
  RunId id_{};  // of the answer that came last
  Duration next_poll_{0};
  Duration next_boards_{0};
  std::vector<KnownHook> hooks_;  // at most one for each node and position
  std::string told_hooks_;        // of others
  HookId last_hook_ = kNoHook;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_GROOT2_CLIENT_GROOT2_H_
