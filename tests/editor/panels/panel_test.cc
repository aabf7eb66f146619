#include "editor/panels/panel.h"

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

}  // namespace
}  // namespace coppice::editor
