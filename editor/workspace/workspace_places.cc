// The part of the workspace that finds the nodes of elements, and the elements of nodes.
#include <algorithm>
#include <utility>

#include "editor/workspace/workspace.h"

namespace coppice::editor {

std::optional<ElementPlace> Workspace::PlaceOf(const SceneNode& node) const {
  if (run_ >= 0 || !file() || file()->is_stale) return std::nullopt;
  const Document& document = *forest()->documents()[node.document];
  const EditedFile* edited = project_.Find(document.file());
  // A file of format 3 is shown as format 4, element by element the same.
  const bool fits = edited && edited->document &&
                    edited->document->elements().size() == document.elements().size();
  return fits ? std::optional(ElementPlace{edited->path, node.element}) : std::nullopt;
}

std::optional<ElementPlace> Workspace::ShownTree() const {
  if (run_ >= 0 || !file() || tree_ < 0) return std::nullopt;
  const TreeEntry& tree = forest()->trees()[Index(tree_)];
  SceneNode node;
  node.document = tree.document;
  node.element = tree.element;
  return PlaceOf(node);
}

bool Workspace::IsOfOtherElements() const {
  if (run_ >= 0 || !file() || file()->is_stale || tree_ < 0) return false;
  const Document& shown = *forest()->documents()[forest()->trees()[Index(tree_)].document];
  const EditedFile* edited = project_.Find(shown.file());
  return edited && edited->document &&
         edited->document->elements().size() != shown.elements().size();
}

std::string Workspace::ShownTreeId() const {
  return forest() && tree_ >= 0 ? forest()->trees()[Index(tree_)].id : std::string();
}

// An element may be shown several times, where a SubTree is used several times: the one that is
// selected already comes first.
std::vector<std::uint32_t> Workspace::NodesAt(const std::vector<FilePlace>& places) const {
  std::vector<std::uint32_t> found;
  if (!view_) return found;
  const auto& documents = forest()->documents();
  const auto& nodes = view_->scene()->nodes;
  for (const FilePlace& place : places) {
    const EditedFile* edited = project_.Find(place.path);
    if (!edited || !edited->document) continue;
    const ElementIndex element = edited->document->ElementAt(place.offset);
    std::uint32_t first = kNoSceneNode;
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
      if (nodes[i].element != element || documents[nodes[i].document]->file() != edited->path) {
        continue;
      }
      if (first == kNoSceneNode || view_->IsSelected(i)) first = i;
    }
    if (first != kNoSceneNode) found.push_back(first);
  }
  return found;
}

bool Workspace::IsInShownTree(const FilePlace& place) const {
  const std::optional<ElementPlace> tree = ShownTree();
  if (!tree || tree->path != place.path) return false;
  const Element& element = project_.Find(tree->path)->document->element(tree->element);
  return place.offset >= element.offset && place.offset < element.end;
}

bool Workspace::ShowTreeOf(const FilePlace& place, double now) {
  for (std::size_t f = 0; f < files_.size(); ++f) {
    const Forest& forest = *files_[f].forest;
    for (std::size_t t = 0; t < forest.trees().size(); ++t) {
      const TreeEntry& tree = forest.trees()[t];
      const Document& document = *forest.documents()[tree.document];
      if (document.file() != place.path) continue;
      const EditedFile* edited = project_.Find(place.path);
      if (!edited || !edited->document) return false;
      const Element& element = edited->document->element(tree.element);
      if (place.offset < element.offset || place.offset >= element.end) continue;
      ShowFileTree(f, static_cast<int>(t), now);
      return true;
    }
  }
  return false;
}

void Workspace::SelectPlaces(const std::vector<FilePlace>& places, double now) {
  if (places.empty() || run_ >= 0) return;
  std::vector<std::uint32_t> nodes = NodesAt(places);
  if (nodes.empty() && !IsInShownTree(places.front()) && ShowTreeOf(places.front(), now)) {
    nodes = NodesAt(places);
  }
  if (view_) view_->SelectAll(std::move(nodes));
}

bool Workspace::SelectElement(const Document& document, ElementIndex element) {
  if (!view_ || !forest()) return false;
  const Scene& scene = *view_->scene();
  for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
    const SceneNode& node = scene.nodes[i];
    if (node.element == element && forest()->documents()[node.document] == &document) {
      view_->Select(i);
      return true;
    }
  }
  return false;
}

}  // namespace coppice::editor
