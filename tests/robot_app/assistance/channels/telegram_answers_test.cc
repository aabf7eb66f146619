#include "robot_app/assistance/channels/telegram_answers.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "robot_app/assistance/assistance.h"
#include "tests/robot_app/assistance/local_server.h"
#include "tests/robot_app/eventually.h"

namespace coppice::robot::assistance {
namespace {

using nlohmann::json;
using std::chrono::seconds;
using testing::HasSubstr;
using testing::SizeIs;

json Text(std::int64_t id, std::int64_t chat, const std::string& text, int date = 1000) {
  return {{"update_id", id},
          {"message", {{"chat", {{"id", chat}}}, {"date", date}, {"text", text}}}};
}
json Press(std::int64_t id, std::int64_t chat, const std::string& data) {
  return {{"update_id", id},
          {"callback_query",
           {{"id", "press"}, {"data", data}, {"message", {{"chat", {{"id", chat}}}}}}}};
}
std::string Reply(const json& updates) { return json{{"ok", true}, {"result", updates}}.dump(); }

TEST(TelegramUpdates, AreReadFromTextsAndButtons) {
  const auto updates = ReadTelegramUpdates(Reply(
      {Text(10, 42, "Fixed"), Press(12, -7, "not_fixed:5"), Text(11, 42, "/not_fixed@a_bot 8")}));
  ASSERT_TRUE(updates);
  EXPECT_EQ(updates->next, 13);
  ASSERT_THAT(updates->answers, SizeIs(3));
  EXPECT_EQ(updates->answers[0].from, "42");
  EXPECT_TRUE(updates->answers[0].fixed);
  EXPECT_EQ(updates->answers[0].request, 0u);
  EXPECT_EQ(updates->answers[0].written, Time(seconds(1000)));
  EXPECT_EQ(updates->answers[1].from, "-7");
  EXPECT_FALSE(updates->answers[1].fixed);
  EXPECT_EQ(updates->answers[1].request, 5u);
  EXPECT_EQ(updates->answers[1].pressed, "press");
  EXPECT_FALSE(updates->answers[2].fixed);
  EXPECT_EQ(updates->answers[2].request, 8u);
}

TEST(TelegramUpdates, TalkIsNoAnswerButIsSeen) {
  json picture = Text(20, 42, "");
  picture["message"].erase("text");
  const auto updates = ReadTelegramUpdates(
      Reply({Text(14, 42, "is it fixed?"), Text(15, 42, "fixed 99999999999"), Text(16, 42, "not"),
             Text(17, 42, "fixed it"), Press(18, 42, "fixed"), Press(19, 42, "reboot:1"), picture,
             json{{"update_id", 21}}}));
  ASSERT_TRUE(updates);
  EXPECT_THAT(updates->answers, SizeIs(0));
  EXPECT_EQ(updates->next, 22);
}

TEST(TelegramUpdates, WhatIsNoReplyIsNone) {
  for (const char* body :
       {"", "{}", "[1]", R"({"result":7})", R"({"result":[{"update_id":"x"}]})"}) {
    EXPECT_FALSE(ReadTelegramUpdates(body)) << body;
  }
}

// Telegram in small: hands out updates from an offset on, and hears what is sent.
class FakeTelegram {
 public:
  void Add(json update) {
    const std::lock_guard<std::mutex> lock(mutex_);
    updates_.push_back(std::move(update));
  }
  ChannelConfig Config() const {
    return {"telegram", ChannelConfig::Kind::kTelegram, server_.url(), "", "s3cret", ""};
  }
  std::vector<json> Bodies(const std::string& method) {
    std::vector<json> bodies;
    for (const HttpServer::Request& request : server_.requests()) {
      if (request.target() == "/bots3cret/" + method) bodies.push_back(json::parse(request.body()));
    }
    return bodies;
  }

 private:
  std::string Answer(const HttpServer::Request& request) {
    if (request.target() != "/bots3cret/getUpdates") return R"({"ok":true})";
    const std::int64_t offset = json::parse(request.body()).at("offset");
    const std::lock_guard<std::mutex> lock(mutex_);
    json due = json::array();
    for (const json& update : updates_) {
      if (update.at("update_id") >= offset) due.push_back(update);
    }
    return Reply(due);
  }

