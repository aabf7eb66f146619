#include "robot_app/assistance/page/page_desk.h"

#include <nlohmann/json.hpp>
#include <utility>

namespace coppice::robot::assistance {
namespace {

using nlohmann::json;
using Kind = PageCommand::Kind;

constexpr Duration kBeatPeriod = std::chrono::milliseconds(100);
constexpr Duration kRequestsPeriod = std::chrono::seconds(1);
constexpr std::size_t kLargestPicture = std::size_t{4} << 20;  // no JPEG of a camera is larger
constexpr char kPicture = 1;                                   // first byte of a binary message

std::string Dump(const json& object) {
  return object.dump(-1, ' ', false, json::error_handler_t::replace);
}

const char* NameOf(HelpState state) {
  switch (state) {
    case HelpState::kOpen:
      return "open";
    case HelpState::kFixed:
      return "fixed";
    case HelpState::kNotFixed:
      return "not fixed";
    case HelpState::kWithdrawn:
      return "withdrawn";
    case HelpState::kNobody:
      return "nobody";
  }
  return "";
}

json ToJson(const HelpRequest& request, Time now) {
  json asked = json::array();
  for (const AskedSupervisor& one : request.asked) asked.push_back(one.name);
  const bool is_open = request.state == HelpState::kOpen;
  return {
      {"id", request.id},
      {"subject", request.subject},
      {"question", request.question},
      {"state", NameOf(request.state)},
      {"asked", asked},
      {"taken_by", request.taken_by},
      {"answered_by", request.answered_by},
      {"message", request.message},
      {"age", std::chrono::duration_cast<std::chrono::seconds>(now - request.opened).count()},
      {"left",
       is_open ? std::chrono::duration_cast<std::chrono::seconds>(request.deadline - now).count()
               : 0}};
}

}  // namespace

PageDesk::PageDesk(const AssistanceConfig& config, HelpDesk& help,
                   teleoperation::Teleoperation& wheel, PageRobot& robot, Send send)
    : config_(config), help_(help), wheel_(wheel), robot_(robot), send_(std::move(send)) {}

std::string PageDesk::OnEvent(const PageEvent& event, Time now) {
  const std::string& name = event.pass.name;
  if (event.kind == PageEvent::Kind::kJoined) {
    clients_[event.client] = {event.pass, {}};
    Greet(event.client, event.pass);
    if (event.pass.request != 0) help_.Take(event.pass.request, name, now);
    return name + " has opened the page";
  }
  if (event.kind == PageEvent::Kind::kLeft) {
    clients_.erase(event.client);
    wheel_.Leave(event.client);
    return name + " has closed the page";
  }
  const auto found = clients_.find(event.client);
  const std::optional<PageCommand> command = ReadPageCommand(event.text);
  if (found == clients_.end()) return "";
  if (!command) {
    Tell(event.client, false, "The robot does not understand this page. Load it again.");
    return "";
  }
  if (event.pass.role == PageRole::kViewer && !IsForViewers(command->kind)) {
    Tell(event.client, false, "You may watch only.");
    return "";
  }
  return Do(event.client, found->second, *command, now);
}

std::string PageDesk::Do(std::uint64_t client, Client& who, const PageCommand& command, Time now) {
  const std::string& name = who.pass.name;
  switch (command.kind) {
    case Kind::kCameras:
      who.cameras.clear();
      for (std::size_t i = 0; i < config_.page.cameras.size(); ++i) {
        for (const std::string& wanted : command.names) {
          if (wanted == config_.page.cameras[i].name) who.cameras.insert(i);
        }
      }
      return "";
    case Kind::kTake:
      Take(client, who, command.take_over, now);
      return name + " takes the wheel";
    case Kind::kLeave:
      wheel_.Leave(client);
      return name + " leaves the wheel";
    case Kind::kDrive:
      wheel_.Drive(client, command.velocity, command.beat, now);
      return "";
    case Kind::kSetPose:
      robot_.SetPose(command.pose);
      Tell(client, true, "The position was set.");
      return name + " sets the position";
    case Kind::kAnswer: {
      const Expected<std::string> told = help_.Answer(command.request, name, command.fixed, now);
      Tell(client, told.ok(), told ? *told : told.problem());
      return name + (command.fixed ? " says fixed" : " says not fixed");
    }
    case Kind::kRestart:
      robot_.Restart(command.name,
                     [this, client](bool ok, const std::string& text) { Tell(client, ok, text); });
      return name + " restarts " + command.name;
  }
  return "";
}

void PageDesk::Take(std::uint64_t client, const Client& who, bool take_over, Time now) {
  if (wheel_.Take(client, who.pass.name, take_over, now)) return;
  const json answer = {{"type", "wheel_taken"}, {"by", wheel_.driver_name()}};
  send_(client, "wheel_taken", std::make_shared<const std::string>(Dump(answer)), false);
}

void PageDesk::Show(const std::string& key, std::string text) {
  ShowAll(key, {std::make_shared<const std::string>(std::move(text)), false});
}

void PageDesk::ShowBytes(const std::string& key, std::string bytes) {
  ShowAll(key, {std::make_shared<const std::string>(std::move(bytes)), true});
}

void PageDesk::ShowAll(const std::string& key, Shown shown) {
  for (const auto& [client, who] : clients_) send_(client, key, shown.message, shown.is_binary);
  shown_[key] = std::move(shown);
}

void PageDesk::ShowPicture(std::size_t camera, const void* jpeg, std::size_t size) {
  if (size > kLargestPicture) return;
  std::string bytes = {kPicture, static_cast<char>(camera)};
  bytes.append(static_cast<const char*>(jpeg), size);
  const auto message = std::make_shared<const std::string>(std::move(bytes));
  for (const auto& [client, who] : clients_) {
    if (who.cameras.count(camera) == 0) continue;
    send_(client, "camera " + std::to_string(camera), message, true);
  }
}

void PageDesk::Step(Time now) {
  SendBeat(now);
  ShowRequests(now);
  ShowWheel();
}

bool PageDesk::is_watched(std::size_t camera) const {
  for (const auto& [client, who] : clients_) {
    if (who.cameras.count(camera) > 0) return true;
  }
  return false;
}

void PageDesk::Greet(std::uint64_t client, const PagePass& pass) {
  json cameras = json::array();
  for (const CameraConfig& camera : config_.page.cameras) cameras.push_back(camera.name);
  const json hello = {{"type", "hello"},
                      {"robot", config_.robot},
                      {"name", pass.name},
                      {"client", client},
                      {"request", pass.request},
                      {"operator", pass.role == PageRole::kOperator},
                      {"editor", config_.page.editor_url},
                      {"cameras", cameras},
                      {"linear", config_.page.most_linear},
                      {"angular", config_.page.most_angular}};
  send_(client, "hello", std::make_shared<const std::string>(Dump(hello)), false);
  for (const auto& [key, shown] : shown_) send_(client, key, shown.message, shown.is_binary);
}

void PageDesk::Tell(std::uint64_t client, bool ok, const std::string& text) {
  const json message = {{"type", "told"}, {"ok", ok}, {"text", text}};
  send_(client, "told", std::make_shared<const std::string>(Dump(message)), false);
}

// Comes back with the commands of who drives: so the robot knows how old they are.
void PageDesk::SendBeat(Time now) {
  if (now - beat_at_ < kBeatPeriod) return;
  beat_at_ = now;
  const auto beat =
      std::chrono::duration_cast<std::chrono::milliseconds>(now.time_since_epoch()).count();
  Show("beat", Dump({{"type", "beat"}, {"beat", beat}}));
}

void PageDesk::ShowRequests(Time now) {
  if (help_.version() == shown_version_ && now - requests_shown_at_ < kRequestsPeriod) return;
  shown_version_ = help_.version();
  requests_shown_at_ = now;
  json requests = json::array();
  for (const HelpRequest& request : help_.requests()) requests.push_back(ToJson(request, now));
  Show("requests", Dump({{"type", "requests"}, {"requests", requests}}));
}

void PageDesk::ShowWheel() {
  std::string wheel = Dump({{"type", "wheel"},
                            {"driver", wheel_.driver()},
                            {"name", wheel_.driver_name()},
                            {"held", wheel_.held()}});
  if (wheel == shown_wheel_) return;
  shown_wheel_ = wheel;
  Show("wheel", std::move(wheel));
}

}  // namespace coppice::robot::assistance
