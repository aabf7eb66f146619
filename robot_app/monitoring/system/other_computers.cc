#include "robot_app/monitoring/system/other_computers.h"

#include <set>

namespace coppice::robot::monitoring {

std::vector<std::string> OtherComputers::NodesToAsk(const ProcessTable& processes) const {
  std::vector<std::string> nodes;
  std::set<std::string> asked = {own_};
  for (const auto& [node, host] : processes.hosts) {
    const bool is_new = addresses_.count(host) == 0 && asked.insert(host).second;
    if (is_new) nodes.push_back(node);
  }
  return nodes;
}

void OtherComputers::OnAddress(const ProcessTable& processes, const std::string& node,
                               const std::string& address) {
  const std::string host = processes.HostOf(node);
  if (!host.empty() && host != own_) addresses_.emplace(host, address);
}

std::vector<Computer> OtherComputers::List(const ProcessTable& processes) const {
  std::vector<Computer> others;
  for (const auto& [name, address] : addresses_) others.push_back({name, address});
  bool is_another = false;  // than the supervisor's own
  for (const auto& [node, host] : processes.hosts) is_another = is_another || host == own_;
  if (is_another) others.push_back({"main", master_});
  return others;
}

}  // namespace coppice::robot::monitoring
