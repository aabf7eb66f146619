#include <algorithm>
#include <map>
#include <utility>

#include "behaviortree_cpp/xml_parsing.h"
#include "bt_core/compat/tree_run.h"
#include "bt_core/engine/compile/models.h"
#include "bt_core/engine/compile/schema.h"
#include "bt_core/engine/program.h"
#include "bt_core/nodes/guards.h"

namespace BT {
namespace {

using coppice::NodeIndex;
using coppice::Program;

std::string Escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&apos;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string Attribute(std::string_view name, std::string_view value) {
  return StrCat(" ", name, "=\"", Escaped(value), "\"");
}

std::string Indent(int depth) { return std::string(static_cast<std::size_t>(depth) * 4, ' '); }

// ---- Models.

std::string TagOf(PortDirection direction) {
  if (direction == PortDirection::INPUT) return "input_port";
  return direction == PortDirection::OUTPUT ? "output_port" : "inout_port";
}

std::string PortXml(const std::string& name, const PortInfo& port, int depth) {
  const std::string tag = TagOf(port.direction());
  std::string xml = StrCat(Indent(depth), "<", tag, Attribute("name", name));
  if (port.isStronglyTyped()) xml += Attribute("type", port.typeName());
  if (!port.defaultValue().empty()) xml += Attribute("default", port.defaultValueString());
  if (port.description().empty()) return xml + "/>\n";
  return StrCat(xml, ">", Escaped(port.description()), "</", tag, ">\n");
}

std::string MetadataXml(const KeyValueVector& metadata, int depth) {
  if (metadata.empty()) return {};
  std::string xml = Indent(depth) + "<MetadataFields>\n";
  for (const auto& [key, value] : metadata) {
    xml += StrCat(Indent(depth + 1), "<Metadata", Attribute(key, value), "/>\n");
  }
  return StrCat(xml, Indent(depth), "</MetadataFields>\n");
}

std::string ModelXml(const TreeNodeManifest& manifest, int depth) {
  const std::string tag = toStr(manifest.type);
  const std::string start =
      StrCat(Indent(depth), "<", tag, Attribute("ID", manifest.registration_ID));
  if (manifest.ports.empty() && manifest.metadata.empty()) return start + "/>\n";
  std::string xml = start + ">\n";
  for (const auto& [name, port] : manifest.ports) xml += PortXml(name, port, depth + 1);
  xml += MetadataXml(manifest.metadata, depth + 1);
  return StrCat(xml, Indent(depth), "</", tag, ">\n");
}

using Manifests = std::map<std::string, const TreeNodeManifest*>;

std::string ModelsXml(const Manifests& manifests) {
  if (manifests.empty()) return Indent(1) + "<TreeNodesModel/>\n";
  std::string xml = Indent(1) + "<TreeNodesModel>\n";
  for (const auto& [id, manifest] : manifests) xml += ModelXml(*manifest, 2);
  return xml + Indent(1) + "</TreeNodesModel>\n";
}

// The order of names, built-in nodes only if they are asked for.
Manifests Chosen(const std::unordered_map<std::string, TreeNodeManifest>& all, bool built_in) {
  static const BehaviorTreeFactory plain;
  Manifests chosen;
  for (const auto& [id, manifest] : all) {
    if (built_in || plain.builtinNodes().count(id) == 0) chosen[id] = &manifest;
  }
  return chosen;
}

// ---- Trees.

class TreeWriter {
 public:
  TreeWriter(const Program& program, bool metadata) : program_(program), metadata_(metadata) {}

  std::string Write() const {
    std::string xml;
    for (const coppice::TreeInstance& tree : program_.trees) {
      xml += StrCat(Indent(1), "<BehaviorTree", Attribute("ID", tree.id),
                    Attribute("_fullpath", tree.path), ">\n");
      xml += Node(tree.root, 2);
      xml += Indent(1) + "</BehaviorTree>\n";
    }
    return xml;
  }

 private:
  std::string Node(NodeIndex node, int depth) const {
    const bool is_subtree = program_.nodes[node].type == coppice::NodeType::kSubTree;
    const std::string tag = is_subtree ? "SubTree" : program_.Id(node);
    std::string xml = StrCat(Indent(depth), "<", tag);
    if (is_subtree) {
      xml += Attribute("ID", program_.Id(node));
      if (metadata_) xml += Attribute("_fullpath", program_.Path(node));
    } else {
      xml += Attribute("name", program_.Name(node));
    }
    if (metadata_) xml += Attribute("_uid", std::to_string(static_cast<std::uint32_t>(node) + 1));
    xml += Written(node);
    const NodeIndex end = program_.nodes[node].end;
    if (is_subtree || end == node + 1) return xml + "/>\n";
    xml += ">\n";
    for (NodeIndex child = node + 1; child < end; child = program_.nodes[child].end) {
      xml += Node(child, depth + 1);
    }
    return StrCat(xml, Indent(depth), "</", tag, ">\n");
  }

  // Ports and conditions as they are in the text.
  std::string Written(NodeIndex node) const {
    std::string xml;
    const coppice::StartTag tag = program_.TagOf(node);
    for (const auto& [name, value] : tag.attributes) {
      if (name != "ID" && name != "name") xml += Attribute(name, value);
    }
    return xml;
  }

  const Program& program_;
  bool metadata_;
};

std::string InRoot(const std::string& inside) {
  return StrCat("<root BTCPP_format=\"4\">\n", inside, "</root>\n");
}

}  // namespace

std::string writeTreeNodesModelXML(const BehaviorTreeFactory& factory, bool include_builtin) {
  return InRoot(ModelsXml(Chosen(factory.manifests(), include_builtin)));
}

std::string writeTreeXSD(const BehaviorTreeFactory& factory) {
  return coppice::WriteSchema(*factory.registry());
}

std::string WriteTreeToXML(const Tree& tree, bool add_metadata, bool add_builtin_models) {
  const Program& program = tree.run().executor().program();
  return InRoot(TreeWriter(program, add_metadata).Write() +
                ModelsXml(Chosen(tree.manifests, add_builtin_models)));
}

}  // namespace BT
