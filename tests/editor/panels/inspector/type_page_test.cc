#include <gmock/gmock.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

using testing::HasSubstr;
using testing::Not;

class TypePage : public testing::Test {
 protected:
  TypePage() {
    driver_.editor.Open(file_.path());
    driver_.Frames();
    driver_.Click("canvas/MainTree/1.1.2");
    driver_.Press('I');
  }
  std::string Text() { return driver_.editor.state().workspace.project().Find(file_.path())->text; }
  void Fill(const std::string& item, const std::string& text) {
    ASSERT_TRUE(driver_.Click("inspector/type/" + item)) << item;
    driver_.Press('A', kCtrl);
    driver_.Type(text);
    driver_.Press(kKeyEnter);
  }

  TemporaryFile file_{"small.xml", kSmallFile};
  Driver driver_;
};

TEST_F(TypePage, ShowsTheModelInThePlaceOfTheNode) {
  EXPECT_TRUE(driver_.Has("inspector/type/kind"));
  EXPECT_FALSE(driver_.Has("inspector/name"));
  ASSERT_TRUE(driver_.Click("inspector/type/done"));
  EXPECT_TRUE(driver_.Has("inspector/name"));
}

TEST_F(TypePage, EndsWhenAnotherNodeIsSelected) {
  driver_.Click("canvas/MainTree/1.1.1");
  EXPECT_FALSE(driver_.Has("inspector/type/kind"));
}

TEST_F(TypePage, ChangesTheKind) {
  ASSERT_TRUE(driver_.Click("inspector/type/kind/choices"));
  ASSERT_TRUE(driver_.Click("inspector/type/kind/choice/Condition"));
  EXPECT_THAT(Text(), HasSubstr("<Condition ID=\"SwitchOn\">"));
}

TEST_F(TypePage, ChangesAPort) {
  Fill("port/1/default", "hall");
  Fill("port/1/description", "of the house");
  ASSERT_TRUE(driver_.Click("inspector/type/port/1/direction"));
  EXPECT_THAT(Text(),
              HasSubstr("<output_port name=\"lamp\" type=\"string\" default=\"hall\">of the "
                        "house</output_port>"));
}

TEST_F(TypePage, RemovesAPort) {
  ASSERT_TRUE(driver_.Click("inspector/type/port/1/remove"));
  EXPECT_THAT(Text(), Not(HasSubstr("which one")));
}

TEST_F(TypePage, AKindThatThereIsNotIsRefused) {
  Fill("kind", "Leaf");
  EXPECT_EQ(Text(), kSmallFile);
}

}  // namespace
}  // namespace coppice::editor
