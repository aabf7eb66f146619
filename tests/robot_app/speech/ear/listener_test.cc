#include "robot_app/speech/ear/listener.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <future>

#include "robot_app/speech/mouth/synthesizer.h"
#include "tests/robot_app/assistance/local_server.h"
#include "tests/robot_app/knowledge/language_files.h"
#include "tests/robot_app/knowledge/sample_database.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::speech {
namespace {

using assistance::HttpServer;
using knowledge::Language;

// The likeliest.
std::string TextOf(const HeardUtterance& heard) {
  return heard.alternatives.empty() ? "" : heard.alternatives.front().text;
}

// The shipped words with the first two examples of each intent: to learn all of them takes seconds.
class FewExamples {
 public:
  FewExamples() {
    std::filesystem::copy(knowledge::LanguageFolder(), folder_.path());
    YAML::Node table = YAML::LoadFile(folder_.Path("intents.yaml"));
    for (YAML::Node intent : table["intents"]) {
      YAML::Node says = intent["says"]["en"];
      const YAML::Node all = says["examples"];
      YAML::Node few;
      for (std::size_t i = 0; i < std::min<std::size_t>(all.size(), 2); ++i) few.push_back(all[i]);
      says["examples"] = few;
    }
    std::ofstream(folder_.Path("intents.yaml")) << table;
  }
  std::string path() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
};

class ListenerTest : public testing::Test {
 protected:
  ListenerSettings Settings(const std::string& url = {}) {
    ListenerSettings settings;
    settings.knowledge = sample_.path();
    settings.language_folder = language_.path();
    settings.service.url = url;
    settings.service.timeout = std::chrono::milliseconds(1500);
    return settings;
  }

  HeardUtterance Heard(const ListenerSettings& settings, Language language = Language::kEnglish) {
    return Heard(settings, {said_}, language);
  }
  HeardUtterance Heard(const ListenerSettings& settings, Utterance utterance,
                       Language language = Language::kEnglish) {
    std::promise<HeardUtterance> heard;
    Listener listener(
        settings, [&](const HeardUtterance& utterance) { heard.set_value(utterance); },
        [this](const std::string& problem) { problem_ = problem; });
    listener.Listen(std::move(utterance), language, "visitor");
    auto answer = heard.get_future();
    if (answer.wait_for(std::chrono::seconds(60)) != std::future_status::ready) return {};
    return answer.get();
  }

  knowledge::SampleDatabase sample_;
  const FewExamples language_;
  const Sound said_ = Synthesizer().Speak("where is the reading room", {"en-us+f2", 140})->sound;
  std::string problem_;
};

TEST_F(ListenerTest, HearsOfflineWithoutAService) {
  const HeardUtterance heard = Heard(Settings());
  EXPECT_EQ(TextOf(heard), "where is the reading room");
  EXPECT_EQ(heard.who, "visitor");
  EXPECT_GT(heard.took.count(), 0);
  EXPECT_EQ(problem_, "");
}

TEST_F(ListenerTest, AWholeRequestIsToldInThePauseAlready) {
  const HeardUtterance heard = Heard(Settings(), {said_, false, 7});
  EXPECT_EQ(TextOf(heard), "where is the reading room");
  EXPECT_EQ(heard.pause, 7);
}

TEST_F(ListenerTest, WhereItMayNotEndEarlyOfAPauseNobodyIsToldAndItIsNotTakenForWhatFollows) {
  const Sound other = Synthesizer().Speak("where is the copy shop", {"en-us+f2", 140})->sound;
  std::vector<std::string> texts;
  std::promise<void> all;
  ListenerSettings settings = Settings();
  settings.ends_early = false;
  Listener listener(
      settings,
      [&](const HeardUtterance& heard) {
        texts.push_back(TextOf(heard));
        if (heard.who == "last") all.set_value();
      },
      [](const std::string&) {});
  listener.Listen({said_, false}, Language::kEnglish, "visitor");
  listener.Listen({said_}, Language::kEnglish, "visitor");
  listener.Listen({said_, false}, Language::kEnglish, "visitor");
  listener.Listen({other}, Language::kEnglish, "last");
  ASSERT_EQ(all.get_future().wait_for(std::chrono::seconds(60)), std::future_status::ready);
  EXPECT_EQ(texts,
            (std::vector<std::string>{"where is the reading room", "where is the copy shop"}));
}

TEST_F(ListenerTest, HearsWithTheServiceWhereItAnswers) {
  HttpServer server([](const auto&) { return "{\"text\": \"Wo ist die Mensa?\"}"; });
  EXPECT_EQ(TextOf(Heard(Settings(server.url()), Language::kGerman)), "Wo ist die Mensa?");
}

TEST_F(ListenerTest, WhatWasSaidForSureIsUnderstoodByTheServiceForIt) {
  HttpServer ear([](const auto&) { return "{\"text\": \"Bring mich in die Bücherei\"}"; });
  HttpServer mind([](const auto&) {
    return R"({"choices": [{"message": {"content": "{\"intent\": \"guide\", \"slots\": []}"}}]})";
  });
  ListenerSettings settings = Settings(ear.url());
  settings.understanding.url = mind.url();
  const HeardUtterance heard = Heard(settings, Language::kGerman);
  ASSERT_TRUE(heard.told) << problem_;
  EXPECT_EQ(heard.told->intent, knowledge::Intent::kGuide);
}

TEST_F(ListenerTest, AServiceForUnderstandingThatIsSlowIsGoneWithoutInTime) {
  HttpServer ear([](const auto&) { return "{\"text\": \"where is the library\"}"; });
  assistance::LocalServer mind([](assistance::LocalServer::Socket& socket) {
    char byte = 0;
    boost::system::error_code gone;
    while (!gone) socket.read_some(boost::asio::buffer(&byte, 1), gone);  // and no answer
  });
  ListenerSettings settings = Settings(ear.url());
  settings.understanding.url = "http://127.0.0.1:" + mind.port();
  const auto begin = std::chrono::steady_clock::now();
  const HeardUtterance heard = Heard(settings);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(2500));
  EXPECT_FALSE(heard.told);
  EXPECT_EQ(TextOf(heard), "where is the library");
  EXPECT_NE(problem_.find("the understanding of the service"), std::string::npos);
}

TEST_F(ListenerTest, FallsBackWhereTheServiceTalksNonsense) {
  HttpServer server([](const auto&) { return "<html>"; });
  EXPECT_EQ(TextOf(Heard(Settings(server.url()))), "where is the reading room");
  EXPECT_NE(problem_, "");
}

TEST_F(ListenerTest, FallsBackWhereTheServiceIsAbsent) {
  std::string url;
  { url = HttpServer().url(); }
  EXPECT_EQ(TextOf(Heard(Settings(url))), "where is the reading room");
}

TEST_F(ListenerTest, GermanWithoutAServiceIsNotUnderstood) {
  EXPECT_EQ(TextOf(Heard(Settings(), Language::kGerman)), "");
}

TEST_F(ListenerTest, WithoutKnowledgeNothingIsHeardAndSomebodyIsTold) {
  ListenerSettings settings = Settings();
  settings.knowledge = "/nowhere/campus.db";
  EXPECT_EQ(TextOf(Heard(settings)), "");
  EXPECT_NE(problem_.find("speech cannot be recognized"), std::string::npos);
}

}  // namespace
}  // namespace coppice::robot::speech
