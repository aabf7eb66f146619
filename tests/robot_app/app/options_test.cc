// The command lines of the robot's programs, as far as they can be seen without a robot.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <string>

#include "tests/support/folders.h"

namespace coppice::robot {
namespace {

struct Called {
  int status = -1;
  std::string output;
};

Called Call(const std::string& program, const std::string& arguments) {
  const std::string command = "ROS_MASTER_URI=http://127.0.0.1:1 " + BinaryFolder() + "/bin/" +
                              program + " " + arguments + " 2>&1";
  Called called;
  FILE* const pipe = popen(command.c_str(), "r");
  char buffer[256];
  while (std::fgets(buffer, sizeof(buffer), pipe)) called.output += buffer;
  const int status = pclose(pipe);
  if (WIFEXITED(status)) called.status = WEXITSTATUS(status);
  return called;
}

TEST(OptionsOfPrograms, HelpIsNoErrorAndNonsenseIs) {
  for (const char* program : {"coppice-robot", "coppice-demo", "coppice-supervisor",
                              "coppice-processes", "coppice-remote", "coppice-assistance"}) {
    const Called help = Call(program, "--help");
    EXPECT_EQ(help.status, 0) << program;
    EXPECT_EQ(help.output.find("usage: coppice"), 0U) << help.output;
    const Called nonsense = Call(program, "--nonsense");
    EXPECT_EQ(nonsense.status, 2) << program;
    EXPECT_NE(nonsense.output.find("unknown option --nonsense"), std::string::npos)
        << nonsense.output;
  }
}

TEST(OptionsOfPrograms, WhatIsNoMasterAndNoFolderIsRefused) {
  for (const char* const master : {"robot:11311", "''"}) {
    const Called processes = Call("coppice-processes", std::string("--master ") + master);
    EXPECT_EQ(processes.status, 2) << processes.output;
  }
  const Called demo = Call("coppice-demo", "--run ''");
  EXPECT_EQ(demo.status, 2) << demo.output;
}

TEST(OptionsOfPrograms, TheTreeOfTheApplicationCanBeNamed) {
  const Called robot =
      Call("coppice-robot", "--application a.xml --monitor b.xml --places c --tree Dock");
  EXPECT_EQ(robot.output.find("coppice-robot: no ROS master"), 0U) << robot.output;
}

}  // namespace
}  // namespace coppice::robot
