// What happens on the supervisor page: who is there, what they see, what they may do. Knows neither
// sockets nor ROS; time is handed in. Not for several threads.
#ifndef COPPICE_ROBOT_APP_ASSISTANCE_PAGE_PAGE_DESK_H_
#define COPPICE_ROBOT_APP_ASSISTANCE_PAGE_PAGE_DESK_H_

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "robot_app/assistance/assistance_config.h"
#include "robot_app/assistance/help_desk.h"
#include "robot_app/assistance/page/page_command.h"
#include "robot_app/assistance/page/page_server.h"
#include "robot_app/teleoperation/teleoperation.h"

namespace coppice::robot::assistance {

/// What the page does to the robot. Returns at once.
class PageRobot {
 public:
  virtual ~PageRobot() = default;
  /// The robot stands there, in the map frame, says a person.
  virtual void SetPose(const Pose2D& pose) = 0;
  /// A process or a group. `done`: on the desk's thread, with what came of it, for people.
  virtual void Restart(const std::string& name,
                       std::function<void(bool ok, const std::string& text)> done) = 0;
};

class PageDesk {
 public:
  using Message = std::shared_ptr<const std::string>;
  /// As PageServer::Send.
  using Send = std::function<void(std::uint64_t client, const std::string& key,
                                  const Message& message, bool is_binary)>;

  PageDesk(const AssistanceConfig& config, HelpDesk& help, teleoperation::Teleoperation& wheel,
           PageRobot& robot, Send send);

  /// Somebody came, went, or asked for something. Returns a line for the log; empty: nothing that
  /// matters.
  std::string OnEvent(const PageEvent& event, Time now);

  /// Shows a text (a JSON object) to all pages, and to those that come later.
  void Show(const std::string& key, std::string text);
  /// The same of bytes.
  void ShowBytes(const std::string& key, std::string bytes);
  /// A picture of a camera, of at most 4 MiB, to those who watch it.
  void ShowPicture(std::size_t camera, const void* jpeg, std::size_t size);

  /// A beat, and the requests and the wheel if they have changed. Call it 20 times a second.
  void Step(Time now);

  bool is_watched() const { return !clients_.empty(); }
  bool is_watched(std::size_t camera) const;

 private:
  struct Client {
    PagePass pass;
    std::set<std::size_t> cameras;
  };
  struct Shown {
    Message message;
    bool is_binary = false;
  };

  void Greet(std::uint64_t client, const PagePass& pass);
  void Tell(std::uint64_t client, bool ok, const std::string& text);
  std::string Do(std::uint64_t client, Client& who, const PageCommand& command, Time now);
  void Take(std::uint64_t client, const Client& who, bool take_over, Time now);
  void ShowAll(const std::string& key, Shown shown);
  void SendBeat(Time now);
  void ShowRequests(Time now);
  void ShowWheel();

  const AssistanceConfig& config_;
  HelpDesk& help_;
  teleoperation::Teleoperation& wheel_;
  PageRobot& robot_;
  const Send send_;
  std::map<std::uint64_t, Client> clients_;
  std::map<std::string, Shown> shown_;
  std::uint64_t shown_version_ = ~std::uint64_t{0};
  Time beat_at_{};
  Time requests_shown_at_{};
  std::string shown_wheel_;
};

}  // namespace coppice::robot::assistance

#endif  // COPPICE_ROBOT_APP_ASSISTANCE_PAGE_PAGE_DESK_H_
