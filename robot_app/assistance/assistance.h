// The desk of requests with what it needs: a sender of its letters, links to the page, and a file.
// Knows no ROS. Time is handed in. For one thread; nothing here waits for a channel.
#ifndef COPPICE_ROBOT_APP_ASSISTANCE_ASSISTANCE_H_
#define COPPICE_ROBOT_APP_ASSISTANCE_ASSISTANCE_H_

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "robot_app/assistance/assistance_config.h"
#include "robot_app/assistance/assistance_store.h"
#include "robot_app/assistance/channels/chat_answer.h"
#include "robot_app/assistance/channels/message_sender.h"
#include "robot_app/assistance/help_desk.h"
#include "robot_app/assistance/page/page_access.h"
#include "robot_app/common/service_caller.h"

namespace coppice::robot::assistance {

using Channels = std::map<std::string, std::unique_ptr<MessageChannel>>;
Channels MakeChannels(const AssistanceConfig& config);

/// Of the channels by which people may answer, by name.
using ChatListeners = std::map<std::string, std::unique_ptr<ChatListener>>;
ChatListeners MakeListeners(const AssistanceConfig& config);

class Assistance {
 public:
  /// Keeps open requests in `state_file` and takes up what an earlier run has left there; empty:
  /// they end with the program. `now`: nanoseconds since 1970 of a clock that never goes back.
  Assistance(const AssistanceConfig& config, Channels channels, const std::string& state_file,
             Time now);
  ~Assistance();

  /// Where the page is, without slash at its end; from now on questions bear a link to it.
  void set_page_url(const std::string& url) { page_url_ = url; }

  /// From now on people may also answer by these channels. Whoever writes from the address of a
  /// supervisor is that supervisor; what others write is not even answered.
  void Listen(ChatListeners listeners) { listeners_ = std::move(listeners); }

  HelpDesk& desk() { return desk_; }
  const HelpDesk& desk() const { return desk_; }
  PageAccess& access() { return access_; }

  /// Moves on: deadlines, letters, the file. Returns problems for the log, one line each. Call it
  /// several times a second.
  std::vector<std::string> Step(Time now);

 private:
  OutgoingMessage Compose(const Letter& letter, Time now);
  void TakeAnswers(Time now, std::vector<std::string>& problems);
  void TakeAnswer(const std::string& channel, const ChatAnswer& answer, Time now);
  std::string MessageId(Time now);
  void SendLetters(Time now);
  void EndLinksOfClosed();
  void Save(std::vector<std::string>& problems);
  AssistanceState CurrentState() const;

  const AssistanceConfig config_;
  const std::string state_file_;
  std::string page_url_;
  HelpDesk desk_;
  PageAccess access_;
  MessageSender sender_;
  ChatListeners listeners_;
  std::set<std::uint32_t> with_links_;  // requests that links were made for
  std::uint64_t messages_so_far_ = 0;
  std::uint64_t saved_desk_ = 0;
  std::uint64_t saved_access_ = 0;
  bool is_saving_ = false;
  std::string save_problem_;  // of the last time
  std::unique_ptr<ServiceCaller> writer_ = std::make_unique<ServiceCaller>();
};

}  // namespace coppice::robot::assistance

#endif  // COPPICE_ROBOT_APP_ASSISTANCE_ASSISTANCE_H_
