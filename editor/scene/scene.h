// One tree as the editor shows it: flat, in preorder, SubTrees written out in place, with the paths
// that people and scripted tests use ("1.2" is the second child of the root).
//
// Immutable. The views point into the Forest and the NodeModels that it was made from.
#ifndef COPPICE_EDITOR_SCENE_SCENE_H_
#define COPPICE_EDITOR_SCENE_SCENE_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/nodes/control.h"
#include "editor/scene/forest.h"
#include "editor/scene/node_models.h"

namespace coppice::editor {

enum class Shape : std::uint8_t { kControl, kDecorator, kAction, kCondition, kSubTree, kUnknown };

/// The nodes of a scene have numbers of their own, beside those of the run (NodeIndex).
inline constexpr std::uint32_t kNoSceneNode = UINT32_MAX;

/// One attribute that is not reserved, or a pre- or post-condition.
struct PortLine {
  std::string_view name;
  std::string_view value;
  PortDirection direction = PortDirection::kInput;
  std::string_view key;              ///< that the value names; empty: a literal
  const PortModel* model = nullptr;  ///< null if not declared
};

struct SceneNode {
  std::string_view id;    ///< node type; for a SubTree the ID of its tree
  std::string_view name;  ///< given in the XML, or else the ID
  std::string path;       ///< "1.2.1"
  const KnownModel* model = nullptr;
  Shape shape = Shape::kUnknown;
  bool autoremap = false;  ///< a SubTree whose keys are those outside
  bool recursive = false;  ///< a SubTree inside itself, or beyond the limit: not written out
  std::uint32_t parent = kNoSceneNode;
  std::uint32_t end = 0;     ///< one past the last descendant
  std::uint32_t number = 1;  ///< among its siblings, from 1
  std::uint32_t document = 0;
  ElementIndex element{0};
  std::uint32_t first_port = 0;  ///< of Scene::ports
  std::uint32_t port_count = 0;
  std::uint32_t scope = 0;       ///< of Scene::scopes
  NodeIndex run_node = kNoNode;  ///< number on the robot; kNoNode if there is none
  bool disabled = false;         ///< always skipped: _skipIf="true"
  std::string note;              ///< the comments about it in the file, in one line; may be empty
};

struct Scene {
  std::string tree_id;
  std::vector<SceneNode> nodes;
  std::vector<PortLine> ports;
  std::vector<std::string> scopes;         ///< names of the blackboards, in order of creation
  std::vector<std::uint32_t> of_run_node;  ///< kNoSceneNode where there is none

  bool HasChildren(std::uint32_t node) const { return nodes[node].end > node + 1; }
  std::uint32_t FindPath(std::string_view path) const;  ///< kNoSceneNode if there is none
  std::uint32_t FindElement(std::uint32_t document, ElementIndex element) const;  ///< the first
};

/// Writes out tree number `tree` of the forest, up to about `limit` nodes; SubTrees beyond it stay
/// closed, with limit 0 all of them.
Scene BuildScene(const Forest& forest, int tree, const NodeModels& models,
                 std::size_t limit = 50000);
}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_SCENE_SCENE_H_
