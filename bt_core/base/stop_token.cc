#include "bt_core/base/stop_token.h"

namespace coppice {

bool StopToken::WaitFor(Duration duration) const {
  std::unique_lock<std::mutex> lock(mutex_);
  return changed_.wait_for(lock, duration, [this] { return stop_requested(); });
}

void StopToken::RequestStop() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    requested_ = true;
  }
  changed_.notify_all();
}

}  // namespace coppice
