#include "robot_app/speech/endpoint/understanding_service.h"

#include <gmock/gmock.h>

#include "bt_core/base/json.h"
#include "tests/robot_app/assistance/local_server.h"
#include "tests/robot_app/knowledge/language_files.h"

namespace coppice::robot::speech {
namespace {

using assistance::HttpServer;
using knowledge::Intent;
using knowledge::Kind;
using knowledge::Language;
using testing::HasSubstr;

// Answers every question with that message.
HttpServer::Answer Chats(const std::string& content) {
  return [content](const HttpServer::Request&) {
    return "{\"choices\": [{\"message\": {\"role\": \"assistant\", \"content\": " +
           JsonString(content) + "}}]}";
  };
}

Expected<knowledge::ToldMeaning> Asked(const std::string& url) {
  SpeechService service;
  service.url = url;
  service.key = "sesame-4711";
  service.model = "small";
  return AskMeaning(service, "say \"hi\" to the libary", Language::kEnglish,
                    knowledge::ShippedLanguageFiles().intents);
}

TEST(UnderstandingService, TellsIntentAndNames) {
  HttpServer server(
      Chats(R"({"intent": "guide", "slots": [{"kind": "place", "words": "the libary"}]})"));
  const auto told = Asked(server.url());
  ASSERT_TRUE(told) << told.problem();
  EXPECT_EQ(told->intent, Intent::kGuide);
  ASSERT_EQ(told->slots.size(), 1U);
  EXPECT_EQ(told->slots[0].kind, Kind::kPlace);
  EXPECT_EQ(told->slots[0].words, "the libary");
}

TEST(UnderstandingService, IsAskedToChooseAmongTheIntentsAlone) {
  HttpServer server(Chats(R"({"intent": "none", "slots": []})"));
  const auto told = Asked(server.url());
  ASSERT_TRUE(told) << told.problem();
  EXPECT_FALSE(told->intent);
  const auto request = server.requests().at(0);
  EXPECT_EQ(request.target(), "/v1/chat/completions");
  EXPECT_EQ(request["Authorization"], "Bearer sesame-4711");
  const auto body = ParseJson(request.body());
  ASSERT_TRUE(body) << request.body();
  EXPECT_EQ(body->Find("messages")->children.at(1).Find("content")->text,
            "say \"hi\" to the libary");
  for (const char* part : {"\"enum\":[\"none\",\"find_place\"", "\"strict\":true",
                           "take me to {place}", "\"model\":\"small\""}) {
    EXPECT_THAT(request.body(), HasSubstr(part));
  }
}

TEST(UnderstandingService, WhatWasNotToBeChosenIsAProblem) {
  for (const char* content :
       {"I will open the door for you.", R"({"intent": "open_door", "slots": []})", "[]",
        R"({"intent": "guide", "slots": [{"kind": "door", "words": "x"}]})",
        R"({"intent": "guide", "slots": [7]})", R"({"slots": []})"}) {
    HttpServer server(Chats(content));
    EXPECT_FALSE(Asked(server.url())) << content;
  }
}

TEST(UnderstandingService, WhatIsNoAnswerIsAProblem) {
  for (const char* reply : {"", "{}", "[]", "{\"choices\": []}", "{\"choices\": [{}]}",
                            "{\"choices\": [{\"message\": {\"content\": 7}}]}"}) {
    HttpServer server([reply](const HttpServer::Request&) { return reply; });
    EXPECT_FALSE(Asked(server.url())) << reply;
  }
}

}  // namespace
}  // namespace coppice::robot::speech
