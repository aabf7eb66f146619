#include "robot_app/assistance/call.h"

#include <chrono>

namespace coppice::robot::assistance {

bool CallSupervisors(const AssistanceConfig& config, Channels channels, const std::string& subject,
                     const std::string& text, std::string& problems) {
  const std::atomic<bool> never_cancelled{false};
  OutgoingMessage message;
  message.headline = config.robot + " tells: " + subject;
  message.text = text;
  message.kind = "notice";
  message.subject = subject;
  message.id =
      "coppice-" + std::to_string(std::chrono::system_clock::now().time_since_epoch().count());
  for (const HumanSupervisor& supervisor : config.supervisors) {
    for (const Way& way : supervisor.ways) {
      message.to = way.to;
      message.name = supervisor.name;
      const Outcome sent = channels.at(way.channel)->Send(message, never_cancelled);
      if (sent) return true;
      problems += supervisor.name + " by " + way.channel + ": " + sent.problem() + "\n";
    }
  }
  if (config.supervisors.empty()) problems = "the configuration names no supervisor\n";
  return false;
}

}  // namespace coppice::robot::assistance
