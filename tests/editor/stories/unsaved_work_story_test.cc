// No work is lost, by mouse and keys alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <memory>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr int kSomeSeconds = 300;  // frames

std::string Disk(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class UnsavedWorkStory : public testing::Test {
 protected:
  std::unique_ptr<Driver> Start() const {
    EditorOptions options;
    options.backup_folder = file_.folder() + "/state";
    auto driver = std::make_unique<Driver>(options);
    driver->Frames();
    return driver;
  }
  std::unique_ptr<Driver> StartWithFile() const {
    auto driver = Start();
    driver->editor.Open(file_.path());
    driver->Frames();
    return driver;
  }
  static void Disable(Driver& driver, const std::string& node = "canvas/MainTree/1.3") {
    ASSERT_TRUE(driver.Click(node));
    driver.Press('D');
  }
  // Without an answer to what becomes of its work. Killing is what editor_lost_work_test does.
  static void End(std::unique_ptr<Driver> driver) {
    driver->Frames(kSomeSeconds);
    driver.reset();
  }
  std::string TextOf(Driver& driver) const {
    return driver.editor.state().workspace.project().Find(file_.path())->text;
  }

  const TemporaryFile file_{"small.xml", kSmallFile};
};

TEST_F(UnsavedWorkStory, QuittingAsksAndSaves) {
  const auto driver = StartWithFile();
  Disable(*driver);
  driver->Press('Q', kCtrl);
  driver->Frames();
  EXPECT_FALSE(driver->editor.wants_quit());
  ASSERT_TRUE(driver->Has("popup/2"));
  EXPECT_FALSE(driver->Has("popup/input")) << "a question, nothing to search";
  driver->Picture("quit_question");
  driver->Press(kKeyEnter);
  EXPECT_TRUE(driver->editor.wants_quit());
  EXPECT_THAT(Disk(file_.path()), HasSubstr("_skipIf"));
}

TEST_F(UnsavedWorkStory, QuittingAsksAndDiscards) {
  {
    const auto driver = StartWithFile();
    Disable(*driver);
    driver->Frames(kSomeSeconds);
    driver->Press('Q', kCtrl);
    driver->Frames();
    ASSERT_TRUE(driver->Click("popup/1"));
    EXPECT_TRUE(driver->editor.wants_quit());
  }
  EXPECT_EQ(Disk(file_.path()), kSmallFile);
  EXPECT_FALSE(StartWithFile()->Has("banner/unsaved")) << "the user has said so";
}

TEST_F(UnsavedWorkStory, ClosingTheWindowAsksTooAndEscapeGoesOn) {
  const auto driver = StartWithFile();
  Disable(*driver);
  driver->editor.AskToQuit();
  driver->Frames();
  EXPECT_TRUE(driver->Has("popup/2"));
  driver->Press(kKeyEscape);
  driver->Frames();
  EXPECT_FALSE(driver->editor.wants_quit());
  EXPECT_FALSE(driver->Has("popup/2"));
}

TEST_F(UnsavedWorkStory, QuittingWithANewFileAsksForItsPath) {
  const auto driver = Start();
  driver->Press('N', kCtrl);
  driver->Press(kKeyTab);
  driver->Type("Sequence");
  driver->Press(kKeyEnter);
  driver->Press('Q', kCtrl);
  driver->Frames();
  driver->Press(kKeyEnter);
  driver->Frames();
  EXPECT_FALSE(driver->editor.wants_quit());
  driver->Press('A', kCtrl);
  driver->Type(file_.folder() + "/mine.xml");
  driver->Press(kKeyEnter);
  driver->Frames();
  EXPECT_TRUE(driver->editor.wants_quit());
  EXPECT_THAT(Disk(file_.folder() + "/mine.xml"), HasSubstr("<Sequence/>"));
}

TEST_F(UnsavedWorkStory, ANewFileThatNobodyTouchedIsNoWork) {
  const auto driver = Start();
  driver->Press('N', kCtrl);
  driver->Press('Q', kCtrl);
  EXPECT_TRUE(driver->editor.wants_quit());
}

TEST_F(UnsavedWorkStory, AnotherFileIsReplacedOnlyWhenAskedTwice) {
  const TemporaryFile other("other.xml", "<root/>");
  const auto driver = StartWithFile();
  driver->Press('S', kCtrl | kShift);
  driver->Press('A', kCtrl);
  driver->Type(other.path());
  driver->Press(kKeyEnter);
  driver->Frames();
  EXPECT_EQ(Disk(other.path()), "<root/>");
  EXPECT_THAT(driver->editor.state().popup.error, HasSubstr("once more"));
  driver->Press(kKeyEnter);
  driver->Frames();
  EXPECT_EQ(Disk(other.path()), kSmallFile);
}

TEST_F(UnsavedWorkStory, AfterACrashTheStartScreenOffersANewFile) {
  {
    auto driver = Start();
    driver->Press('N', kCtrl);
    driver->Press(kKeyTab);
    driver->Type("Fallback");
    driver->Press(kKeyEnter);
    End(std::move(driver));
  }
  const auto driver = Start();
  ASSERT_TRUE(driver->Has("start/unsaved/0"));
  driver->Picture("start_unsaved");
  ASSERT_TRUE(driver->Click("start/unsaved/0"));
  driver->Frames();
  EXPECT_TRUE(driver->Has("canvas/MainTree/1"));
  EXPECT_THAT(driver->editor.title(), StartsWith("* untitled"));
  EXPECT_TRUE(driver->editor.state().work.left().empty());
}

TEST_F(UnsavedWorkStory, AfterACrashABarOffersToGoOnAndTheStepsAreThere) {
  {
    auto driver = StartWithFile();
    Disable(*driver);
    End(std::move(driver));
  }
  const auto driver = StartWithFile();
  ASSERT_TRUE(driver->Click("banner/restore"));
  driver->Frames();
  EXPECT_FALSE(driver->Has("banner/unsaved"));
  EXPECT_THAT(TextOf(*driver), HasSubstr("_skipIf"));
  driver->Press('Z', kCtrl);
  EXPECT_EQ(TextOf(*driver), kSmallFile);
}

TEST_F(UnsavedWorkStory, WhatIsDoneBeforeTheBarIsAnsweredIsKeptToo) {
  {
    auto driver = StartWithFile();
    Disable(*driver);
    End(std::move(driver));
  }
  {
    auto driver = StartWithFile();
    ASSERT_TRUE(driver->Has("banner/unsaved"));
    Disable(*driver, "canvas/MainTree/1.1");
    End(std::move(driver));
  }
  const auto driver = StartWithFile();
  EXPECT_EQ(driver->editor.state().work.left().size(), 2u) << "of both";
  Disable(*driver, "canvas/MainTree/1.2");
  const std::string typed = TextOf(*driver);
  ASSERT_TRUE(driver->Click("banner/restore"));
  driver->Press('Z', kCtrl);
  EXPECT_EQ(TextOf(*driver), typed) << "and what was done before the answer";
}

TEST_F(UnsavedWorkStory, ASecondEditorOfTheFileIsTold) {
  const auto first = StartWithFile();
  Disable(*first);
  first->Frames(kSomeSeconds);
  const auto second = StartWithFile();
  EXPECT_FALSE(second->Has("banner/unsaved")) << "it has not ended";
  ASSERT_TRUE(second->Has("banner/elsewhere"));
  second->Picture("elsewhere");
  first->Press('S', kCtrl);
  second->Frames(kSomeSeconds);
  EXPECT_FALSE(second->Has("banner/elsewhere"));
  EXPECT_THAT(TextOf(*second), HasSubstr("_skipIf"));
}

TEST_F(UnsavedWorkStory, AFileThatVanishesIsWrittenAgain) {
  const auto driver = StartWithFile();
  std::filesystem::remove(file_.path());
  driver->Frames(100);
  ASSERT_TRUE(driver->Has("banner/gone"));
  driver->Picture("gone");
  EXPECT_THAT(driver->editor.title(), StartsWith("* small.xml"));
  driver->Press('S', kCtrl);
  driver->Frames();
  EXPECT_EQ(Disk(file_.path()), kSmallFile);
  EXPECT_FALSE(driver->Has("banner/gone"));
}

TEST_F(UnsavedWorkStory, SaveInAFieldTakesWhatIsTyped) {
  const auto driver = StartWithFile();
  ASSERT_TRUE(driver->Click("canvas/MainTree/1.1.2"));
  driver->Frames();
  ASSERT_TRUE(driver->Click("inspector/port/lamp"));
  driver->Press('A', kCtrl);
  driver->Type("attic");
  driver->Press('S', kCtrl);
  driver->Frames(4);
  EXPECT_THAT(Disk(file_.path()), HasSubstr(R"(lamp="attic")"));
  EXPECT_EQ(driver->editor.title(), "small.xml - Coppice");
}

TEST_F(UnsavedWorkStory, ASaveThatFailsStaysInSightWithItsReason) {
  const auto driver = StartWithFile();
  Disable(*driver);
  const std::string away = file_.folder() + "/away";
  std::filesystem::rename(file_.path(), away);
  std::filesystem::create_directory(file_.path());
  driver->Press('S', kCtrl);
  driver->Frames(kSomeSeconds);
  ASSERT_TRUE(driver->Has("banner/failed_save"));
  driver->Picture("failed_save");
  std::filesystem::remove(file_.path());
  std::filesystem::rename(away, file_.path());
  driver->Frames(60);
  ASSERT_TRUE(driver->Click("banner/save_again"));
  driver->Frames();
  EXPECT_FALSE(driver->Has("banner/failed_save"));
  EXPECT_THAT(Disk(file_.path()), HasSubstr("_skipIf"));
}

TEST_F(UnsavedWorkStory, WhatIsNotSavedIsMarkedEverywhere) {
  const auto driver = StartWithFile();
  EXPECT_EQ(driver->editor.title(), "small.xml - Coppice");
  Disable(*driver);
  driver->Frames();
  driver->Picture("not_saved");
  EXPECT_EQ(driver->editor.title(), "* small.xml - Coppice");
  driver->Press('S', kCtrl);
  EXPECT_THAT(driver->editor.title(), Not(StartsWith("*")));
  EXPECT_THAT(driver->editor.title(), EndsWith("- Coppice"));
}

TEST_F(UnsavedWorkStory, SaysWhenNoCopyCanBeKept) {
  WriteFile(file_.folder() + "/state", "a file where the folder should be");
  const auto driver = StartWithFile();
  Disable(*driver);
  driver->Frames(kSomeSeconds);
  EXPECT_TRUE(driver->Has("banner/unkept"));
}

}  // namespace
}  // namespace coppice::editor
