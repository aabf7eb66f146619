#include "editor/keys/key_file.h"

#include <gtest/gtest.h>

namespace coppice::editor {
namespace {

class KeyFileTest : public testing::Test {
 protected:
  KeyFileTest() {
    commands_.Add({"view.fit_all", "Fit all", {kKeyHome}, [this] { ran_ += "fit "; }});
    commands_.Add({"file.save", "Save", {'S', kCtrl}, [this] { ran_ += "save "; }});
    commands_.Add({"tree.collapse", "Collapse", {'C'}, [this] { ran_ += "collapse "; }});
    commands_.Add(
        {"sim.tick", "Tick", {'S', kCtrl}, [this] { ran_ += "tick "; }, [] { return false; }});
  }
  std::string Read(const std::string& text) {
    Diagnostics diagnostics;
    ReadKeys(text, "keys", commands_, diagnostics);
    return diagnostics.ToString();
  }
  CommandTable commands_;
  std::string ran_;
};

TEST_F(KeyFileTest, GivesCommandsOtherKeys) {
  EXPECT_EQ(Read("# mine\nview.fit_all = Ctrl+Shift+F2\n\n  tree.collapse =\n"), "");
  EXPECT_FALSE(commands_.Press({kKeyHome}));
  EXPECT_FALSE(commands_.Press({'C'}));
  EXPECT_TRUE(commands_.Press({kKeyF1 + 1, kCtrl | kShift}));
  EXPECT_TRUE(commands_.Press({'S', kCtrl})) << "what is not named keeps its keys";
  EXPECT_EQ(ran_, "fit save ");
}

TEST_F(KeyFileTest, SaysWhatIsWrongWithItsLineAndKeepsTheRest) {
  const std::string problems =
      Read("view.fit_al = F2\nfile.save\nfile.save = Ctrl+Nothing\n= F3\ntree.collapse = F4\n");
  EXPECT_NE(problems.find("keys:1:1: error: there is no command view.fit_al"), std::string::npos)
      << problems;
  EXPECT_NE(problems.find(R"(did you mean "view.fit_all"?)"), std::string::npos) << problems;
  EXPECT_NE(problems.find("keys:2:1"), std::string::npos) << problems;
  EXPECT_NE(problems.find("Ctrl+Nothing is no key"), std::string::npos) << problems;
  EXPECT_NE(problems.find("keys:4:1"), std::string::npos) << problems;
  EXPECT_TRUE(commands_.Press({kKeyF1 + 3}));
}

TEST_F(KeyFileTest, SaysWhichCommandsHaveTheSameKeys) {
  const std::string problems = Read("tree.collapse = Ctrl+S\n");
  EXPECT_NE(problems.find("Ctrl+S is bound to file.save and to tree.collapse"), std::string::npos)
      << problems;
  EXPECT_EQ(problems.find("sim.tick"), std::string::npos) << "its keys are its own at times only";
}

TEST_F(KeyFileTest, TwoCommandsThatCameWithoutKeysCanMeetToo) {
  commands_.Add({"a", "A", {}, [] {}});
  commands_.Add({"b", "B", {}, [] {}});
  EXPECT_TRUE(commands_.FindConflicts().empty());
  EXPECT_NE(Read("a = F9\nb = F9\n").find("F9 is bound to a and to b"), std::string::npos);
}

TEST_F(KeyFileTest, ChangesOneLineOfTheFile) {
  const std::string text = "# mine\nfile.save = F2\ntree.collapse =\n# end";
  EXPECT_EQ(WithKeys(text, "file.save", {kKeySpace, kAlt}),
            "# mine\nfile.save = Alt+Space\ntree.collapse =\n# end");
  EXPECT_EQ(WithKeys(text, "view.fit_all", {}), text + "\nview.fit_all =\n");
  EXPECT_EQ(WithoutKeys(text, "file.save"), "# mine\ntree.collapse =\n# end");
  EXPECT_EQ(WithoutKeys(text, "view.fit_all"), text);
}

}  // namespace
}  // namespace coppice::editor
