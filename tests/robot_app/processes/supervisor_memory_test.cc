#include "robot_app/processes/supervisor_memory.h"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/robot_app/processes/temporary.h"
#include "tests/robot_app/text_of.h"

namespace coppice::robot::processes {
namespace {

using std::chrono::seconds;
using testing::ElementsAre;
using testing::HasSubstr;

SupervisorMemory Example() {
  SupervisorMemory memory;
  memory.site = "hill";
  memory.configuration = "charging";
  memory.manual = true;
  memory.new_stack = true;
  memory.clear_stack = true;
  GroupMemory group;
  group.restarts = {Time(seconds(100)), Time(seconds(200))};
  group.counting = 1;
  group.step = EscalationStep::kClosure;
  group.closures = 1;
  group.trouble_since = Time(seconds(150));
  memory.groups["ekf"] = group;
  memory.groups["other"].given_up = "broken";
  memory.restarts["ekf"] = 7;
  memory.stack_restarts = {Time(seconds(300))};
  memory.stack_counting = 1;
  return memory;
}

TEST(SupervisorMemoryTest, ReadsBackWhatItHasWritten) {
  const std::string path = Temporary("memory.json");
  EXPECT_EQ(SaveMemory(Example(), path).problem(), "");
  const SupervisorMemory memory = LoadMemory(path, Time(seconds(1000))).value();
  EXPECT_EQ(ToText(memory), ToText(Example()));
  EXPECT_EQ(memory.groups.at("ekf").step, EscalationStep::kClosure);
  EXPECT_EQ(memory.groups.at("ekf").trouble_since, Time(seconds(150)));
  EXPECT_EQ(memory.restarts.at("ekf"), 7u);
}

TEST(SupervisorMemoryTest, AMissingFileIsEmptyAndNoProblem) {
  EXPECT_EQ(LoadMemory(Temporary("nothing.json"), Time(seconds(1))).value().configuration, "");
}

TEST(SupervisorMemoryTest, EveryTornFileIsAProblem) {
  const std::string text = ToText(Example());
  for (std::size_t size = 0; size + 2 < text.size(); ++size) {
    EXPECT_EQ(MemoryFromText(text.substr(0, size), Time(seconds(1000))).problem(), "is damaged")
        << size;
  }
}

TEST(SupervisorMemoryTest, ValuesOfWrongKindsAndOtherVersionsAreRefused) {
  EXPECT_EQ(MemoryFromText("[]", Time(seconds(1))).problem(), "is damaged");
  EXPECT_EQ(MemoryFromText(R"({"version": 1, "configuration": 3})", Time(seconds(1))).problem(),
            "is damaged");
  EXPECT_EQ(MemoryFromText(R"({"version": 2})", Time(seconds(1))).problem(),
            "is of another version");
}

TEST(SupervisorMemoryTest, TimesInTheFutureCountAsNow) {
  const SupervisorMemory memory = MemoryFromText(ToText(Example()), Time(seconds(120))).value();
  EXPECT_THAT(memory.groups.at("ekf").restarts,
              ElementsAre(Time(seconds(100)), Time(seconds(120))));
}

TEST(SupervisorMemoryTest, AFileThatCannotBeWrittenIsReported) {
  EXPECT_THAT(SaveMemory(Example(), "/proc/nowhere/memory.json").problem(),
              HasSubstr("cannot write"));
}

// As root, `--state /dev/null` would end it for the whole computer.
TEST(SupervisorMemoryTest, TakesThePlaceOfNoDeviceAndNoPipe) {
  const std::string pipe = Temporary("memory_pipe");
  unlink(pipe.c_str());
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT(SaveMemory(Example(), pipe).problem(), HasSubstr("a device or a pipe"));
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

TEST(SupervisorMemoryTest, WritesNothingThroughALinkThatSomebodyHasPutBesideIt) {
  const std::string path = Temporary("linked.json"), other = Temporary("of_somebody_else");
  std::ofstream(other) << "theirs";
  unlink((path + ".new").c_str());
  ASSERT_EQ(symlink(other.c_str(), (path + ".new").c_str()), 0);
  EXPECT_EQ(SaveMemory(Example(), path).problem(), "");
  EXPECT_EQ(TextOf(other), "theirs");
}

TEST(SupervisorMemoryTest, IsReadByItsOwnerAlone) {
  using std::filesystem::perms;
  const std::string path = Temporary("own.json");
  std::ofstream(path) << "{}";
  ASSERT_EQ(chmod(path.c_str(), 0644), 0);
  EXPECT_EQ(SaveMemory(Example(), path).problem(), "");
  EXPECT_EQ(std::filesystem::status(path).permissions(), perms::owner_read | perms::owner_write);
}

TEST(SupervisorMemoryTest, WhatIsNestedWithoutEndIsDamaged) {
  EXPECT_EQ(MemoryFromText(std::string(5'000'000, '['), Time(seconds(1))).problem(), "is damaged");
}

}  // namespace
}  // namespace coppice::robot::processes
