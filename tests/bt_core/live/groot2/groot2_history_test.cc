#include "bt_core/live/groot2/groot2_history.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "bt_core/data/value_bytes.h"
#include "tests/bt_core/live/watcher.h"

namespace coppice {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)

constexpr Status kIdle = Status::kIdle;
constexpr Status kRunning = Status::kRunning;
constexpr Status kSuccess = Status::kSuccess;
constexpr Status kFailure = Status::kFailure;

constexpr char kXml[] = R"(<root BTCPP_format="4"><BehaviorTree ID="Main" _fullpath="">
  <Parallel name="p" _uid="10"><A name="a" _uid="20"/><B name="b" _uid="30"/></Parallel>
  </BehaviorTree></root>)";

std::string Transition(std::uint64_t microseconds, std::uint16_t uid, Status status) {
  std::string bytes;
  for (int i = 0; i < 6; ++i) bytes += static_cast<char>(microseconds >> (8 * i));
  bytes += static_cast<char>(uid);
  bytes += static_cast<char>(uid >> 8);
  bytes += static_cast<char>(status);
  return bytes;
}

std::string Statuses(int p, int a, int b) {
  std::string bytes;
  int uid = 10;
  for (const int status : {p, a, b}) {
    bytes += {static_cast<char>(uid), 0, static_cast<char>(status)};
    uid += 10;
  }
  return bytes;
}

std::string Pack(const nlohmann::json& json) {
  const auto bytes = nlohmann::json::to_msgpack(json);
  return std::string(bytes.begin(), bytes.end());
}

class Groot2HistoryTest : public ::testing::Test {
 protected:
  void Begin(bool records = true) {
    ASSERT_EQ(history_.SetTree(RunId{1}, kXml).problem(), "");
    if (records) {
      ASSERT_EQ(history_.SetRecording("1000000").problem(), "");
    }
    ASSERT_EQ(history_.AddStatuses(Statuses(0, 12, 0), Time(1s)).problem(), "");
  }
  std::vector<Status> statuses() { return watcher_.watched().follower->statuses(); }

  Watcher watcher_;
  Groot2History history_{watcher_, "robot:1667"};
};

TEST_F(Groot2HistoryTest, BeginsWhenTheStatusesAreKnown) {
  ASSERT_EQ(history_.SetTree(RunId{1}, kXml).problem(), "");
  EXPECT_FALSE(history_.has_begun());
  EXPECT_THAT(watcher_.watched().trees, IsEmpty());
  ASSERT_EQ(history_.AddStatuses(Statuses(1, 2, 1), Time(1s)).problem(), "");
  EXPECT_TRUE(history_.has_begun());
  EXPECT_THAT(watcher_.watched().trees, SizeIs(1));
  EXPECT_THAT(statuses(), ElementsAre(kRunning, kSuccess, kRunning));
}

TEST_F(Groot2HistoryTest, SaysThatOnlyChangesAreTold) {
  Begin();
  EXPECT_TRUE(TellsChangesOnly(watcher_.watched().trees[0].info));
  EXPECT_FALSE(TellsChangesOnly(RunInfo()));
}

TEST_F(Groot2HistoryTest, MakesTicksOfTransitionsThatFollowEachOther) {
  Begin();
  EXPECT_EQ(history_
                .AddTransitions(Transition(0, 20, kRunning) + Transition(500, 30, kFailure) +
                                Transition(900, 10, kRunning) + Transition(9000, 20, kSuccess))
                .problem(),
            "");
  EXPECT_THAT(watcher_.watched().ticks, ElementsAre(1, 2));
  EXPECT_THAT(statuses(), ElementsAre(kRunning, kSuccess, kFailure));
}

TEST_F(Groot2HistoryTest, StatusesCorrectOnlyWhatStaysDifferent) {
  Begin();
  EXPECT_EQ(history_.AddStatuses(Statuses(1, 1, 0), Time(2s)).problem(), "");
  EXPECT_THAT(statuses(), ElementsAre(kIdle, kIdle, kIdle));  // the transitions will come
  EXPECT_EQ(history_.AddStatuses(Statuses(1, 1, 0), Time(3s)).problem(), "");
  EXPECT_THAT(statuses(), ElementsAre(kRunning, kRunning, kIdle));
}

TEST_F(Groot2HistoryTest, WithoutARecordingStatusesAreAllThereIs) {
  Begin(false);
  EXPECT_EQ(history_.AddStatuses(Statuses(1, 1, 0), Time(2s)).problem(), "");
  EXPECT_THAT(statuses(), ElementsAre(kRunning, kRunning, kIdle));
}

TEST_F(Groot2HistoryTest, ReportsAGapWhenTheRobotMayHaveDroppedTransitions) {
  Begin();
  std::string bytes;
  for (int i = 0; i < 1000; ++i) bytes += Transition(static_cast<std::uint64_t>(i), 20, kRunning);
  EXPECT_EQ(history_.AddTransitions(bytes).problem(), "");
  EXPECT_EQ(history_.AddStatuses(Statuses(3, 12, 13), Time(2s)).problem(), "");
  EXPECT_THAT(watcher_.watched().gaps, SizeIs(1));
  EXPECT_THAT(statuses(), ElementsAre(kFailure, kIdle, kIdle));
}

