// A SubTree is written out wherever it stands, so a scene can be far larger than its files, and a
// small file can ask for an endless one. Hence a list of what is still to do in the place of
// recursion, a limit, and for each instance of a tree the instances around it, by which a tree
// inside itself is recognized.
#include "editor/scene/scene.h"

#include <algorithm>
#include <optional>
#include <unordered_map>

#include "bt_core/model/keys.h"
#include "editor/scene/notes.h"

namespace coppice::editor {
namespace {

// Each instance of a tree has texts of its own; a small file can ask for gigabytes of them.
constexpr std::size_t kMostTextBytes = std::size_t{24} << 20;

bool IsHidden(std::string_view name) {
  return name == "name" || name == "ID" || name == "_uid" || name == "_fullpath";
}

Shape ShapeOf(NodeCategory category) {
  switch (category) {
    case NodeCategory::kAction:
      return Shape::kAction;
    case NodeCategory::kCondition:
      return Shape::kCondition;
    case NodeCategory::kControl:
      return Shape::kControl;
    case NodeCategory::kDecorator:
      return Shape::kDecorator;
    case NodeCategory::kSubTree:
      return Shape::kSubTree;
  }
  return Shape::kUnknown;
}

// Walks the elements depth first, with a list of its own instead of recursion: files may be deep.
class Builder {
 public:
  Builder(const Forest& forest, const NodeModels& models, std::size_t limit)
      : forest_(forest), models_(models), limit_(limit) {}

  Scene Build(int tree) {
    const TreeEntry& entry = forest_.trees()[static_cast<std::size_t>(tree)];
    scene_.tree_id = entry.id;
    scene_.scopes.push_back(entry.instance_path.empty() ? entry.id : entry.instance_path);
    trees_.push_back({tree, kNone});
    const Document& document = *forest_.documents()[entry.document];
    const Element& last = document.elements().back();
    scene_.nodes.reserve(document.elements().size());
    scene_.ports.reserve(last.first_attribute + last.attribute_count);
    PushChildren(entry.document, forest_.documents()[entry.document]->element(entry.element),
                 kNoSceneNode, 0, 0);
    while (!open_.empty()) {
      const Open next = open_.back();
      open_.pop_back();
      Add(next);
    }
    CloseRanges();
    return std::move(scene_);
  }

 private:
  static constexpr std::uint32_t kNone = UINT32_MAX;

  struct Open {
    std::uint32_t document;
    ElementIndex element;
    std::uint32_t parent;
    std::uint32_t number;
    std::uint32_t scope;
    std::uint32_t tree;  // of trees_
  };
  struct TagMeaning {
    std::optional<NodeCategory> category;  // written instead of a type
    const KnownModel* model = nullptr;     // of the type of that name
  };
  struct TreeInstance {
    int tree;
    std::uint32_t outer;  // of trees_
  };

  void PushChildren(std::uint32_t document, const Element& element, std::uint32_t parent,
                    std::uint32_t scope, std::uint32_t tree) {
    const std::size_t first = open_.size();
    std::uint32_t number = 0;
    const Document& text = *forest_.documents()[document];
    for (ElementIndex i = element.first_child; i != kNoElement; i = text.element(i).next_sibling) {
      open_.push_back({document, i, parent, ++number, scope, tree});
    }
    std::reverse(open_.begin() + static_cast<std::ptrdiff_t>(first), open_.end());
  }

  void Add(const Open& open) {
    const Document& document = *forest_.documents()[open.document];
    const Element& element = document.element(open.element);
    const auto index = static_cast<std::uint32_t>(scene_.nodes.size());
    scene_.nodes.push_back({});
    Name(document, element, open);
    AddPorts(document, element);
    if (scene_.nodes[index].shape == Shape::kSubTree && element.child_count == 0) {
      OpenSubTree(document, element, index, open);
    } else {
      PushChildren(open.document, element, index, open.scope, open.tree);
    }
  }

  void Name(const Document& document, const Element& element, const Open& open) {
    SceneNode& node = scene_.nodes.back();
    node.parent = open.parent;
    node.number = open.number;
    node.document = open.document;
    node.element = open.element;
    node.scope = open.scope;
    node.path = open.parent == kNoSceneNode
                    ? std::to_string(open.number)
                    : scene_.nodes[open.parent].path + "." + std::to_string(open.number);
    const std::string_view id = document.AttributeValue(element, "ID");
    const TagMeaning& tag = MeaningOf(element.tag);
    const std::optional<NodeCategory> explicit_category = tag.category;
    node.id = explicit_category && !id.empty() ? id : element.tag;
    const bool is_subtree = element.tag == "SubTree" || element.tag == "SubTreePlus";
    if (element.tag == "SubTreePlus") node.id = id;
    node.name = document.AttributeValue(element, "name");
    if (node.name.empty()) node.name = node.id;
    node.model = node.id.data() == element.tag.data() ? tag.model : models_.Find(node.id);
    if (is_subtree) {
      node.shape = Shape::kSubTree;
      node.autoremap = IsAutoremapped(document, element);
    } else if (explicit_category) {
      node.shape = ShapeOf(*explicit_category);
    } else if (node.model) {
      node.shape = ShapeOf(node.model->category);
    }
    node.disabled = document.AttributeValue(element, "_skipIf") == "true" ||
                    (open.parent != kNoSceneNode && scene_.nodes[open.parent].disabled);
    node.note = open.tree == 0 ? NoteOf(document, open.element) : KnownNote(document, open.element);
    text_bytes_ += node.path.size() + node.note.size();
    if (open.tree != 0) text_bytes_ += TextOf(document, element);
  }

