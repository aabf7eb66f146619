#include <gmock/gmock.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(TreePage, ShowsWhatTheTreeSharesWhenNoNodeIsSelected) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  EXPECT_TRUE(driver.Has("inspector/interface/light"));
  ASSERT_TRUE(driver.Click("inspector/edit_type"));
  EXPECT_THAT(driver.editor.state().workspace.project().Find(file.path())->text,
              testing::HasSubstr("<SubTree ID=\"MainTree\">"));
  EXPECT_TRUE(driver.Has("inspector/type/port/0/name"));
}

TEST(TreePage, RenamesTheTreeEverywhere) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  ASSERT_TRUE(driver.Click("inspector/tree"));
  driver.Press('A', kCtrl);
  driver.Type("Round");
  driver.Press(kKeyEnter);
  EXPECT_EQ(driver.editor.state().workspace.ShownTreeId(), "Round");
}

}  // namespace
}  // namespace coppice::editor
