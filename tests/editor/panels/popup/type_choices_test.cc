#include "editor/panels/popup/type_choices.h"

#include <gmock/gmock.h>

#include "editor/keys/recent.h"
#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

using testing::Contains;
using testing::Field;

class TypeChoicesTest : public testing::Test {
 protected:
  TypeChoicesTest() { driver_.editor.Open(file_.path()); }
  std::vector<TypeChoice> Find(const std::string& typed, bool with_trees = true) {
    return FindTypes(driver_.editor.state(), typed, with_trees, 12);
  }
  TemporaryFile file_{"small.xml", kSmallFile};
  Driver driver_;
};

TEST_F(TypeChoicesTest, FindByAFewLetters) {
  EXPECT_EQ(Find("swon").front().type, "SwitchOn");
  EXPECT_EQ(Find("swon").front().xml, "<SwitchOn/>");
}

TEST_F(TypeChoicesTest, FindByAWordOfTheDescriptionOrTheCategory) {
  EXPECT_EQ(Find("a lamp").front().type, "SwitchOn");
  EXPECT_THAT(Find("condition"), Contains(Field(&TypeChoice::type, "IsDark")));
}

TEST_F(TypeChoicesTest, OfferTheOtherTreesAsSubTrees) {
  EXPECT_EQ(Find("Walk").front().xml, R"(<SubTree ID="Walk"/>)");
  EXPECT_THAT(Find("MainTree"), Not(Contains(Field(&TypeChoice::kind, "SubTree"))));
  EXPECT_THAT(Find("Walk", false), Not(Contains(Field(&TypeChoice::kind, "SubTree"))));
}

TEST_F(TypeChoicesTest, OfferWhatIsUsedWithoutAModelAndWhatIsNew) {
  EXPECT_EQ(Find("Step").front().kind, "unknown");
  EXPECT_EQ(Find("Dance").back().kind, "new");
  EXPECT_THAT(Find("1 2"), Not(Contains(Field(&TypeChoice::kind, "new"))));
}

TEST_F(TypeChoicesTest, ShowWhatWasUsedLastFirst) {
  UseAgain(driver_.editor.state().recent.types, "Inverter");
  UseAgain(driver_.editor.state().recent.types, "Sequence");
  EXPECT_EQ(Find("")[0].type, "Sequence");
  EXPECT_EQ(Find("")[1].type, "Inverter");
}

TEST_F(TypeChoicesTest, AWholeNameGoesBeforeWhatWasUsedLast) {
  UseAgain(driver_.editor.state().recent.types, "ReactiveSequence");
  EXPECT_EQ(Find("sequence")[0].type, "Sequence");
  EXPECT_EQ(Find("sequence")[1].type, "ReactiveSequence");
}

TEST_F(TypeChoicesTest, OfThoseThatFitAlikeWhatWasUsedLastComesFirst) {
  UseAgain(driver_.editor.state().recent.types, "SwitchOn");
  EXPECT_EQ(Find("sw")[0].type, "SwitchOn") << "before Switch2";
}

}  // namespace
}  // namespace coppice::editor
