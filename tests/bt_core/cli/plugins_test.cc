// The verbs of the program `coppice` with --plugin; the plugins are those of the engine's tests.
#include "bt_core/cli/plugins.h"

#include <sys/wait.h>

#include <cstdio>

#include "tests/bt_core/cli/fixture.h"
#include "tests/support/folders.h"

namespace coppice {
namespace {

class PluginsTest : public CliTest {
 protected:
  int Call(const std::string& arguments) {
    const std::string command =
        "cd " + BinaryFolder() + "/tests/bt_core; ../../bin/coppice " + arguments + " 2>&1";
    FILE* pipe = popen(command.c_str(), "r");
    out_.clear();
    char buffer[256];
    while (std::fgets(buffer, sizeof(buffer), pipe)) out_ += buffer;
    const int status = pclose(pipe);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
};

TEST_F(PluginsTest, RunTicksTheirNodes) {
  const std::string tree = WriteTree(R"(<Sequence><Half number="3" half="{h}"/></Sequence>)");
  EXPECT_EQ(Call("run --plugin plugin_good.so " + tree), 0) << out_;
  EXPECT_NE(out_.find("Half::2  IDLE -> SUCCESS"), std::string::npos) << out_;
}

TEST_F(PluginsTest, CheckKnowsTheirPorts) {
  const std::string tree = WriteTree(R"(<Half numbr="3"/>)");
  EXPECT_EQ(Call("check " + tree), 0) << out_;
  EXPECT_EQ(Call("check --plugin plugin_good.so " + tree), 1);
  EXPECT_NE(out_.find(R"(did you mean "number"?)"), std::string::npos) << out_;
}

TEST_F(PluginsTest, NodesListsThem) {
  EXPECT_EQ(Call("nodes --plugin plugin_good.so"), 0);
  EXPECT_NE(out_.find("IsSmall"), std::string::npos) << out_;
}

TEST_F(PluginsTest, OneThatCannotBeLoadedIsNamed) {
  EXPECT_EQ(Call("nodes --plugin plugin_good.so --plugin plugin_taken_id.so"), 2);
  EXPECT_EQ(out_, "plugin_taken_id.so: node ID \"Sequence\" is already registered\n");
}

// This test program is linked without coppice_load_plugins.
TEST_F(PluginsTest, AProgramThatHidesTheEngineIsToldSo) {
  const std::string plugin = BinaryFolder() + "/tests/bt_core/plugin_good.so";
  EXPECT_EQ(CliTest::Run(RunNodes, {"--plugin", plugin}), 2);
  EXPECT_NE(err_.find("must be linked with coppice_load_plugins"), std::string::npos) << err_;
}

}  // namespace
}  // namespace coppice
