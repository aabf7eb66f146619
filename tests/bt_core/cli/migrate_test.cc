#include "tests/bt_core/cli/fixture.h"

namespace coppice {
namespace {

class MigrateTest : public CliTest {
 protected:
  int Migrate() { return Run(RunMigrate, {folder_.string()}); }
};

TEST_F(MigrateTest, WhatCompilesIsFine) {
  Write("CMakeLists.txt", "find_package(behaviortree_cpp REQUIRED)\n");
  Write("node.h",
        "#include \"behaviortree_cpp/bt_factory.h\"\nclass A : public BT::ControlNode {};\n");
  EXPECT_EQ(Migrate(), 0);
  EXPECT_NE(out_.find("CMakeLists.txt:1: fine: find_package(behaviortree_cpp "), std::string::npos)
      << out_;
  EXPECT_NE(out_.find("2 files read, 2 use BehaviorTree.CPP: 0 lines will not compile"),
            std::string::npos)
      << out_;
}

TEST_F(MigrateTest, ADerivedBuiltInNodeDoesNotCompile) {
  Write("node.h", "\nclass A : public BT::SequenceNode {};\nclass B : public SequenceNodes {};\n");
  EXPECT_EQ(Migrate(), 1);
  EXPECT_NE(out_.find("node.h:2: stop: SequenceNode is built in"), std::string::npos) << out_;
  EXPECT_EQ(out_.find("node.h:3"), std::string::npos) << out_;
}

TEST_F(MigrateTest, AHeaderThatIsMissingIsNamed) {
  Write("a.cpp", "#include \"behaviortree_cpp/contrib/any.hpp\"\n");
  EXPECT_EQ(Migrate(), 1);
  EXPECT_NE(out_.find("a.cpp:1: stop: behaviortree_cpp/contrib/any.hpp is not there; BT::Any is"),
            std::string::npos)
      << out_;
}

TEST_F(MigrateTest, WhatBehavesOtherwiseIsANote) {
  Write("a.cpp", "auto entry = board->getEntry(key);\n");
  EXPECT_EQ(Migrate(), 0);
  EXPECT_NE(out_.find("a.cpp:1: note: getEntry( is a copy"), std::string::npos) << out_;
}

TEST_F(MigrateTest, PartsOfOtherNamesAreNotMeant) {
  Write("a.cpp", "tryGetAny(key); mygetAny(key);\n");
  EXPECT_EQ(Migrate(), 0);
  EXPECT_EQ(out_.find("a.cpp"), std::string::npos) << out_;
}

TEST_F(MigrateTest, BuildFoldersAreLeftOut) {
  std::filesystem::create_directories(folder_ / "build");
  Write("build/CMakeCache.txt", "");
  Write("build/a.cpp", "getAny(key);\n");
  EXPECT_EQ(Migrate(), 0);
}

TEST_F(MigrateTest, AFolderMustBeThere) {
  EXPECT_EQ(Run(RunMigrate, {(folder_ / "none").string()}), 2);
  EXPECT_NE(err_.find("no such folder"), std::string::npos);
}

}  // namespace
}  // namespace coppice
