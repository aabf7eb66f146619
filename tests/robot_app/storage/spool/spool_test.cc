#include "robot_app/storage/spool/spool.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "tests/support/temporary_folder.h"

namespace coppice::robot::storage {
namespace {

using testing::ElementsAre;

class SpoolTest : public testing::Test {
 protected:
  std::unique_ptr<Spool> Open(const SpoolLimits& limits = {}) {
    auto spool = Spool::Open(folder_.Path("spool.db"), limits);
    EXPECT_TRUE(spool) << spool.problem();
    return std::move(spool).value();
  }

  Document Make(const std::string& json, int priority = 5) {
    Document document;
    document.priority = priority;
    document.received = ++now_;
    document.topic = "/t" + std::to_string(priority);
    document.type = type_;
    document.json = json;
    return document;
  }

  static std::vector<std::string> Jsons(const Spool& spool) {
    std::vector<std::string> jsons;
    for (const Document& document : spool.Next({}).documents) jsons.push_back(document.json);
    return jsons;
  }

  std::int64_t now_ = 0;
  const std::shared_ptr<const MessageType> type_ =
      std::make_shared<const MessageType>(MessageType{"a/B", "md5", "int32 x"});
  const TemporaryFolder folder_;
};

TEST_F(SpoolTest, GivesTheMostImportantFirstThenTheOldest) {
  const auto spool = Open();
  spool->Add({Make("1", 5), Make("2", 9)});
  spool->Add({Make("3", 9), Make("4", 0)});
  EXPECT_THAT(Jsons(*spool), ElementsAre("2", "3", "1", "4"));
}

TEST_F(SpoolTest, GivesNoMoreThanFitsIntoABatchButAlwaysOne) {
  const auto spool = Open();
  spool->Add({Make("1"), Make("22"), Make("333")});
  EXPECT_EQ(spool->Next({2, 100}).documents.size(), 2u);
  EXPECT_EQ(spool->Next({10, 3}).documents.size(), 2u);
  EXPECT_EQ(spool->Next({10, 0}).documents.size(), 1u);
}

TEST_F(SpoolTest, TellsTheTypeOfADocument) {
  const auto spool = Open();
  spool->Add({Make("1")});
  const Batch batch = spool->Next({});
  EXPECT_EQ(batch.documents[0].type->name, "a/B");
  EXPECT_EQ(batch.documents[0].type->definition, "int32 x");
}

TEST_F(SpoolTest, HoldsWhatItGotAfterARestart) {
  auto spool = Open();
  spool->Add({Make("1")});
  const std::string name = spool->name();
  spool.reset();
  spool = Open();
  EXPECT_THAT(Jsons(*spool), ElementsAre("1"));
  EXPECT_EQ(spool->name(), name);
  EXPECT_EQ(spool->Look().documents, 1);
}

TEST_F(SpoolTest, NeverGivesANumberAgain) {
  auto spool = Open();
  spool->Add({Make("1")});
  const std::int64_t number = spool->Next({}).documents[0].number;
  spool->Remove(spool->Next({}));
  spool.reset();
  spool = Open();
  spool->Add({Make("2")});
  EXPECT_GT(spool->Next({}).documents[0].number, number);
}

TEST_F(SpoolTest, ForgetsWhatWasSent) {
  const auto spool = Open();
  spool->Add({Make("1"), Make("2")});
  spool->Remove(spool->Next({1, 100}));
  EXPECT_THAT(Jsons(*spool), ElementsAre("2"));
  EXPECT_EQ(spool->Look().documents, 1);
}

TEST_F(SpoolTest, PutsWhatTheServerRefusesAside) {
  const auto spool = Open();
  spool->Add({Make("1"), Make("2")});
  spool->SetAside(spool->Next({1, 100}), "no");
  EXPECT_THAT(Jsons(*spool), ElementsAre("2"));
  EXPECT_EQ(spool->Look().refused, 1);
  EXPECT_EQ(spool->Look().lost, 0);
}

TEST_F(SpoolTest, GivesTheLeastImportantAndOldestUpWhenItIsFullAndCountsThem) {
  const auto spool = Open({300'000});
  const std::string large(1000, 'x');
  const auto add = [&](int count, int priority) {
    spool->Add(std::vector<Document>(static_cast<std::size_t>(count), Make(large, priority)));
  };
  add(100, 1);
  add(100, 9);
  EXPECT_EQ(spool->Look().lost, 0);
  add(100, 9);
  const Backlog backlog = spool->Look();
  EXPECT_LE(backlog.bytes, 300'000u);
  EXPECT_EQ(backlog.documents + backlog.lost, 300);
  const Batch batch = spool->Next({});
  ASSERT_EQ(batch.losses.size(), 1u);
  EXPECT_EQ(batch.losses[0].topic, "/t1");
  EXPECT_EQ(batch.losses[0].count, backlog.lost);
  EXPECT_GT(batch.documents.back().number, backlog.lost);  // the oldest have gone
}

// Somebody who makes messages that no server takes would fill it for ever.
TEST_F(SpoolTest, IsNotFilledByWhatTheServerRefuses) {
  const auto spool = Open({300'000});
  const std::string large(1000, 'x');
  for (int i = 0; i < 10; ++i) {
    spool->Add(std::vector<Document>(50, Make(large)));
    spool->SetAside(spool->Next({}), "no");
  }
  spool->Add({Make("1"), Make("2")});
  EXPECT_THAT(Jsons(*spool), ElementsAre("1", "2"));
  const Backlog backlog = spool->Look();
  EXPECT_EQ(backlog.refused + backlog.lost, 500);
  EXPECT_LE(backlog.bytes, 300'000u);
}

TEST_F(SpoolTest, IsNotFilledByTypesOfWhichItHoldsNothing) {
  const auto spool = Open({300'000});
  for (int i = 0; i < 500; ++i) {
    Document document = Make("1");
    document.type = std::make_shared<const MessageType>(
        MessageType{"a/B" + std::to_string(i), "md5", std::string(2'000, '#')});
    spool->Add({document});
    spool->Remove(spool->Next({}));
  }
  spool->Add({Make("1")});
  EXPECT_THAT(Jsons(*spool), ElementsAre("1"));
}

TEST_F(SpoolTest, AddsLossesUp) {
  const auto spool = Open();
  spool->Add({}, {{"/a", "too long", 2, 10, 20}});
  spool->Add({}, {{"/a", "too long", 3, 30, 40}, {"/b", "too long", 1, 5, 5}});
  const Batch batch = spool->Next({});
  ASSERT_EQ(batch.losses.size(), 2u);
  EXPECT_EQ(batch.losses[0].count, 5);
  EXPECT_EQ(batch.losses[0].first, 10);
  EXPECT_EQ(batch.losses[0].last, 40);
}

TEST_F(SpoolTest, IsOfOneProgramAtATime) {
  const auto spool = Open();
  EXPECT_NE(Spool::Open(folder_.Path("spool.db"), {}).problem().find("locked"), std::string::npos);
}

// Of a disk that fails: the head of the file is there, what is in it is not.
TEST_F(SpoolTest, PutsADamagedSpoolAsideAndBeginsAnew) {
  const std::string path = folder_.Path("spool.db");
  auto spool = Open();
  for (int i = 0; i < 200; ++i) spool->Add({Make(std::string(1000, 'x'))});
  const std::string name = spool->name();
  spool.reset();
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(4096);
  file << std::string(std::filesystem::file_size(path) - 4096, '\xa5');
  file.close();
  spool = Open();
  EXPECT_TRUE(spool->has_replaced());
  EXPECT_NE(spool->name(), name);
  EXPECT_TRUE(std::filesystem::exists(path + ".damaged"));
  spool->Add({Make("1")});
  EXPECT_THAT(Jsons(*spool), ElementsAre("1"));
  spool.reset();
  EXPECT_FALSE(Open()->has_replaced());
}

TEST_F(SpoolTest, BeginsAnewWhenItIsDamagedWhileItIsInUse) {
  const std::string path = folder_.Path("spool.db");
  const auto spool = Open();
  for (int i = 0; i < 40; ++i)
    spool->Add({Make(std::string(200'000, 'x'))});  // more than it caches
  const Batch old = spool->Next({10, 1});
  for (const char* const part : {"", "-wal"}) {
    const auto size = std::filesystem::file_size(path + part);
    std::fstream file(path + part, std::ios::in | std::ios::out | std::ios::binary);
    file << std::string(size, '\xa5');
  }
  EXPECT_THROW(spool->Next({40, 1 << 30}), std::runtime_error);
  spool->Add({Make("1")});
  EXPECT_TRUE(spool->has_replaced());
  EXPECT_EQ(spool->Look().lost, 40);
  EXPECT_EQ(spool->Next({}).losses.at(0).reason, "the spool was damaged");
  EXPECT_TRUE(std::filesystem::exists(path + ".damaged"));
  // Documents of the same numbers are others.
  spool->Remove(old);
  spool->SetAside(old, "refused");
  EXPECT_THAT(Jsons(*spool), ElementsAre("1"));
}

TEST_F(SpoolTest, BeginsAnewWhenItsFileOrFolderIsDeleted) {
  const std::string path = folder_.Path("deep/spool.db");
  std::filesystem::create_directories(folder_.Path("deep"));
  const auto spool = Spool::Open(path, {}).value();
  spool->Add({Make("1"), Make("2")});
  std::filesystem::remove_all(folder_.Path("deep"));
  spool->Add({Make("3")});
  EXPECT_TRUE(std::filesystem::exists(path));
  EXPECT_EQ(spool->Look().lost, 2);
  EXPECT_EQ(spool->Next({}).losses.at(0).reason, "the spool was deleted");
  EXPECT_EQ(Jsons(*spool), std::vector<std::string>{"3"});
}

TEST_F(SpoolTest, LeavesFilesOfOthersAlone) {
  WriteFile(folder_.Path("spool.db"), "a text that is no database, and long enough to be seen");
  EXPECT_FALSE(Spool::Open(folder_.Path("spool.db"), {}));
}

// As where the disk is full, or cannot be written.
TEST_F(SpoolTest, BeginsOnceItsFileCanBeMade) {
  WriteFile(folder_.Path("full"), "no folder");
  const auto spool = Spool::Open(folder_.Path("full/spool.db"), {}).value();
  EXPECT_THROW(spool->Add({Make("1")}), std::runtime_error);
  EXPECT_THROW(spool->Look(), std::runtime_error);
  std::filesystem::remove(folder_.Path("full"));
  spool->Add({Make("2")});
  EXPECT_EQ(Jsons(*spool), std::vector<std::string>{"2"});
  EXPECT_EQ(spool->Look().lost, 0);
}

TEST_F(SpoolTest, WhatItHeldBeforeItsDiskWasFullIsThereWhenItTakesSomethingAgain) {
  Open()->Add({Make("1")});
  const std::string beside = folder_.Path("spool.db-journal");
  std::filesystem::create_directories(beside);  // SQLite cannot keep its file there
  const auto spool = Spool::Open(folder_.Path("spool.db"), {}).value();
  EXPECT_THROW(spool->Add({Make("2")}), std::runtime_error);
  std::filesystem::remove(beside);
  spool->Add({Make("2")});
  EXPECT_THAT(Jsons(*spool), ElementsAre("1", "2"));
}

}  // namespace
}  // namespace coppice::robot::storage
