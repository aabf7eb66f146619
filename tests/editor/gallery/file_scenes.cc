#include "editor/files/git_head.h"
#include "tests/editor/gallery/scenes.h"
#include "tests/editor/patrol_file.h"

namespace coppice::editor {
namespace {

// Every shape and every mark of a node.
constexpr char kShapes[] = R"(<root BTCPP_format="4" main_tree_to_execute="Shapes">
  <BehaviorTree ID="Shapes">
    <ReactiveSequence name="every shape">
      <!-- Notes stand at the node behind them. -->
      <Parallel success_count="2" failure_count="1">
        <Inverter><IsBatteryLow level="{battery}"/></Inverter>
        <SequenceWithMemory name="errand">
          <Pick up="cup" _skipIf="full"/>
          <AlwaysSuccess _skipIf="true"/>
        </SequenceWithMemory>
      </Parallel>
      <SubTree ID="Carry" _autoremap="true" what="{cup}"/>
      <Timeout msec="500"><RetryUntilSuccessful num_attempts="3">
        <Unheard from="of {battery}"/>
      </RetryUntilSuccessful></Timeout>
      <Switch2 variable="{mode}" case_1="day" case_2="night">
        <AlwaysSuccess/><AlwaysFailure/><Sleep msec="100"/>
      </Switch2>
      <Fallback name="a name that is much longer than anybody would wish it to be in a tree"/>
    </ReactiveSequence>
  </BehaviorTree>
  <BehaviorTree ID="Carry"><Script code="carried := true" _onSuccess="count += 1"/></BehaviorTree>
  <TreeNodesModel>
    <Condition ID="IsBatteryLow"><input_port name="level" type="double">of charge</input_port>
      </Condition>
    <Action ID="Pick"><input_port name="up" type="string">what</input_port></Action>
  </TreeNodesModel>
</root>
)";

// A field of each kind.
constexpr char kFields[] = R"(<root BTCPP_format="4" main_tree_to_execute="Main">
  <BehaviorTree ID="Main">
    <Sequence>
      <Drive to="1.5;2;0.5" gait="trot" speed="0.4" quiet="true" key="{goal}" times="three"
             _while="battery &gt;" _onHalted="stopped := true"/>
      <Plan goal="{goal}"/>
    </Sequence>
  </BehaviorTree>
  <TreeNodesModel>
    <Action ID="Drive">
      <input_port name="to" type="Pose2D">where to</input_port>
      <input_port name="from" type="Pose2D">where from</input_port>
      <input_port name="gait" type="Gait">how fast: walk, trot or gallop</input_port>
      <input_port name="speed" type="double" default="0.3">m/s</input_port>
      <input_port name="times" type="int">how often</input_port>
      <input_port name="quiet" type="bool">without a sound</input_port>
      <input_port name="key" type="Pose2D">a key</input_port>
      <inout_port name="a_port_with_a_long_name" type="std::vector&lt;geometry::Pose2D&gt;">much
        </inout_port>
      <MetadataFields><Metadata description="Drives to a pose and tells how far it was. It gives up
        when the way is blocked for longer than a minute."/></MetadataFields>
    </Action>
    <Action ID="Plan"><output_port name="goal" type="Pose2D"/></Action>
  </TreeNodesModel>
</root>
)";

constexpr char kProblems[] = R"(<root BTCPP_format="4" main_tree_to_execute="Main">
  <BehaviorTree ID="Main">
    <Sequence>
      <Inverter/>
      <SwitchOn lamp="{lmap}" brightness="3"/>
      <Unheard/>
      <SubTree ID="Wlak"/>
      <Script code="x := "/>
      <Fallback><AlwaysSuccess/><AlwaysFailure/></Fallback>
      <Repeat num_cycles="often"><AlwaysSuccess/></Repeat>
    </Sequence>
  </BehaviorTree>
  <BehaviorTree ID="Walk"><AlwaysSuccess/></BehaviorTree>
  <TreeNodesModel>
    <Action ID="SwitchOn"><input_port name="lamp" type="string">which one</input_port></Action>
  </TreeNodesModel>
</root>
)";

constexpr char kMalformed[] = R"(<root BTCPP_format="4">
  <BehaviorTree ID="Main">
    <Sequence>
      <AlwaysSuccess/>
    </Fallback>
  </BehaviorTree>
</root>
)";