  // What there is to measure and to paint in each instance.
  static std::size_t TextOf(const Document& document, const Element& element) {
    std::size_t bytes = element.tag.size();
    for (const Attribute* a = document.attributes_begin(element);
         a != document.attributes_end(element); ++a) {
      bytes += a->name.size() + a->value.size();
    }
    return bytes;
  }

  // Looked for once, however often the tree is written out.
  const std::string& KnownNote(const Document& document, ElementIndex element) {
    const auto [at, is_new] = notes_.try_emplace(&document.element(element));
    if (is_new) at->second = NoteOf(document, element);
    return at->second;
  }

  // The same few tags come again and again.
  const TagMeaning& MeaningOf(std::string_view tag) {
    const auto [at, is_new] = tags_.try_emplace(tag);
    if (is_new) at->second = {CategoryFromTag(tag), models_.Find(tag)};
    return at->second;
  }

  // Declared ports first, in the declared order; then the others as they are written.
  void AddPorts(const Document& document, const Element& element) {
    SceneNode& node = scene_.nodes.back();
    node.first_port = static_cast<std::uint32_t>(scene_.ports.size());
    undeclared_.clear();
    for (const Attribute* a = document.attributes_begin(element);
         a != document.attributes_end(element); ++a) {
      if (!IsHidden(a->name)) undeclared_.push_back(a);
    }
    if (node.model && node.shape != Shape::kSubTree) {
      for (const PortModel& port : node.model->ports) {
        const auto given = std::find_if(undeclared_.begin(), undeclared_.end(),
                                        [&](const Attribute* a) { return a->name == port.name; });
        if (given == undeclared_.end()) continue;
        AddPort(**given, &port);
        undeclared_.erase(given);
      }
    }
    for (const Attribute* a : undeclared_) AddPort(*a, nullptr);
    node.port_count = static_cast<std::uint32_t>(scene_.ports.size()) - node.first_port;
  }

  void AddPort(const Attribute& given, const PortModel* model) {
    scene_.ports.push_back(
        {given.name, given.value, model ? model->direction : PortDirection::kInput,
         IsReservedAttribute(given.name) ? std::string_view() : KeyOf(given.value, given.name),
         model});
  }

  void OpenSubTree(const Document& document, const Element& element, std::uint32_t index,
                   const Open& open) {
    const int tree = forest_.Resolve(document, element);
    if (tree < 0) return;
    if (IsInside(tree, open.tree) || scene_.nodes.size() + open_.size() > limit_ ||
        text_bytes_ > kMostTextBytes) {
      scene_.nodes[index].recursive = true;
      return;
    }
    const TreeEntry& entry = forest_.trees()[static_cast<std::size_t>(tree)];
    const auto scope = static_cast<std::uint32_t>(scene_.scopes.size());
    scene_.scopes.push_back(entry.instance_path.empty() ? InstancePath(index, open.scope)
                                                        : entry.instance_path);
    text_bytes_ += scene_.scopes.back().size();
    trees_.push_back({tree, open.tree});
    PushChildren(entry.document, forest_.documents()[entry.document]->element(entry.element), index,
                 scope, static_cast<std::uint32_t>(trees_.size() - 1));
  }

  // Below the main tree the path starts anew, as the engine writes it.
  std::string InstancePath(std::uint32_t index, std::uint32_t scope) const {
    const std::string name(scene_.nodes[index].name);
    return scope == 0 ? name : scene_.scopes[scope] + "/" + name;
  }

  bool IsInside(int tree, std::uint32_t instance) const {
    for (; instance != kNone; instance = trees_[instance].outer) {
      if (trees_[instance].tree == tree) return true;
    }
    return false;
  }

  void CloseRanges() {
    for (auto i = static_cast<std::uint32_t>(scene_.nodes.size()); i-- > 0;) {
      SceneNode& node = scene_.nodes[i];
      node.end = std::max(node.end, i + 1);
      if (node.parent == kNoSceneNode) continue;
      SceneNode& parent = scene_.nodes[node.parent];
      parent.end = std::max(parent.end, node.end);
    }
  }

  const Forest& forest_;
  const NodeModels& models_;
  const std::size_t limit_;
  Scene scene_;
  std::vector<Open> open_;
  std::vector<TreeInstance> trees_;
  std::unordered_map<std::string_view, TagMeaning> tags_;
  std::unordered_map<const Element*, std::string> notes_;  // of what may be written out again
  std::size_t text_bytes_ = 0;                             // paths, notes and scopes of the scene
  std::vector<const Attribute*> undeclared_;               // of the node that is being added
};

}  // namespace

std::uint32_t Scene::FindPath(std::string_view path) const {
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].path == path) return i;
  }
  return kNoSceneNode;
}

std::uint32_t Scene::FindElement(std::uint32_t document, ElementIndex element) const {
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].element == element && nodes[i].document == document) return i;
  }
  return kNoSceneNode;
}

Scene BuildScene(const Forest& forest, int tree, const NodeModels& models, std::size_t limit) {
  if (tree < 0 || static_cast<std::size_t>(tree) >= forest.trees().size()) return {};
  return Builder(forest, models, limit).Build(tree);
}

}  // namespace coppice::editor
