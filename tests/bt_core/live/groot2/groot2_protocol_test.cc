#include "bt_core/live/groot2/groot2_protocol.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace coppice::groot2 {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::string Header(char type) { return std::string("\x02") + type + "\x78\x56\x34\x12"; }

std::string ProblemOf(const Parts& parts) { return ParseRequest(parts).problem(); }

TEST(Groot2Protocol, TakesARequestApart) {
  const Parts parts = {Header('B'), "Main;sub"};
  const auto request = ParseRequest(parts).value();
  EXPECT_EQ(request.type, RequestType::kBlackboard);
  EXPECT_EQ(request.number, 0x12345678u);
  EXPECT_EQ(request.argument, "Main;sub");
}

TEST(Groot2Protocol, MakesTheHeaderThatItReads) {
  const Parts parts = {MakeHeader('S', 0x12345678)};
  EXPECT_EQ(parts[0], Header('S'));
  EXPECT_EQ(ParseRequest(parts).value().number, 0x12345678u);
}

TEST(Groot2Protocol, EchoesTypeAndNumberInTheReply) {
  const Parts parts = {Header('S')};
  TreeId tree;
  tree.fill('t');
  const Parts reply = MakeReply(ParseRequest(parts).value(), tree, "payload");
  EXPECT_THAT(reply, ElementsAre(Header('S') + std::string(16, 't'), "payload"));
}

TEST(Groot2Protocol, SaysWhatIsWrongWithARequest) {
  EXPECT_EQ(ProblemOf({}), "wrong request header");
  EXPECT_EQ(ProblemOf({"\x02S123"}), "wrong request header");
  EXPECT_EQ(ProblemOf({"\x02S12345"}), "wrong request header");
  EXPECT_EQ(ProblemOf({Header('B')}), "must be 2 parts message");
  EXPECT_EQ(ProblemOf({Header('B'), "Main", "more"}), "must be 2 parts message");
  EXPECT_EQ(ProblemOf({Header('Q')}), "Request not recognized");
  for (const char type : std::string("BIRUrC")) {
    EXPECT_EQ(ProblemOf({Header(type)}), "must be 2 parts message");
    EXPECT_EQ(ProblemOf({Header(type), "something"}), "");
  }
  for (const char type : std::string("TSDAXt")) EXPECT_EQ(ProblemOf({Header(type)}), "");
  EXPECT_EQ(ProblemOf({Header('N'), "5"}), "Request not recognized");
}

TEST(Groot2Protocol, IgnoresTheVersionAndPartsThatNobodyAskedFor) {
  EXPECT_EQ(ProblemOf({"\x01T1234", "extra", "parts"}), "");
}

TEST(Groot2Protocol, GivesEveryRunItsOwnIdWithTheMarksOfAUuid) {
  const TreeId first = RandomTreeId();
  EXPECT_NE(first, RandomTreeId());
  EXPECT_EQ(first[6] & 0xf0, 0x40);
  EXPECT_EQ(first[8] & 0xc0, 0x80);
}

TEST(Groot2Protocol, PacksAStatusInThreeBytes) {
  std::string payload;
  AppendStatus(payload, 0x1234, 12);
  EXPECT_EQ(payload, "\x34\x12\x0c");
}

TEST(Groot2Protocol, SplitsNames) {
  EXPECT_THAT(SplitNames("Main;a/b"), ElementsAre("Main", "a/b"));
  EXPECT_THAT(SplitNames(";;x;"), ElementsAre("x"));
  EXPECT_THAT(SplitNames(""), IsEmpty());
}

TEST(Groot2Protocol, TakesRandomBytesForARequestOrSaysWhyNot) {
  std::mt19937 random(20);
  for (int i = 0; i < 20000; ++i) {
    Parts parts(random() % 4);
    for (std::string& part : parts) {
      part.resize(random() % 2 ? 6 : random() % 30);
      for (char& c : part) c = static_cast<char>(random());
      if (part.size() > 1 && random() % 2) part[1] = "TSBIRUDAXrtNC"[random() % 13];
    }
    const auto parsed = ParseRequest(parts);
    if (parsed) {
      EXPECT_EQ(parts[0][1], static_cast<char>(parsed->type));
    } else {
      EXPECT_NE(parsed.problem(), "");
    }
  }
}

}  // namespace
}  // namespace coppice::groot2
