// What a recorder has called safe survives kill -9 at any moment. Every repetition
// (--gtest_repeat=10) takes other moments.
#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "tests/bt_core/record/victim.h"
#include "tests/bt_core/record/whole_record.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace coppice {
namespace {

// The newest tick that bt_core_record_victim has called safe; 0 if none.
std::uint64_t SafeTick(const std::string& said) {
  std::uint64_t tick = 0;
  const std::size_t reports = said.size() / sizeof(tick);
  if (reports > 0) std::memcpy(&tick, said.data() + (reports - 1) * sizeof(tick), sizeof(tick));
  return tick;
}

void ExpectWholeUpTo(std::uint64_t safe, const WholeRecord& record) {
  EXPECT_TRUE(record.gaps.empty());
  EXPECT_TRUE(record.damages.empty());  // the end may be torn
  EXPECT_FALSE(record.closed);
  ASSERT_GE(record.numbers.size(), safe);
  for (std::size_t i = 0; i < record.numbers.size(); ++i) ASSERT_EQ(record.numbers[i], i + 1);
}

TEST(Recorder, LosesNothingThatItCalledSafeWhenItIsKilled) {
  static std::mt19937 random(9);
  for (int round = 0; round < 20; ++round) {
    const TemporaryFolder folder;
    const std::string path = folder.Path("run.coppice");
    Victim victim({BinaryFolder() + "/tests/bin/bt_core_record_victim", path}, STDOUT_FILENO);
    const bool is_young = round % 4 == 0;  // it is killed while it begins
    if (!is_young) {
      ASSERT_TRUE(victim.Listen(Victim::Clock::now() + std::chrono::seconds(30)));
    }
    const auto end =
        Victim::Clock::now() + std::chrono::microseconds(random() % (is_young ? 60000 : 15000));
    while (Victim::Clock::now() < end) victim.Listen(end);
    victim.Kill();

    const std::uint64_t safe = SafeTick(victim.said());
    Diagnostics diagnostics;
    const auto reader = RecordReader::Open(path, diagnostics);
    ASSERT_TRUE(reader || safe == 0) << diagnostics.ToString();
    if (reader) ExpectWholeUpTo(safe, ReadAll(*reader));
  }
}

}  // namespace
}  // namespace coppice
