#include "robot_app/speech/mouth/voices.h"

#include <gtest/gtest.h>

#include "robot_app/speech/sound/wav_file.h"
#include "tests/robot_app/assistance/local_server.h"

namespace coppice::robot::speech {
namespace {

using assistance::HttpServer;

const Sound kSecond{kHearingRate, std::vector<std::int16_t>(16000, 100)};

SpeechService At(const std::string& url) {
  SpeechService service;
  service.url = url;
  return service;
}

HttpServer::Answer Says(const std::string& body) {
  return [body](const HttpServer::Request&) { return body; };
}

TEST(Voices, SpeakWithTheServiceWhereItAnswers) {
  HttpServer server(Says(WavOf(kSecond)));
  VoiceSettings settings;
  settings.service = At(server.url());
  Voices voices(settings, [](const std::string&) {});
  EXPECT_EQ(voices.Speak("hello", "en")->sound.samples, kSecond.samples);
}

TEST(Voices, SpeakOfflineWhereItDoesNotAndLeaveItAloneForAWhile) {
  HttpServer server(Says("no"), 500);
  VoiceSettings settings;
  settings.service = At(server.url());
  std::vector<std::string> problems;
  Voices voices(settings, [&](const std::string& problem) { problems.push_back(problem); });
  EXPECT_GT(voices.Speak("hello", "en")->sound.seconds(), 0.2);
  EXPECT_GT(voices.Speak("hallo", "de")->sound.seconds(), 0.2);
  EXPECT_EQ(server.requests().size(), 1U);
  EXPECT_EQ(problems.size(), 1U);
}

}  // namespace
}  // namespace coppice::robot::speech
