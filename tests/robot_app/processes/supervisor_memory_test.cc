#include "robot_app/processes/supervisor_memory.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>

#include "tests/robot_app/processes/temporary.h"

namespace coppice::robot::processes {
namespace {

using std::chrono::seconds;
using testing::ElementsAre;
using testing::HasSubstr;

SupervisorMemory Example() {
  SupervisorMemory memory;
  memory.configuration = "charging";
  memory.manual = true;
  memory.new_stack = true;
  memory.clear_stack = true;
  GroupMemory group;
  group.restarts = {seconds(100), seconds(200)};
  group.counting = 1;
  group.step = EscalationStep::kClosure;
  group.closures = 1;
  group.trouble_since = seconds(150);
  memory.groups["ekf"] = group;
  memory.groups["other"].given_up = "broken";
  memory.restarts["ekf"] = 7;
  memory.stack_restarts = {seconds(300)};
  memory.stack_counting = 1;
  return memory;
}

TEST(SupervisorMemoryTest, ReadsBackWhatItHasWritten) {
  const std::string path = Temporary("memory.json");
  EXPECT_EQ(SaveMemory(Example(), path), "");
  std::string problem;
  const SupervisorMemory memory = LoadMemory(path, seconds(1000), problem);
  EXPECT_EQ(problem, "");
  EXPECT_EQ(ToText(memory), ToText(Example()));
  EXPECT_EQ(memory.groups.at("ekf").step, EscalationStep::kClosure);
  EXPECT_EQ(memory.groups.at("ekf").trouble_since, seconds(150));
  EXPECT_EQ(memory.restarts.at("ekf"), 7u);
}

TEST(SupervisorMemoryTest, AMissingFileIsEmptyAndNoProblem) {
  std::string problem;
  EXPECT_EQ(LoadMemory(Temporary("nothing.json"), seconds(1), problem).configuration, "");
  EXPECT_EQ(problem, "");
}

TEST(SupervisorMemoryTest, EveryTornFileIsEmptyAndAProblem) {
  const std::string text = ToText(Example());
  for (std::size_t size = 0; size + 2 < text.size(); ++size) {
    std::string problem;
    const SupervisorMemory memory = MemoryFromText(text.substr(0, size), seconds(1000), problem);
    EXPECT_EQ(problem, "is damaged") << size;
    EXPECT_TRUE(memory.groups.empty());
  }
}

TEST(SupervisorMemoryTest, ValuesOfWrongKindsAndOtherVersionsAreRefused) {
  std::string problem;
  MemoryFromText("[]", seconds(1), problem);
  EXPECT_EQ(problem, "is damaged");
  MemoryFromText(R"({"version": 1, "configuration": 3})", seconds(1), problem);
  EXPECT_EQ(problem, "is damaged");
  MemoryFromText(R"({"version": 2})", seconds(1), problem);
  EXPECT_EQ(problem, "is of another version");
}

TEST(SupervisorMemoryTest, TimesInTheFutureCountAsNow) {
  std::string problem;
  const SupervisorMemory memory = MemoryFromText(ToText(Example()), seconds(120), problem);
  EXPECT_THAT(memory.groups.at("ekf").restarts, ElementsAre(seconds(100), seconds(120)));
}

TEST(SupervisorMemoryTest, AFileThatCannotBeWrittenIsReportedAndTheOldOneStays) {
  EXPECT_THAT(SaveMemory(Example(), "/proc/nowhere/memory.json"), HasSubstr("cannot write"));
  const std::string path = Temporary("kept.json");
  EXPECT_EQ(SaveMemory(Example(), path), "");
  mkdir((path + ".new").c_str(), 0755);
  EXPECT_THAT(SaveMemory({}, path), HasSubstr("Is a directory"));
  std::string problem;
  EXPECT_EQ(LoadMemory(path, seconds(1000), problem).configuration, "charging");
}

}  // namespace
}  // namespace coppice::robot::processes
