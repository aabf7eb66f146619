// Drives an Editor as a user does, by path: no window, simulated time, and robots of which the
// test says what they do.
#ifndef COPPICE_TESTS_EDITOR_DRIVER_H_
#define COPPICE_TESTS_EDITOR_DRIVER_H_

#include <memory>
#include <string>
#include <vector>

#include "editor/shell/editor.h"
#include "tests/editor/scripted_robot.h"
#include "tests/editor/shared_fonts.h"
#include "tests/support/temporary_folder.h"

namespace coppice::editor {

/// A file in a folder of its own that is gone afterwards.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, const std::string& text) : path_(folder_.Path(name)) {
    Write(text);
  }
  void Write(const std::string& text) const { WriteFile(path_, text); }
  const std::string& path() const { return path_; }
  std::string folder() const { return folder_.path(); }

 private:
  const TemporaryFolder folder_;
  const std::string path_;
};

class Driver {
 public:
  explicit Driver(EditorOptions options = {}) : editor(WithSharedFonts(std::move(options))) {
    input.width = 1280;
    input.height = 800;
    input.dt = 0.02F;
  }

  /// Lets frames go by: a whole click needs a few.
  void Frames(int count = 3);

  Box BoxOf(const std::string& path) const {
    const Box* box = editor.items().Find(path);
    return box ? *box : Box{};
  }
  bool Has(const std::string& path) const { return editor.items().Find(path) != nullptr; }

  /// Opens the row of the XML and the problems, as a user does.
  void OpenRow() {
    Frames();
    Click("fold/bottom");
  }
  void MoveTo(Point at);
  void ClickAt(Point at, int button = 0);
  /// False if there is no such item.
  bool Click(const std::string& path);
  void Drag(Point from, Point to, int button = 0);
  /// Drags without letting go.
  void Carry(Point from, Point to);
  void Press(Key key, int modifiers = kNoModifier);
  /// Holds the modifier keys until the next call.
  void Hold(int modifiers);
  void Type(const std::string& text);
  void Wheel(float up, float left = 0);
  /// Around the mouse, with Ctrl.
  void Zoom(float up);

  /// A robot that runs the trees of that XML; tell it what to do and let frames go by. The editor
  /// owns it.
  ScriptedRobot* AddRobot(const std::string& endpoint, const std::string& xml);

  TreeView& view() { return *editor.state().workspace.view(); }
  std::string Selected() {
    TreeView* shown = editor.state().workspace.view();
    if (!shown || shown->selected() == kNoSceneNode) return {};
    return shown->scene()->nodes[shown->selected()].path;
  }

  /// How many pixels of the box are near that colour.
  int CountColor(const Box& box, Color color, int tolerance = 24) const;

  /// Writes the picture into $COPPICE_PICTURES, if that is set.
  void Picture(const std::string& name) const;

  Editor editor;
  InputEvents input;
};

/// A small tree with every shape: control, decorator, condition, action, SubTree, unknown.
inline constexpr char kSmallFile[] = R"(<?xml version="1.0"?>
<root BTCPP_format="4" main_tree_to_execute="MainTree">
  <BehaviorTree ID="MainTree">
    <Sequence name="round">
      <Fallback>
        <Inverter><IsDark light="{light}"/></Inverter>
        <SwitchOn lamp="hall" level="{level}"/>
      </Fallback>
      <SubTree ID="Walk" name="walk" goal="{goal}"/>
      <AlwaysSuccess/>
    </Sequence>
  </BehaviorTree>
  <BehaviorTree ID="Walk">
    <RetryUntilSuccessful num_attempts="3"><Step to="{goal}"/></RetryUntilSuccessful>
  </BehaviorTree>
  <TreeNodesModel>
    <Condition ID="IsDark"><input_port name="light" type="double">in lux</input_port></Condition>
    <Action ID="SwitchOn"><input_port name="level" type="int">0 to 9</input_port>
      <input_port name="lamp" type="string">which one</input_port>
      <input_port name="slowly" type="bool" default="false">over a second</input_port>
      <MetadataFields><Metadata description="Switches a lamp on."/></MetadataFields>
    </Action>
  </TreeNodesModel>
</root>
)";

/// What a robot sends while it runs a tree.
inline constexpr char kLiveTree[] = R"(<root BTCPP_format="4">
<BehaviorTree ID="Main" _fullpath="">
 <Sequence name="top" _uid="1"><IsReady name="IsReady" _uid="2"/>
  <SubTree ID="Walk" name="walk" _fullpath="walk" goal="{goal}" _uid="3"/>
  <Say name="Say" text="hello" _uid="6"/></Sequence>
</BehaviorTree>
<BehaviorTree ID="Walk" _fullpath="walk"><Repeat name="Repeat" num_cycles="3" _uid="4">
 <Step name="Step" to="{goal}" _uid="5"/></Repeat></BehaviorTree>
<TreeNodesModel><Condition ID="IsReady"/>
 <Action ID="Say"><input_port name="text" type="string">what</input_port></Action>
 <Action ID="Step"/></TreeNodesModel>
</root>
)";

}  // namespace coppice::editor

#endif  // COPPICE_TESTS_EDITOR_DRIVER_H_
