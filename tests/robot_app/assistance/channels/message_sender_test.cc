#include "robot_app/assistance/channels/message_sender.h"

#include <gmock/gmock.h>

#include <condition_variable>
#include <functional>

namespace coppice::robot::assistance {
namespace {

class FunctionChannel : public MessageChannel {
 public:
  using Function = std::function<Outcome(const OutgoingMessage&, const std::atomic<bool>&)>;
  explicit FunctionChannel(Function function) : function_(std::move(function)) {}
  Outcome Send(const OutgoingMessage& message, const std::atomic<bool>& cancelled) override {
    return function_(message, cancelled);
  }

 private:
  const Function function_;
};

std::unique_ptr<MessageChannel> Make(FunctionChannel::Function function) {
  return std::make_unique<FunctionChannel>(std::move(function));
}

// Hangs until the program ends.
Outcome Hang(const OutgoingMessage&, const std::atomic<bool>& cancelled) {
  while (!cancelled) std::this_thread::yield();
  return Problem{"cancelled"};
}

Delivery Next(MessageSender& sender) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while (std::chrono::steady_clock::now() < deadline) {
    const std::vector<Delivery> deliveries = sender.TakeDeliveries();
    if (!deliveries.empty()) return deliveries.front();
    std::this_thread::yield();
  }
  ADD_FAILURE() << "nothing was delivered";
  return {};
}

std::map<std::string, std::unique_ptr<MessageChannel>> One(const std::string& name,
                                                           FunctionChannel::Function function) {
  std::map<std::string, std::unique_ptr<MessageChannel>> channels;
  channels[name] = Make(std::move(function));
  return channels;
}

TEST(MessageSender, ReportsEveryLetter) {
  MessageSender sender(One("good", [](const OutgoingMessage& message, const std::atomic<bool>&) {
    return message.to == "Ada" ? Outcome() : Problem{"unknown"};
  }));
  OutgoingMessage message;
  message.to = "Ada";
  sender.Send(1, "good", message);
  EXPECT_EQ(Next(sender).outcome.problem(), "");
  message.to = "Bob";
  sender.Send(2, "good", message);
  const Delivery delivery = Next(sender);
  EXPECT_EQ(delivery.letter, 2u);
  EXPECT_EQ(delivery.outcome.problem(), "unknown");
}

TEST(MessageSender, AChannelThatHangsDelaysOnlyItself) {
  auto channels = One("hung", Hang);
  channels["good"] =
      Make([](const OutgoingMessage&, const std::atomic<bool>&) { return Outcome(); });
  MessageSender sender(std::move(channels));
  sender.Send(1, "hung", {});
  sender.Send(2, "good", {});
  EXPECT_EQ(Next(sender).letter, 2u);
}

TEST(MessageSender, AnExceptionIsAnError) {
  MessageSender sender(One("bad", [](const OutgoingMessage&, const std::atomic<bool>&) -> Outcome {
    throw std::runtime_error("broken");
  }));
  sender.Send(1, "bad", {});
  EXPECT_EQ(Next(sender).outcome.problem(), "broken");
}

TEST(MessageSender, AnUnknownChannelAndAFullOneAreErrorsAtOnce) {
  MessageSender sender(One("hung", Hang));
  sender.Send(1, "other", {});
  EXPECT_EQ(Next(sender).outcome.problem(), "there is no such channel");
  for (std::uint32_t i = 0; i <= MessageSender::kMostWaiting + 1; ++i) sender.Send(i, "hung", {});
  EXPECT_EQ(Next(sender).outcome.problem(), "too many messages wait for it");
}

}  // namespace
}  // namespace coppice::robot::assistance
