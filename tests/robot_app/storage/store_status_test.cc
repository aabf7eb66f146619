#include "robot_app/storage/store_status.h"

#include <gtest/gtest.h>

namespace coppice::robot::storage {
namespace {

using Level = StatusLine::Level;

const WallTime kNow{std::chrono::seconds(1000)};

StoreState Well() {
  StoreState state;
  state.backlog.documents = 3;
  state.backlog.oldest = Duration(std::chrono::seconds(990)).count();
  return state;
}

StatusLine Spool(StoreStatus& status, const StoreState& state, WallTime now = kNow) {
  return status.Judge(state, now)[0];
}

TEST(StoreStatus, IsOkWhileMessagesFlow) {
  StoreStatus status;
  const auto lines = status.Judge(Well(), kNow);
  EXPECT_EQ(lines[0].level, Level::kOk);
  EXPECT_EQ(lines[1].level, Level::kOk);
  EXPECT_EQ(lines[1].message, "3 messages wait, the oldest for 10.0 s");
}

TEST(StoreStatus, WarnsWhileTheServerIsAway) {
  StoreStatus status;
  StoreState state = Well();
  state.shipper.problem = "no route";
  const auto lines = status.Judge(state, kNow);
  EXPECT_EQ(lines[0].level, Level::kOk);
  EXPECT_EQ(lines[1].level, Level::kWarn);
  EXPECT_EQ(lines[1].message, "3 messages wait, the oldest for 10.0 s: no route");
}

TEST(StoreStatus, IsAnErrorWhileTheSpoolCannotBeWritten) {
  StoreStatus status;
  StoreState state = Well();
  state.intake.problem = "disk full";
  EXPECT_EQ(Spool(status, state).level, Level::kError);
  EXPECT_EQ(Spool(status, state).message, "the spool cannot be written: disk full");
}

TEST(StoreStatus, IsAnErrorForAWhileWhenMessagesWereLost) {
  StoreStatus status;
  StoreState state = Well();
  state.backlog.lost = 5;  // long ago
  EXPECT_EQ(Spool(status, state).level, Level::kOk);
  state.backlog.lost = 6;
  EXPECT_EQ(Spool(status, state).level, Level::kError);
  EXPECT_EQ(Spool(status, state, kNow + std::chrono::seconds(59)).level, Level::kError);
  EXPECT_EQ(Spool(status, state, kNow + std::chrono::seconds(61)).level, Level::kOk);
}

TEST(StoreStatus, WarnsOfRefusedMessages) {
  StoreStatus status;
  StoreState state = Well();
  state.backlog.refused = 2;
  EXPECT_EQ(status.Judge(state, kNow)[1].message, "the server has refused 2 messages");
}

}  // namespace
}  // namespace coppice::robot::storage
