// What the editor costs with large files.
//
//   coppice_editor_bench
//
//   FirstFrame          from an editor with no fonts to its first frame with a file; the window and
//                       its OpenGL come on top of it, while the fonts are baked
//   FrameOf20000Nodes   build of one frame, without painting it
//   LayoutOf10000Nodes  boxes of all nodes from their sizes
//   OpenOneMegabyte     read, parse, measure and lay out 10 000 nodes; the checker follows later
//   UndoInOneMegabyte   from the key to where the next frame can be built; mean of undo and redo
//   UndoFarBack         one step after the other, beyond those whose documents are kept
//   FrameAfterUndo      that frame, while the nodes glide to their places
//   FrameOfLargeValues  of a live tree whose 20 leaves read a key of 5 MB, with one of them in the
//                       inspector; 1: a text, 2: JSON; and when it was written anew
//   FrameOfLargePorts   of a file in which a port of the selected leaf has 5 MB; 1: the mouse is on
//   FrameOf50Robots     each runs a tree of 200 nodes and sends a tick in every other frame
//   FirstFrameOf        that of a file with 1: letters of Europe, 2: 100 Chinese characters; as a
//                       window begins, which knows them before
//   FirstLook           opens every tree with at most 80 nodes of a folder, --trees=FOLDER, else of
//                       the project's own: which part of their names can be read as they open in a
//                       window of 1280 x 800, and at which zoom
#include <benchmark/benchmark.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
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

void FirstFrame(benchmark::State& state) {
  const TemporaryFile file("small.xml", kSmallFile);
  for (auto _ : state) {
    Editor editor({});
    editor.Open(file.path());
    editor.Frame({});
  }
}
BENCHMARK(FirstFrame)->Unit(benchmark::kMillisecond);

void FrameOf20000Nodes(benchmark::State& state) {
  Opened opened(20000, 0);
  opened.driver().view().camera.zoom = 0.7F;  // every node in sight is painted in full
  for (auto _ : state) opened.driver().editor.Frame(opened.driver().input);
}
BENCHMARK(FrameOf20000Nodes)->Unit(benchmark::kMillisecond);

