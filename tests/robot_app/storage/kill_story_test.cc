#include "tests/robot_app/storage/kill_story.h"

#include <gtest/gtest.h>

namespace coppice::robot::storage {
namespace {

// coppice_store_bench kills more often.
TEST(KillStory, EndsWithEveryMessageOnTheServerOnce) {
  LocalPostgres postgres;
  const KillStory story = TellKillStory(postgres, 8, 2, 1);
  EXPECT_GT(story.accepted, 0);
  EXPECT_EQ(story.lost, 0);
  EXPECT_EQ(story.twice, 0);
}

}  // namespace
}  // namespace coppice::robot::storage
