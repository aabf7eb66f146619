#include "editor/live/run_summary.h"

#include <gtest/gtest.h>

#include "tests/editor/executed_source.h"

namespace coppice::editor {
namespace {

TEST(RunSummary, TellsTheNewestTickOfARecordByItsOwnNumberAlthoughAHaltIsAnEntryToo) {
  Driver driver;
  auto source = std::make_unique<ExecutedSource>("a.coppice", kDoorTrees, false);
  source->tree.results["drive"] = Status::kRunning;
  source->Ticks(20);
  source->tree.executor.Halt();
  driver.editor.AddRun(std::move(source));
  driver.Frames();
  const RunView& run = *driver.editor.state().workspace.run();
  EXPECT_EQ(run.run().size(), 21U);
  EXPECT_EQ(SummaryOf(run), "record   tick 20");
}

}  // namespace
}  // namespace coppice::editor
