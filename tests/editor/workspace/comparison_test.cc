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
  const auto compared = Comparison::With(file.path());
  ASSERT_TRUE(compared) << compared.problem();
  const std::unique_ptr<Comparison>& comparison = *compared;
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
  const auto comparison = Comparison::With("/nowhere.xml");
  ASSERT_FALSE(comparison);
  EXPECT_NE(comparison.problem().find("/nowhere.xml"), std::string::npos) << comparison.problem();
}

}  // namespace
}  // namespace coppice::editor
