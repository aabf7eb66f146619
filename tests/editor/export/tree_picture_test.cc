#include "editor/export/tree_picture.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/editor/export/painted.h"
#include "tests/editor/shared_fonts.h"

namespace coppice::editor {
namespace {

constexpr char kTree[] = "<Sequence><Retry n='3'><Open door='{door}'/></Retry><Say/></Sequence>";

bool Has(const Drawing& drawing, const std::string& text) {
  return std::any_of(drawing.items.begin(), drawing.items.end(),
                     [&](const DrawnItem& item) { return item.text == text; });
}

// Boxes and texts that leave the paper.
std::size_t Outside(const Drawing& drawing) {
  std::size_t count = 0;
  for (const DrawnItem& item : drawing.items) {
    for (const Point& p : item.points) {
      count += p.x < 0 || p.y < 0 || p.x + item.width > drawing.size.x || p.y > drawing.size.y;
    }
  }
  return count;
}

TEST(TreePicture, WritesEveryNameKeyAndTitle) {
  PictureMaker maker(1, SharedFonts(1));
  ASSERT_EQ(maker.error(), "");
  const Painted painted(kTree, "Doors");
  const Drawing drawing = maker.Draw(painted.painting);
  for (const char* text : {"Doors", "Sequence", "Retry", "Open", "Say", "door", "{door}"}) {
    EXPECT_TRUE(Has(drawing, text)) << text;
  }
  EXPECT_EQ(Outside(drawing), 0U);
}

TEST(TreePicture, MakesRoomForATitleThatIsWiderThanItsTree) {
  PictureMaker maker(1, SharedFonts(1));
  const std::string title(200, 'W');
  const Painted painted("<A/>", title);
  EXPECT_EQ(Outside(maker.Draw(painted.painting)), 0U);
}

TEST(TreePicture, PutsTreesBelowEachOther) {
  PictureMaker maker(1, SharedFonts(1));
  Painted painted(kTree, "One");
  const float height = maker.Draw(painted.painting).size.y;
  painted.painting.trees.push_back({painted.scene.get(), "Two", nullptr});
  const Drawing two = maker.Draw(painted.painting);
  EXPECT_EQ(two.size.y, 2 * height);
  EXPECT_TRUE(Has(two, "Two"));
}

TEST(TreePicture, PaintsTheSamePixelsTwice) {
  const Painted painted(kTree, "Doors");
  PictureMaker one(2);
  PictureMaker other(2);
  const Image image = one.Paint(painted.painting);
  EXPECT_EQ(HashOf(image), HashOf(one.Paint(painted.painting)));
  EXPECT_EQ(HashOf(image), HashOf(other.Paint(painted.painting)));
}

TEST(TreePicture, HasSoManyPixelsAsAskedForAndNoMoreThanAllowed) {
  const Painted painted(kTree);
  PictureMaker maker(2, SharedFonts(2));
  const Drawing drawing = PictureMaker(1).Draw(painted.painting);
  const Image image = maker.Paint(painted.painting);
  EXPECT_NEAR(static_cast<float>(image.width), 2 * drawing.size.x, 10);
  const Image small = maker.Paint(painted.painting, 10000);
  EXPECT_LE(small.width * small.height, 10000);
  EXPECT_GT(small.width * small.height, 9000);
}

TEST(TreePicture, MarksChanges) {
  PictureMaker maker(1, SharedFonts(1));
  Painted painted("<A><B/></A>");
  const std::vector<Change> changes = {Change::kNone, Change::kAdded};
  painted.painting.trees[0].changes = &changes;
  EXPECT_TRUE(Has(maker.Draw(painted.painting), "+"));
}

TEST(TreePicture, LeavesTheContextOfOthersAlone) {
  ImGuiContext* context = ImGui::CreateContext();
  ImGui::SetCurrentContext(context);
  {
    PictureMaker maker(1, SharedFonts(1));
    maker.Draw(Painted("<A/>").painting);
    EXPECT_EQ(ImGui::GetCurrentContext(), context);
  }
  EXPECT_EQ(ImGui::GetCurrentContext(), context);
  ImGui::DestroyContext(context);
}

TEST(TreePicture, PaintsATreeOfTenThousandNodes) {
  std::string xml = "<A>";
  for (int i = 0; i < 2000; ++i) xml += "<B><C/><D x='1'/><E/><F/></B>";
  const Painted painted(xml + "</A>");
  PictureMaker maker(2, SharedFonts(2));
  const Image image = maker.Paint(painted.painting, 4e6);
  EXPECT_LE(image.width, 65500);
  EXPECT_GT(maker.Draw(painted.painting).items.size(), 50000U);
}

}  // namespace
}  // namespace coppice::editor
