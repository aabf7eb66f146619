#include "editor/panels/widgets/inspector_row.h"

#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

constexpr char kFile[] = R"(<root BTCPP_format="4"><BehaviorTree ID="Main">
<Repeat num_cycles="often"><AlwaysSuccess/></Repeat></BehaviorTree></root>)";

TEST(InspectorRow, AWrongValueIsMarkedUntilItIsRight) {
  const TemporaryFile file("repeat.xml", kFile);
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  driver.view().Select(0);
  driver.Frames();
  EXPECT_TRUE(driver.Has("inspector/port/num_cycles/problem"));
  ASSERT_TRUE(driver.Click("inspector/port/num_cycles"));
  driver.Press('A', kCtrl);
  driver.Type("3");
  driver.Press(kKeyEnter);
  driver.Frames(20);
  EXPECT_FALSE(driver.Has("inspector/port/num_cycles/problem"));
}

TEST(InspectorRow, WhatCannotBeTypedInIsNoField) {
  const TemporaryFile file("repeat.xml", kFile);
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  driver.view().Select(0);
  driver.Frames();
  const Color field = GetPalette(PaletteName::kDark).field;
  EXPECT_GT(driver.CountColor(driver.BoxOf("inspector/name"), field, 2), 1000);
  EXPECT_EQ(driver.CountColor(driver.BoxOf("inspector/path"), field, 2), 0);
}

}  // namespace
}  // namespace coppice::editor
