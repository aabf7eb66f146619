#include "editor/panels/xml/xml_gutter.h"

#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

bool HasAny(const Driver& driver, const std::string& what) {
  for (int line = 1; line < 40; ++line) {
    if (driver.Has("xml/" + what + "/" + std::to_string(line))) return true;
  }
  return false;
}

void DisableOneNode(Driver& driver) {
  driver.view().Select(driver.view().scene()->FindPath("1.3"));
  driver.Press('D');
  driver.Frames();
}

TEST(XmlGutter, MarksWhatIsNotSavedUntilItIs) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  driver.OpenRow();
  EXPECT_FALSE(HasAny(driver, "unsaved"));
  DisableOneNode(driver);
  EXPECT_TRUE(driver.Has("xml/unsaved/10"));
  driver.Press('S', kCtrl);
  driver.Frames();
  EXPECT_FALSE(HasAny(driver, "unsaved"));
  EXPECT_FALSE(HasAny(driver, "uncommitted")) << "git does not know this file";
}

TEST(XmlGutter, MarksWhatIsNotCommitted) {
  if (!OutputOf({"git", "--version"})) GTEST_SKIP() << "no git here";
  const TemporaryFile file("small.xml", kSmallFile);
  const auto git = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"git", "-C", file.folder(), "-c", "user.name=A", "-c",
                                 "user.email=a@b", "-c", "commit.gpgsign=false"});
    return OutputOf(words).has_value();
  };
  ASSERT_TRUE(git({"init", "-q"}) && git({"add", "."}) && git({"commit", "-q", "-m", "one"}));
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  driver.OpenRow();
  driver.editor.state().git.Wait();
  driver.Frames();
  EXPECT_FALSE(HasAny(driver, "uncommitted"));
  DisableOneNode(driver);
  driver.Press('S', kCtrl);
  driver.Frames();
  EXPECT_TRUE(driver.Has("xml/uncommitted/10"));
  EXPECT_FALSE(HasAny(driver, "unsaved"));
}

}  // namespace
}  // namespace coppice::editor
