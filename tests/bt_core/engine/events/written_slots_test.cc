#include "bt_core/engine/events/written_slots.h"

#include <gtest/gtest.h>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

std::vector<std::string> KeysOf(const Stage& stage, NodeIndex node) {
  const WrittenSlots written = WrittenSlotsOf(*stage.program);
  std::vector<std::string> keys;
  for (std::uint32_t i = written.first[node]; i != written.first[node + 1]; ++i) {
    keys.push_back(stage.program->layout.slots[written.slots[i]].key);
  }
  return keys;
}
using Keys = std::vector<std::string>;

TEST(WrittenSlots, AreThoseOfOutputs) {
  const Stage stage(Main(R"(<Tell text="{a}" to="{b}"/>)"));
  EXPECT_EQ(KeysOf(stage, 0), Keys{"b"});
}

TEST(WrittenSlots, AreThoseThatScriptsAssign) {
  const Stage stage(Main(R"(<Sequence _onSuccess="done:=x"><Script code="n:=1; m:=n"/>)"
                         "<AlwaysSuccess/></Sequence>"));
  EXPECT_EQ(KeysOf(stage, 0), Keys{"done"});
  EXPECT_EQ(KeysOf(stage, 1), (Keys{"n", "m"}));
  EXPECT_EQ(KeysOf(stage, 2), Keys());
}

TEST(WrittenSlots, ThereIsARangeForEveryNode) {
  const Stage stage(Main("<Sequence><AlwaysSuccess/><AlwaysFailure/></Sequence>"));
  EXPECT_EQ(WrittenSlotsOf(*stage.program).first, std::vector<std::uint32_t>(4, 0));
}

}  // namespace
}  // namespace coppice
