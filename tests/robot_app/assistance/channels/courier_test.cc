#include "robot_app/assistance/channels/courier.h"

#include <gmock/gmock.h>

#include <condition_variable>
#include <functional>

namespace coppice::robot::assistance {
namespace {

class FunctionChannel : public MessageChannel {
 public:
  using Function = std::function<std::string(const OutgoingMessage&, const std::atomic<bool>&)>;
  explicit FunctionChannel(Function function) : function_(std::move(function)) {}
  std::string Send(const OutgoingMessage& message, const std::atomic<bool>& cancelled) override {
    return function_(message, cancelled);
  }

 private:
  const Function function_;
};

std::unique_ptr<MessageChannel> Make(FunctionChannel::Function function) {
  return std::make_unique<FunctionChannel>(std::move(function));
}

// Hangs until the program ends.
std::string Hang(const OutgoingMessage&, const std::atomic<bool>& cancelled) {
  while (!cancelled) std::this_thread::yield();
  return "cancelled";
}

Delivery Next(Courier& courier) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while (std::chrono::steady_clock::now() < deadline) {
    const std::vector<Delivery> deliveries = courier.TakeDeliveries();
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

TEST(Courier, ReportsEveryLetter) {
  Courier courier(One("good", [](const OutgoingMessage& message, const std::atomic<bool>&) {
    return message.to == "Ada" ? "" : "unknown";
  }));
  OutgoingMessage message;
  message.to = "Ada";
  courier.Send(1, "good", message);
  EXPECT_EQ(Next(courier).error, "");
  message.to = "Bob";
  courier.Send(2, "good", message);
  const Delivery delivery = Next(courier);
  EXPECT_EQ(delivery.letter, 2u);
  EXPECT_EQ(delivery.error, "unknown");
}

TEST(Courier, AChannelThatHangsDelaysOnlyItself) {
  auto channels = One("hung", Hang);
  channels["good"] = Make([](const OutgoingMessage&, const std::atomic<bool>&) { return ""; });
  Courier courier(std::move(channels));
  courier.Send(1, "hung", {});
  courier.Send(2, "good", {});
  EXPECT_EQ(Next(courier).letter, 2u);
}

TEST(Courier, AnExceptionIsAnError) {
  Courier courier(One("bad", [](const OutgoingMessage&, const std::atomic<bool>&) -> std::string {
    throw std::runtime_error("broken");
  }));
  courier.Send(1, "bad", {});
  EXPECT_EQ(Next(courier).error, "broken");
}

TEST(Courier, AnUnknownChannelAndAFullOneAreErrorsAtOnce) {
  Courier courier(One("hung", Hang));
  courier.Send(1, "other", {});
  EXPECT_EQ(Next(courier).error, "there is no such channel");
  for (std::uint32_t i = 0; i <= Courier::kMostWaiting + 1; ++i) courier.Send(i, "hung", {});
  EXPECT_EQ(Next(courier).error, "too many messages wait for it");
}

}  // namespace
}  // namespace coppice::robot::assistance
