#include "robot_app/speech/endpoint/speech_service.h"

#include <gmock/gmock.h>

#include "robot_app/speech/sound/wav_file.h"
#include "tests/robot_app/assistance/local_server.h"

namespace coppice::robot::speech {
namespace {

using assistance::HttpServer;
using assistance::LocalServer;
using testing::HasSubstr;
using testing::Not;

const Sound kSecond{kHearingRate, std::vector<std::int16_t>(16000, 100)};

SpeechService At(const std::string& url) {
  SpeechService service;
  service.url = url;
  service.key = "sesame-4711";
  service.model = "whisper-1";
  service.voice = "alloy";
  return service;
}

HttpServer::Answer Says(const std::string& body) {
  return [body](const HttpServer::Request&) { return body; };
}

TEST(SpeechService, TranscribesASound) {
  HttpServer server(Says("{\"text\": \"where is the library\"}"));
  const auto text = Transcribe(At(server.url()), kSecond, "en");
  ASSERT_TRUE(text) << text.problem();
  EXPECT_EQ(*text, "where is the library");
}

TEST(SpeechService, SendsAFormWithFileModelAndLanguage) {
  HttpServer server(Says("{\"text\": \"\"}"));
  ASSERT_TRUE(Transcribe(At(server.url()), kSecond, "de"));
  const auto request = server.requests().at(0);
  EXPECT_EQ(request.target(), "/v1/audio/transcriptions");
  EXPECT_EQ(request["Authorization"], "Bearer sesame-4711");
  EXPECT_THAT(std::string(request["Content-Type"]), HasSubstr("multipart/form-data"));
  for (const char* part : {"name=\"file\"", "RIFF", "name=\"model\"", "whisper-1", "\r\nde\r\n"}) {
    EXPECT_THAT(request.body(), HasSubstr(part));
  }
}

SpeechService GoogleAt(const std::string& url) {
  SpeechService service = At(url);
  service.interface = ServiceInterface::kGoogle;
  service.model = "latest_short";
  return service;
}

TEST(SpeechService, TranscribesASoundWithTheInterfaceOfGoogle) {
  HttpServer server(Says(
      "{\"results\": [{\"alternatives\": [{\"transcript\": \"wo ist\", \"confidence\": 0.9},"
      " {\"transcript\": \"wo isst\"}]}, {\"alternatives\": [{\"transcript\": \" die Mensa\"}]}]}"));
  const auto text = Transcribe(GoogleAt(server.url()), kSecond, "de");
  ASSERT_TRUE(text) << text.problem();
  EXPECT_EQ(*text, "wo ist die Mensa");
  const auto request = server.requests().at(0);
  EXPECT_EQ(request.target(), "/v1/speech:recognize");
  EXPECT_EQ(request["X-Goog-Api-Key"], "sesame-4711");
  EXPECT_EQ(request["Authorization"], "");
  for (const char* part :
       {"\"encoding\":\"LINEAR16\"", "\"sampleRateHertz\":16000", "\"languageCode\":\"de-DE\"",
        "\"model\":\"latest_short\"", "\"content\":\"ZABkAGQA"}) {
    EXPECT_THAT(request.body(), HasSubstr(part));
  }
}

TEST(SpeechService, WhereGoogleHearsNobodyNobodySpoke) {
  HttpServer server(Says("{}"));
  const auto text = Transcribe(GoogleAt(server.url()), kSecond, "en");
  ASSERT_TRUE(text) << text.problem();
  EXPECT_EQ(*text, "");
}

TEST(SpeechService, WhatGoogleWouldNotSayIsAProblem) {
  for (const char* reply : {"[]", "7", "{\"results\": [{}]}", "{\"results\": [[[]]]}", "<html>",
                            "{\"results\": [{\"alternatives\": [{\"transcript\": 7}]}]}"}) {
    HttpServer server(Says(reply));
    EXPECT_FALSE(Transcribe(GoogleAt(server.url()), kSecond, "en")) << reply;
  }
}

TEST(SpeechService, SpeaksAText) {
  HttpServer server(Says(WavOf(kSecond)));
  const auto sound = Synthesized(At(server.url()), "Follow \"me\".");
  ASSERT_TRUE(sound) << sound.problem();
  EXPECT_EQ(sound->samples, kSecond.samples);
  EXPECT_THAT(server.requests().at(0).body(), HasSubstr("Follow \\\"me\\\"."));
}

TEST(SpeechService, AnAbsentOneIsAProblemThatTellsNoSecret) {
  std::string url;
  { url = HttpServer().url(); }
  const auto text = Transcribe(At(url), kSecond, "en");
  ASSERT_FALSE(text);
  EXPECT_THAT(text.problem(), Not(HasSubstr("sesame")));
}

TEST(SpeechService, ASlowOneIsAProblemInTime) {
  LocalServer server([](LocalServer::Socket& socket) {
    char byte = 0;
    boost::system::error_code gone;
    while (!gone) socket.read_some(boost::asio::buffer(&byte, 1), gone);  // and no answer
  });
  SpeechService service = At("http://127.0.0.1:" + server.port());
  service.timeout = std::chrono::milliseconds(200);
  EXPECT_FALSE(Transcribe(service, kSecond, "en"));
  EXPECT_FALSE(Synthesized(service, "hello"));
}

TEST(SpeechService, ARefusalIsAProblem) {
  HttpServer server(Says("no"), 401);
  EXPECT_EQ(Transcribe(At(server.url()), kSecond, "en").problem(),
            "the service answered with status 401");
}

TEST(SpeechService, NonsenseIsAProblem) {
  const std::string cases[] = {
      "", "{", "[]", "{\"text\": 5}", "{\"texts\": \"a\"}", std::string(100'000, '['), "<html>"};
  for (const std::string& body : cases) {
    HttpServer server(Says(body));
    EXPECT_FALSE(Transcribe(At(server.url()), kSecond, "en")) << body.substr(0, 20);
    EXPECT_EQ(Synthesized(At(server.url()), "a").problem(), "the service sent no WAV file");
  }
}

TEST(SpeechService, ABookIsNoUtterance) {
  HttpServer server(Says("{\"text\": \"" + std::string(2000, 'a') + "\"}"));
  EXPECT_EQ(Transcribe(At(server.url()), kSecond, "en").problem(),
            "the service heard more than a person says");
}

TEST(SpeechService, AnEndlessAnswerIsCut) {
  HttpServer server(Says(std::string(17 << 20, 'a')));
  EXPECT_FALSE(Transcribe(At(server.url()), kSecond, "en"));
}

TEST(SpeechService, OneWithoutTrustedCertificateIsNotTalkedTo) {
  HttpServer server(Says("{\"text\": \"x\"}"));
  EXPECT_FALSE(Transcribe(At("https" + server.url().substr(4)), kSecond, "en"));
  EXPECT_TRUE(server.requests().empty());
}

}  // namespace
}  // namespace coppice::robot::speech
