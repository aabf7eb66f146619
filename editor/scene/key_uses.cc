#include "editor/scene/key_uses.h"

#include <map>
#include <string>
#include <string_view>
#include <utility>

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
    if (node.parent == kNoNode || scopes_[node.scope].opened) return;
    const SceneNode& subtree = scene_.nodes[node.parent];
    if (subtree.scope == node.scope) return;
    Scope& scope = scopes_[node.scope];
    scope.opened = true;
    scope.parent = subtree.scope;
    for (std::uint32_t p = subtree.first_port; p < subtree.first_port + subtree.port_count; ++p) {
      const PortLine& port = scene_.ports[p];
      if (port.name == "_autoremap") scope.autoremap = port.value == "true" || port.value == "1";
      if (port.is_key) scope.keys.emplace(port.name, Resolve(NameOf(port), subtree.scope));
    }
  }

  // "{=}" is the key with the name of the port.
  static std::string_view NameOf(const PortLine& port) {
    const std::string_view key = KeyOf(port.value);
    return key == "=" ? port.name : key;
  }

  std::uint32_t Resolve(std::string_view key, std::uint32_t scope) {
    if (!key.empty() && key.front() == '@') {
      key.remove_prefix(1);
      scope = 0;
    }
    Scope& here = scopes_[scope];
    if (const auto known = here.keys.find(key); known != here.keys.end()) return known->second;
    std::uint32_t number = 0;
    if (here.autoremap && key.substr(0, 1) != "_") {
      number = Resolve(key, here.parent);
    } else {
      number = static_cast<std::uint32_t>(result_.uses.size());
      result_.uses.emplace_back();
    }
    here.keys.emplace(key, number);
    return number;
  }

  void AddPorts(std::uint32_t index) {
    const SceneNode& node = scene_.nodes[index];
    for (std::uint32_t p = node.first_port; p < node.first_port + node.port_count; ++p) {
      const PortLine& port = scene_.ports[p];
      if (!port.is_key) continue;
      const std::uint32_t key = Resolve(NameOf(port), node.scope);
      result_.key_of_port[p] = key;
      const bool hands_on = node.shape == Shape::kSubTree;
      result_.uses[key].push_back({index, p, !hands_on && port.direction != PortDirection::kOutput,
                                   !hands_on && port.direction != PortDirection::kInput});
    }
  }

  const Scene& scene_;
  std::vector<Scope> scopes_;
  KeyUses result_;
};

}  // namespace

KeyUses FindKeyUses(const Scene& scene) { return Collector(scene).Run(); }

}  // namespace coppice::editor