TEST_F(Groot2HistoryTest, ValuesAreWritesAndNewKeysAreAnotherDescription) {
  Begin();
  EXPECT_EQ(history_.AddBoards(Pack({{"Main", {{"n", 1}, {"x", 0.5}}}}), Time(2s)).problem(), "");
  EXPECT_THAT(watcher_.watched().trees, SizeIs(2));
  EXPECT_EQ(history_.AddBoards(Pack({{"Main", {{"n", 2}, {"x", 0.5}}}}), Time(3s)).problem(), "");
  const Watched watched = watcher_.watched();
  EXPECT_THAT(watched.trees, SizeIs(2));
  ASSERT_THAT(watched.values, SizeIs(2));
  EXPECT_EQ(PrintValueBytes(watched.values[0]), "2");
  EXPECT_EQ(PrintValueBytes(watched.values[1]), "0.5");
  EXPECT_EQ(history_.AddBoards(Pack(nullptr), Time(3s)).problem(), "");
}

TEST_F(Groot2HistoryTest, KeepsTheFirstKeysOfARobotThatMakesThemWithoutEnd) {
  Begin();
  for (int round = 0; round < 4; ++round) {
    nlohmann::json board;
    for (int i = 0; i < 20'000; ++i) {
      board[std::to_string(round) + "/" + std::to_string(i)] = true;
    }
    ASSERT_EQ(history_.AddBoards(Pack({{"Main", board}}), Time(2s)).problem(), "");
  }
  EXPECT_THAT(watcher_.watched().values, SizeIs(Groot2History::kMostKeys));
  const std::string name(1 << 20, 'n');
  for (char board = 'a'; board <= 'z'; ++board) {
    const std::string long_name = name + board;
    ASSERT_EQ(history_.AddBoards(Pack({{long_name, {{"k", 1}}}}), Time(3s)).problem(), "");
  }
  EXPECT_THAT(watcher_.watched().values, SizeIs(Groot2History::kMostKeys));
}

TEST_F(Groot2HistoryTest, KeepsNoMoreValuesThanAnAnswerCanHold) {
  Begin();
  const std::string large(10 << 20, 'x');
  ASSERT_EQ(history_.AddBoards(Pack({{"Main", {{"a", large}}}}), Time(2s)).problem(), "");
  ASSERT_EQ(history_.AddBoards(Pack({{"Main", {{"b", large}, {"c", 1}}}}), Time(2s)).problem(), "");
  Watched watched = watcher_.watched();
  ASSERT_THAT(watched.values, SizeIs(3));
  EXPECT_GT(watched.values[0].size(), large.size());
  EXPECT_THAT(watched.values[1], IsEmpty()) << "there is no room for it";
  EXPECT_EQ(PrintValueBytes(watched.values[2]), "1");
  ASSERT_EQ(history_.AddBoards(Pack({{"Main", {{"a", 1}}}}), Time(3s)).problem(), "");
  ASSERT_EQ(history_.AddBoards(Pack({{"Main", {{"b", large}}}}), Time(3s)).problem(), "");
  EXPECT_GT(watcher_.watched().values[1].size(), large.size());
}

TEST_F(Groot2HistoryTest, RefusesWhatCannotBeRead) {
  EXPECT_THAT(history_.SetTree(RunId{1}, "<root>").problem(), HasSubstr("cannot be read"));
  Begin();
  EXPECT_NE(history_.SetRecording("soon").problem(), "");
  EXPECT_NE(history_.SetRecording("-5").problem(), "");
  EXPECT_NE(history_.SetRecording("99999999999999999999").problem(), "");
  EXPECT_NE(history_.AddTransitions("12345678").problem(), "");
  EXPECT_NE(history_.AddTransitions(Transition(0, 99, kRunning)).problem(), "");
  EXPECT_NE(history_.AddStatuses("1234", Time(1s)).problem(), "");
  EXPECT_NE(history_.AddStatuses(Statuses(1, 200, 1), Time(1s)).problem(), "");
  EXPECT_NE(history_.AddBoards("\xc1", Time(1s)).problem(), "");
}

TEST_F(Groot2HistoryTest, IsNotDisturbedByRandomAnswers) {
  Begin();
  std::mt19937 random(3);
  for (int i = 0; i < 5000; ++i) {
    std::string bytes(random() % 40 * (random() % 2 ? 9 : 3), '\0');
    for (char& c : bytes) c = static_cast<char>(random());
    static_cast<void>(history_.AddTransitions(bytes));
    static_cast<void>(history_.AddStatuses(bytes, Time(1s)));
    static_cast<void>(history_.AddBoards(bytes, Time(1s)));
    static_cast<void>(history_.SetRecording(bytes));
  }
  EXPECT_EQ(history_.AddStatuses(Statuses(1, 1, 1), Time(1s)).problem(), "");
}

}  // namespace
}  // namespace coppice
