#include "robot_app/app/note_limit.h"

#include <gtest/gtest.h>

namespace coppice::robot {
namespace {

TEST(NoteLimit, TakesSoManyInASecond) {
  NoteLimit limit;
  int taken = 0;
  for (int i = 0; i < 1000; ++i) taken += limit.Pass("fault", 100 + i * 1e-6) ? 1 : 0;
  EXPECT_EQ(taken, NoteLimit::kMostPerSecond);
  EXPECT_EQ(limit.Pass("fault", 102), "fault");
}

TEST(NoteLimit, CutsALongNote) {
  NoteLimit limit;
  EXPECT_EQ(limit.Pass(std::string(8'000'000, 'x'), 1)->size(), NoteLimit::kLongest);
}

}  // namespace
}  // namespace coppice::robot
