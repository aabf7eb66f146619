#include "editor/canvas/tree_view.h"

#include <gtest/gtest.h>

#include "tests/editor/canvas/make_scene.h"

namespace coppice::editor {
namespace {

class TreeViewTest : public testing::Test {
 protected:
  TreeViewTest() {
    auto scene = MakeScene("<A><B><C/><D/></B><E><F/></E></A>");
    view_.SetScene(scene, SameSize, 0);
  }
  TreeView view_;
};

TEST_F(TreeViewTest, HidesWhatIsBelowACollapsedNode) {
  view_.SetCollapsed(1, true, 1);
  EXPECT_EQ(view_.shown(), (std::vector<std::uint32_t>{0, 1, 4, 5}));
  EXPECT_EQ(view_.shown_ends(), (std::vector<std::uint32_t>{4, 2, 4, 4}));
  EXPECT_EQ(view_.ShownOf(3), 1U);
  view_.SetCollapsed(1, false, 2);
  EXPECT_EQ(view_.shown().size(), 6U);
}

TEST_F(TreeViewTest, DoesNotCollapseLeaves) {
  view_.SetCollapsed(2, true, 1);
  EXPECT_FALSE(view_.IsCollapsed(2));
}

TEST_F(TreeViewTest, KeepsTheCollapsedNodeWhereItIsOnTheScreen) {
  view_.FitAll({800, 600});
  const Point before = view_.camera.ToScreen(view_.BoxAt(1, 5).min);
  view_.SetCollapsed(1, true, 5);
  for (const double now : {5.0, 5.05, 5.1, 6.0}) {
    const Point after = view_.camera.ToScreen(view_.BoxAt(1, now).min);
    EXPECT_NEAR(after.x, before.x, 0.01) << now;
    EXPECT_NEAR(after.y, before.y, 0.01) << now;
  }
}

TEST_F(TreeViewTest, MovesTheOtherNodesSmoothlyToTheirPlaces) {
  view_.FitAll({800, 600});
  const Point before = view_.camera.ToScreen(view_.BoxAt(4, 5).min);
  view_.SetCollapsed(1, true, 5);
  EXPECT_TRUE(view_.IsMoving(5.01));
  const Point first = view_.camera.ToScreen(view_.BoxAt(2, 5).min);
  EXPECT_NEAR(first.x, before.x, 0.01);
  const float half = view_.camera.ToScreen(view_.BoxAt(2, 5.05).min).x;
  const float end = view_.camera.ToScreen(view_.BoxAt(2, 9).min).x;
  EXPECT_LT(end, half);
  EXPECT_LT(half, before.x);
  EXPECT_FALSE(view_.IsMoving(5.2));
}

TEST_F(TreeViewTest, LetsNewNodesComeOutOfTheirParent) {
  view_.SetCollapsed(1, true, 1);
  const Point parent = view_.BoxAt(1, 5).min;
  const Point screen = view_.camera.ToScreen(parent);
  view_.SetCollapsed(1, false, 5);
  const Point child = view_.camera.ToScreen(view_.BoxAt(2, 5).min);
  EXPECT_NEAR(child.x, screen.x, 0.01);
  EXPECT_NEAR(child.y, screen.y, 0.01);
}

TEST_F(TreeViewTest, OpensWhatHidesTheSelection) {
  view_.SetCollapsed(0, true, 1);
  view_.Select(3);
  EXPECT_FALSE(view_.IsCollapsed(0));
  EXPECT_EQ(view_.selected(), 3U);
}

TEST_F(TreeViewTest, KeepsSelectionAndCollapsedNodesInAnotherVersion) {
  view_.Select(5);
  view_.SetCollapsed(1, true, 1);
  auto scene = MakeScene("<A><B><C/></B><E><F/></E></A>");
  view_.SetScene(scene, SameSize, 2);
  EXPECT_TRUE(view_.IsCollapsed(1));
  EXPECT_EQ(scene->nodes[view_.selected()].path, "1.2.1");
}

TEST_F(TreeViewTest, MovesTheNodesOfAnotherVersionToTheirNewPlaces) {
  view_.FitAll({800, 600});
  view_.Select(3);
  const Point before = view_.camera.ToScreen(view_.BoxAt(3, 5).min);
  const Point sibling = view_.camera.ToScreen(view_.BoxAt(5, 5).min);
  auto scene = MakeScene("<A><New/><B><C/><D/></B><E><F/></E></A>");
  view_.SetScene(scene, SameSize, 5);
  EXPECT_EQ(scene->nodes[view_.selected()].path, "1.2.2");
  for (const double now : {5.0, 5.1, 9.0}) {
    const Point after =
        view_.camera.ToScreen(view_.BoxAt(view_.ShownOf(view_.selected()), now).min);
    EXPECT_NEAR(after.x, before.x, 0.01) << "the selected node is the anchor";
    EXPECT_NEAR(after.y, before.y, 0.01);
  }
  EXPECT_NEAR(view_.camera.ToScreen(view_.BoxAt(6, 5).min).x, sibling.x, 0.01);
}

TEST_F(TreeViewTest, JumpsWhenNotAnimated) {
  view_.animated = false;
  view_.SetCollapsed(1, true, 5);
  EXPECT_FALSE(view_.IsMoving(5));
}

TEST_F(TreeViewTest, AddsToTheSelectionAndTakesOut) {
  view_.Select(2);
  view_.ToggleSelected(5);
  EXPECT_EQ(view_.selection(), (std::vector<std::uint32_t>{2, 5}));
  EXPECT_EQ(view_.selected(), 5U);
  view_.ToggleSelected(5);
  EXPECT_EQ(view_.selection(), std::vector<std::uint32_t>{2});
  EXPECT_EQ(view_.selected(), 2U);
  view_.ToggleSelected(2);
  EXPECT_EQ(view_.selected(), kNoSceneNode);
}

TEST_F(TreeViewTest, SelectsSiblingsUpToTheOneThatIsShiftClicked) {
  view_.Select(4);
  view_.SelectTo(1);
  EXPECT_EQ(view_.selection(), (std::vector<std::uint32_t>{1, 4}));
  view_.Select(2);
  view_.SelectTo(5);
  EXPECT_EQ(view_.selection(), (std::vector<std::uint32_t>{2, 3, 4, 5}));
}

TEST_F(TreeViewTest, KeepsTheSelectedNodesThatAreStillThere) {
  view_.SelectAll({2, 3, 5});
  auto scene = MakeScene("<A><B><C/></B><E><F/></E></A>");
  view_.SetScene(scene, SameSize, 2);
  EXPECT_EQ(view_.selection(), (std::vector<std::uint32_t>{2, 4}));
}

TEST_F(TreeViewTest, CollapsesWhatDoesNotHoldTheSelection) {
  view_.Select(2);
  view_.CollapseOthers(1);
  EXPECT_EQ(view_.shown(), (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
  view_.OpenAll(2);
  EXPECT_EQ(view_.shown().size(), 6U);
}

TEST_F(TreeViewTest, FitsAllIntoTheCanvas) {
  view_.FitAll({300, 200});
  const Box box = view_.camera.ToScreen(view_.bounds());
  EXPECT_GE(box.min.x, 0);
  EXPECT_GE(box.min.y, 0);
  EXPECT_LE(box.max.x, 300);
  EXPECT_LE(box.max.y, 200);
  EXPECT_FALSE(view_.needs_fit);
}

TEST_F(TreeViewTest, StaysFittedWhenTheCanvasChangesItsSize) {
  view_.PlaceIn({{100, 50}, {900, 650}});
  view_.PlaceIn({{300, 50}, {700, 300}});
  TreeView fitted = view_;
  fitted.FitAll({400, 250});
  EXPECT_EQ(view_.camera, fitted.camera);
  view_.PlaceIn({{100, 50}, {900, 650}});
  fitted.FitAll({800, 600});
  EXPECT_EQ(view_.camera, fitted.camera);
}

TEST_F(TreeViewTest, LeavesTheNodesWhereTheyAreOnTheScreenOnceTheUserHasMovedThem) {
  view_.PlaceIn({{100, 50}, {900, 650}});
  view_.ZoomAt({10, 10}, 1.2F);
  const Camera before = view_.camera;
  view_.PlaceIn({{300, 80}, {700, 300}});
  EXPECT_EQ(view_.camera.zoom, before.zoom);
  EXPECT_EQ(view_.camera.offset + Point({300, 80}), before.offset + Point({100, 50}));
  view_.FitAll({400, 220});
  view_.PlaceIn({{300, 80}, {800, 600}});
  TreeView fitted = view_;
  fitted.FitAll({500, 520});
  EXPECT_EQ(view_.camera, fitted.camera) << "fitted again";
}

TEST_F(TreeViewTest, GivesWayToABarAboveTheCanvasWithoutAJump) {
  view_.PlaceIn({{0, 0}, {800, 300}});
  const Camera before = view_.camera;
  const auto is_whole = [&](float top) {
    const Box tree = view_.camera.ToScreen(view_.bounds());
    return tree.min.y >= 0 && tree.max.y <= 300 - top;
  };
  view_.PlaceIn({{0, 26}, {800, 300}});
  EXPECT_TRUE(is_whole(26));
  EXPECT_EQ(view_.camera.zoom, before.zoom);
  EXPECT_NEAR(view_.camera.offset.y + 26, before.offset.y, 12) << "a few pixels on the screen";
  view_.PlaceIn({{0, 150}, {800, 300}});
  EXPECT_TRUE(is_whole(150)) << "there it must be smaller";
  EXPECT_LT(view_.camera.zoom, before.zoom);
  view_.PlaceIn({{0, 0}, {800, 300}});
  EXPECT_EQ(view_.camera, before);
}

TEST_F(TreeViewTest, LeavesABigTreeAloneThatWasOpenedBeyondTheCanvas) {
  view_.SetCollapsed(0, true, 1);
  view_.PlaceIn({{0, 0}, {200, 120}});
  view_.SetCollapsed(0, false, 2);
  const Camera before = view_.camera;
  view_.PlaceIn({{0, 26}, {200, 120}});
  EXPECT_EQ(view_.camera.zoom, before.zoom) << "a bar that a click has brought does not zoom";
  EXPECT_EQ(view_.camera.offset.y + 26, before.offset.y);
}

TEST_F(TreeViewTest, StaysFittedWhenTheTreeChanges) {
  view_.PlaceIn({{0, 0}, {800, 300}});
  view_.SetCollapsed(4, true, 1);
  view_.PlaceIn({{0, 0}, {600, 200}});
  const Box tree = view_.camera.ToScreen(view_.bounds());
  EXPECT_TRUE((Box{{0, 0}, {600, 200}}).Contains(tree.min));
  EXPECT_TRUE((Box{{0, 0}, {600, 200}}).Contains(tree.max));
}

TEST_F(TreeViewTest, ZoomsAroundThePointUnderTheMouse) {
  view_.FitAll({800, 600});
  const Point world = view_.camera.ToWorld({200, 100});
  view_.ZoomAt({200, 100}, 1.7F);
  EXPECT_NEAR(view_.camera.ToScreen(world).x, 200, 0.01);
  EXPECT_NEAR(view_.camera.ToScreen(world).y, 100, 0.01);
}

TEST_F(TreeViewTest, RevealsASelectionThatIsOutOfSight) {
  view_.camera.offset = {5000, 5000};
  view_.Select(2);
  view_.Reveal({800, 600});
  const Box box = view_.camera.ToScreen(view_.BoxAt(view_.ShownOf(2), 9));
  EXPECT_TRUE((Box{{0, 0}, {800, 600}}).Contains(box.min));
  EXPECT_TRUE((Box{{0, 0}, {800, 600}}).Contains(box.max));
}

TEST_F(TreeViewTest, ComesCloseEnoughToReadWhatItReveals) {
  view_.FitAll({800, 600});
  view_.ZoomAt({0, 0}, 0.1F);
  view_.Select(2);
  view_.RevealReadable({800, 600});
  EXPECT_GE(view_.camera.zoom, kReadablePorts);
  const Box box = view_.camera.ToScreen(view_.BoxAt(view_.ShownOf(2), 9));
  EXPECT_NEAR(box.center().x, 400, 1);
  const Camera before = view_.camera;
  view_.Select(3);
  view_.RevealReadable({800, 600});
  EXPECT_EQ(view_.camera.zoom, before.zoom) << "that can be read";
}

TEST_F(TreeViewTest, ComesCloseToANodeBeforeItWasEverShown) {
  view_.Select(5);
  view_.RevealReadable({200, 100});
  const Camera before = view_.camera;
  EXPECT_GE(before.zoom, view_.names_only() ? kReadableNames : kReadablePorts);
  view_.PlaceIn({{0, 0}, {200, 100}});
  EXPECT_EQ(view_.camera, before);
}

TEST_F(TreeViewTest, TurnsTheTreeOnItsSide) {
  LayoutStyle style;
  style.growth = Growth::kAcross;
  view_.SetStyle(style, 1);
  EXPECT_GT(view_.BoxAt(1, 9).min.x, view_.BoxAt(0, 9).max.x);
}

// Of nodes that are large with their ports and small with their names alone.
class PortsTest : public testing::Test {
 protected:
  void Show(int branches) {
    std::string xml = "<A>";
    for (int i = 0; i < branches; ++i) xml += "<B><C/><D/><E/></B>";
    view_.SetScene(
        MakeScene(xml + "</A>"),
        [](const Scene&, const SceneNode&) {
          return NodeSizes({220, 120}, {100, 26});
        },
        0);
    view_.FitAll(kCanvas);
  }
  void SetPorts(ShownPorts ports) {
    LayoutStyle style = view_.style();
    style.ports = ports;
    view_.SetStyle(style, 0);
    view_.FitAll(kCanvas);
  }

  static constexpr Point kCanvas{730, 540};
  TreeView view_;
};

TEST_F(PortsTest, AreShownWhereTheyCanBeRead) {
  Show(1);
  EXPECT_FALSE(view_.names_only());
  EXPECT_EQ(view_.BoxAt(0, 1).height(), 120);
}

TEST_F(PortsTest, GiveWayToNamesThatAreLarger) {
  Show(12);
  EXPECT_TRUE(view_.names_only());
  EXPECT_EQ(view_.BoxAt(0, 1).height(), 26);
  const float with_names = view_.camera.zoom;
  SetPorts(ShownPorts::kAll);
  EXPECT_GT(with_names, view_.camera.zoom * 1.8F);
}

TEST_F(PortsTest, AreAsTheUserSaysWhateverTheSize) {
  Show(1);
  SetPorts(ShownPorts::kNone);
  EXPECT_TRUE(view_.names_only());
  SetPorts(ShownPorts::kByItself);
  EXPECT_FALSE(view_.names_only());
}

TEST_F(PortsTest, ComeBackInTheRowsThatTheyHadBefore) {
  Show(12);
  SetPorts(ShownPorts::kAll);
  const Box before = view_.bounds();
  SetPorts(ShownPorts::kNone);
  SetPorts(ShownPorts::kAll);
  EXPECT_EQ(view_.bounds(), before);
}

// Five branches of three leaves are 1 600 pixels side by side, but not below each other.
TEST_F(PortsTest, ATreeOfNamesIsTurnedWhereItIsFarLargerThen) {
  Show(5);
  ASSERT_TRUE(view_.names_only());
  EXPECT_EQ(view_.orientation(), Orientation::kLeftToRight);
  EXPECT_GT(view_.camera.zoom, 0.7F);
}

class FirstLook : public PortsTest {};

TEST_F(FirstLook, ShowsTheTopOfATreeThatCannotBeReadAsAWhole) {
  Show(200);
  view_.needs_fit = true;
  view_.PlaceIn({{0, 0}, kCanvas});
  EXPECT_NEAR(view_.camera.zoom, kReadableNames, 0.001F);
  const Box root = view_.camera.ToScreen(view_.BoxAt(0, 1));
  EXPECT_TRUE((Box{{0, 0}, kCanvas}).Contains(root.min));
  const Box all = view_.camera.ToScreen(view_.bounds());
  EXPECT_LE(all.max.x, kCanvas.x) << "the rest is below it";
  EXPECT_GT(all.max.y, kCanvas.y);
}

TEST_F(FirstLook, IsKeptWhenTheCanvasChanges) {
  Show(200);
  view_.needs_fit = true;
  view_.PlaceIn({{0, 0}, kCanvas});
  view_.PlaceIn({{0, 0}, kCanvas + Point{200, 0}});
  EXPECT_NEAR(view_.camera.zoom, kReadableNames, 0.001F);
  EXPECT_GT(view_.bounds().width() * kReadableNames, kCanvas.x * 0.8F) << "broken anew";
}

TEST_F(FirstLook, ComesAgainWithAStyleThatAsksForAnotherLayout) {
  Show(200);
  view_.PlaceIn({{0, 0}, kCanvas});
  ASSERT_TRUE(view_.in_rows());
  LayoutStyle style;
  for (const bool wrapped : {false, true}) {
    style.wrapped = wrapped;
    view_.SetStyle(style, 1);
    view_.PlaceIn({{0, 0}, kCanvas});
    EXPECT_EQ(view_.in_rows(), wrapped);
  }
}

TEST_F(FirstLook, FitShowsAllOfItNevertheless) {
  Show(200);
  view_.FitAll(kCanvas);
  EXPECT_LE(view_.camera.ToScreen(view_.bounds()).max.y, kCanvas.y);
  view_.PlaceIn({{0, 0}, kCanvas});
  EXPECT_LE(view_.camera.ToScreen(view_.bounds()).max.y, kCanvas.y) << "and stays so";
}

}  // namespace
}  // namespace coppice::editor
