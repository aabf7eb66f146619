#include "editor/canvas/free_place.h"

#include <gtest/gtest.h>

#include "tests/editor/canvas/make_scene.h"

namespace coppice::editor {
namespace {

constexpr Box kCanvas = {{0, 0}, {1000, 600}};
constexpr Box kNode = {{400, 250}, {520, 300}};
constexpr Point kSize = {200, 20};
constexpr float kGap = 6;

Box Place(const Box& node, const std::vector<Box>& others) {
  return FreePlaceBeside(node, kSize, kGap, kCanvas, others);
}

TEST(FreePlace, IsBelowTheNodeIfNothingIsThere) {
  const Box box = Place(kNode, {});
  EXPECT_EQ(box.min.y, kNode.max.y + kGap);
  EXPECT_EQ(box.center().x, kNode.center().x);
  EXPECT_EQ(box.width(), kSize.x);
}

TEST(FreePlace, IsAboveItIfItsChildrenAreBelow) {
  const Box box = Place(kNode, {{{300, 310}, {600, 360}}});
  EXPECT_EQ(box.max.y, kNode.min.y - kGap);
}

TEST(FreePlace, IsBesideItBetweenParentAndChildren) {
  const Box parent = {{300, 200}, {600, 248}};
  const Box child = {{300, 302}, {600, 360}};
  const Box box = Place(kNode, {parent, child});
  EXPECT_EQ(box.min.x, kNode.max.x + kGap);
  EXPECT_FALSE(box.Overlaps(parent) || box.Overlaps(child));
}

TEST(FreePlace, HidesAsLittleAsPossible) {
  const std::vector<Box> all_around = {{{300, 302}, {700, 360}},
                                       {{300, 190}, {700, 230}},
                                       {{522, 250}, {900, 300}},
                                       {{100, 250}, {398, 300}}};
  EXPECT_EQ(Place(kNode, all_around).max.y, kNode.min.y - kGap) << "a part of it is free";
}

TEST(FreePlace, StaysInsideOfTheCanvas) {
  for (const Point at : {Point{-50, -20}, {960, 580}, {-50, 580}, {960, -20}}) {
    const Box box = Place({at, at + Point{90, 40}}, {});
    EXPECT_GE(box.min.x, kCanvas.min.x + kGap);
    EXPECT_GE(box.min.y, kCanvas.min.y + kGap);
    EXPECT_LE(box.max.x, kCanvas.max.x - kGap);
    EXPECT_LE(box.max.y, kCanvas.max.y - kGap);
  }
}

TEST(FreePlace, OfAViewKeepsClearOfItsOtherNodes) {
  TreeView view;
  view.SetScene(MakeScene("<A><B/><C><D/></C></A>"), SameSize, 0);
  view.FitAll({1000, 600});
  const auto c = view.ShownOf(view.scene()->FindPath("1.2"));
  const Box box = FreePlaceBeside(view, c, {80, 10}, kGap, kCanvas, 9);
  for (std::uint32_t k = 0; k < view.shown().size(); ++k) {
    EXPECT_FALSE(box.Overlaps(view.camera.ToScreen(view.BoxAt(k, 9)))) << k;
  }
}

}  // namespace
}  // namespace coppice::editor
