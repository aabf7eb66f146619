#include "robot_app/processes/launch/survivors.h"

#include <gmock/gmock.h>
#include <sys/wait.h>

#include <csignal>
#include <filesystem>

#include "robot_app/processes/launch/process_launcher.h"
#include "tests/robot_app/processes/temporary.h"

namespace coppice::robot::processes {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class SurvivorsTest : public testing::Test {
 protected:
  int Start(const std::string& name) {
    ProcessConfig config;
    config.name = name;
    config.command = {"/usr/bin/sleep", "1000"};
    config.log = "survivors.log";
    return launcher_.Start(config).value();
  }

  const std::string owner_ = Temporary("survivors");
  PosixLauncher launcher_{Temporary("survivors_logs"), owner_};
};

TEST_F(SurvivorsTest, AreFoundByOwnerAndByName) {
  const int one = Start("one"), two = Start("one_more");
  EXPECT_THAT(FindOwned(owner_), testing::UnorderedElementsAre(one, two));
  EXPECT_THAT(FindOwned(OwnedName(owner_, "one")), ElementsAre(one));
  EXPECT_THAT(FindOwned("/somebody/else:"), IsEmpty());
  kill(one, SIGKILL);
  kill(two, SIGKILL);
  while (waitpid(-1, nullptr, 0) > 0) {
  }
  EXPECT_THAT(FindOwned(owner_), IsEmpty());
}

TEST_F(SurvivorsTest, AreKilledEvenIfTheyAreStopped) {
  const int pid = Start("one");
  kill(pid, SIGSTOP);
  EXPECT_EQ(KillOwned(owner_, std::chrono::seconds(10)), 1);
  int status = 0;
  EXPECT_EQ(waitpid(pid, &status, 0), pid);
  EXPECT_EQ(WTERMSIG(status), SIGKILL);
  EXPECT_EQ(KillOwned(owner_, std::chrono::seconds(10)), 0);
}

TEST_F(SurvivorsTest, TheOnlyOneIsToldToWhoComesLater) {
  const std::string file = Temporary("only_one.lock");
  std::filesystem::remove(file);
  ASSERT_EQ(BecomeOnlyOne(file, {}).value(), 0);
  EXPECT_EQ(BecomeOnlyOne(file, {}).value(), getpid());
}

TEST_F(SurvivorsTest, WithoutAFileNobodyKnowsWhoIsTheOnlyOne) {
  const Expected<int> other = BecomeOnlyOne(Temporary("no_such_folder") + "/only_one.lock", {});
  ASSERT_FALSE(other);
  EXPECT_THAT(other.problem(), testing::HasSubstr("cannot open"));
}

}  // namespace
}  // namespace coppice::robot::processes
