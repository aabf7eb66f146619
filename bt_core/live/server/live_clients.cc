#include "bt_core/live/server/live_clients.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace coppice {
namespace {

using groot2::Parts;

// What it costs to keep it, about.
constexpr std::size_t kPart = 64;
std::size_t SizeOf(const Parts& parts) {
  std::size_t size = 0;
  for (const std::string& part : parts) size += kPart + part.size();
  return size;
}

constexpr std::size_t kOverhead = 4 * kPart;  // of a message of two parts, with its header

bool IsAbout(const Parts& parts, const std::vector<std::string>& topics) {
  return std::any_of(topics.begin(), topics.end(), [&](const std::string& topic) {
    return parts.front().compare(0, topic.size(), topic) == 0;
  });
}

}  // namespace

ClientId LiveClients::Enter(std::shared_ptr<LiveConnection> connection, bool may_control) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const ClientId id{++clients_so_far_};
  clients_[id] = {std::move(connection), may_control, false, 0, {}};
  return id;
}

ClientId LiveClients::EnterListener(std::shared_ptr<LiveConnection> connection) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const ClientId id{++clients_so_far_};
  listeners_[id] = {std::move(connection), false, false, 0, {}};
  return id;
}

void LiveClients::SetTopics(ClientId listener, std::vector<std::string> topics) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto at = listeners_.find(listener);
  if (at != listeners_.end()) at->second.topics = std::move(topics);
}

void LiveClients::Leave(ClientId id) {
  std::shared_ptr<LiveConnection> connection;  // ends without the lock
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (std::map<ClientId, Client>* all : {&clients_, &listeners_}) {
      const auto at = all->find(id);
      if (at == all->end()) continue;
      unread_ -= at->second.unread;
      connection = std::move(at->second.connection);
      const bool was_served = at->second.was_served;
      all->erase(at);
      for (std::deque<ReceivedRequest>* queue : {&requests_, &readers_requests_}) {
        queue->erase(std::remove_if(queue->begin(), queue->end(),
                                    [id](const auto& request) { return request.client == id; }),
                     queue->end());
      }
      if (!was_served) return;
      const char type = static_cast<char>(groot2::RequestType::kExtension);
      requests_.push_back({id, false, Now(), {groot2::MakeHeader(type, 0), R"({"do":"bye"})"}});
    }
  }
  if (connection) on_request_();
}

void LiveClients::Clear() {
  const std::lock_guard<std::mutex> lock(mutex_);
  clients_.clear();
  listeners_.clear();
  requests_.clear();
  readers_requests_.clear();
}

void LiveClients::Put(ClientId id, Parts request) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto at = clients_.find(id);
    if (at == clients_.end()) return;
    const bool may_control = at->second.may_control;
    std::deque<ReceivedRequest>& queue = may_control ? requests_ : readers_requests_;
    queue.push_back({id, may_control, Now(), std::move(request)});
  }
  on_request_();
}

void LiveClients::GiveRoom(ClientId id, std::size_t bytes) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (std::map<ClientId, Client>* all : {&clients_, &listeners_}) {
    const auto at = all->find(id);
    if (at == all->end()) continue;
    at->second.unread -= bytes;
    unread_ -= bytes;
  }
}

bool LiveClients::Receive(ReceivedRequest& request) {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::deque<ReceivedRequest>& queue = requests_.empty() ? readers_requests_ : requests_;
  if (queue.empty()) return false;
  request = std::move(queue.front());
  queue.pop_front();
  const auto at = clients_.find(request.client);
  if (at == clients_.end()) return true;
  at->second.was_served = true;
  at->second.connection->ReadOn();
  return true;
}

Duration LiveClients::HeardUntil(Duration now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const std::deque<ReceivedRequest>* queue : {&requests_, &readers_requests_}) {
    if (!queue->empty()) now = std::min(now, queue->front().arrived);
  }
  return now;
}

Duration LiveClients::Now() { return std::chrono::steady_clock::now().time_since_epoch(); }

std::size_t LiveClients::RoomFor(const Client& client) const {
  if (client.unread == 0) return SIZE_MAX;
  const auto left = [](std::size_t most, std::size_t used) { return most - std::min(most, used); };
  return std::min(left(kMaxUnreadBytes, client.unread), left(kMaxUnreadInAll, unread_));
}

// However long the answer is: nobody can be asked to read a part of it first.
bool LiveClients::HasRoomForReply(const Client& client, std::size_t bytes) const {
  if (client.unread == 0) return unread_ + bytes <= kMaxRepliesInAll || unread_ == 0;
  return client.unread <= 2 * kMaxUnreadBytes && unread_ <= 2 * kMaxUnreadInAll;
}

void LiveClients::Post(Client& client, const Parts& parts, std::size_t bytes) {
  client.unread += bytes;
  unread_ += bytes;
  client.connection->Post(parts, bytes);
}

std::size_t LiveClients::RoomFor(ClientId id) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto at = clients_.find(id);
  const std::size_t room = at == clients_.end() ? SIZE_MAX : RoomFor(at->second);
  return room - std::min(room, kOverhead);
}

SendResult LiveClients::Send(ClientId id, const Parts& parts) {
  const std::size_t bytes = SizeOf(parts);
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto at = clients_.find(id);
  if (at == clients_.end()) return SendResult::kGone;
  if (RoomFor(at->second) < bytes) return SendResult::kFull;
  Post(at->second, parts, bytes);
  return SendResult::kSent;
}

SendResult LiveClients::Reply(ClientId id, const Parts& parts) {
  const std::size_t bytes = SizeOf(parts);
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto at = clients_.find(id);
  if (at == clients_.end()) return SendResult::kGone;
  if (HasRoomForReply(at->second, bytes)) {
    Post(at->second, parts, bytes);
    return SendResult::kSent;
  }
  at->second.connection->CutOff();
  return SendResult::kGone;
}

void LiveClients::Publish(const Parts& parts) {
  const std::size_t bytes = SizeOf(parts);
  const std::lock_guard<std::mutex> lock(mutex_);
  for (auto& [id, listener] : listeners_) {
    if (IsAbout(parts, listener.topics) && RoomFor(listener) >= bytes) Post(listener, parts, bytes);
  }
}

}  // namespace coppice
