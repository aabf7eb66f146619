#include "editor/settings/project_session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class ProjectSessionTest : public testing::Test {
 protected:
  ProjectSessionTest() {
    for (const char* name : {"kitchen/a.xml", "kitchen/b.xml", "garden/c.xml"}) {
      std::filesystem::create_directories(std::filesystem::path(folder_.Path(name)).parent_path());
      WriteFile(folder_.Path(name), kSmallFile);
    }
    options_.projects_folder = folder_.Path("state");
    Start();
  }
  void Start() {
    driver_.reset();  // which keeps what there is
    driver_ = std::make_unique<Driver>(options_);
    driver_->Frames();
  }
  void Open(const char* name) {
    ASSERT_TRUE(driver_->editor.Open(folder_.Path(name)));
    driver_->Frames();
  }
  void Run(const char* command) {
    driver_->editor.state().commands.Run(command);
    driver_->Frames();
  }
  EditorState& state() { return driver_->editor.state(); }
  std::vector<std::string> Files() {
    std::vector<std::string> names;
    for (const OpenFile& file : state().workspace.files()) {
      names.push_back(std::filesystem::path(file.path).filename());
    }
    return names;
  }

  const TemporaryFolder folder_;
  EditorOptions options_;
  std::unique_ptr<Driver> driver_;
};

TEST_F(ProjectSessionTest, AnotherProjectHasAnotherScreen) {
  Open("kitchen/a.xml");
  Run("tile.outline");
  Open("garden/c.xml");
  EXPECT_FALSE(state().screen.tiles.outline) << "a new project takes over what is there";
  Run("tile.outline");
  Open("kitchen/b.xml");
  EXPECT_FALSE(state().screen.tiles.outline);
  Open("garden/c.xml");
  EXPECT_TRUE(state().screen.tiles.outline);
}

TEST_F(ProjectSessionTest, OpensTheFilesThatWereOpenBehindTheOneThatIsAskedFor) {
  Open("kitchen/a.xml");
  Open("kitchen/b.xml");
  Open("garden/c.xml");
  Start();
  Open("kitchen/b.xml");
  EXPECT_THAT(Files(), ElementsAre("b.xml", "a.xml"));
  EXPECT_EQ(state().workspace.file()->path, folder_.Path("kitchen/b.xml"));
  EXPECT_EQ(state().canvas.tabs.size(), 2U);
}

TEST_F(ProjectSessionTest, FilesThatAreGoneAreNotOpened) {
  Open("kitchen/a.xml");
  Open("kitchen/b.xml");
  Start();
  std::filesystem::remove(folder_.Path("kitchen/a.xml"));
  Open("kitchen/b.xml");
  EXPECT_THAT(Files(), ElementsAre("b.xml"));
  EXPECT_EQ(state().canvas.tabs.size(), 1U);
}

TEST_F(ProjectSessionTest, NodesThatHaveBecomeOthersAreNotClosed) {
  Open("kitchen/a.xml");
  TreeView& before = driver_->view();
  before.SetCollapsed(before.scene()->FindPath("1.1"), true, state().now);
  before.SetCollapsed(before.scene()->FindPath("1.2"), true, state().now);
  Start();
  std::string changed = kSmallFile;
  const std::string fallback = "Fallback>";
  for (auto at = changed.find(fallback); at != std::string::npos; at = changed.find(fallback)) {
    changed.replace(at, fallback.size(), "Parallel>");
  }
  WriteFile(folder_.Path("kitchen/a.xml"), changed);
  Open("kitchen/a.xml");
  const TreeView& view = driver_->view();
  EXPECT_TRUE(view.IsCollapsed(view.scene()->FindPath("1.2")));
  EXPECT_FALSE(view.IsCollapsed(view.scene()->FindPath("1.1")));
}

TEST_F(ProjectSessionTest, ADamagedFileIsSaidOnceAndTheProjectOpensAsANewOne) {
  Open("kitchen/a.xml");
  Run("tile.outline");
  Start();
  const ProjectStore store(options_.projects_folder);
  WriteFile(store.FileOf(folder_.Path("kitchen")), "{\"tiles\": {\"outline\": ");
  Open("kitchen/a.xml");
  EXPECT_TRUE(state().screen.tiles.outline);
  EXPECT_THAT(state().notice.text, HasSubstr("the settings of this project are damaged"));
  Start();
  Open("kitchen/a.xml");
  EXPECT_EQ(state().notice.text, "") << "the file was written anew";
}

TEST_F(ProjectSessionTest, NothingIsWrittenIntoTheProject) {
  Open("kitchen/a.xml");
  Run("tile.outline");
  Start();
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_.Path("kitchen"))) {
    names.push_back(entry.path().filename());
  }
  EXPECT_THAT(names, testing::UnorderedElementsAre("a.xml", "b.xml"));
}

}  // namespace
}  // namespace coppice::editor
