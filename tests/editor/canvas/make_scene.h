// Scenes of a few elements, written as XML.
#ifndef COPPICE_TESTS_EDITOR_CANVAS_MAKE_SCENE_H_
#define COPPICE_TESTS_EDITOR_CANVAS_MAKE_SCENE_H_

#include <memory>
#include <string>

#include "editor/scene/scene.h"
#include "editor/theme/geometry.h"
#include "tests/editor/read_forest.h"

namespace coppice::editor {

/// The scene of a tree with that root element. What it points into lives as long as it does.
inline std::shared_ptr<const Scene> MakeScene(const std::string& xml) {
  struct Kept {
    Forest forest;
    Scene scene;
  };
  static const NodeModels models;
  auto kept = std::make_shared<Kept>();
  kept->forest = ReadForest(R"(<root BTCPP_format="4"><BehaviorTree ID="T">)" + xml +
                            "</BehaviorTree></root>");
  kept->scene = BuildScene(kept->forest, 0, models);
  return {kept, &kept->scene};
}

/// For a TreeView whose nodes are all equally large.
inline Point SameSize(const Scene&, const SceneNode&) { return {100, 30}; }

}  // namespace coppice::editor

#endif  // COPPICE_TESTS_EDITOR_CANVAS_MAKE_SCENE_H_
