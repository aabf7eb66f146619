#include "robot_app/knowledge/store/write_campus.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <thread>

#include "tests/robot_app/knowledge/sample_database.h"

namespace coppice::robot::knowledge {
namespace {

// A campus of so many places, all of which are called by the same generation.
Campus CampusOf(const std::string& generation, int places) {
  Campus campus;
  campus.site = {"Europe/Berlin", "place_0", {}};
  campus.buildings.push_back({"here", {"here", "hier"}});
  for (int i = 0; i < places; ++i) {
    const std::string id = "place_" + std::to_string(i);
    campus.places.push_back({id, {"here", 0, std::nullopt}, "", {}});
    campus.names.push_back({Kind::kPlace, id, Language::kEnglish, generation + id, true});
  }
  return campus;
}

// The generation that all names of the database are of; "mixed" if they are of several.
std::string GenerationOf(const Database& database, int places) {
  const Snapshot snapshot(database);
  const std::vector<Name> names = Names(database);
  if (static_cast<int>(names.size()) != places) return std::to_string(names.size()) + " names";
  const std::string generation = names[0].text.substr(0, 1);
  for (const Name& name : names) {
    if (name.text.substr(0, 1) != generation) return "mixed";
  }
  return generation;
}

class WriteCampusTest : public testing::Test {
 protected:
  std::string path() const { return folder_.Path("campus.db"); }
  TemporaryFolder folder_;
};

TEST_F(WriteCampusTest, AReaderSeesAllOfOneImportOrAllOfTheNext) {
  constexpr int kPlaces = 300;
  Database writer = Database::OpenOrCreate(path()).value();
  ASSERT_TRUE(WriteCampus(writer, CampusOf("a", kPlaces)));
  std::atomic<bool> is_done = false;
  std::string wrong;
  int reads = 0;
  std::thread reader([&] {
    const Database database = Database::Open(path()).value();
    while (!is_done || reads == 0) {
      const std::string generation = GenerationOf(database, kPlaces);
      if (generation != "a" && generation != "b") wrong = generation;
      ++reads;
    }
  });
  for (int i = 0; i < 20; ++i) {
    EXPECT_TRUE(WriteCampus(writer, CampusOf(i % 2 == 0 ? "b" : "a", kPlaces)));
  }
  is_done = true;
  reader.join();
  EXPECT_EQ(wrong, "");
}

TEST_F(WriteCampusTest, AnImportThatIsKilledHasNotBeen) {
  constexpr int kPlaces = 200;
  Database database = Database::OpenOrCreate(path()).value();
  ASSERT_TRUE(WriteCampus(database, CampusOf("a", kPlaces)));
  for (int round = 0; round < 10; ++round) {
    int ready[2];
    ASSERT_EQ(pipe(ready), 0);
    const pid_t child = fork();
    if (child == 0) {
      Database writer = Database::Open(path()).value();
      while (true) {
        if (write(ready[1], "x", 1) != 1) _exit(1);
        (void)WriteCampus(writer, CampusOf("b", kPlaces)).ok();
        (void)WriteCampus(writer, CampusOf("a", kPlaces)).ok();
      }
    }
    // Somewhere within a write: each round a little later.
    char byte = 0;
    for (int i = 0; i <= round; ++i) ASSERT_EQ(read(ready[0], &byte, 1), 1);
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    close(ready[0]);
    close(ready[1]);
    const Database reader = Database::Open(path()).value();
    const std::string generation = GenerationOf(reader, kPlaces);
    EXPECT_TRUE(generation == "a" || generation == "b") << generation;
  }
  EXPECT_TRUE(WriteCampus(database, CampusOf("c", kPlaces)));
  EXPECT_EQ(GenerationOf(database, kPlaces), "c");
}

TEST_F(WriteCampusTest, ARecordThatRefersToNothingLeavesTheOldKnowledge) {
  Database database = Database::OpenOrCreate(path()).value();
  ASSERT_TRUE(WriteCampus(database, CampusOf("a", 3)));
  Campus broken = CampusOf("b", 3);
  broken.people.push_back({"ada", "nowhere", "", ""});
  EXPECT_FALSE(WriteCampus(database, broken).ok());
  EXPECT_EQ(GenerationOf(database, 3), "a");
}

TEST_F(WriteCampusTest, OthersSeeThatSomethingHasChanged) {
  Database writer = Database::OpenOrCreate(path()).value();
  const Database reader = Database::Open(path()).value();
  const std::int64_t before = reader.version();
  EXPECT_EQ(reader.version(), before);
  ASSERT_TRUE(WriteCampus(writer, CampusOf("a", 3)));
  EXPECT_NE(reader.version(), before);
}

// Neither log nor journal can be made, as on a disk that is full or cannot be written.
TEST_F(WriteCampusTest, WhereTheDiskTakesNothingWhatIsKnownIsCopied) {
  {
    Database database = Database::OpenOrCreate(path()).value();
    ASSERT_TRUE(WriteCampus(database, CampusOf("a", 3)));
    EXPECT_FALSE(Database::OpenOrCopy(path())->is_copy());
  }
  std::filesystem::create_directories(path() + "-shm");
  const auto copy = Database::OpenOrCopy(path());
  ASSERT_TRUE(copy) << copy.problem();
  EXPECT_TRUE(copy->is_copy());
  EXPECT_EQ(GenerationOf(*copy, 3), "a");
  EXPECT_FALSE(Database::Open(path())) << "an import would be lost";
}

TEST_F(WriteCampusTest, AFileOfOthersIsLeftAlone) {
  coppice::WriteFile(path(), "this is no database, but a letter of some length to somebody");
  EXPECT_NE(Database::OpenOrCreate(path()).problem().find("not a database"), std::string::npos);
  EXPECT_EQ(coppice::ReadFile(path()).substr(0, 7), "this is");
  EXPECT_FALSE(Database::Open(folder_.Path("missing.db")).ok());
}

}  // namespace
}  // namespace coppice::robot::knowledge
