#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(WorkspacePlaces, LeadFromNodesToElementsAndBack) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  Workspace& workspace = driver.editor.state().workspace;
  const Scene& scene = *driver.view().scene();
  const auto place = workspace.PlaceOf(scene.nodes[scene.FindPath("1.3")]);
  ASSERT_TRUE(place);
  const EditedFile& edited = *workspace.project().Find(place->path);
  const std::uint32_t offset = edited.document->element(place->element).offset;
  EXPECT_EQ(edited.text.substr(offset, 14), "<AlwaysSuccess");
  workspace.SelectPlaces({{place->path, offset}}, 0);
  EXPECT_EQ(driver.Selected(), "1.3");
}

TEST(WorkspacePlaces, OfAnotherTreeShowIt) {
  const TemporaryFile file("small.xml",
                           R"(<root BTCPP_format="4" main_tree_to_execute="A">)"
                           R"(<BehaviorTree ID="A"><AlwaysSuccess/></BehaviorTree>)"
                           R"(<BehaviorTree ID="B"><AlwaysFailure/></BehaviorTree></root>)");
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  Workspace& workspace = driver.editor.state().workspace;
  const std::string& text = workspace.project().Find(file.path())->text;
  const auto offset = static_cast<std::uint32_t>(text.find("<AlwaysFailure"));
  workspace.SelectPlaces({{file.path(), offset}}, 0);
  EXPECT_EQ(workspace.ShownTreeId(), "B");
  EXPECT_EQ(driver.Selected(), "1");
}

}  // namespace
}  // namespace coppice::editor
