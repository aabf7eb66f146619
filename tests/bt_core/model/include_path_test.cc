#include "bt_core/model/include_path.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

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
        *document, document->element(0),
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

}  // namespace
}  // namespace coppice
