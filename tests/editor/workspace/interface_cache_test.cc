#include "editor/workspace/interface_cache.h"

#include <gtest/gtest.h>

#include "editor/workspace/project_editor.h"
#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(InterfaceCache, FollowsTheProject) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.Open(file.path());
  EditorState& state = driver.editor.state();
  ProjectEditor edit(state, driver.editor.now());
  InterfaceCache cache;
  ASSERT_EQ(cache.Of("Walk", state.workspace, edit.Files()).size(), 1U);
  EXPECT_EQ(cache.Of("Walk", state.workspace, edit.Files())[0].model.name, "goal");
  EXPECT_EQ(cache.UsesOf("Walk", state.workspace, edit.Files()), 1U);
  EXPECT_EQ(cache.UsesOf("MainTree", state.workspace, edit.Files()), 0U);
  driver.view().Select(driver.view().scene()->FindPath("1.2.1.1"));
  ASSERT_EQ(edit.RenameKey("goal", "target").problem(), "");
  EXPECT_EQ(cache.Of("Walk", state.workspace, edit.Files())[0].model.name, "target");
}

}  // namespace
}  // namespace coppice::editor
