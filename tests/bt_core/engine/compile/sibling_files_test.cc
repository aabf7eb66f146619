#include "bt_core/engine/compile/sibling_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace coppice {
namespace {

class SiblingFilesTest : public testing::Test {
 protected:
  SiblingFilesTest() { std::filesystem::create_directories(folder_); }
  ~SiblingFilesTest() override { std::filesystem::remove_all(folder_); }
  std::string Write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  const std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) /
      testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(SiblingFilesTest, NamesTheFileThatDefinesTheTree) {
  const std::string main = Write("main.xml", "<root/>");
  Write("dock.xml", R"(<root><BehaviorTree ID="Dock"><A/></BehaviorTree></root>)");
  EXPECT_EQ(SiblingFiles().FindTree(main, "Dock"), "dock.xml");
}

TEST_F(SiblingFilesTest, AMereMentionIsNoDefinition) {
  const std::string main = Write("main.xml", "<root/>");
  Write("user.xml", R"(<root><BehaviorTree ID="X"><SubTree ID="Dock"/></BehaviorTree></root>)");
  Write("broken.xml", R"(<root><BehaviorTree ID="Dock">)");
  Write("dock.txt", R"(<root><BehaviorTree ID="Dock"><A/></BehaviorTree></root>)");
  EXPECT_EQ(SiblingFiles().FindTree(main, "Dock"), "");
}

TEST_F(SiblingFilesTest, ATextThatIsNoFileHasNoFolder) {
  Write("dock.xml", R"(<root><BehaviorTree ID="Dock"><A/></BehaviorTree></root>)");
  EXPECT_EQ(SiblingFiles().FindTree((folder_ / "none.xml").string(), "Dock"), "");
}

TEST_F(SiblingFilesTest, AFolderIsReadOnce) {
  const std::string main = Write("main.xml", "<root/>");
  SiblingFiles siblings;
  EXPECT_EQ(siblings.FindTree(main, "Dock"), "");
  Write("dock.xml", R"(<root><BehaviorTree ID="Dock"><A/></BehaviorTree></root>)");
  EXPECT_EQ(siblings.FindTree(main, "Dock"), "");
  EXPECT_EQ(SiblingFiles().FindTree(main, "Dock"), "dock.xml");
}

TEST_F(SiblingFilesTest, NotMoreThanSomeMegabytesAreRead) {
  const std::string main = Write("main.xml", "<root/>");
  const std::string much = "<root>" + std::string((4 << 20) - 100, ' ') + "</root>";
  for (const char* name : {"a.xml", "b.xml", "c.xml", "d.xml", "e.xml"}) Write(name, much);
  Write("zzz.xml", R"(<root><BehaviorTree ID="Dock"><A/></BehaviorTree></root>)");
  EXPECT_EQ(SiblingFiles().FindTree(main, "Dock"), "");
}

}  // namespace
}  // namespace coppice
