#include "robot_app/storage/spool/intake.h"

#include <gtest/gtest.h>

#include "tests/robot_app/eventually.h"
#include "tests/support/temporary_folder.h"
#include "tests/system/small_disk.h"

namespace coppice::robot::storage {
namespace {

Document Make(std::size_t size, int priority = 5) {
  Document document;
  document.priority = priority;
  document.received = 1;
  document.topic = "/t" + std::to_string(priority);
  static const auto type =
      std::make_shared<const MessageType>(MessageType{"a/B", "md5", "int32 x"});
  document.type = type;
  document.json = "\"" + std::string(size, 'x') + "\"";
  return document;
}

TEST(Intake, BringsDocumentsIntoTheSpoolAndTells) {
  const TemporaryFolder folder;
  const auto spool = std::move(Spool::Open(folder.Path("spool.db"), {})).value();
  std::atomic<int> told{0};
  Intake intake(*spool, {}, [&] { ++told; });
  intake.Put(Make(10));
  EXPECT_TRUE(Eventually([&] { return told > 0; }));
  EXPECT_EQ(spool->Look().documents, 1);
  EXPECT_EQ(intake.Look().stored, 1u);
}

TEST(Intake, StoresWhatIsThereWhenItEnds) {
  const TemporaryFolder folder;
  const auto spool = std::move(Spool::Open(folder.Path("spool.db"), {})).value();
  {
    Intake intake(*spool, {1 << 20, std::chrono::hours(1)}, [] {});
    for (int i = 0; i < 100; ++i) intake.Put(Make(10));
  }
  EXPECT_EQ(spool->Look().documents, 100);
}

TEST(Intake, KeepsFewReasonsAndNoneThatADatabaseDoesNotTake) {
  const TemporaryFolder folder;
  const auto spool = std::move(Spool::Open(folder.Path("spool.db"), {})).value();
  {
    Intake intake(*spool, {1 << 20, std::chrono::hours(1)}, [] {});
    for (int i = 0; i < 100; ++i) {
      intake.Lose("/t", "\xff'" + std::to_string(i) + std::string("\0\n", 2), 1);
    }
    intake.Lose("/t", "\xff'" + std::to_string(0), 1);
  }
  const Batch batch = spool->Next({});
  ASSERT_EQ(batch.losses.size(), 21u);
  std::int64_t count = 0;
  for (const Loss& loss : batch.losses) {
    count += loss.count;
    EXPECT_TRUE(loss.reason == "other reasons" || loss.reason[0] == '\'') << loss.reason;
  }
  EXPECT_EQ(count, 101);
}

TEST(Intake, CountsWhatDoesNotFitIntoMemory) {
  const TemporaryFolder folder;
  const auto spool = std::move(Spool::Open(folder.Path("spool.db"), {})).value();
  {
    Intake intake(*spool, {1000, std::chrono::hours(1)}, [] {});
    for (int i = 0; i < 30; ++i) intake.Put(Make(98, i % 3 == 0 ? 9 : 2));
    EXPECT_EQ(intake.Look().documents, 10u);
    EXPECT_EQ(intake.Look().lost, 20u);
  }
  const Batch batch = spool->Next({});
  for (const Document& document : batch.documents) EXPECT_EQ(document.priority, 9);
  ASSERT_EQ(batch.losses.size(), 1u);
  EXPECT_EQ(batch.losses[0].topic, "/t2");
  EXPECT_EQ(batch.losses[0].count, 20);
}

TEST(Intake, HoldsDocumentsWhileTheDiskIsFull) {
  const SmallDisk disk;
  const std::string path = disk.path() / "spool.db";
  auto spool = std::move(Spool::Open(path, {})).value();
  {
    Intake intake(*spool, {8 << 20, std::chrono::milliseconds(5)}, [] {});
    disk.Fill();
    for (int i = 0; i < 300; ++i) intake.Put(Make(10'000));
    ASSERT_TRUE(Eventually([&] { return !intake.Look().problem.empty(); }));
    disk.Free();
    ASSERT_TRUE(Eventually([&] { return intake.Look().stored == 300; }));
    EXPECT_EQ(intake.Look().problem, "");
    EXPECT_EQ(intake.Look().lost, 0u);
  }
  EXPECT_EQ(spool->Look().documents, 300);
  spool.reset();
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace coppice::robot::storage
