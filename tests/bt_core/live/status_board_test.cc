#include "bt_core/live/status_board.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

namespace coppice {
namespace {

using ::testing::ElementsAre;

std::vector<std::uint8_t> Read(const StatusBoard& board) {
  std::vector<std::uint8_t> bytes;
  board.Read(bytes);
  return bytes;
}

TEST(StatusBoard, StartsWithTheStatusesOfTheTree) {
  EXPECT_THAT(Read(StatusBoard({Status::kIdle, Status::kRunning})), ElementsAre(0, 1));
}

TEST(StatusBoard, RemembersWhatANodeDidBeforeItWasReset) {
  StatusBoard board(std::vector<Status>(4, Status::kIdle));
  board.Apply({{0, Status::kIdle, Status::kRunning},
               {1, Status::kIdle, Status::kSuccess},
               {2, Status::kIdle, Status::kFailure},
               {3, Status::kIdle, Status::kSkipped}});
  EXPECT_THAT(Read(board), ElementsAre(1, 2, 3, 4));
  board.Apply({{0, Status::kRunning, Status::kIdle},
               {1, Status::kSuccess, Status::kIdle},
               {2, Status::kFailure, Status::kIdle},
               {3, Status::kSkipped, Status::kIdle}});
  EXPECT_THAT(Read(board), ElementsAre(11, 12, 13, 14));
}

TEST(StatusBoard, ShowsOneTickAtATime) {
  constexpr NodeIndex kNodes = 64;
  StatusBoard board(std::vector<Status>(kNodes, Status::kSuccess));
  std::vector<StatusChange> to_failure;
  std::vector<StatusChange> to_success;
  for (NodeIndex i = 0; i < kNodes; ++i) {
    to_failure.push_back({i, Status::kSuccess, Status::kFailure});
    to_success.push_back({i, Status::kFailure, Status::kSuccess});
  }
  std::thread writer([&] {
    for (int i = 0; i < 2000; ++i) {
      board.Apply(to_failure);
      board.Apply(to_success);
      std::this_thread::yield();
    }
  });
  for (int i = 0; i < 2000; ++i) {
    const std::vector<std::uint8_t> bytes = Read(board);
    EXPECT_THAT(bytes, ::testing::Each(bytes[0]));
  }
  writer.join();
}

}  // namespace
}  // namespace coppice
