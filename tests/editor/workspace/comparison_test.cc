#include "editor/workspace/comparison.h"

#include <gtest/gtest.h>

#include "tests/editor/canvas/make_scene.h"
#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

constexpr char kBefore[] =
    "<root BTCPP_format='4'><BehaviorTree ID='T'><A><B/></A></BehaviorTree></root>";

Point Measure(const Scene&, const SceneNode&) { return {100, 30}; }

TEST(Comparison, MergesTheOtherVersionWithWhatIsShown) {
  const TemporaryFile file("a.xml", kBefore);
  std::string wrong;
  const auto comparison = Comparison::With(file.path(), wrong);
  ASSERT_TRUE(comparison) << wrong;
  comparison->Follow(MakeScene("<A><B/><C/></A>"), {}, {}, Measure, 0);
  EXPECT_EQ(comparison->summary(), "1 added");
  EXPECT_EQ(comparison->changes(),
            (std::vector<Change>{Change::kNone, Change::kNone, Change::kAdded}));
  comparison->Follow(MakeScene("<A/>"), {}, {}, Measure, 1);
  EXPECT_EQ(comparison->summary(), "1 removed");
  EXPECT_EQ(comparison->view().scene()->nodes.size(), 2U);
  comparison->Follow(MakeScene("<A><B/></A>"), {}, {}, Measure, 2);
  EXPECT_EQ(comparison->summary(), "no difference");
}

TEST(Comparison, SaysWhyAFileCannotBeComparedWith) {
  std::string wrong;
  EXPECT_FALSE(Comparison::With("/nowhere.xml", wrong));
  EXPECT_NE(wrong.find("/nowhere.xml"), std::string::npos) << wrong;
}

}  // namespace
}  // namespace coppice::editor
