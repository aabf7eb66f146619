#include "bt_core/engine/compile/schema.h"

#include <string_view>

#include "bt_core/data/enum.h"
#include "bt_core/engine/compile/models.h"
#include "bt_core/nodes/guards.h"

namespace coppice {
namespace {

constexpr char kFrame[] = R"(  <xs:simpleType name="key">
    <xs:restriction base="xs:string"><xs:pattern value="\s*(\{[^{}]+\}|=)\s*"/></xs:restriction>
  </xs:simpleType>
  <xs:simpleType name="whole_number">
    <xs:restriction base="xs:string"><xs:pattern value="\s*[+\-]?[0-9]+\s*"/></xs:restriction>
  </xs:simpleType>
  <xs:simpleType name="whole_number_or_key">
    <xs:union memberTypes="whole_number key"/>
  </xs:simpleType>
  <xs:simpleType name="number_or_key"><xs:union memberTypes="xs:double key"/></xs:simpleType>
  <xs:element name="root">
    <xs:complexType>
      <xs:choice minOccurs="0" maxOccurs="unbounded">
        <xs:element name="include">
          <xs:complexType>
            <xs:attribute name="path" type="xs:string" use="required"/>
            <xs:attribute name="ros_pkg" type="xs:string"/>
          </xs:complexType>
        </xs:element>
        <xs:element name="BehaviorTree">
          <xs:complexType>
            <xs:group ref="node"/>
            <xs:attribute name="ID" type="xs:string" use="required"/>
            <xs:attributeGroup ref="for_editors"/>
          </xs:complexType>
        </xs:element>
        <xs:element name="TreeNodesModel">
          <xs:complexType mixed="true">
            <xs:sequence>
              <xs:any minOccurs="0" maxOccurs="unbounded" processContents="skip"/>
            </xs:sequence>
          </xs:complexType>
        </xs:element>
      </xs:choice>
      <xs:attribute name="BTCPP_format" type="xs:string"/>
      <xs:attribute name="main_tree_to_execute" type="xs:string"/>
    </xs:complexType>
  </xs:element>
  <xs:complexType name="generic">
    <xs:group ref="node" minOccurs="0" maxOccurs="unbounded"/>
    <xs:attribute name="ID" type="xs:string" use="required"/>
    <xs:anyAttribute processContents="skip"/>
  </xs:complexType>
)";

constexpr const char* kGenericForms[] = {"Action", "Condition", "Control", "Decorator", "SubTree"};

std::string Attribute(std::string_view name, const std::string& rest) {
  return "<xs:attribute name=\"" + EscapeXml(name) + "\"" + rest;
}

// What every node may carry.
std::string AttributeGroups() {
  std::string xsd = "  <xs:attributeGroup name=\"for_editors\">\n";
  for (const char* name : {"_description", "_collapsed", "_uid", "_fullpath"}) {
    xsd += "    " + Attribute(name, " type=\"xs:string\"/>\n");
  }
  xsd += "  </xs:attributeGroup>\n  <xs:attributeGroup name=\"of_every_node\">\n    " +
         Attribute("name", " type=\"xs:string\"/>\n");
  for (const std::string_view guard : kGuardAttributes) {
    xsd += "    " + Attribute(guard, " type=\"xs:string\"/>\n");
  }
  return xsd + "    <xs:attributeGroup ref=\"for_editors\"/>\n  </xs:attributeGroup>\n";
}

std::string AnyNode(const Registry& registry) {
  std::string xsd = "  <xs:group name=\"node\">\n    <xs:choice>\n";
  const auto add = [&xsd](std::string_view id) {
    xsd += "      <xs:element ref=\"" + EscapeXml(id) + "\"/>\n";
  };
  for (const char* form : kGenericForms) add(form);
  for (const auto& [id, entry] : registry.entries()) {
    if (entry.type != NodeType::kSubTree) add(id);
  }
  return xsd + "    </xs:choice>\n  </xs:group>\n";
}

std::string ChoicesOrKey(const EnumeratorList& choices) {
  std::string xsd =
      "<xs:simpleType><xs:union memberTypes=\"key whole_number\"><xs:simpleType>"
      "<xs:restriction base=\"xs:string\">";
  for (const Enumerator& choice : choices) {
    xsd += "<xs:enumeration value=\"" + EscapeXml(choice.name) + "\"/>";
  }
  return xsd + "</xs:restriction></xs:simpleType></xs:union></xs:simpleType>";
}

std::string TypeAttribute(const PortDeclaration& port) {
  if (port.direction != PortDirection::kInput && port.type) return " type=\"key\"";
  const TypeKind kind = port.type ? port.type->kind : TypeKind::kOther;
  switch (kind) {
    case TypeKind::kInt:
    case TypeKind::kUnsigned:
    case TypeKind::kInt64:
    case TypeKind::kUint64:
      return " type=\"whole_number_or_key\"";
    case TypeKind::kFloat:
    case TypeKind::kDouble:
      return " type=\"number_or_key\"";
    case TypeKind::kEnum:
      return "";  // a type of its own inside of the element
    default:
      return " type=\"xs:string\"";
  }
}

std::string Port(const PortDeclaration& port) {
  const std::string use = port.required ? " use=\"required\"" : "";
  std::string xsd = "      " + Attribute(port.name, TypeAttribute(port) + use + ">") +
                    "<xs:annotation><xs:documentation>" + EscapeXml(port.description) +
                    "</xs:documentation></xs:annotation>";
  const bool own = port.direction == PortDirection::kInput && port.type && port.type->enumerators;
  if (own) xsd += ChoicesOrKey(*port.type->enumerators);
  return xsd + "</xs:attribute>\n";
}

std::string Children(ChildCount children) {
  if (children.max == 0) return {};
  const std::string max = children.max == UINT32_MAX ? "unbounded" : std::to_string(children.max);
  return "      <xs:group ref=\"node\" minOccurs=\"" + std::to_string(children.min) +
         "\" maxOccurs=\"" + max + "\"/>\n";
}

std::string Node(const Registry::Entry& entry) {
  std::string xsd =
      "  <xs:element name=\"" + EscapeXml(entry.manifest.id) +
      "\">\n    <xs:annotation><xs:documentation>" + EscapeXml(entry.manifest.description) +
      "</xs:documentation></xs:annotation>\n    <xs:complexType>\n" + Children(entry.children);
  for (const PortDeclaration& port : entry.manifest.ports) xsd += Port(port);
  return xsd +
         "      <xs:attributeGroup ref=\"of_every_node\"/>\n    </xs:complexType>\n"
         "  </xs:element>\n";
}

}  // namespace

std::string WriteSchema(const Registry& registry) {
  std::string xsd =
      "<xs:schema xmlns:xs=\"http://www.w3.org/2001/XMLSchema\" "
      "elementFormDefault=\"qualified\">\n";
  xsd += kFrame + AttributeGroups() + AnyNode(registry);
  for (const char* form : kGenericForms) {
    xsd += std::string("  <xs:element name=\"") + form + "\" type=\"generic\"/>\n";
  }
  for (const auto& [id, entry] : registry.entries()) {
    if (entry.type != NodeType::kSubTree) xsd += Node(entry);
  }
  return xsd + "</xs:schema>\n";
}

}  // namespace coppice
