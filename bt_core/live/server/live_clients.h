// All who are connected to a live view, by whatever way they came: their requests on the way to the
// thread that serves, its answers and pushes on the way back.
//
//   LiveClients clients([&] { loop.Wake(); });
//   WebGateway gateway(options, clients);
//   while (clients.Receive(request)) desk.Serve(request.client, ...);
//
// What a client can make the robot keep has limits: one request, which must be taken before the
// next is read; answers and pushes that it does not read, of each and of all together.
#ifndef COPPICE_BT_CORE_LIVE_SERVER_LIVE_CLIENTS_H_
#define COPPICE_BT_CORE_LIVE_SERVER_LIVE_CLIENTS_H_

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/live/groot2/groot2_protocol.h"
#include "bt_core/live/server/live_outbox.h"

namespace coppice {

/// A request as it arrives, by whatever way.
struct ReceivedRequest {
  ClientId client{};  ///< whom to answer
  bool may_control = false;
  Duration arrived{0};  ///< in real time
  groot2::Parts parts;
};

/// One connection. Any thread.
class LiveConnection {
 public:
  virtual ~LiveConnection() = default;
  /// Sends a message, as soon as the client takes it. `bytes` of room were taken for it.
  virtual void Post(groot2::Parts message, std::size_t bytes) = 0;
  /// The request that it brought was taken: it may bring the next one.
  virtual void ReadOn() = 0;
  /// Ends now, whatever is unsent.
  virtual void CutOff() = 0;
};

/// Any thread. Must live longer than the connections.
class LiveClients final : public LiveOutbox {
 public:
  /// A request must not be longer: the sum of its parts.
  static constexpr std::size_t kMaxRequestBytes = 64 << 10;
  /// What may wait for a client that does not read: one message, and as many as fit into this. For
  /// answers twice as much.
  static constexpr std::size_t kMaxUnreadBytes = 4 << 20;
  /// The same for all clients together.
  static constexpr std::size_t kMaxUnreadInAll = 32 << 20;
  /// The same of answers, one of which nobody is denied otherwise.
  static constexpr std::size_t kMaxRepliesInAll = 4 * kMaxUnreadInAll;

  /// `on_request` is called when Receive has something new.
  explicit LiveClients(std::function<void()> on_request) : on_request_(std::move(on_request)) {}

  /// Somebody who sends requests, with or without the right to control.
  ClientId Enter(std::shared_ptr<LiveConnection> connection, bool may_control);
  /// Somebody who listens to notifications: those that begin with one of the topics.
  ClientId EnterListener(std::shared_ptr<LiveConnection> connection);
  void SetTopics(ClientId listener, std::vector<std::string> topics);
  /// What the client holds is released: that is, as a request, what it did not say itself. What it
  /// asked and was not taken yet is dropped.
  void Leave(ClientId client);
  /// Nobody is there any more, and nobody is told.
  void Clear();

  /// A request of a client that has entered.
  void Put(ClientId client, groot2::Parts request);
  /// Something that was posted is written, or never will be.
  void GiveRoom(ClientId client, std::size_t bytes);

  /// False if there is no request now. Those who may control come before those who may not;
  /// otherwise clients have their turn one after the other.
  bool Receive(ReceivedRequest& request);
  /// When the oldest request arrived that Receive has not handed over; `now` if there is none.
  Duration HeardUntil(Duration now);

  std::size_t RoomFor(ClientId client) override;
  SendResult Send(ClientId client, const groot2::Parts& parts) override;
  SendResult Reply(ClientId client, const groot2::Parts& parts) override;
  void Publish(const groot2::Parts& parts) override;

 private:
  struct Client {
    std::shared_ptr<LiveConnection> connection;
    bool may_control = false;
    bool was_served = false;  // so it may hold something
    std::size_t unread = 0;
    std::vector<std::string> topics;  // of a listener
  };
  static Duration Now();
  std::size_t RoomFor(const Client& client) const;
  bool HasRoomForReply(const Client& client, std::size_t bytes) const;
  void Post(Client& client, const groot2::Parts& parts, std::size_t bytes);

  const std::function<void()> on_request_;
  std::mutex mutex_;  // for the rest
  std::uint64_t clients_so_far_ = 0;
  std::map<ClientId, Client> clients_;
  std::map<ClientId, Client> listeners_;
  std::deque<ReceivedRequest> requests_;          // of those who may control
  std::deque<ReceivedRequest> readers_requests_;  // of the others
  std::size_t unread_ = 0;                        // of all
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_SERVER_LIVE_CLIENTS_H_
