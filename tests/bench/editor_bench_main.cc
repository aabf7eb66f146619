// What the editor costs with large files.
//
//   coppice_editor_bench
//
//   FrameOf20000Nodes   build of one frame, without painting it
//   LayoutOf10000Nodes  boxes of all nodes from their sizes
//   OpenOneMegabyte     read, parse, measure and lay out 10 000 nodes; the checker follows later
//   UndoInOneMegabyte   from the key to where the next frame can be built; mean of undo and redo
//   UndoFarBack         one step after the other, beyond those whose documents are kept
//   FrameAfterUndo      that frame, while the nodes glide to their places
#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "editor/canvas/layout/tree_layout.h"
#include "editor/workspace/tree_editor.h"
#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

constexpr int kNodesOfAMegabyte = 10000;

// A Sequence of Fallbacks with seven leaves each; a line is about 100 bytes long.
std::string LargeFile(int nodes) {
  std::string text =
      "<root BTCPP_format=\"4\" main_tree_to_execute=\"Main\">\n<BehaviorTree ID=\"Main\">\n"
      "<Sequence>\n";
  for (int i = 1; i < nodes; ++i) {
    const std::string number = std::to_string(i);
    if (i % 8 == 1) {
      if (i > 1) text += "  </Fallback>\n";
      text += "  <Fallback name=\"choice " + number + "\">\n";
    } else {
      text += "    <DriveTo name=\"to place " + number + R"(" goal="{goal_)" +
              std::to_string(i % 50) + R"(}" speed="0.)" + std::to_string(i % 9) +
              R"(" timeout_ms=")" + number + "\" frame=\"map\" retries=\"3\"/>\n";
    }
  }
  return text +
         "  </Fallback>\n</Sequence>\n</BehaviorTree>\n<TreeNodesModel>\n"
         R"(<Action ID="DriveTo"><input_port name="goal" type="string"/>)"
         R"(<input_port name="speed" type="double"/><input_port name="timeout_ms" )"
         R"(type="int"/><input_port name="frame" type="string"/>)"
         "<input_port name=\"retries\" type=\"int\"/></Action>\n</TreeNodesModel>\n</root>\n";
}

// An editor with that file, in which some values were changed, one step each.
class Opened {
 public:
  Opened(int nodes, int steps) : file_("large.xml", LargeFile(nodes)) {
    driver_.editor.Open(file_.path());
    driver_.Frames(20);  // the checker has spoken
    for (int i = 0; i < steps; ++i) {
      driver_.view().Select(static_cast<std::uint32_t>(nodes / 2 + i));
      Edit().SetValue("name", "another name " + std::to_string(i));
      driver_.Frames(20);
    }
  }

  TreeEditor Edit() { return {driver_.editor.state(), driver_.editor.now()}; }
  Driver& driver() { return driver_; }

 private:
  TemporaryFile file_;
  Driver driver_;
};

void FrameOf20000Nodes(benchmark::State& state) {
  Opened opened(20000, 0);
  opened.driver().view().camera.zoom = 0.7F;  // every node in sight is painted in full
  for (auto _ : state) opened.driver().editor.Frame(opened.driver().input);
}
BENCHMARK(FrameOf20000Nodes)->Unit(benchmark::kMillisecond);

void LayoutOf10000Nodes(benchmark::State& state) {
  Opened opened(kNodesOfAMegabyte, 0);
  const TreeView& view = opened.driver().view();
  std::vector<Point> sizes;
  for (std::uint32_t k = 0; k < view.shown().size(); ++k) {
    const Box box = view.BoxAt(k, opened.driver().editor.now());
    sizes.push_back(box.max - box.min);
  }
  const std::vector<bool> is_decorator(sizes.size(), false);
  for (auto _ : state) {
    benchmark::DoNotOptimize(Arrange(view.shown_ends(), sizes, is_decorator, view.style()));
  }
}
BENCHMARK(LayoutOf10000Nodes)->Unit(benchmark::kMillisecond);

void OpenOneMegabyte(benchmark::State& state) {
  const TemporaryFile file("large.xml", LargeFile(kNodesOfAMegabyte));
  for (auto _ : state) {
    state.PauseTiming();
    auto driver = std::make_unique<Driver>();
    driver->Frames();
    state.ResumeTiming();
    driver->editor.Open(file.path());
    state.PauseTiming();
    driver.reset();
    state.ResumeTiming();
  }
}
BENCHMARK(OpenOneMegabyte)->Unit(benchmark::kMillisecond);

void UndoInOneMegabyte(benchmark::State& state) {
  Opened opened(kNodesOfAMegabyte, 1);
  bool undone = false;
  for (auto _ : state) {
    undone ? opened.Edit().Redo() : opened.Edit().Undo();
    undone = !undone;
    state.PauseTiming();
    opened.driver().Frames(20);
    state.ResumeTiming();
  }
}
BENCHMARK(UndoInOneMegabyte)->Unit(benchmark::kMillisecond);

void UndoFarBack(benchmark::State& state) {
  constexpr int kSteps = 60;
  Opened opened(kNodesOfAMegabyte, kSteps);
  int left = kSteps;
  for (auto _ : state) {
    opened.Edit().Undo();
    state.PauseTiming();
    if (--left == 0) {
      for (; left < kSteps; ++left) opened.Edit().Redo();
    }
    opened.driver().Frames(20);
    state.ResumeTiming();
  }
}
BENCHMARK(UndoFarBack)->Unit(benchmark::kMillisecond)->Iterations(50);

void FrameAfterUndo(benchmark::State& state) {
  Opened opened(kNodesOfAMegabyte, 1);
  bool undone = false;
  for (auto _ : state) {
    state.PauseTiming();
    opened.driver().Frames(20);
    undone ? opened.Edit().Redo() : opened.Edit().Undo();
    undone = !undone;
    state.ResumeTiming();
    opened.driver().editor.Frame(opened.driver().input);
  }
}
BENCHMARK(FrameAfterUndo)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace coppice::editor

BENCHMARK_MAIN();
