#include "bt_nodes/operators/open_requests.h"

#include <algorithm>

namespace coppice::leaves {

std::vector<OpenRequests::Open>::iterator OpenRequests::Find(const std::string& subject) {
  return std::find_if(open_.begin(), open_.end(),
                      [&](const Open& open) { return open.request.subject == subject; });
}

bool OpenRequests::IsOpen(const std::string& subject) const {
  return std::any_of(open_.begin(), open_.end(),
                     [&](const Open& open) { return open.request.subject == subject; });
}

void OpenRequests::Assert(const WantedHelp& request, Time now,
                          const std::function<Sender<ActionResult>()>& new_sender) {
  const auto open = Find(request.subject);
  const bool is_known = open != open_.end();
  if (is_known && open->request.question == request.question) {
    open->asserted = now;
    return;
  }
  if (is_known) {
    *open = {request, now};
  } else {
    open_.push_back({request, now});
  }
  channel_.Ask(request.subject, request.question, new_sender());
}

void OpenRequests::Forget(const std::string& subject) {
  const auto open = Find(subject);
  if (open != open_.end()) open_.erase(open);
}

void OpenRequests::Settle(Time now, Duration linger, const Health* health) {
  const auto is_over = [&](const Open& open) {
    if (now - open.asserted <= linger) return false;
    if (health && health->HasError(open.request.faults)) return false;
    channel_.Withdraw(open.request.subject);
    return true;
  };
  open_.erase(std::remove_if(open_.begin(), open_.end(), is_over), open_.end());
}

}  // namespace coppice::leaves
