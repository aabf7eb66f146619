#include "bt_core/model/include_path.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>

namespace coppice {
namespace {

namespace fs = std::filesystem;

class IncludePathTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("coppice_include_") + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "parts");
    std::ofstream(folder_ / "parts" / "docking.xml") << "<root/>";
  }
  void TearDown() override { fs::remove_all(folder_); }

  // The path that this element gives in a file of the folder.
  std::string Resolve(const std::string& include) {
    const auto document =
        Document::FromText(include, (folder_ / "main.xml").string(), diagnostics_);
    return IncludePath(
        *document, document->element(kRootElement),
        [this](const std::string& name) { return name == "pkg" ? folder_.string() : ""; },
        diagnostics_);
  }
  std::string Docking() const { return (folder_ / "parts" / "docking.xml").string(); }
  std::string Problem() const {
    return diagnostics_.all().empty() ? "" : ToString(diagnostics_.all().front());
  }

  fs::path folder_;
  Diagnostics diagnostics_;
};

TEST_F(IncludePathTest, IsRelativeToTheDocumentOrThePackageOrAbsolute) {
  EXPECT_EQ(Resolve("<include path='parts/../parts/docking.xml'/>"), Docking());
  EXPECT_EQ(Resolve("<include path='parts/docking.xml' ros_pkg='pkg'/>"), Docking());
  EXPECT_EQ(Resolve("<include path='" + Docking() + "'/>"), Docking());
  EXPECT_EQ(diagnostics_.ToString(), "");
}

TEST_F(IncludePathTest, APackageThatHasNoEffectIsAWarning) {
  EXPECT_EQ(Resolve("<include ros_pkg='pkg' path='" + Docking() + "'/>"), Docking());
  EXPECT_NE(Problem().find(":1:10: warning: ros_pkg has no effect"), std::string::npos)
      << Problem();
}

TEST_F(IncludePathTest, AMissingFileComesWithTheNearestName) {
  EXPECT_EQ(Resolve("<include path='parts/doking.xml'/>"), "");
  EXPECT_NE(Problem().find("main.xml:1:16: error: included file "), std::string::npos) << Problem();
  EXPECT_NE(Problem().find(R"((did you mean "docking.xml"?))"), std::string::npos) << Problem();
}

TEST_F(IncludePathTest, AMissingFolderIsNamed) {
  EXPECT_EQ(Resolve("<include path='no/docking.xml'/>"), "");
  EXPECT_NE(Problem().find("there is no folder " + (folder_ / "no").string()), std::string::npos)
      << Problem();
}

TEST_F(IncludePathTest, AFolderIsNoFile) {
  EXPECT_EQ(Resolve("<include path='parts'/>"), "");
  EXPECT_TRUE(diagnostics_.has_errors());
}

TEST_F(IncludePathTest, AnUnknownPackageIsReportedAtItsName) {
  EXPECT_EQ(Resolve("<include ros_pkg='other' path='parts/docking.xml'/>"), "");
  EXPECT_NE(Problem().find(R"(:1:19: error: ROS package "other" was not found)"), std::string::npos)
      << Problem();
}

TEST_F(IncludePathTest, WithoutPathItIsAnError) {
  EXPECT_EQ(Resolve("<include path=''/>"), "");
  EXPECT_NE(Problem().find(":1:1: error: <include> without path"), std::string::npos) << Problem();
}

// A workspace of packages; the environment is as before afterwards.
class RosPackagesTest : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : kVariables) {
      const char* value = std::getenv(name);
      before_.push_back(value ? std::optional<std::string>(value) : std::nullopt);
      unsetenv(name);
    }
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("coppice_packages_") + test->name());
    fs::remove_all(folder_);
    setenv("PATH", folder_.c_str(), 1);  // no rospack but the test's own
  }
  void TearDown() override {
    for (std::size_t i = 0; i < before_.size(); ++i) {
      if (before_[i]) {
        setenv(kVariables[i], before_[i]->c_str(), 1);
      } else {
        unsetenv(kVariables[i]);
      }
    }
    fs::remove_all(folder_);
  }

  std::string AddPackage(const std::string& path, const std::string& name) {
    fs::create_directories(folder_ / path);
    std::ofstream(folder_ / path / "package.xml")
        << "<?xml version=\"1.0\"?>\n<package><name>\n  " << name << " </name></package>";
    return (folder_ / path).string();
  }

  static constexpr const char* kVariables[] = {"ROS_PACKAGE_PATH", "AMENT_PREFIX_PATH", "PATH"};
  std::vector<std::optional<std::string>> before_;
  fs::path folder_;
};

TEST_F(RosPackagesTest, ThePackageIsKnownByTheNameInItsManifest) {
  const std::string there = AddPackage("src/group/some_folder", "robot_trees");
  AddPackage("src/robot_trees_2", "robot_trees_2");
  setenv("ROS_PACKAGE_PATH", ("/no/such::" + (folder_ / "src").string()).c_str(), 1);
  EXPECT_EQ(FindRosPackage("robot_trees"), there);
  EXPECT_EQ(FindRosPackage("some_folder"), "");
}

TEST_F(RosPackagesTest, PackagesInsideOfOthersAndIgnoredFoldersDoNotCount) {
  AddPackage("src/outer", "outer");
  AddPackage("src/outer/inner", "inner");
  AddPackage("src/old/hidden", "hidden");
  std::ofstream(folder_ / "src/old/CATKIN_IGNORE") << "";
  setenv("ROS_PACKAGE_PATH", (folder_ / "src").c_str(), 1);
  EXPECT_NE(FindRosPackage("outer"), "");
  EXPECT_EQ(FindRosPackage("inner"), "");
  EXPECT_EQ(FindRosPackage("hidden"), "");
}

TEST_F(RosPackagesTest, TheFirstFolderOfThePathWins) {
  AddPackage("b/trees", "trees");
  const std::string first = AddPackage("a/trees", "trees");
  setenv("ROS_PACKAGE_PATH", ((folder_ / "a").string() + ":" + (folder_ / "b").string()).c_str(),
         1);
  EXPECT_EQ(FindRosPackage("trees"), first);
}

TEST_F(RosPackagesTest, InstalledPackagesOfRos2AreFound) {
  const std::string there = AddPackage("install/share/trees", "trees");
  setenv("AMENT_PREFIX_PATH", (folder_ / "install").c_str(), 1);
  EXPECT_EQ(FindRosPackage("trees"), there);
}

TEST_F(RosPackagesTest, RospackIsAskedAtLast) {
  fs::create_directories(folder_);
  std::ofstream(folder_ / "rospack") << "#!/bin/sh\nif [ \"$1 $2\" = \"find far_away\" ]; then "
                                        "echo /opt/far_away; else exit 1; fi\n";
  fs::permissions(folder_ / "rospack", fs::perms::owner_all);
  EXPECT_EQ(FindRosPackage("far_away"), "/opt/far_away");
  EXPECT_EQ(FindRosPackage("nowhere"), "");
}

TEST_F(RosPackagesTest, WhatIsNoPackageNameIsNotAskedFor) {
  fs::create_directories(folder_);
  std::ofstream(folder_ / "rospack") << "#!/bin/sh\necho /found\n";
  fs::permissions(folder_ / "rospack", fs::perms::owner_all);
  EXPECT_EQ(FindRosPackage("a"), "/found");
  for (const char* name : {"", "a b", "a;b", "$(a)", "../a", "-a"}) {
    EXPECT_EQ(FindRosPackage(name), "") << name;
  }
}

}  // namespace
}  // namespace coppice
