#include "editor/panels/widgets/panel.h"

#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(Panel, RegistersVisibleRowsOnly) {
  std::string xml = "<root BTCPP_format=\"4\"><BehaviorTree ID=\"T\"><Sequence>\n";
  for (int i = 0; i < 200; ++i) xml += "<AlwaysSuccess/>\n";
  const TemporaryFile file("long.xml", xml + "</Sequence></BehaviorTree></root>\n");
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  driver.OpenRow();
  const Box panel = driver.BoxOf("xml");
  int rows = 0;
  for (const auto& [path, box] : driver.editor.items().all()) {
    if (path.compare(0, 4, "xml/") != 0) continue;
    ++rows;
    EXPECT_TRUE(box.Overlaps(panel)) << path;
  }
  EXPECT_GT(rows, 3);
  EXPECT_LT(rows, 40);
}

TEST(Panel, CountsInWords) {
  EXPECT_EQ(Count(0, "node"), "0 nodes");
  EXPECT_EQ(Count(1, "node"), "1 node");
  EXPECT_EQ(Count(2, "node"), "2 nodes");
}

TEST(Panel, WritesTextOfAnXmlInOneLine) {
  EXPECT_EQ(InOneLine("  goes\n      there,\tslowly \n"), "goes there, slowly");
  EXPECT_EQ(InOneLine(""), "");
}

TEST(Panel, ASentenceThatIsTooLongGetsMoreLines) {
  Driver driver;
  ScriptedRobot* const robot = driver.AddRobot("robot:1", kLiveTree);
  robot->Disconnect("no answer");
  driver.Frames();
  const float one_line = driver.BoxOf("run/problem").height();
  robot->Disconnect("no answer, " + std::string(40, 'x') + " and " + std::string(40, 'y') +
                    " and then still nothing at all");
  driver.Frames();
  EXPECT_GT(driver.BoxOf("run/problem").height(), one_line + 8);
}

}  // namespace
}  // namespace coppice::editor
