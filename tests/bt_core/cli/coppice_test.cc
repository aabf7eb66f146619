// The program itself: verbs are found, others run the program beside it.
#include <sys/wait.h>

#include <cstdio>
#include <memory>

#include "bt_core/base/version.h"
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
    const std::string command = "(" + program_ + " " + arguments + ") 2>&1";
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

TEST_F(CoppiceTest, HelpIsNoError) {
  EXPECT_EQ(Call("--help"), 0);
  EXPECT_EQ(Call("run --help"), 0);
  EXPECT_EQ(out_.find("usage: coppice run [options] FILE"), 0u) << out_;
}

TEST_F(CoppiceTest, TellsItsVersion) {
  EXPECT_EQ(Call("--version"), 0);
  EXPECT_EQ(out_, std::string("coppice ") + kVersion + "\n");
}

TEST_F(CoppiceTest, CompletesInBash) {
  const std::string script =
      Write("complete.sh", "eval \"$(" + program_ +
                               " completion bash)\"\n"
                               "COMP_WORDS=(coppice stats --sort t) COMP_CWORD=3\n"
                               "_coppice\necho \"${COMPREPLY[@]}\"\n"
                               "COMP_WORDS=(coppice live --st) COMP_CWORD=2\n"
                               "_coppice\necho \"${COMPREPLY[@]}\"\n");
  program_ = "bash " + script;
  EXPECT_EQ(Call(""), 0);
  EXPECT_EQ(out_, "tree ticks time\n--step --step-node\n");
}

// A full disk, as far as a program can see.
TEST_F(CoppiceTest, SaysWhenTheOutputCannotBeWritten) {
  const std::string tree = WriteTree("<AlwaysSuccess/>");
  const std::string record = (folder_ / "run.coppice").string();
  const std::string test =
      Write("a.test.json", R"({"tree": "tree.xml", "scenarios": [{"name": "a", "steps": []}]})");
  ASSERT_EQ(Call("run " + tree + " --record " + record), 0) << out_;
  for (const std::string& call :
       {"cat " + tree, "check --json " + tree, std::string("completion bash"), std::string("nodes"),
        "replay --print " + record, "replay --tick 1 " + record, "replay --verify " + record,
        "replay --json " + record, "run " + tree, "stats " + record, "test " + test,
        "trace " + tree, "upgrade " + tree, std::string("stats --help")}) {
    EXPECT_EQ(Call(call + " > /dev/full"), 2) << call << ": " << out_;
  }
  const std::string odd = Write("odd.xml", R"(<root BTCPP_format="4"><Unknown/></root>)");
  EXPECT_EQ(Call("check " + odd + " 2> /dev/full"), 2);
}

TEST_F(CoppiceTest, WritesNothingIntoItsFilesIfTheOutputIsClosed) {
  const std::string tree = WriteTree(
      "<Repeat num_cycles=\"2000\"><KeepRunningUntilFailure><AlwaysFailure/>"
      "</KeepRunningUntilFailure></Repeat>");
  const std::string record = (folder_ / "run.coppice").string();
  EXPECT_EQ(Call("run " + tree + " --record " + record + " >&-"), 2) << out_;
  EXPECT_EQ(Call("replay --verify " + record), 0) << out_;
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
