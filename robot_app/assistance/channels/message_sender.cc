#include "robot_app/assistance/channels/message_sender.h"

#include <pthread.h>

#include <exception>
#include <utility>

namespace coppice::robot::assistance {

MessageSender::MessageSender(std::map<std::string, std::unique_ptr<MessageChannel>> channels) {
  for (auto& [name, channel] : channels) {
    Lane& lane = lanes_[name];
    lane.name = name;
    lane.channel = std::move(channel);
  }
  for (auto& [name, lane] : lanes_) lane.thread = std::thread([this, &lane = lane] { Work(lane); });
}

MessageSender::~MessageSender() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
  }
  for (auto& [name, lane] : lanes_) lane.changed.notify_one();
  for (auto& [name, lane] : lanes_) lane.thread.join();
}

void MessageSender::Send(std::uint32_t letter, const std::string& channel,
                         OutgoingMessage message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = lanes_.find(channel);
  if (found == lanes_.end()) {
    deliveries_.push_back({letter, channel, Problem{"there is no such channel"}});
  } else if (found->second.waiting.size() >= kMostWaiting) {
    deliveries_.push_back({letter, channel, Problem{"too many messages wait for it"}});
  } else {
    found->second.waiting.push_back({letter, std::move(message)});
    found->second.changed.notify_one();
  }
}

std::vector<Delivery> MessageSender::TakeDeliveries() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(deliveries_, {});
}

void MessageSender::Work(Lane& lane) {
  pthread_setname_np(pthread_self(), "message_sender");
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    lane.changed.wait(lock, [&] { return stop_ || !lane.waiting.empty(); });
    if (stop_) return;
    const Item item = std::move(lane.waiting.front());
    lane.waiting.pop_front();
    lock.unlock();
    Outcome outcome;
    try {
      outcome = lane.channel->Send(item.message, stop_);
    } catch (const std::exception& exception) {
      outcome = Problem{exception.what()};
    }
    lock.lock();
    deliveries_.push_back({item.letter, lane.name, std::move(outcome)});
  }
}

}  // namespace coppice::robot::assistance
