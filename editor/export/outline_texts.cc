#include "editor/export/outline_texts.h"

#include <algorithm>

namespace coppice::editor {
namespace {

std::string Quoted(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c == '\n' || c == '\r' ? ' ' : c;
  }
  return quoted + "\"";
}

const char* DotShape(Shape shape) {
  switch (shape) {
    case Shape::kControl:
      return "box,style=rounded";
    case Shape::kDecorator:
      return "hexagon";
    case Shape::kCondition:
      return "octagon";
    case Shape::kSubTree:
      return "box,peripheries=2";
    case Shape::kAction:
      return "box";
    case Shape::kUnknown:
      return "box,style=dotted";
  }
  return "box";
}

// "MoveTo: goal {goal}, speed 0.4"; the type only if the name does not say it.
std::string Label(const Scene& scene, const SceneNode& node, const char* separator) {
  std::string label(node.name);
  if (node.name != node.id) label += " (" + std::string(node.id) + ")";
  for (std::uint32_t p = node.first_port; p < node.first_port + node.port_count; ++p) {
    label += p == node.first_port ? separator : ", ";
    label += std::string(scene.ports[p].name) + " " + std::string(scene.ports[p].value);
  }
  return label;
}

// What Markdown would read as its own signs.
std::string Plain(std::string_view text) {
  std::string plain;
  for (const char c : text) {
    if (std::string_view("\\`*_[]<>#|").find(c) != std::string_view::npos) plain += '\\';
    plain += c == '\n' || c == '\r' ? ' ' : c;
  }
  return plain;
}

std::size_t Depth(const SceneNode& node) {
  return static_cast<std::size_t>(std::count(node.path.begin(), node.path.end(), '.'));
}

}  // namespace

std::string ToDot(const std::vector<const Scene*>& trees) {
  std::string dot = "digraph {\n  node [fontname=\"DejaVu Sans\", fontsize=10];\n";
  for (std::size_t t = 0; t < trees.size(); ++t) {
    const Scene& scene = *trees[t];
    const std::string prefix = "t" + std::to_string(t) + "n";
    dot += "  subgraph cluster_" + std::to_string(t) + " {\n    label=" + Quoted(scene.tree_id) +
           ";\n";
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
      const SceneNode& node = scene.nodes[i];
      const std::string name = prefix + std::to_string(i);
      dot += "    " + name + " [label=" + Quoted(Label(scene, node, ": ")) +
             ",shape=" + DotShape(node.shape) + "];\n";
      if (node.parent == kNoSceneNode) continue;
      dot += "    " + prefix + std::to_string(node.parent) + " -> " + name + ";\n";
    }
    dot += "  }\n";
  }
  return dot + "}\n";
}

std::string ToMarkdown(const std::vector<const Scene*>& trees) {
  std::string text;
  for (const Scene* scene : trees) {
    if (!text.empty()) text += "\n";
    text += "## " + Plain(scene->tree_id) + "\n\n";
    for (const SceneNode& node : scene->nodes) {
      text += std::string(2 * Depth(node), ' ') + "- " + Plain(Label(*scene, node, ": "));
      const bool is_first = node.parent == kNoSceneNode || !scene->nodes[node.parent].disabled;
      if (node.disabled && is_first) text += " (disabled)";
      if (!node.note.empty()) text += " — *" + Plain(node.note) + "*";
      text += "\n";
    }
  }
  return text;
}

}  // namespace coppice::editor
