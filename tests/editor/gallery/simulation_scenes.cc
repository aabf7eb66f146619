#include "tests/editor/gallery/scenes.h"
#include "tests/editor/sample_trees.h"

namespace coppice::editor {
namespace {

void Answer(Stage& stage, const std::string& text) {
  stage.driver().Type(text);
  stage.driver().Press(kKeyEnter);
  stage.driver().Frames(8);
}

void Begin(Stage& stage) {
  stage.Open("patrol.xml", kPatrolTree);
  stage.Run("sim.start");
  stage.Run("view.fit_all");
}

void Ticking(Stage& stage) {
  Begin(stage);
  stage.Run("sim.set");
  Answer(stage, "battery = 0.9");
  for (int i = 0; i < 14; ++i) stage.Run("sim.tick");
  stage.Select("1.2.1.2");
  stage.Run("view.fit_all");
}

void LeafScript(Stage& stage) {
  Ticking(stage);
  stage.Run("sim.script");
}

void SetKey(Stage& stage) {
  Ticking(stage);
  stage.Run("sim.set");
}

void EditedWrongly(Stage& stage) {
  Ticking(stage);
  std::string text = kPatrolTree;
  text.replace(text.find(R"(<Dock name="dock"/>)"), 19, "<Inverter/>");
  const std::string path = stage.state().workspace.project().files().begin()->first;
  stage.state().workspace.project().SetText(path, "Type", text);
  stage.driver().Frames(30);
}

void Finished(Stage& stage) {
  Ticking(stage);
  stage.Run("sim.set");
  Answer(stage, "battery = 0.2");
  for (int i = 0; i < 25; ++i) stage.Run("sim.tick");
  stage.Run("view.fit_all");
}

void ByChance(Stage& stage) {
  Begin(stage);
  stage.state().simulator.get()->SetChance(Chance{7, {}});
  static_cast<void>(stage.state().simulator.get()->SetKey("battery", "0.9"));
  for (int i = 0; i < 14; ++i) stage.Run("sim.tick");
  stage.Select("1.2.1.1");
  stage.Run("view.fit_all");
}

void Covered(Stage& stage, const char* battery) {
  Begin(stage);
  if (*battery) static_cast<void>(stage.state().simulator.get()->SetKey("battery", battery));
  stage.Run("sim.runs");
  stage.state().popup.text = "200";
  stage.driver().Press(kKeyEnter);
  while (stage.state().coverage.is_running()) stage.driver().Frames(1);
  stage.Run("view.fit_all");
}

void NoTests(Stage& stage) {
  stage.Open("patrol.xml", kPatrolTree);
  stage.Run("tile.tests");
}

void TestPassed(Stage& stage) {
  Ticking(stage);
  stage.Run("sim.save_test");
  Answer(stage, "goes its round when the battery is full");
  stage.Run("sim.tests");
  stage.Rest();
}

void TestFailed(Stage& stage) {
  TestPassed(stage);
  std::string text = kPatrolTree;
  text.replace(text.find("&lt; 0.3"), 8, "&gt; 0.3");
  const std::string path = stage.state().workspace.project().files().begin()->first;
  stage.state().workspace.project().SetText(path, "Type", text);
  stage.Run("sim.tests");
  stage.Rest();
}

}  // namespace

std::vector<GalleryScene> SimulationScenes() {
  return {{"simulation", Begin},
          {"simulation_ticking", Ticking},
          {"simulation_leaf", LeafScript},
          {"simulation_key", SetKey},
          {"simulation_error", EditedWrongly},
          {"simulation_finished", Finished},
          {"simulation_by_chance", ByChance},
          {"coverage", [](Stage& stage) { Covered(stage, "0.9"); }},
          {"coverage_finding", [](Stage& stage) { Covered(stage, ""); }},
          {"no_coverage",
           [](Stage& stage) {
             Begin(stage);
             stage.Run("run.coverage");
           }},
          {"no_tests", NoTests},
          {"test_passed", TestPassed},
          {"test_failed", TestFailed}};
}

std::vector<GalleryScene> GalleryScenes() {
  std::vector<GalleryScene> all;
  for (const auto& part : {FileScenes(), PopupScenes(), RunScenes(), SimulationScenes()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

}  // namespace coppice::editor
