#include "robot_app/storage/topics/topic_reader.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

#include "tests/robot_app/eventually.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::storage {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr std::int64_t kStart = 1764059400 * kSecond;

class TopicReaderTest : public testing::Test {
 protected:
  void Read(const TopicConfig& config, const std::vector<std::int64_t>& times,
            const std::string& definition = "char[] x",
            const std::string& bytes = std::string("\x01\0\0\0a", 5)) {
    Intake intake(*spool_, {}, [] {});
    TopicReader reader(config, intake, files_);
    for (const std::int64_t time : times) {
      const std::string type = "a/B", md5 = "m" + std::to_string(definition.size());
      reader.OnMessage({type, md5, definition, bytes, time, 7});
    }
  }

  const TemporaryFolder folder_;
  const std::unique_ptr<Spool> spool_ =
      std::move(Spool::Open(folder_.Path("spool.db"), {})).value();
  FileStore files_{folder_.Path("files"), 1000};
};

TEST_F(TopicReaderTest, MakesDocuments) {
  Read({"/a", 8}, {kStart});
  const Batch batch = spool_->Next({});
  ASSERT_EQ(batch.documents.size(), 1u);
  EXPECT_EQ(batch.documents[0].topic, "/a");
  EXPECT_EQ(batch.documents[0].priority, 8);
  EXPECT_EQ(batch.documents[0].received, kStart);
  EXPECT_EQ(batch.documents[0].stamp, 7);
  EXPECT_EQ(batch.documents[0].json, R"({"x":"YQ=="})");
  EXPECT_EQ(batch.documents[0].type->name, "a/B");
}

TEST_F(TopicReaderTest, TakesNoMoreThanItsRate) {
  std::vector<std::int64_t> times;
  for (int i = 0; i < 100; ++i) times.push_back(kStart + i * kSecond / 10);
  Read({"/a", 5, 2}, times);  // 10 a second, of which 2 are taken
  EXPECT_EQ(spool_->Look().documents, 20);
}

TEST_F(TopicReaderTest, MakesSomeFilesOfAMessageHoweverManyArraysItHas) {
  std::string fields = "std_msgs/E[9999] none\n", arrays;
  for (int i = 0; i < 100; ++i) {
    fields += "uint8[] x" + std::to_string(i) + "\n";
    arrays += std::string("\x03\0\0\0abc", 7);
  }
  Read({"/a", 5, 0, 2, true}, {kStart}, fields + "===\nMSG: std_msgs/E\n", arrays);
  EXPECT_EQ(spool_->Look().documents, 1);
  const std::filesystem::recursive_directory_iterator entries(folder_.Path("files"));
  EXPECT_EQ(std::count_if(begin(entries), end(entries),
                          [](const auto& entry) { return entry.is_regular_file(); }),
            16);
}

TEST_F(TopicReaderTest, TakesNoTypeWhoseNameNoDatabaseTakes) {
  Intake intake(*spool_, {}, [] {});
  TopicReader reader({"/a"}, intake, files_);
  const std::string type = "a/" + std::string(3000, 'B'), md5 = "m", definition = "int8 x";
  reader.OnMessage({type, md5, definition, "\x01", kStart, 7});
  EXPECT_EQ(intake.Look().lost, 1u);
}

TEST_F(TopicReaderTest, GoesOnWhenTheClockIsSetBack) {
  Read({"/a", 5, 1}, {kStart, kStart - 3600 * kSecond, kStart - 3598 * kSecond});
  EXPECT_EQ(spool_->Look().documents, 3);
}

TEST_F(TopicReaderTest, CountsWhatItDoesNotUnderstand) {
  Read({"/a"}, {kStart}, "nonsense");
  Read({"/a"}, {kStart}, "int32 x");
  const Batch batch = spool_->Next({});
  EXPECT_TRUE(batch.documents.empty());
  std::vector<std::string> reasons;
  for (const Loss& loss : batch.losses) reasons.push_back(loss.reason);
  EXPECT_THAT(reasons, testing::UnorderedElementsAre("a message of a/B has 1 bytes too many",
                                                     "a/B: line 1: expected a type and a name"));
}

TEST_F(TopicReaderTest, KeepsRemarksOfAnyEncodingOutOfTheDatabase) {
  Read({"/a"}, {kStart}, "char[] x # 5 \xb5m");
  const Batch batch = spool_->Next({});
  ASSERT_EQ(batch.documents.size(), 1u);
  EXPECT_EQ(batch.documents[0].type->definition, "char[] x # 5 ?m");
}

TEST_F(TopicReaderTest, HasNoMoreTypesThanATopicHasAndNoOddOnes) {
  Intake intake(*spool_, {}, [] {});
  TopicReader reader({"/a"}, intake, files_);
  const std::string definition = "int8 x", bytes = "a", bad = "\xff'\"";
  for (int i = 0; i < kMostTypes + 2; ++i) {
    const std::string type = "a/B", md5 = "m" + std::to_string(i);
    reader.OnMessage({type, bad, definition, bytes, kStart, 7});
    reader.OnMessage({bad, md5, definition, bytes, kStart, 7});
    reader.OnMessage({type, md5, definition, bytes, kStart, 7});
  }
  EXPECT_TRUE(Eventually([&] { return intake.Look().stored == kMostTypes; }));
  EXPECT_EQ(intake.Look().lost, 2u + 2 * (kMostTypes + 2));
}

TEST_F(TopicReaderTest, KeepsWhatIsTooLongInAFile) {
  TopicConfig config{"/a"};
  config.longest_array = 0;
  config.keeps_files = true;
  Read(config, {kStart});
  EXPECT_EQ(spool_->Next({}).documents.at(0).json,
            R"({"x":{"left_out":"uint8","length":1,"file":"2025-11-25/083000.000000-1.bin"}})");
  EXPECT_EQ(ReadFile(folder_.Path("files/2025-11-25/083000.000000-1.bin")), "a");
}

}  // namespace
}  // namespace coppice::robot::storage
