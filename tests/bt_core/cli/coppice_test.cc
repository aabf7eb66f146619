// The program itself: verbs are found, others run the program beside it.
#include <sys/wait.h>

#include <cstdio>
#include <memory>

#include "tests/bt_core/cli/fixture.h"
#include "tests/support/folders.h"

namespace coppice {
namespace {

class CoppiceTest : public CliTest {
 protected:
  // Copied, so that programs can be put beside it.
  void SetUp() override {
    CliTest::SetUp();
    program_ = (folder_ / "coppice").string();
    std::filesystem::copy_file(BinaryFolder() + "/bin/coppice", program_);
  }

  int Call(const std::string& arguments) {
    const std::string command = program_ + " " + arguments + " 2>&1";
    FILE* pipe = popen(command.c_str(), "r");
    out_.clear();
    char buffer[256];
    while (std::fgets(buffer, sizeof(buffer), pipe)) out_ += buffer;
    const int status = pclose(pipe);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  std::string program_;
};

TEST_F(CoppiceTest, WithoutVerbItListsTheVerbs) {
  EXPECT_EQ(Call(""), 2);
  for (const char* verb : {"check", "nodes", "run"}) {
    EXPECT_NE(out_.find(verb), std::string::npos) << verb;
  }
}

TEST_F(CoppiceTest, RunsAVerb) {
  EXPECT_EQ(Call("check " + WriteTree("<AlwaysSuccess/>")), 0) << out_;
  EXPECT_EQ(Call("check " + WriteTree("<Sequence/>")), 1) << out_;
}

TEST_F(CoppiceTest, UnknownVerbGetsTheNearest) {
  EXPECT_EQ(Call("chekc"), 2);
  EXPECT_EQ(out_, "coppice: no verb \"chekc\" did you mean \"check\"?\n");
}

TEST_F(CoppiceTest, OtherVerbsRunTheProgramBesideIt) {
  const std::string other = Write("coppice-greet", "#!/bin/sh\necho hello \"$1\"\nexit 7\n");
  std::filesystem::permissions(other, std::filesystem::perms::owner_all);
  EXPECT_EQ(Call("greet you"), 7);
  EXPECT_EQ(out_, "hello you\n");
}

}  // namespace
}  // namespace coppice
