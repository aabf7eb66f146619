#include "editor/files/history.h"

#include <gtest/gtest.h>

namespace coppice::editor {
namespace {

Step Named(const std::string& name) {
  Step step;
  step.name = name;
  step.files.push_back({"a.xml", {}, {}, {}, {}});
  step.selected_after = {{"a.xml", 7}};
  return step;
}

TEST(History, GoesBackAndForth) {
  History history;
  EXPECT_EQ(history.TakeUndo(), nullptr);
  history.Add(Named("one"));
  history.Add(Named("two"));
  EXPECT_EQ(history.undo()->name, "two");
  EXPECT_EQ(history.TakeUndo()->name, "two");
  EXPECT_EQ(history.redo()->name, "two");
  EXPECT_EQ(history.TakeUndo()->name, "one");
  EXPECT_EQ(history.undo(), nullptr);
  EXPECT_EQ(history.TakeRedo()->name, "one");
  history.Add(Named("three"));
  EXPECT_EQ(history.TakeRedo(), nullptr);
  EXPECT_EQ(history.steps().size(), 2U);
  EXPECT_EQ(history.done(), 2U);
}

TEST(History, FollowsARenamedFile) {
  History history;
  history.Add(Named("one"));
  history.Rename("a.xml", "b.xml");
  EXPECT_EQ(history.undo()->files[0].path, "b.xml");
  EXPECT_EQ(history.undo()->selected_after[0].path, "b.xml");
}

}  // namespace
}  // namespace coppice::editor
