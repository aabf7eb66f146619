#include <gtest/gtest.h>

#include <filesystem>

#include "editor/workspace/file_dialog.h"
#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

// Two projects; all is done by mouse and keys.
class ProjectSettingsStory : public testing::Test {
 protected:
  ProjectSettingsStory() {
    for (const char* project : {"kitchen", "garden"}) {
      std::filesystem::create_directories(folder_.Path(project));
      WriteFile(folder_.Path(std::string(project) + "/small.xml"), kSmallFile);
    }
    options_.projects_folder = folder_.Path("state");
    Start();
  }
  void Start() {
    driver_.reset();
    driver_ = std::make_unique<Driver>(options_);
    driver_->Frames();
  }
  void OpenByKeys(const std::string& project) {
    driver_->Press('O', kCtrl);
    driver_->Type(folder_.Path(project + "/small.xml"));
    driver_->Press(kKeyEnter);
    driver_->Frames(20);
  }
  static std::string Node(const char* path) { return std::string("canvas/MainTree/") + path; }

  const TemporaryFolder folder_;
  EditorOptions options_;
  std::unique_ptr<Driver> driver_;
};

TEST_F(ProjectSettingsStory, AProjectIsFoundAsItWasLeftAndAnotherIsAsItWas) {
  OpenByKeys("kitchen");
  ASSERT_TRUE(driver_->Has(Node("1.2.1.1")));
  ASSERT_TRUE(driver_->Has("outline"));
  driver_->ClickAt(driver_->BoxOf(Node("1.2")).center());
  driver_->Press('C');                // closes the SubTree
  driver_->Press(kKeyF1 + 2, kCtrl);  // hides the outline
  driver_->Frames(20);
  ASSERT_FALSE(driver_->Has(Node("1.2.1.1")));
  OpenByKeys("garden");
  EXPECT_TRUE(driver_->Has(Node("1.2.1.1"))) << "of another project";
  driver_->Press(kKeyF1 + 2, kCtrl);
  driver_->Frames(20);
  EXPECT_TRUE(driver_->Has("outline"));

  Start();
  OpenByKeys("kitchen");
  EXPECT_FALSE(driver_->Has(Node("1.2.1.1")));
  EXPECT_FALSE(driver_->Has("outline"));
  driver_->Picture("project_kitchen");
  OpenByKeys("garden");
  EXPECT_TRUE(driver_->Has(Node("1.2.1.1")));
  EXPECT_TRUE(driver_->Has("outline"));
  driver_->Picture("project_garden");
}

}  // namespace
}  // namespace coppice::editor
