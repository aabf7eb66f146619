// Who reads and who writes each blackboard key of a scene, by ports, scripts and guards.
//
// A key of a SubTree that an attribute or _autoremap makes a key of the tree outside is that key:
// the engine's own rule (bt_core/model/keys.h). "@key" is a key of the main tree.
#ifndef COPPICE_EDITOR_SCENE_KEY_USES_H_
#define COPPICE_EDITOR_SCENE_KEY_USES_H_

#include <cstdint>
#include <string>
#include <vector>

#include "editor/scene/scene.h"

namespace coppice::editor {

inline constexpr std::uint32_t kNoKey = UINT32_MAX;

struct KeyUse {
  std::uint32_t node = 0;
  std::uint32_t port = 0;  ///< of Scene::ports
  bool reads = false;
  bool writes = false;  ///< neither: a SubTree that hands the key on
};

struct KeyUses {
  std::vector<std::uint32_t> key_of_port;  ///< by number of Scene::ports; kNoKey: none, or a script
  std::vector<std::vector<KeyUse>> uses;   ///< by key, in preorder
  std::vector<std::string> names;          ///< of the keys, where they were met first
};

KeyUses FindKeyUses(const Scene& scene);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_SCENE_KEY_USES_H_
