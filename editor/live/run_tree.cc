#include "editor/live/run_tree.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace coppice::editor {
namespace {

Forest ReadForest(const TreeDescription& description, Diagnostics& problems) {
  std::vector<Document> documents;
  for (const DescribedDocument& described : description.documents) {
    auto document = Document::FromText(described.text, described.file, problems);
    if (!document) return {};
    documents.push_back(*std::move(document));
  }
  return Forest::FromDocuments(std::move(documents), description.main_tree);
}

// A question that is a key has no words yet.
std::string WordsOf(const DescribedNode& node, const Forest& forest) {
  if (node.document >= forest.documents().size()) return node.path;
  const Document& document = *forest.documents()[node.document];
  if (node.element >= document.elements().size()) return node.path;
  const Attribute* const question =
      document.FindAttribute(document.element(node.element), "question");
  const bool has_words = question && !question->value.empty() && question->value[0] != '{';
  return has_words ? std::string(question->value) : node.path;
}

}  // namespace

RunTree::RunTree(std::shared_ptr<const TreeDescription> description, const NodeModels& known)
    : description_(std::move(description)),
      forest_(ReadForest(*description_, problems_)),
      models_(known) {
  for (const Document* document : forest_.documents()) models_.AddFrom(*document);
  if (!description_->models.empty()) {
    const auto models = Document::FromText(description_->models, "models", problems_);
    if (models) models_.AddTold(*models, "the running program");
  }
  for (NodeIndex i{0}; i < description_->nodes.size(); ++i) {
    const DescribedNode& node = description_->nodes[i];
    if (AsksPeople(node.id, models_)) asking_.push_back({i, WordsOf(node, forest_)});
  }
}

bool AsksPeople(std::string_view id, const NodeModels& models) {
  if (id == "AskSupervisor" || id == "RequestHelp") return true;
  const KnownModel* const model = models.Find(id);
  if (!model) return false;
  return std::any_of(model->metadata.begin(), model->metadata.end(),
                     [](const auto& field) { return field.first == "asks"; });
}

const RecordedTree& RunTree::recorded() const {
  if (!recorded_) {
    Diagnostics ignored;  // without a program less can be asked, that is all
    recorded_ = CompileRecorded(*description_, std::make_shared<Registry>(), ignored);
  }
  return *recorded_;
}

// Both list children in the order of the text, so each search goes on behind the child before.
void NumberNodes(const TreeDescription& description, Scene& scene) {
  const TreeShape shape = ShapeOf(description);
  scene.of_run_node.assign(shape.size(), kNoSceneNode);
  std::vector<NodeIndex> next(shape.size());  // per node of the run: its first child to look at
  for (NodeIndex i{0}; i < next.size(); ++i) next[i] = i + 1;
  for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
    SceneNode& node = scene.nodes[i];
    node.run_node = kNoNode;
    const bool is_root = node.parent == kNoSceneNode;
    const NodeIndex parent = is_root ? kRootNode : scene.nodes[node.parent].run_node;
    if (parent >= shape.size()) continue;
    NodeIndex at = is_root ? kRootNode : next[parent];
    const NodeIndex end = shape[parent].end;
    const auto fits = [&](const DescribedNode& other) {
      return other.element == node.element && other.document == node.document;
    };
    while (at < end && !fits(description.nodes[at])) at = shape[at].end;
    if (at >= end) continue;
    node.run_node = at;
    scene.of_run_node[at] = i;
    if (!is_root) next[parent] = shape[at].end;
  }
}

}  // namespace coppice::editor
