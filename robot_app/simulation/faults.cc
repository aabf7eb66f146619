#include "robot_app/simulation/faults.h"

#include <algorithm>
#include <csignal>
#include <utility>

namespace coppice::robot {

const std::map<std::string, Faults::Kind>& Faults::Kinds() {
  static const std::map<std::string, Kind> kinds = {
      {"block_corridor", {&Faults::Block, "clear_corridor"}},
      {"clear_corridor", {&Faults::Clear, "block_corridor"}},
      {"open_door", {&Faults::Open, "close_door"}},
      {"close_door", {&Faults::Close, "open_door"}},
      {"set_battery", {&Faults::SetBattery, ""}},
      {"kill_node", {&Faults::Kill, ""}},
      {"hang_node", {&Faults::Hang, "resume_node"}},
      {"resume_node", {&Faults::Resume, ""}},
      {"silence_topic", {&Faults::Silence, "restore_topic"}},
      {"restore_topic", {&Faults::Restore, "silence_topic"}},
  };
  return kinds;
}

Faults::Faults(World& world, std::vector<std::string> topics, SignalNode signal_node)
    : world_(world), topics_(std::move(topics)), signal_node_(std::move(signal_node)) {}

Outcome Faults::Inject(const Fault& fault) {
  const auto kind = Kinds().find(fault.fault);
  if (kind == Kinds().end()) {
    std::vector<std::string> names;
    std::string list;
    for (const auto& [name, unused] : Kinds()) {
      names.push_back(name);
      list += (list.empty() ? "" : ", ") + name;
    }
    const std::string hint = DidYouMean(fault.fault, names);
    return {false, "unknown fault \"" + fault.fault + "\"" +
                       (hint.empty() ? "; known: " + list : " (" + hint + ")")};
  }
  const std::string healer = kind->second.healed_by;
  if (!(fault.duration >= 0)) return {false, "the duration must be 0 or more seconds"};
  if (fault.duration > 0 && healer.empty()) {
    return {false, fault.fault + " does not heal by itself; the duration must be 0"};
  }
  const Outcome outcome = (this->*kind->second.action)(fault);
  if (!outcome.ok) return outcome;
  // The newest word on a thing counts: what was to happen to it later is forgotten.
  healings_.erase(std::remove_if(healings_.begin(), healings_.end(),
                                 [&](const Healing& h) {
                                   return h.fault.target == fault.target &&
                                          (h.fault.fault == healer || h.fault.fault == fault.fault);
                                 }),
                  healings_.end());
  if (fault.duration > 0) {
    healings_.push_back({world_.time() + fault.duration, {healer, fault.target, 0, 0}});
  }
  return outcome;
}

void Faults::Update() {
  for (std::size_t i = 0; i < healings_.size();) {
    const Healing& due = healings_[i];
    if (due.time > world_.time() || !(this->*Kinds().at(due.fault.fault).action)(due.fault).ok) {
      ++i;
    } else {
      healings_.erase(healings_.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
}

Outcome Faults::Kill(const Fault& f) { return signal_node_(f.target, SIGKILL); }
Outcome Faults::Hang(const Fault& f) { return signal_node_(f.target, SIGSTOP); }
Outcome Faults::Resume(const Fault& f) { return signal_node_(f.target, SIGCONT); }

Outcome Faults::CheckTopic(const std::string& topic) const {
  if (std::find(topics_.begin(), topics_.end(), topic) != topics_.end()) return {true, ""};
  std::string list;
  for (const std::string& name : topics_) list += (list.empty() ? "" : ", ") + name;
  const std::string hint = DidYouMean(topic, topics_);
  return {false, "the simulator does not publish \"" + topic + "\"" +
                     (hint.empty() ? "; it publishes " + list : " (" + hint + ")")};
}

Outcome Faults::Silence(const Fault& f) {
  const Outcome known = CheckTopic(f.target);
  if (!known.ok) return known;
  silenced_.insert(f.target);
  return {true, f.target + " is silent"};
}

Outcome Faults::Restore(const Fault& f) {
  const Outcome known = CheckTopic(f.target);
  if (!known.ok) return known;
  silenced_.erase(f.target);
  return {true, f.target + " is published"};
}

}  // namespace coppice::robot
