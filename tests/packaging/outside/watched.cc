// Watches a run over the live socket.
#include <condition_variable>
#include <cstdio>
#include <mutex>

#include "bt_core/live/client/client.h"
#include "bt_core/live/server/live_publisher.h"
#include "tree.h"

namespace {

class View final : public coppice::LiveListener {
 public:
  void OnTree(const coppice::TreeDescription&) override {}
  void OnState(const coppice::HistoryState&) override {}
  void OnTick(const coppice::TickEvents& events) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    result_ = events.result;
    ++ticks_;
    changed_.notify_all();
  }

  // False if the tree did not complete in time.
  bool WaitForTheEnd() {
    std::unique_lock<std::mutex> lock(mutex_);
    return changed_.wait_for(lock, std::chrono::seconds(30),
                             [this] { return result_ == coppice::Status::kSuccess; });
  }
  int ticks() const { return ticks_; }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  coppice::Status result_ = coppice::Status::kIdle;
  int ticks_ = 0;
};

}  // namespace

int main() {
  coppice::SimulatedClock clock;
  coppice::Executor executor(CompileTree(), clock);
  coppice::EventStream stream(executor);
  coppice::LiveOptions options;
  options.port = 0;
  coppice::LivePublisher live(stream, options);
  View view;
  coppice::LiveClient client("127.0.0.1:" + std::to_string(live.port()), view);
  while (executor.Tick() == coppice::Status::kRunning) clock.Advance(std::chrono::seconds(1));
  if (!view.WaitForTheEnd()) return 1;
  std::printf("SUCCESS after %d watched ticks\n", view.ticks());
  return 0;
}