void LayoutOf10000Nodes(benchmark::State& state) {
  Opened opened(kNodesOfAMegabyte, 0);
  const TreeView& view = opened.driver().view();
  MeasuredTree tree;
  tree.ends = view.shown_ends();
  for (std::uint32_t k = 0; k < view.shown().size(); ++k) {
    const Box box = view.BoxAt(k, opened.driver().editor.now());
    tree.sizes.emplace_back(box.max - box.min);
  }
  tree.is_decorator.assign(tree.sizes.size(), false);
  for (auto _ : state) benchmark::DoNotOptimize(Arrange(tree, view.style(), {}));
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

constexpr std::size_t kLargeValue = 5 << 20;

std::string LargeValue(bool is_json) {
  if (!is_json) return std::string(kLargeValue, 'x');
  std::string text = "[";
  while (text.size() < kLargeValue) text += R"({"room": "laboratory", "x": 1.5, "y": 2.25},)";
  text.back() = ']';
  return text;
}

// As robots send it.
std::string ReadersOfAKey() {
  std::string leaves;
  for (int i = 0; i < 20; ++i) {
    leaves += "<Use name=\"use\" map=\"{map}\" _uid=\"" + std::to_string(i + 2) + "\"/>";
  }
  return R"(<root BTCPP_format="4"><BehaviorTree ID="Main" _fullpath=""><Sequence _uid="1">)" +
         leaves + "</Sequence></BehaviorTree></root>";
}

void FrameOfLargeValues(benchmark::State& state) {
  Driver driver;
  ScriptedRobot* const robot = driver.AddRobot("robot:1", ReadersOfAKey());
  const std::string value = LargeValue(state.range(0) == 2);
  const bool is_written = state.range(1) != 0;
  robot->Write("Main", "map", value);
  driver.Frames(4);
  driver.view().Select(3);
  driver.Frames(20);
  for (auto _ : state) {
    state.PauseTiming();
    if (is_written) robot->Write("Main", "map", value + " ");
    state.ResumeTiming();
    driver.editor.Frame(driver.input);
  }
}
BENCHMARK(FrameOfLargeValues)
    ->Unit(benchmark::kMillisecond)
    ->ArgsProduct({{1, 2}, {0, 1}})
    ->ArgNames({"kind", "written"})
    ->Iterations(60);

void FrameOfLargePorts(benchmark::State& state) {
  const TemporaryFile file("ports.xml",
                           R"(<root BTCPP_format="4"><BehaviorTree ID="Main"><Sequence>)"
                           "<Use map=\"" +
                               LargeValue(false) + "\"/><Use map=\"" + LargeValue(false) +
                               "\"/></Sequence></BehaviorTree></root>");
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames(4);
  driver.view().Select(1);
  if (state.range(0) != 0) driver.MoveTo(driver.BoxOf("canvas/Main/1.1").center());
  driver.Frames(80);
  for (auto _ : state) driver.editor.Frame(driver.input);
}
BENCHMARK(FrameOfLargePorts)
    ->Unit(benchmark::kMillisecond)
    ->Arg(0)
    ->Arg(1)
    ->ArgName("mouse")
    ->Iterations(60);

// A tree of 200 leaves, as robots send it.
std::string TreeOfARobot() {
  std::string leaves;
  for (int i = 2; i <= 200; ++i) {
    leaves += "<Use name=\"use\" _uid=\"" + std::to_string(i) + "\"/>";
  }
  return R"(<root BTCPP_format="4"><BehaviorTree ID="Main" _fullpath=""><Sequence _uid="1">)" +
         leaves + "</Sequence></BehaviorTree></root>";
}

void FrameOf50Robots(benchmark::State& state) {
  Driver driver;
  std::vector<ScriptedRobot*> robots;
  for (int i = 1; i <= 50; ++i) {
    robots.push_back(driver.AddRobot("robot-" + std::to_string(i) + ":1667", TreeOfARobot()));
  }
  driver.editor.state().run.tab = RunTab::kRobots;
  driver.Frames(20);
  std::uint32_t frame = 0;
  for (auto _ : state) {
    state.PauseTiming();
    ++frame;
    for (std::size_t i = frame % 2; i < robots.size(); i += 2) {
      EventWriter words;
      const NodeIndex node(1 + frame % 199);
      words.Status(node, Status::kRunning);
      words.Status(node, Status::kSuccess);
      words.Reset(node);
      robots[i]->Tick(words.words());
    }
    state.ResumeTiming();
    driver.editor.Frame(driver.input);
  }
}
BENCHMARK(FrameOf50Robots)->Unit(benchmark::kMillisecond)->Iterations(300);

void FirstFrameOf(benchmark::State& state) {
  std::string name = "Tür Ждать";
  if (state.range(0) == 2) {
    for (int i = 0; i < 100; ++i)
      name += {'\xE6', static_cast<char>(0x88 + i / 64), static_cast<char>(0x80 + i % 64)};
  }
  std::string text = kSmallFile;
  text.replace(text.find("round"), 5, name);
  const TemporaryFile file("small.xml", text);
  for (auto _ : state) {
    EditorOptions options;
    options.fonts = std::make_shared<const Fonts>(1, UnusualCharacters(text));
    Editor editor(std::move(options));
    editor.Open(file.path());
    editor.Frame({});
  }
}
BENCHMARK(FirstFrameOf)->Unit(benchmark::kMillisecond)->Arg(1)->Arg(2)->ArgName("kind");

constexpr std::uint32_t kSmallTree = 80;  // nodes
std::string trees_folder = "trees";

// What can be read of the tree that is shown: whole nodes, with names of 9 pixels or more.
struct Look {
  std::size_t nodes = 0;
  std::size_t readable = 0;
  float zoom = 0;
};

Look LookAt(Driver& driver) {
  Look look;
  const TreeView& view = driver.view();
  const Point size = driver.editor.state().screen.canvas_size;
  const Box canvas = {{0, 0}, size};
  const bool large = view.camera.zoom >= (view.names_only() ? kReadableNames : kReadablePorts);
  look.nodes = view.shown().size();
  look.zoom = view.camera.zoom;
  for (std::uint32_t k = 0; k < look.nodes; ++k) {
    const Box box = view.camera.ToScreen(view.BoxAt(k, 1e9));
    if (large && canvas.Contains(box.min) && canvas.Contains(box.max)) ++look.readable;
  }
  return look;
}

std::vector<std::string> FilesWithTrees() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(trees_folder)) {
    if (entry.path().extension() == ".xml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

void FirstLook(benchmark::State& state) {
  const std::vector<std::string> files = FilesWithTrees();
  std::size_t nodes = 0;
  std::size_t readable = 0;
  std::vector<float> zooms;
  for (auto _ : state) {
    for (const std::string& file : files) {
      Driver driver;
      driver.editor.Open(file);
      driver.Frames(3);
      const TreeView* const view = driver.editor.state().workspace.view();
      if (!view || view->shown().empty() || view->shown().size() > kSmallTree) continue;
      const Look look = LookAt(driver);
      nodes += look.nodes;
      readable += look.readable;
      zooms.push_back(look.zoom);
      if (look.readable < look.nodes) {
        std::cout << "cannot be read as a whole: " << file << ", " << look.nodes << " nodes\n";
      }
    }
  }
  std::sort(zooms.begin(), zooms.end());
  state.counters["trees"] = static_cast<double>(zooms.size());
  if (zooms.empty()) return;
  state.counters["readable_%"] = 100 * static_cast<double>(readable) / static_cast<double>(nodes);
  state.counters["median_zoom_%"] = 100 * zooms[zooms.size() / 2];
}
BENCHMARK(FirstLook)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace

// Takes --trees=FOLDER out of the arguments.
void TakeTreesFolder(int& count, char** arguments) {
  const std::string option = "--trees=";
  int kept = 1;
  for (int i = 1; i < count; ++i) {
    const std::string argument = arguments[i];
    if (argument.compare(0, option.size(), option) == 0) {
      trees_folder = argument.substr(option.size());
    } else {
      arguments[kept++] = arguments[i];
    }
  }
  count = kept;
}

}  // namespace coppice::editor

int main(int count, char** arguments) {
  coppice::editor::TakeTreesFolder(count, arguments);
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
