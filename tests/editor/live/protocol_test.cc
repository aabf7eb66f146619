#include "editor/live/protocol.h"

#include <gtest/gtest.h>

#include <random>

namespace coppice::editor {
namespace {

TEST(Protocol, WritesTheHeaderInLittleEndian) {
  EXPECT_EQ(EncodeRequest(RequestType::kStatus, 0x01020304),
            std::string("\x02S\x04\x03\x02\x01", 6));
}

TEST(Protocol, ReadsTheTreeIdAndThePayload) {
  std::string error;
  const std::string header =
      EncodeRequest(RequestType::kFullTree, 9) + std::string(15, '\0') + "\x7f";
  const auto reply = DecodeReply({header, "<root/>"}, RequestType::kFullTree, 9, error);
  ASSERT_TRUE(reply) << error;
  EXPECT_EQ(reply->tree_id[15], 0x7f);
  EXPECT_EQ(reply->payload, "<root/>");
}

TEST(Protocol, PassesTheRobotsWordsOnWhenItRefuses) {
  std::string error;
  EXPECT_FALSE(DecodeReply({"error", "Node ID not found"}, RequestType::kStatus, 1, error));
  EXPECT_NE(error.find("Node ID not found"), std::string::npos);
}

TEST(Protocol, RefusesAnswersToOtherRequests) {
  std::string error;
  const std::string header = EncodeRequest(RequestType::kStatus, 9) + std::string(16, 'i');
  EXPECT_FALSE(DecodeReply({header}, RequestType::kStatus, 8, error));
  EXPECT_FALSE(DecodeReply({header}, RequestType::kFullTree, 9, error));
  EXPECT_FALSE(DecodeReply({header + "x"}, RequestType::kStatus, 9, error));
  EXPECT_FALSE(DecodeReply({}, RequestType::kStatus, 9, error));
}

TEST(Protocol, ReadsStatusesAndTheTrailOfIdleNodes) {
  const auto nodes = DecodeStatuses(std::string("\x01\x00\x01\xff\x01\x0d\x03\x00\x00", 9));
  ASSERT_TRUE(nodes);
  ASSERT_EQ(nodes->size(), 3U);
  EXPECT_EQ((*nodes)[0].status, Status::kRunning);
  EXPECT_EQ((*nodes)[1].uid, 0x1ff);
  EXPECT_EQ((*nodes)[1].status, Status::kIdle);
  EXPECT_EQ((*nodes)[1].before, Status::kFailure);
  EXPECT_EQ((*nodes)[2].before, Status::kIdle);
}

TEST(Protocol, RefusesStatusesThatAreCutOffOrUnknown) {
  EXPECT_FALSE(DecodeStatuses(std::string("\x01\x00", 2)));
  EXPECT_FALSE(DecodeStatuses(std::string("\x01\x00\x05", 3)));
  EXPECT_FALSE(DecodeStatuses(std::string("\x01\x00\x0a", 3)));
  EXPECT_FALSE(DecodeStatuses(std::string("\x01\x00\xff", 3)));
  EXPECT_TRUE(DecodeStatuses(""));
}

TEST(Protocol, ReadsNestedBlackboardValues) {
  // {"Main": {"list": [1, 2.5], "none": nil}}
  const auto boards = DecodeBoards(
      std::string("\x81\xa4Main\x82\xa4list\x92\x01\xca\x40\x20\x00\x00\xa4none\xc0", 25));
  ASSERT_TRUE(boards);
  ASSERT_EQ(boards->size(), 1U);
  EXPECT_EQ((*boards)[0].entries[0].value, "[1,2.5]");
  EXPECT_EQ((*boards)[0].entries[1].value, "null");
}

TEST(Protocol, AcceptsThatNoBlackboardWasFound) {
  const auto boards = DecodeBoards("\xc0");
  ASSERT_TRUE(boards);
  EXPECT_TRUE(boards->empty());
}

TEST(Protocol, ShowsBytesThatAreNoUtf8WithoutFailing) {
  const auto boards = DecodeBoards("\x81\xa1M\x81\xa1k\xa2\xff\xfe");
  ASSERT_TRUE(boards);
  EXPECT_FALSE((*boards)[0].entries[0].value.empty());
}

TEST(Protocol, SurvivesRandomBytes) {
  std::mt19937 random(1);
  int refused = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string bytes;
    for (unsigned n = random() % 40; n > 0; --n) bytes += static_cast<char>(random());
    refused += !DecodeBoards(bytes) + !DecodeStatuses(bytes);
  }
  EXPECT_GT(refused, 20000);
}

}  // namespace
}  // namespace coppice::editor
