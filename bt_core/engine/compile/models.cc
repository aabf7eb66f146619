#include "bt_core/engine/compile/models.h"

#include "bt_core/data/enum.h"
#include "bt_core/engine/compile/type_names.h"

namespace coppice {
namespace {

// With the choices of an enum, which a model has no other place for.
std::string Description(const PortDeclaration& port) {
  if (!port.type || !port.type->enumerators) return port.description;
  return port.description + ": " + Choices(*port.type->enumerators);
}

std::string Port(const PortDeclaration& port) {
  std::string tag = ToString(port.direction);
  tag += "_port";
  std::string xml = "      <" + tag + " name=\"" + EscapeXml(port.name) + "\" type=\"" +
                    EscapeXml(TypeName(port)) + "\"";
  if (port.default_text) xml += " default=\"" + EscapeXml(*port.default_text) + "\"";
  return xml + ">" + EscapeXml(Description(port)) + "</" + tag + ">\n";
}

}  // namespace

std::string EscapeXml(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\n':
        escaped += "&#10;";
        break;
      case '\r':
        escaped += "&#13;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string WriteModelsElement(const Registry& registry) {
  std::string xml = "  <TreeNodesModel>\n";
  for (const auto& [id, entry] : registry.entries()) {
    const std::string tag = ToString(entry.manifest.category);
    xml += "    <" + tag + " ID=\"" + EscapeXml(id) + "\">\n";
    for (const PortDeclaration& port : entry.manifest.ports) xml += Port(port);
    xml += "      <MetadataFields><Metadata description=\"" +
           EscapeXml(entry.manifest.description) + "\"/></MetadataFields>\n    </" + tag + ">\n";
  }
  return xml + "  </TreeNodesModel>\n";
}

std::string WriteModels(const Registry& registry) {
  return "<root BTCPP_format=\"4\">\n" + WriteModelsElement(registry) + "</root>\n";
}

std::string DescribeNodes(const Registry& registry) {
  std::string text;
  for (const auto& [id, entry] : registry.entries()) {
    text += id + "  (" + ToString(entry.manifest.category) + ")\n  " + entry.manifest.description +
            "\n";
    for (const PortDeclaration& port : entry.manifest.ports) {
      text +=
          std::string("    ") + ToString(port.direction) + " " + port.name + " : " + TypeName(port);
      if (port.default_text) text += " = " + *port.default_text;
      text += "  " + Description(port) + "\n";
    }
    text += "\n";
  }
  return text;
}

}  // namespace coppice
