#include "editor/document/model_edits.h"

#include <string>

#include "bt_core/model/attribute_edits.h"
#include "bt_core/model/element_edits.h"
#include "bt_core/model/layout.h"
#include "bt_core/model/xml_text.h"

namespace coppice::editor {
namespace {

constexpr char kModels[] = "TreeNodesModel";

std::string Attribute(const char* name, std::string_view value) {
  return std::string(" ") + name + "=\"" + EscapeXmlValue(value, '"') + "\"";
}

// As the content of an element.
std::string EscapeText(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '&') {
      escaped += "&amp;";
    } else if (c == '<') {
      escaped += "&lt;";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

std::string TagOf(PortDirection direction) { return std::string(ToString(direction)) + "_port"; }

std::string PortXml(const PortModel& port) {
  const std::string tag = TagOf(port.direction);
  std::string xml = "<" + tag + Attribute("name", port.name);
  if (!port.type.empty()) xml += Attribute("type", port.type);
  if (port.default_text) xml += Attribute("default", *port.default_text);
  if (port.description.empty()) return xml + "/>";
  return xml + ">" + EscapeText(port.description) + "</" + tag + ">";
}

std::string ModelXml(const NodeModel& model, const std::string& line, const std::string& step) {
  std::string inside;
  for (const PortModel& port : model.ports) inside += line + step + PortXml(port);
  if (!model.description.empty()) {
    inside += line + step + "<MetadataFields><Metadata" +
              Attribute("description", model.description) + "/></MetadataFields>";
  }
  const std::string tag = ToString(model.category);
  const std::string start = "<" + tag + Attribute("ID", model.id);
  return inside.empty() ? start + "/>" : start + ">" + inside + line + "</" + tag + ">";
}

ElementIndex ChildWithTag(const Document& document, ElementIndex parent, std::string_view tag) {
  for (ElementIndex i = document.element(parent).first_child; i != kNoElement;
       i = document.element(i).next_sibling) {
    if (document.element(i).tag == tag) return i;
  }
  return kNoElement;
}

// Makes that the text of an element without children. An end tag that this needs is called `tag`.
Edit SetText(const Document& document, ElementIndex index, std::string_view text,
             std::string_view tag) {
  const Element& element = document.element(index);
  if (document.TextOf(element) == text || element.child_count > 0) return {};
  if (element.is_self_closing()) {
    return {Replacement(element.end - 2, element.end,
                        ">" + EscapeText(text) + "</" + std::string(tag) + ">")};
  }
  return {Replacement(element.start_tag_end, EndTagOffset(document, element), EscapeText(text))};
}

// Takes an empty attribute away.
Edit SetOrRemove(const Document& document, ElementIndex element, const char* name,
                 std::string_view value) {
  return value.empty() ? RemoveAttribute(document, element, name)
                       : SetAttribute(document, element, name, value);
}

}  // namespace

ElementIndex FindModel(const Document& document, std::string_view id) {
  for (ElementIndex i{0}; i < document.elements().size(); ++i) {
    const Element& element = document.element(i);
    if (element.parent == kNoElement || document.element(element.parent).tag != kModels) continue;
    if (CategoryFromTag(element.tag) && document.AttributeValue(element, "ID") == id) return i;
  }
  return kNoElement;
}

ElementIndex FindPort(const Document& document, ElementIndex model, std::string_view name) {
  for (ElementIndex i = document.element(model).first_child; i != kNoElement;
       i = document.element(i).next_sibling) {
    if (document.AttributeValue(document.element(i), "name") == name) return i;
  }
  return kNoElement;
}

Edit AddModel(const Document& document, const NodeModel& model) {
  const std::string line(LineEndAt(document.text(), document.element(kRootElement).offset));
  return AddModel(document,
                  ModelXml(model, line, std::string(IndentationStep(document, kRootElement))));
}

Edit AddModel(const Document& document, std::string_view xml) {
  const ElementIndex models = ChildWithTag(document, kRootElement, kModels);
  if (models != kNoElement) return InsertElement(document, models, UINT32_MAX, xml);
  const std::string line(LineEndAt(document.text(), document.element(kRootElement).offset));
  const std::string step(IndentationStep(document, kRootElement));
  return InsertElement(document, kRootElement, UINT32_MAX,
                       "<TreeNodesModel>" + line + step + Reindent(xml, "", step, line) + line +
                           "</TreeNodesModel>");
}

Edit RemoveModel(const Document& document, ElementIndex model) {
  const ElementIndex models = document.element(model).parent;
  return RemoveElement(document, document.element(models).child_count == 1 ? models : model);
}

Edit DescribeModel(const Document& document, ElementIndex model, std::string_view description) {
  const ElementIndex said = ChildWithTag(document, model, "description");
  if (said != kNoElement) return SetText(document, said, description, "description");
  const ElementIndex fields = ChildWithTag(document, model, "MetadataFields");
  const std::string field = "<Metadata" + Attribute("description", description) + "/>";
  if (fields == kNoElement) {
    if (description.empty()) return {};
    return InsertElement(document, model, UINT32_MAX,
                         "<MetadataFields>" + field + "</MetadataFields>");
  }
  for (ElementIndex i = document.element(fields).first_child; i != kNoElement;
       i = document.element(i).next_sibling) {
    if (!document.FindAttribute(document.element(i), "description")) continue;
    return SetAttribute(document, i, "description", description);
  }
  return InsertElement(document, fields, UINT32_MAX, field);
}

Edit AddPort(const Document& document, ElementIndex model, const PortModel& port) {
  std::uint32_t position = 0;  // in front of <MetadataFields>
  std::uint32_t number = 0;
  for (ElementIndex i = document.element(model).first_child; i != kNoElement;
       i = document.element(i).next_sibling) {
    ++number;
    if (document.FindAttribute(document.element(i), "name")) position = number;
  }
  return InsertElement(document, model, position, PortXml(port));
}

Edit ChangePort(const Document& document, ElementIndex element, const PortModel& port) {
  const std::string tag = TagOf(port.direction);
  Edit edit = SetTag(document, element, tag);
  edit = Merge(std::move(edit), SetAttribute(document, element, "name", port.name));
  edit = Merge(std::move(edit), SetOrRemove(document, element, "type", port.type));
  edit = Merge(std::move(edit), port.default_text
                                    ? SetAttribute(document, element, "default", *port.default_text)
                                    : RemoveAttribute(document, element, "default"));
  return Merge(std::move(edit), SetText(document, element, port.description, tag));
}

}  // namespace coppice::editor
