#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(Xml, ScrollsToTheLineOfTheSelectedNodeAndMarksIt) {
  std::string xml = "<root BTCPP_format=\"4\"><BehaviorTree ID=\"T\"><Sequence>\n";
  for (int i = 0; i < 200; ++i) xml += "<AlwaysSuccess/>\n";
  const TemporaryFile file("long.xml", xml + "</Sequence></BehaviorTree></root>\n");
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  EXPECT_FALSE(driver.Has("xml/151"));
  driver.view().Select(driver.view().scene()->FindPath("1.150"));
  driver.Frames();
  ASSERT_TRUE(driver.Has("xml/151"));
  const Box row = driver.BoxOf("xml/151");
  const Box edge = {row.min, {row.min.x + 3, row.max.y}};
  const Color accent = GetPalette(PaletteName::kDark).accent;
  EXPECT_GT(driver.CountColor(edge, accent, 4), 30);
  const Box other = driver.BoxOf("xml/152");
  EXPECT_EQ(driver.CountColor({other.min, {other.min.x + 3, other.max.y}}, accent, 4), 0);
}

}  // namespace
}  // namespace coppice::editor
