#include "editor/scene/key_uses.h"

#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "bt_core/model/keys.h"
#include "bt_core/nodes/guards.h"
#include "editor/scene/script_words.h"

namespace coppice::editor {
namespace {

class Collector {
 public:
  explicit Collector(const Scene& scene) : scene_(scene), scopes_(scene.scopes.size()) {
    result_.key_of_port.assign(scene.ports.size(), kNoKey);
  }

  // A SubTree comes before what is in it, so its keys are known by then.
  KeyUses Run() {
    for (std::uint32_t i = 0; i < scene_.nodes.size(); ++i) {
      OpenScope(i);
      AddPorts(i);
    }
    return std::move(result_);
  }

 private:
  struct Scope {
    std::uint32_t parent = 0;
    bool opened = false;
    bool autoremap = false;
    std::map<std::string, std::uint32_t, std::less<>> keys;
  };

  void OpenScope(std::uint32_t index) {
    const SceneNode& node = scene_.nodes[index];
    if (node.parent == kNoSceneNode || scopes_[node.scope].opened) return;
    const SceneNode& subtree = scene_.nodes[node.parent];
    if (subtree.scope == node.scope) return;
    scopes_[node.scope].opened = true;
    scopes_[node.scope].parent = subtree.scope;
    scopes_[node.scope].autoremap = subtree.autoremap;
    for (std::uint32_t p = subtree.first_port; p < subtree.first_port + subtree.port_count; ++p) {
      const PortLine& port = scene_.ports[p];
      if (!IsReservedAttribute(port.name)) Remap(node.scope, port.name, port.key);
    }
    if (subtree.autoremap || !subtree.model) return;
    for (const PortModel& port : subtree.model->ports) {
      if (port.default_text) Remap(node.scope, port.name, KeyOf(*port.default_text, port.name));
    }
  }

  // Inside, `name` is that key of the tree outside, or holds a literal. The first who says it wins.
  void Remap(std::uint32_t scope, std::string_view name, std::string_view key) {
    if (scopes_[scope].keys.count(name) > 0) return;
    const std::uint32_t number = key.empty() ? NewKey(name) : Resolve(key, scopes_[scope].parent);
    scopes_[scope].keys.emplace(name, number);
  }

  std::uint32_t NewKey(std::string_view name) {
    result_.names.emplace_back(name);
    result_.uses.emplace_back();
    return static_cast<std::uint32_t>(result_.uses.size() - 1);
  }

  std::uint32_t Resolve(std::string_view key, std::uint32_t scope) {
    if (key.front() == '@') {
      key.remove_prefix(1);
      scope = 0;
    }
    Scope& here = scopes_[scope];
    if (const auto known = here.keys.find(key); known != here.keys.end()) return known->second;
    const bool is_outside = here.autoremap && !IsPrivateKey(key);
    const std::uint32_t number = is_outside ? Resolve(key, here.parent) : NewKey(key);
    here.keys.emplace(key, number);
    return number;
  }

  void AddPorts(std::uint32_t index) {
    const SceneNode& node = scene_.nodes[index];
    for (std::uint32_t p = node.first_port; p < node.first_port + node.port_count; ++p) {
      const PortLine& port = scene_.ports[p];
      if (IsScript(port)) AddScript(index, p);
      if (port.key.empty()) continue;
      const std::uint32_t key = Resolve(port.key, node.scope);
      result_.key_of_port[p] = key;
      const bool hands_on = node.shape == Shape::kSubTree;
      result_.uses[key].push_back({index, p, !hands_on && port.direction != PortDirection::kOutput,
                                   !hands_on && port.direction != PortDirection::kInput});
    }
  }

  static bool IsScript(const PortLine& port) {
    return IsGuardAttribute(port.name) || (port.model && port.model->type == "script");
  }

  void AddScript(std::uint32_t index, std::uint32_t port) {
    for (const ScriptWord& word : WordsOf(scene_.ports[port].value)) {
      auto& uses = result_.uses[Resolve(word.text, scene_.nodes[index].scope)];
      if (uses.empty() || uses.back().node != index || uses.back().port != port) {
        uses.push_back({index, port, false, false});
      }
      uses.back().reads |= word.reads;
      uses.back().writes |= word.writes;
    }
  }

  const Scene& scene_;
  std::vector<Scope> scopes_;
  KeyUses result_;
};

}  // namespace

KeyUses FindKeyUses(const Scene& scene) { return Collector(scene).Run(); }

}  // namespace coppice::editor
