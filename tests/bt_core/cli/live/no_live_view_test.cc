#include "tests/bt_core/cli/fixture.h"

namespace coppice {
namespace {

class NoLiveViewTest : public CliTest {};

TEST_F(NoLiveViewTest, SaysThatThereIsNone) {
  EXPECT_EQ(CliTest::Run(RunTree, {WriteTree("<AlwaysSuccess/>"), "--live"}), 2);
  EXPECT_NE(err_.find("--live: this coppice was built without the live view"), std::string::npos);
  EXPECT_EQ(CliTest::Run(RunTree, {WriteTree("<AlwaysSuccess/>")}), 0);
}

}  // namespace
}  // namespace coppice
