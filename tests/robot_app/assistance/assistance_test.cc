#include "robot_app/assistance/assistance.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <mutex>

namespace coppice::robot::assistance {
namespace {

using std::chrono::seconds;
using testing::HasSubstr;
using testing::StartsWith;

struct Outbox {
  std::mutex mutex;
  std::vector<OutgoingMessage> messages;
};

class KeepingChannel : public MessageChannel {
 public:
  explicit KeepingChannel(Outbox& outbox) : outbox_(outbox) {}
  Outcome Send(const OutgoingMessage& message, const std::atomic<bool>&) override {
    const std::lock_guard<std::mutex> lock(outbox_.mutex);
    outbox_.messages.push_back(message);
    return {};
  }

 private:
  Outbox& outbox_;
};

class AssistanceTest : public testing::Test {
 protected:
  AssistanceTest() {
    unlink(state_.c_str());
    config_.robot = "Sobi";
    config_.supervisors = {{"Ada", {{"kept", "a"}}}, {"Ben", {{"kept", "b"}}}};
    Start();
  }

  void Start() {
    Channels channels;
    channels["kept"] = std::make_unique<KeepingChannel>(outbox_);
    assistance_.reset();
    assistance_ = std::make_unique<Assistance>(config_, std::move(channels), state_, now_);
    assistance_->set_page_url("http://robot:8090");
  }

  // The messages, once there are so many.
  std::vector<OutgoingMessage> Messages(std::size_t count) {
    const auto deadline = std::chrono::steady_clock::now() + seconds(30);
    while (std::chrono::steady_clock::now() < deadline) {
      EXPECT_TRUE(assistance_->Step(now_).empty());
      const std::lock_guard<std::mutex> lock(outbox_.mutex);
      if (outbox_.messages.size() >= count) return outbox_.messages;
    }
    ADD_FAILURE() << "too few messages";
    return std::vector<OutgoingMessage>(count);
  }

  static std::string TokenOf(const OutgoingMessage& message) {
    return message.link.substr(message.link.find('#') + 1);
  }

  const std::string state_ =
      testing::TempDir() + "assistance_" + std::to_string(getpid()) + ".json";
  Time now_{std::chrono::hours(10000)};
  AssistanceConfig config_;
  Outbox outbox_;
  std::unique_ptr<Assistance> assistance_;
};

TEST_F(AssistanceTest, AQuestionBearsALinkThatWorksOnceAndEndsWithTheRequest) {
  const std::uint32_t id = assistance_->desk().Ask("navigation", "Blocked.", now_).value();
  const OutgoingMessage message = Messages(1)[0];
  EXPECT_EQ(message.headline, "Sobi needs help: navigation");
  EXPECT_EQ(message.kind, "question");
  EXPECT_THAT(message.link, StartsWith("http://robot:8090/#"));
  const Expected<PageAccess::Entry> entry =
      assistance_->access().LogIn(TokenOf(message), "192.0.2.1", now_);
  EXPECT_EQ(entry->pass.request, id);
  EXPECT_EQ(entry->pass.name, "Ada");
  EXPECT_FALSE(assistance_->access().LogIn(TokenOf(message), "192.0.2.1", now_));
}

TEST_F(AssistanceTest, TheAllClearHasNoLinkAndUnusedLinksEnd) {
  const std::uint32_t id = assistance_->desk().Ask("navigation", "Blocked.", now_).value();
  const std::string token = TokenOf(Messages(1)[0]);
  EXPECT_TRUE(assistance_->desk().Answer(id, "Ben", true, now_));
  const OutgoingMessage message = Messages(2)[1];
  EXPECT_EQ(message.kind, "all-clear");
  EXPECT_EQ(message.name, "Ada");
  EXPECT_THAT(message.text, HasSubstr("Ben has fixed it"));
  EXPECT_EQ(message.link, "");
  EXPECT_FALSE(assistance_->access().LogIn(token, "192.0.2.1", now_));
}

TEST_F(AssistanceTest, RequestsAndLinksOutliveARestart) {
  const std::uint32_t id = assistance_->desk().Ask("navigation", "Blocked.", now_).value();
  const std::string token = TokenOf(Messages(1)[0]);
  for (int i = 0; i < 3; ++i) {  // until the report of the sender is kept
    Messages(1);
    if (assistance_->desk().requests()[0].asked[0].state == AskedSupervisor::State::kReached) break;
  }
  Start();
  ASSERT_NE(assistance_->desk().Find(id), nullptr);
  EXPECT_EQ(assistance_->desk().Find(id)->question, "Blocked.");
  EXPECT_EQ(assistance_->access().LogIn(token, "192.0.2.1", now_)->pass.name, "Ada");
}

TEST_F(AssistanceTest, WithoutAPageThereIsNoLink) {
  assistance_->set_page_url("");
  ASSERT_TRUE(assistance_->desk().Ask("navigation", "Blocked.", now_));
  EXPECT_EQ(Messages(1)[0].link, "");
}

}  // namespace
}  // namespace coppice::robot::assistance
