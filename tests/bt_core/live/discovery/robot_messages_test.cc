#include "bt_core/live/discovery/robot_messages.h"

#include <gmock/gmock.h>

namespace coppice {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

constexpr std::uint16_t kId = 0x1234;
constexpr Ipv4 kAddress = {192, 168, 1, 7};

RobotNotice Sobi() { return {"sobi-1667-5", 1667, "sobi", "Patrol", true}; }

// A question of another program, in the bytes of RFC 1035: its number, no flags, one question.
std::string Question(const std::string& labels, char type) {
  return std::string("\x12\x34\0\0\0\1\0\0\0\0\0\0", 12) + labels + std::string("\0\0", 2) + type +
         std::string("\0\1", 2);
}

std::string Answer(const RobotNotice& robot) {
  return AnswerMessage(robot, kAddress, ReadQuestion(QuestionMessage(kId), robot).value());
}

TEST(RobotMessages, WhatARobotAnswersIsReadAsItWasSaid) {
  const std::vector<RobotNotice> read = ReadAnswer(Answer(Sobi()), kId);
  ASSERT_THAT(read, SizeIs(1));
  EXPECT_EQ(read[0].port, 1667);
  EXPECT_EQ(read[0].host, "sobi");
  EXPECT_EQ(read[0].tree, "Patrol");
  EXPECT_TRUE(read[0].needs_token);
}

TEST(RobotMessages, AnAnswerToSomeOtherQuestionIsNone) {
  EXPECT_THAT(ReadAnswer(Answer(Sobi()), kId + 1), IsEmpty());
  EXPECT_THAT(ReadAnswer(AnnouncementMessage(Sobi(), kAddress), kId), IsEmpty());
  EXPECT_THAT(ReadAnswer(QuestionMessage(kId), kId), IsEmpty());
}

TEST(RobotMessages, TheQuestionIsRepeatedToWhoAskedFromAPortOfHisOwn) {
  const std::string question = QuestionMessage(kId).substr(12);
  EXPECT_EQ(Answer(Sobi()).substr(12, question.size()), question);
}

TEST(RobotMessages, ARobotAnswersOtherToolsInAnyCaseOfTheName) {
  const std::string service = "\x08_COPPICE\x04_tcp\x05local";
  EXPECT_TRUE(ReadQuestion(Question(service, 12), Sobi()));
  EXPECT_TRUE(ReadQuestion(Question(service, char(255)), Sobi()));
  EXPECT_TRUE(ReadQuestion(Question("\x0bsobi-1667-5" + service, 33), Sobi()));
  EXPECT_TRUE(ReadQuestion(Question("\x0bsobi-1667-5\x05local", 1), Sobi()));
}

TEST(RobotMessages, QuestionsAboutOthersAreNotAnswered) {
  EXPECT_FALSE(ReadQuestion(Question("\x05_http\x04_tcp\x05local", 12), Sobi()));
  EXPECT_FALSE(ReadQuestion(Question("\x0bsobi-1668-5\x08_coppice\x04_tcp\x05local", 33), Sobi()));
  EXPECT_FALSE(ReadQuestion(Answer(Sobi()), Sobi()));
}

TEST(RobotMessages, WhoKnowsTheAnswerGetsNone) {
  std::string asks = AnnouncementMessage(Sobi(), kAddress);
  const std::string question = QuestionMessage(kId).substr(12);
  asks.replace(0, 8, std::string("\0\0\0\0\0\1\0\4", 8));
  asks.insert(12, question);
  EXPECT_FALSE(ReadQuestion(asks, Sobi()));
  RobotNotice other = Sobi();
  other.label = "dori-1667-9";
  EXPECT_TRUE(ReadQuestion(asks, other));
}

TEST(RobotMessages, NamesOfStrangersAreCutAndFitToBeShown) {
  RobotNotice stranger = Sobi();
  stranger.tree = "\x1b[2J" + std::string(200, 'y');
  stranger.host = "a\u202eb\xff";
  const std::vector<RobotNotice> read = ReadAnswer(Answer(stranger), kId);
  ASSERT_THAT(read, SizeIs(1));
  EXPECT_EQ(read[0].tree, "[2J" + std::string(kLongestNoticeText - 3, 'y'));
  EXPECT_EQ(read[0].host, "ab");
}

// Written by hand: the own robot does not send such a thing.
TEST(RobotMessages, TextsThatWereNotCleanedByTheirSenderAreCleanedHere) {
  std::string answer = Answer(Sobi());
  answer.replace(answer.find("Patrol"), 6, "P\x1b\x07\n\r\xff");
  EXPECT_EQ(ReadAnswer(answer, kId).at(0).tree, "P");
}

TEST(RobotMessages, ARobotWithoutAPortIsNone) {
  RobotNotice robot = Sobi();
  robot.port = 0;
  EXPECT_THAT(ReadAnswer(Answer(robot), kId), IsEmpty());
}

TEST(RobotMessages, AMessageNamesEightRobotsAtMost) {
  std::string answer = std::string("\x12\x34\x84\0\0\0\0\x14\0\0\0\0", 12);
  for (char i = 0; i < 20; ++i) {
    answer += std::string("\x01") + char('a' + i) + "\x08_coppice\x04_tcp\x05local" +
              std::string("\0\0\x21\0\1\0\0\0\x0a\0\x09\0\0\0\0\x06\x83\1x", 19) + '\0';
  }
  EXPECT_THAT(ReadAnswer(answer, kId), SizeIs(8));
}

TEST(RobotMessages, APieceOfAnAnswerIsReadWithoutHarm) {
  const std::string answer = Answer(Sobi());
  for (std::size_t size = 0; size < answer.size(); ++size) {
    EXPECT_THAT(ReadAnswer(answer.substr(0, size), kId), IsEmpty()) << size;
  }
}

TEST(RobotMessages, ARobotThatGoesSaysSoByZeroSeconds) {
  const std::string stays = AnnouncementMessage(Sobi(), kAddress);
  const std::string goes = AnnouncementMessage(Sobi(), kAddress, true);
  const std::size_t seconds = 12 + std::string("._coppice._tcp.local.").size() + 4;
  EXPECT_EQ(stays.substr(seconds, 4), std::string("\0\0\0\x78", 4));
  EXPECT_EQ(goes.substr(seconds, 4), std::string("\0\0\0\0", 4));
}

}  // namespace
}  // namespace coppice
