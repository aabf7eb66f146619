#include "tests/editor/gallery/scenes.h"
#include "tests/editor/patrol_file.h"

namespace coppice::editor {
namespace {

void ShowPatrol(Stage& stage) {
  stage.Open("patrol.xml", kPatrolFile);
  stage.Select("1.2.1.1");
}

void Type(Stage& stage, const std::string& text) {
  stage.driver().Type(text);
  stage.driver().Frames(6);
}

void AddNode(Stage& stage) {
  ShowPatrol(stage);
  stage.Select("1.2.1");
  stage.Run("edit.add");
}

void AddNodeTyped(Stage& stage) {
  AddNode(stage);
  Type(stage, "wai");
}

void AddNothing(Stage& stage) {
  AddNode(stage);
  Type(stage, "xyzzy");
}

void ChangeType(Stage& stage) {
  ShowPatrol(stage);
  stage.Run("edit.change_type");
  Type(stage, "say");
}

void Rename(Stage& stage) {
  ShowPatrol(stage);
  stage.Run("edit.rename");
}

void Find(Stage& stage) {
  ShowPatrol(stage);
  stage.Run("edit.find");
  Type(stage, "goal");
}

void Replace(Stage& stage) {
  ShowPatrol(stage);
  stage.Run("edit.replace");
  Type(stage, "goal");
}

void ReplacePreview(Stage& stage) {
  Replace(stage);
  stage.driver().Press(kKeyEnter);
  stage.driver().Frames(6);
  Type(stage, "target");
}

void Steps(Stage& stage) {
  ShowPatrol(stage);
  stage.Select("1.1.3");
  stage.Run("edit.delete");
  stage.Select("1.2.1.1");
  stage.Run("edit.disable");
  stage.Run("edit.move_right");
  stage.Run("edit.undo");
  stage.Run("edit.history");
}

void Usages(Stage& stage) {
  ShowPatrol(stage);
  stage.Select("1.1.2");
  stage.Run("tree.usages");
}

void RenameKey(Stage& stage) {
  ShowPatrol(stage);
  stage.Run("key.rename");
}

void Extract(Stage& stage) {
  ShowPatrol(stage);
  stage.Select("1.2.1");
  stage.Run("tree.extract");
}

void ThePalette(Stage& stage) {
  ShowPatrol(stage);
  stage.Run("help.palette");
}

void PaletteTyped(Stage& stage) {
  ThePalette(stage);
  Type(stage, "go");
}

void PaletteNothing(Stage& stage) {
  ThePalette(stage);
  Type(stage, "xyzzy");
}

void Keys(Stage& stage) {
  stage.Write("state/keys", "view.fit_all = Ctrl+Home\nno.such = X\n");
  stage.Restart();
  ShowPatrol(stage);
  stage.Run("help.keys");
  Type(stage, "fit");
}

void AllKeys(Stage& stage) {
  ShowPatrol(stage);
  stage.Run("help.keys");
}

void NewKeys(Stage& stage) {
  ShowPatrol(stage);
  stage.Run("help.keys");
  Type(stage, "fit all");
  stage.driver().Press(kKeyEnter);
  stage.driver().Frames(4);
  stage.driver().Press('Z');
  stage.driver().Frames(4);
}

void AskForAFile(Stage& stage) {
  ShowPatrol(stage);
  stage.Run("file.open");
}

void OpenFails(Stage& stage) {
  AskForAFile(stage);
  Type(stage, "/no/such/file.xml");
  stage.driver().Press(kKeyEnter);
  stage.driver().Frames(4);
}

void SaveAs(Stage& stage) {
  ShowPatrol(stage);
  stage.Run("file.save_as");
}

void Connect(Stage& stage) { stage.Run("robot.connect"); }

void ConnectFails(Stage& stage) {
  Connect(stage);
  stage.driver().Press('A', kCtrl);
  Type(stage, "robot:port");
  stage.driver().Press(kKeyEnter);
  stage.driver().Frames(4);
}

void PasteErrors(Stage& stage) {
  ShowPatrol(stage);
  stage.state().services.set_clipboard(R"(<Sequence><Say text="a"></Sequence>)");
  stage.Run("edit.paste");
}

void ExportPicture(Stage& stage) {
  ShowPatrol(stage);
  stage.Run("file.export");
}

void ChoiceOfAnEnum(Stage& stage) {
  stage.Open("choice.xml", R"(<root BTCPP_format="4"><BehaviorTree ID="Main">
<Drive gait="trot"/></BehaviorTree><TreeNodesModel><Action ID="Drive">
<input_port name="gait" type="Gait">how fast: walk, trot or gallop</input_port></Action>
</TreeNodesModel></root>)");
  stage.Select("1");
  stage.Click("inspector/port/gait/choices");
}

void Guards(Stage& stage) {
  ShowPatrol(stage);
  stage.Click("inspector/new_script");
}

void MenuOf(Stage& stage, const char* path) {
  ShowPatrol(stage);
  stage.Click(path);
}

void MenuOfANode(Stage& stage) {
  ShowPatrol(stage);
  stage.Select("1.1");
  stage.Run("menu.here");
  stage.driver().Frames(4);
}

// In the folder of the example, whose path is the same each time.
void ChooseAFile(Stage& stage) {
  stage.Run("example.tree");
  stage.Run("file.open");
  stage.driver().Frames(4);
}

void TourOf(Stage& stage, int steps) {
  stage.Run("help.tour");
  for (int i = 0; i < steps; ++i) {
    stage.driver().Frames(6);
    stage.Run("tour.next");
  }
  stage.driver().Frames(6);
}

}  // namespace

std::vector<GalleryScene> PopupScenes() {
  return {{"add_node", AddNode},
          {"add_node_typed", AddNodeTyped},
          {"add_nothing", AddNothing},
          {"change_type", ChangeType},
          {"rename", Rename},
          {"find", Find},
          {"replace", Replace},
          {"replace_preview", ReplacePreview},
          {"history", Steps},
          {"usages", Usages},
          {"rename_key", RenameKey},
          {"extract", Extract},
          {"palette", ThePalette},
          {"palette_typed", PaletteTyped},
          {"palette_nothing", PaletteNothing},
          {"keys", Keys},
          {"all_keys", AllKeys},
          {"new_keys", NewKeys},
          {"open", AskForAFile},
          {"open_fails", OpenFails},
          {"save_as", SaveAs},
          {"connect", Connect},
          {"connect_fails", ConnectFails},
          {"paste_errors", PasteErrors},
          {"export", ExportPicture},
          {"choice", ChoiceOfAnEnum},
          {"guards", Guards},
          {"menu_of_a_node", MenuOfANode},
          {"file_dialog", ChooseAFile},
          {"tour", [](Stage& stage) { TourOf(stage, 0); }},
          {"tour_types", [](Stage& stage) { TourOf(stage, 3); }},
          {"tour_timeline", [](Stage& stage) { TourOf(stage, 7); }},
          {"menu_file", [](Stage& stage) { MenuOf(stage, "menu/file"); }},
          {"menu_edit", [](Stage& stage) { MenuOf(stage, "menu/edit"); }},
          {"menu_tree", [](Stage& stage) { MenuOf(stage, "menu/tree"); }},
          {"menu_view", [](Stage& stage) { MenuOf(stage, "menu/view"); }},
          {"menu_tiles", [](Stage& stage) { MenuOf(stage, "menu/tiles"); }},
          {"menu_robot", [](Stage& stage) { MenuOf(stage, "menu/robot"); }},
          {"menu_run", [](Stage& stage) { MenuOf(stage, "menu/run"); }},
          {"menu_help", [](Stage& stage) { MenuOf(stage, "menu/help"); }}};
}

}  // namespace coppice::editor
