#include "editor/live/values/port_values.h"

#include <gtest/gtest.h>

#include "tests/editor/driver.h"
#include "tests/editor/executed_source.h"

namespace coppice::editor {
namespace {

constexpr char kTrees[] = R"(<BehaviorTree ID="Main"><Sequence>
  <Script code="goal := 'lab'; left := 2.5"/>
  <Do as="{goal}"/>
  <SubTree ID="Inner" place="{goal}" count="7"/></Sequence></BehaviorTree>
<BehaviorTree ID="Inner"><Do as="{place}"/></BehaviorTree>)";

class PortValuesTest : public testing::Test {
 protected:
  PortValuesTest() {
    auto source = std::make_unique<ExecutedSource>("robot:1", kTrees);
    source_ = source.get();
    driver_.editor.AddRun(std::move(source));
    source_->tree.results["lab"] = Status::kRunning;
    source_->Ticks(1);
    driver_.Frames();
    values_.Look(run(), driver_.view().scene());
  }
  RunView& run() { return *driver_.editor.state().workspace.run(); }

  // Of that port of the node at that place.
  std::string Of(const std::string& path, std::string_view port) {
    const Scene& scene = *driver_.view().scene();
    const SceneNode& node = scene.nodes[scene.FindPath(path)];
    for (std::uint32_t i = 0; i < node.port_count; ++i) {
      if (scene.ports[node.first_port + i].name == port) return values_.Of(node.first_port + i);
    }
    return "no such port";
  }

  Driver driver_;
  ExecutedSource* source_ = nullptr;
  PortValues values_;
};

TEST_F(PortValuesTest, APortOfALeafShowsWhatItsKeyHolds) { EXPECT_EQ(Of("1.2", "as"), "lab"); }

TEST_F(PortValuesTest, SoDoesThePortOfASubTree) { EXPECT_EQ(Of("1.3", "place"), "lab"); }

TEST_F(PortValuesTest, AndAPortInsideOfItWhoseKeyHasAnotherName) {
  EXPECT_EQ(Of("1.3.1", "as"), "lab");
}

TEST_F(PortValuesTest, ALiteralStaysAsItIsWritten) { EXPECT_EQ(Of("1.3", "count"), ""); }

TEST_F(PortValuesTest, TheCanvasTakesThemFromTheShownTick) {
  source_->tree.results["lab"] = Status::kSuccess;
  source_->Ticks(2);
  driver_.Frames();
  driver_.Picture("port_values");
  values_.Look(run(), driver_.view().scene());
  EXPECT_EQ(Of("1.3.1", "as"), "lab");
}

}  // namespace
}  // namespace coppice::editor