// Two trees per level: many nodes, many keys.
std::string LargeFile() {
  std::string text =
      "<root BTCPP_format=\"4\" main_tree_to_execute=\"Large\">\n"
      "<BehaviorTree ID=\"Large\"><Sequence name=\"shift\">\n";
  for (int room = 1; room <= 24; ++room) {
    const std::string number = std::to_string(room);
    text += "<Fallback name=\"room " + number + "\">\n";
    for (int try_ = 1; try_ <= 3; ++try_) {
      text += "<Sequence><Script code=\"room := " + number + R"("/><Sleep msec=")" + number +
              R"(00"/><SetBlackboard output_key="done_)" + number +
              "\" value=\"true\"/></Sequence>\n";
    }
    text += "</Fallback>\n";
  }
  return text + "</Sequence></BehaviorTree></root>\n";
}

void Start(Stage&) {}

void EmptyTree(Stage& stage) {
  stage.Open(
      "new.xml",
      "<root BTCPP_format=\"4\">\n  <BehaviorTree ID=\"Main\">\n  </BehaviorTree>\n</root>\n");
}

void NoTree(Stage& stage) { stage.OpenBroken("none.xml", "<root BTCPP_format=\"4\"/>\n"); }

void Malformed(Stage& stage) { stage.OpenBroken("malformed.xml", kMalformed); }

void Patrol(Stage& stage) {
  stage.Open("patrol.xml", kPatrolFile);
  stage.Select("1.2.1.1");
}

void PatrolAcross(Stage& stage) {
  Patrol(stage);
  stage.Run("view.left_to_right");
  stage.Run("tree.open_subtrees");
  stage.Run("view.compact");
  stage.Run("view.fit_all");
}

void Shapes(Stage& stage) {
  stage.Open("shapes.xml", kShapes);
  stage.Select("1.2");
}

void ShapesAtFullSize(Stage& stage) {
  Shapes(stage);
  stage.Select("1.1.2.2");
  stage.Run("view.zoom_100");
}

void Collapsed(Stage& stage) {
  stage.Open("shapes.xml", kShapes);
  stage.Select("1.1");
  stage.Run("tree.collapse");
  stage.Select("1.3");
  stage.Run("tree.collapse");
}

// One parent, and far too many leaves for a row or a column.
void ManyLeaves(Stage& stage) {
  std::string text = "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Many\"><Sequence name=\"all\">\n";
  for (int i = 1; i <= 500; ++i) text += "<Sleep msec=\"" + std::to_string(i) + "00\"/>\n";
  stage.Open("many_leaves.xml", text + "</Sequence></BehaviorTree></root>\n");
}

std::string BranchOf(int depth) {
  if (depth == 0) return "<AlwaysSuccess/>";
  std::string text = "<Sequence>";
  for (int i = 0; i < 4; ++i) text += BranchOf(depth - 1);
  return text + "</Sequence>\n";
}

// Four children each: 1365 nodes.
void WideTree(Stage& stage) {
  stage.Open("wide.xml", R"(<root BTCPP_format="4"><BehaviorTree ID="Wide">)" + BranchOf(5) +
                             "</BehaviorTree></root>\n");
}

void WideTreeAtFullSize(Stage& stage) {
  WideTree(stage);
  stage.Select("1.2");
  stage.Run("view.zoom_100");
  stage.driver().MoveTo(stage.driver().BoxOf("canvas").center());
  stage.driver().Zoom(-3);
  stage.driver().Frames(12);
}

void Large(Stage& stage) {
  stage.Open("large.xml", LargeFile());
  stage.Select("1.12.2");
}

void LargeHalfWay(Stage& stage) {
  Large(stage);
  stage.Run("view.left_to_right");
  stage.Run("view.fit_selection");
  stage.driver().MoveTo(stage.driver().BoxOf("canvas").center());
  stage.driver().Zoom(-6);
  stage.driver().Frames(12);
}

void Fields(Stage& stage) {
  stage.Open("fields.xml", kFields);
  stage.Select("1.1");
}

void CompletedKey(Stage& stage) {
  Fields(stage);
  stage.Click("inspector/port/key");
  stage.driver().Press('A', kCtrl);
  stage.driver().Type("{g");
  stage.driver().Frames(4);
}

void FieldTooltip(Stage& stage) {
  Fields(stage);
  stage.Hover("inspector/port/a_port_with_a_long_name");
}

void NodeTooltip(Stage& stage) {
  Patrol(stage);
  stage.Hover("canvas/Patrol/1.1.1");
}

void LitKey(Stage& stage) {
  Patrol(stage);
  stage.Click("canvas/Patrol/1.2.1.1/port/waypoint");
}

void Problems(Stage& stage) {
  stage.Open("problems.xml", kProblems);
  stage.Select("1.2");
}

void InASharedTree(Stage& stage) {
  Patrol(stage);
  stage.Run("tree.open_subtrees");
  stage.Select("1.2.1.2.1");
}

