// Carries messages to people without holding anybody up: each channel has a thread of its own, so
// that one that hangs in its timeout delays only itself.
#ifndef COPPICE_ROBOT_APP_ASSISTANCE_CHANNELS_MESSAGE_SENDER_H_
#define COPPICE_ROBOT_APP_ASSISTANCE_CHANNELS_MESSAGE_SENDER_H_

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "robot_app/assistance/channels/message_channel.h"

namespace coppice::robot::assistance {

struct Delivery {
  std::uint32_t letter = 0;
  std::string channel;
  Outcome outcome;
};

class MessageSender {
 public:
  static constexpr std::size_t kMostWaiting = 100;  ///< for one channel; more fail at once

  explicit MessageSender(std::map<std::string, std::unique_ptr<MessageChannel>> channels);
  /// Breaks off what is being sent; the rest is not sent.
  ~MessageSender();
  MessageSender(const MessageSender&) = delete;
  MessageSender& operator=(const MessageSender&) = delete;

  /// Returns at once. What came of it is found in TakeDeliveries.
  void Send(std::uint32_t letter, const std::string& channel, OutgoingMessage message);
  std::vector<Delivery> TakeDeliveries();

 private:
  struct Item {
    std::uint32_t letter;
    OutgoingMessage message;
  };
  struct Lane {
    std::string name;
    std::unique_ptr<MessageChannel> channel;
    std::deque<Item> waiting;
    std::condition_variable changed;
    std::thread thread;
  };
  void Work(Lane& lane);

  std::mutex mutex_;
  std::atomic<bool> stop_{false};
  std::map<std::string, Lane> lanes_;
  std::vector<Delivery> deliveries_;
};

}  // namespace coppice::robot::assistance

#endif  // COPPICE_ROBOT_APP_ASSISTANCE_CHANNELS_MESSAGE_SENDER_H_
