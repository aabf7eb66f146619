#include "bt_core/live/groot2/transitions.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

using std::chrono::microseconds;

// Two nodes: a Sequence and its child.
StatusFollower Idle() {
  return StatusFollower({{NodeIndex{0}, NodeIndex{2}, true}, {NodeIndex{0}, NodeIndex{2}, false}},
                        {Status::kIdle, Status::kIdle});
}

void AddTick(Transitions& transitions, Time start, Status child, Status root) {
  EventWriter writer;
  writer.Status(NodeIndex{1}, child);
  writer.Status(kRootNode, root);
  transitions.Add({1, start, Duration(0), root, true, writer.words()});
}

std::string Bytes(std::initializer_list<int> bytes) {
  std::string result;
  for (const int byte : bytes) result += static_cast<char>(byte);
  return result;
}

TEST(Transitions, PacksEachChangeInNineBytes) {
  Transitions transitions;
  transitions.Start(Idle(), Time(microseconds(1000)));
  AddTick(transitions, Time(microseconds(1000 + 0x010203)), Status::kRunning, Status::kRunning);
  EXPECT_EQ(transitions.Take(), Bytes({3, 2, 1, 0, 0, 0, 2, 0, 1, 3, 2, 1, 0, 0, 0, 1, 0, 1}));
  EXPECT_EQ(transitions.Take(), "");
}

TEST(Transitions, TellsOfResetsThatFollowFromResults) {
  Transitions transitions;
  transitions.Start(Idle(), Time{});
  AddTick(transitions, Time{}, Status::kSuccess, Status::kSuccess);
  const std::string bytes = transitions.Take();
  ASSERT_EQ(bytes.size(), 27u);  // child SUCCESS, child IDLE, root SUCCESS
  EXPECT_EQ(bytes.substr(15, 3), Bytes({2, 0, 0}));
}

TEST(Transitions, RecordsOnlyBetweenStartAndStop) {
  Transitions transitions;
  AddTick(transitions, Time{}, Status::kRunning, Status::kRunning);
  EXPECT_EQ(transitions.Take(), "");
  transitions.Start(Idle(), Time{});
  AddTick(transitions, Time{}, Status::kRunning, Status::kRunning);
  transitions.Stop();
  AddTick(transitions, Time{}, Status::kSuccess, Status::kSuccess);
  EXPECT_EQ(transitions.Take().size(), 18u);
}

TEST(Transitions, CountsWhatIsNotFetchedInTime) {
  Transitions transitions(3);
  transitions.Start(Idle(), Time{});
  AddTick(transitions, Time{}, Status::kRunning, Status::kRunning);
  AddTick(transitions, Time{}, Status::kSuccess, Status::kSuccess);
  EXPECT_EQ(transitions.dropped(), 2u);
  EXPECT_EQ(transitions.Take().size(), 27u);
  transitions.Start(Idle(), Time{});
  EXPECT_EQ(transitions.dropped(), 0u);
}

TEST(Transitions, GoesOnBehindAJump) {
  Transitions transitions;
  transitions.Start(Idle(), Time{});
  transitions.Jump(StatusFollower({{NodeIndex{0}, NodeIndex{1}, false}}, {Status::kRunning}));
  EventWriter writer;
  writer.Status(kRootNode, Status::kFailure);
  transitions.Add({1, Time{}, Duration(0), Status::kFailure, true, writer.words()});
  EXPECT_EQ(transitions.Take(), Bytes({0, 0, 0, 0, 0, 0, 1, 0, 3}));
}

}  // namespace
}  // namespace coppice
