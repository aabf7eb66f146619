// A small tree behind the desk of a live view, for harnesses that send it requests.
#ifndef COPPICE_TESTS_FUZZ_SERVED_TREE_H_
#define COPPICE_TESTS_FUZZ_SERVED_TREE_H_

#include <memory>

#include "bt_core/engine/events/event_stream.h"
#include "bt_core/live/server/live_desk.h"

namespace coppice::fuzz {

/// Reads along: what is no answer of the protocol aborts.
class CheckingOutbox : public LiveOutbox {
 public:
  std::size_t RoomFor(ClientId /*client*/) override { return SIZE_MAX; }
  SendResult Reply(ClientId client, const groot2::Parts& parts) override {
    return Send(client, parts);
  }
  SendResult Send(ClientId client, const groot2::Parts& parts) override;
  void Publish(const groot2::Parts& parts) override;

  int good = 0;  ///< answers that are no errors

 private:
  int sent_ = 0;
};

class ServedTree {
 public:
  explicit ServedTree(LiveOutbox& outbox);
  ~ServedTree();
  ServedTree(const ServedTree&) = delete;
  ServedTree& operator=(const ServedTree&) = delete;

  /// A request, then a tick.
  void Serve(ClientId client, bool may_control, const groot2::Parts& request);
  /// All clients are silent for too long.
  void OutlastClients();

 private:
  SimulatedClock clock_;
  Executor executor_;
  EventStream stream_;
  std::shared_ptr<LiveTree> tree_;
  LiveDesk desk_;
  Duration now_{};
};

}  // namespace coppice::fuzz

#endif  // COPPICE_TESTS_FUZZ_SERVED_TREE_H_