void Tabs(Stage& stage) {
  Patrol(stage);
  stage.Click("project/patrol.xml/GoTo");
  stage.Open("shapes.xml", kShapes);
  stage.Select("1.2");
  stage.Run("tree.definition");
}

void TypingXml(Stage& stage) {
  const std::string folder =
      std::filesystem::path(stage.Write("patrol.xml", kPatrolFile)).parent_path().string();
  const auto git = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"git", "-C", folder, "-c", "user.name=A", "-c", "user.email=a@b",
                                 "-c", "commit.gpgsign=false"});
    OutputOf(words);
  };
  git({"init", "-q"});
  git({"add", "patrol.xml"});
  git({"commit", "-q", "-m", "one"});
  Patrol(stage);
  stage.state().git.Wait();
  stage.Select("1.2.1.3");
  stage.Run("edit.disable");
  stage.Run("file.save");
  stage.Select("1.2.1.1");
  stage.Run("edit.delete");
  stage.Select("1.2.1");
  stage.Run("edit.xml");
  stage.driver().Press(kKeyEnd);
  stage.driver().Type(R"(<Say txt="new"/>)");
  stage.Rest();
}

void XmlWithAnError(Stage& stage) {
  Patrol(stage);
  stage.Run("edit.xml");
  stage.driver().Type("<Say");
  stage.Rest();
}

void DropBetween(Stage& stage) {
  Patrol(stage);
  stage.DragBehind("types/Fallback", "canvas/Patrol/1.2.1.1");
}

void DropInto(Stage& stage) {
  Patrol(stage);
  stage.DragOnto("types/Fallback", "canvas/Patrol/1.1");
}

void DropRefused(Stage& stage) {
  Patrol(stage);
  stage.DragOnto("canvas/Patrol/1.1", "canvas/Patrol/1.1.2");
}

void ComparedWithSaved(Stage& stage) {
  Patrol(stage);
  stage.Select("1.1.3");
  stage.Run("edit.delete");
  stage.Select("1.2.1.3");
  stage.Run("edit.disable");
  stage.Select("1.2.1.1");
  stage.Run("edit.move_right");
  stage.driver().editor.state().commands.Run("file.compare");
  stage.driver().Frames();
  stage.driver().Press(kKeyEnter);
  stage.driver().Frames(12);
  stage.Run("view.fit_all");
}

// Both have changed the same place.
void Dispute(Stage& stage) {
  Patrol(stage);
  stage.Select("1.2.1.3");
  stage.Run("edit.disable");
  std::string other = kPatrolFile;
  other.replace(other.find("All quiet.\"/>"), 13, R"(All quiet." _skipIf="night"/>)");
  stage.Write("patrol.xml", other);
  stage.Rest();
}

void Resolve(Stage& stage) {
  Dispute(stage);
  stage.Click("banner/resolve");
}

void AfterACrash(Stage& stage) {
  Patrol(stage);
  stage.Select("1.1.3");
  stage.Run("edit.delete");
  stage.driver().Frames(300);  // a copy is made every five seconds
  stage.Restart();
  stage.Open("patrol.xml", kPatrolFile);
}

void Refusal(Stage& stage) {
  Patrol(stage);
  stage.Run("tree.inline");
}

}  // namespace

std::vector<GalleryScene> FileScenes() {
  return {{"start", Start},
          {"empty_tree", EmptyTree},
          {"no_tree", NoTree},
          {"malformed", Malformed},
          {"patrol", Patrol},
          {"patrol_across", PatrolAcross},
          {"shapes", Shapes},
          {"shapes_100", ShapesAtFullSize},
          {"collapsed", Collapsed},
          {"large", Large},
          {"large_half_way", LargeHalfWay},
          {"many_leaves", ManyLeaves},
          {"wide", WideTree},
          {"wide_close", WideTreeAtFullSize},
          {"fields", Fields},
          {"completions", CompletedKey},
          {"field_tooltip", FieldTooltip},
          {"node_tooltip", NodeTooltip},
          {"lit_key", LitKey},
          {"problems", Problems},
          {"shared_tree", InASharedTree},
          {"tabs", Tabs},
          {"typing_xml", TypingXml},
          {"xml_with_an_error", XmlWithAnError},
          {"drop_between", DropBetween},
          {"drop_into", DropInto},
          {"drop_refused", DropRefused},
          {"compared_with_saved", ComparedWithSaved},
          {"dispute", Dispute},
          {"resolve", Resolve},
          {"after_a_crash", AfterACrash},
          {"notice", Refusal}};
}

}  // namespace coppice::editor