  std::mutex mutex_;
  std::vector<json> updates_;
  HttpServer server_{[this](const HttpServer::Request& request) { return Answer(request); }};
};

TEST(TelegramAnswersTest, HandsOutEachAnswerOnceAndEndsTheWaitOfAButton) {
  FakeTelegram telegram;
  telegram.Add(Press(3, 42, "fixed:7"));
  TelegramAnswers listener(telegram.Config(), {seconds(0), std::chrono::milliseconds(10)});
  std::vector<ChatAnswer> answers;
  const auto take = [&] {
    for (const ChatAnswer& answer : listener.TakeAnswers()) answers.push_back(answer);
    return answers.size();
  };
  ASSERT_TRUE(Eventually([&] { return take() == 1; }));
  EXPECT_EQ(answers[0].request, 7u);
  telegram.Add(Text(4, 42, "not fixed"));
  ASSERT_TRUE(Eventually([&] { return take() == 2; }));
  EXPECT_FALSE(answers[1].fixed);
  ASSERT_THAT(telegram.Bodies("answerCallbackQuery"), SizeIs(1));
  EXPECT_EQ(telegram.Bodies("answerCallbackQuery")[0].at("callback_query_id"), "press");
}

TEST(TelegramAnswersTest, TellsWhyNothingCanCome) {
  HttpServer server(401);
  TelegramAnswers listener({"telegram", ChannelConfig::Kind::kTelegram, server.url(), "", "x", ""},
                           {seconds(0), std::chrono::milliseconds(10)});
  std::vector<std::string> problems;
  ASSERT_TRUE(Eventually([&] { return !(problems = listener.TakeProblems()).empty(); }));
  EXPECT_THAT(problems[0], HasSubstr("status 401"));
}

// From the question to the all-clear, with the channel as it is.
class AnswerByTelegram : public testing::Test {
 protected:
  AnswerByTelegram() {
    config_.robot = "Sobi";
    config_.channels = {telegram_.Config()};
    config_.supervisors = {{"Ada", {{"telegram", "42"}}}, {"Ben", {{"telegram", "43"}}}};
    assistance_.emplace(config_, MakeChannels(config_), "", now_);
    ChatListeners listeners;
    listeners["telegram"] = std::make_unique<TelegramAnswers>(
        telegram_.Config(), TelegramAnswers::Patience{seconds(0), std::chrono::milliseconds(10)});
    assistance_->Listen(std::move(listeners));
    id_ = assistance_->desk().Ask("navigation", "Blocked.", now_).value();
  }

  HelpState State() { return assistance_->desk().Find(id_)->state; }
  // Until a message with this text has gone to the chat.
  bool Hears(const std::string& chat, const std::string& text) {
    return Eventually([&] {
      assistance_->Step(now_);
      for (const json& body : telegram_.Bodies("sendMessage")) {
        const bool fits = body.at("text").get<std::string>().find(text) != std::string::npos;
        if (fits && body.at("chat_id") == chat) return true;
      }
      return false;
    });
  }

  FakeTelegram telegram_;
  const Time now_{std::chrono::hours(10000)};
  AssistanceConfig config_;
  std::optional<Assistance> assistance_;
  std::uint32_t id_ = 0;
};

TEST_F(AnswerByTelegram, TheFirstResponderWinsAndTheOtherHearsOfIt) {
  ASSERT_TRUE(Hears("42", "Blocked."));
  telegram_.Add(Press(1, 42, TelegramButton(id_, false)));
  ASSERT_TRUE(Hears("42", "The next supervisor is asked."));
  ASSERT_TRUE(Hears("43", "Blocked."));
  telegram_.Add(Press(2, 43, TelegramButton(id_, true)));
  ASSERT_TRUE(Hears("43", "Thank you."));
  EXPECT_EQ(State(), HelpState::kFixed);
  EXPECT_EQ(assistance_->desk().Find(id_)->answered_by, "Ben");
  ASSERT_TRUE(Hears("42", "Ben has fixed it."));
  telegram_.Add(Press(3, 42, TelegramButton(id_, true)));
  ASSERT_TRUE(Hears("42", "It was closed before: Ben has fixed it."));
}

TEST_F(AnswerByTelegram, OnlyTheConfiguredChatsCount) {
  ASSERT_TRUE(Hears("42", "Blocked."));
  telegram_.Add(Press(1, 4242, TelegramButton(id_, true)));
  telegram_.Add(Text(2, -42, "fixed", 36000001));
  telegram_.Add(Text(3, 42, "not fixed", 36000001));
  ASSERT_TRUE(Hears("42", "Thank you."));
  EXPECT_EQ(State(), HelpState::kOpen);
  for (const json& body : telegram_.Bodies("sendMessage")) {
    EXPECT_THAT(body.at("chat_id").get<std::string>(), testing::AnyOf("42", "43"));
  }
}

TEST_F(AnswerByTelegram, AnOldTextAnswersNoNewQuestion) {
  telegram_.Add(Text(1, 42, "fixed", 35999000));
  ASSERT_TRUE(Hears("42", "Nothing is open."));
  EXPECT_EQ(State(), HelpState::kOpen);
}

}  // namespace
}  // namespace coppice::robot::assistance
