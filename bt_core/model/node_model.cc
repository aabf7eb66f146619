#include "bt_core/model/node_model.h"

#include <algorithm>

namespace coppice {
namespace {

constexpr std::size_t kMostPorts = 1000;  // no element can give more of them

std::optional<PortDirection> DirectionFromTag(std::string_view tag) {
  if (tag == "input_port") return PortDirection::kInput;
  if (tag == "output_port") return PortDirection::kOutput;
  if (tag == "inout_port") return PortDirection::kInOut;
  return std::nullopt;
}

class Reader {
 public:
  Reader(const Document& document, Diagnostics& diagnostics)
      : document_(document), diagnostics_(diagnostics) {}

  std::optional<NodeModel> Read(ElementIndex index) {
    const Element& element = document_.element(index);
    const auto category = CategoryFromTag(element.tag);
    const std::string tag(element.tag);
    if (!category) {
      Warn(element, "<" + tag + "> in <TreeNodesModel> is ignored",
           DidYouMean(tag, {"Action", "Condition", "Control", "Decorator", "SubTree"}));
      return std::nullopt;
    }
    NodeModel model;
    model.id = document_.AttributeValue(element, "ID");
    model.category = *category;
    model.element = index;
    if (model.id.empty()) {
      Warn(element, "model <" + tag + "> without ID is ignored", "");
      return std::nullopt;
    }
    for (ElementIndex i = element.first_child; i != kNoElement;
         i = document_.element(i).next_sibling) {
      ReadPart(document_.element(i), model);
    }
    return model;
  }

 private:
  void ReadPart(const Element& part, NodeModel& model) {
    if (const auto direction = DirectionFromTag(part.tag)) {
      ReadPort(part, *direction, model);
    } else if (part.tag == "MetadataFields") {
      for (ElementIndex i = part.first_child; i != kNoElement;
           i = document_.element(i).next_sibling) {
        ReadMetadata(document_.element(i), model);
      }
    } else if (part.tag == "description") {
      model.description = document_.TextOf(part);
    } else {
      const std::string tag(part.tag);
      Warn(part, "<" + tag + "> in the model of \"" + model.id + "\" is ignored",
           DidYouMean(
               tag, {"input_port", "output_port", "inout_port", "MetadataFields", "description"}));
    }
  }

  void ReadPort(const Element& element, PortDirection direction, NodeModel& model) {
    PortModel port;
    port.name = document_.AttributeValue(element, "name");
    port.direction = direction;
    port.type = document_.AttributeValue(element, "type");
    port.description = document_.TextOf(element);
    if (const Attribute* text = document_.FindAttribute(element, "default")) {
      port.default_text = std::string(text->value);
    }
    if (port.name.empty()) {
      Warn(element, "port without name in the model of \"" + model.id + "\" is ignored", "");
    } else if (model.ports.size() >= kMostPorts) {
      Warn(element,
           "port \"" + port.name + "\" is beyond the first " + std::to_string(kMostPorts) +
               " of the model of \"" + model.id + "\", and is ignored",
           "");
    } else if (model.FindPort(port.name)) {
      Warn(element,
           "second port \"" + port.name + "\" in the model of \"" + model.id + "\" is ignored", "");
    } else {
      model.ports.push_back(std::move(port));
    }
  }

  void ReadMetadata(const Element& element, NodeModel& model) {
    for (const Attribute* a = document_.attributes_begin(element);
         a != document_.attributes_end(element); ++a) {
      if (a->name == "description") model.description = a->value;
      model.metadata.emplace_back(a->name, a->value);
    }
  }

  void Warn(const Element& element, std::string message, std::string hint) {
    diagnostics_.Warning(document_.Location(element.offset), std::move(message), std::move(hint));
  }

  const Document& document_;
  Diagnostics& diagnostics_;
};

}  // namespace

const PortModel* NodeModel::FindPort(std::string_view name) const {
  const auto found = std::find_if(ports.begin(), ports.end(),
                                  [name](const PortModel& port) { return port.name == name; });
  return found == ports.end() ? nullptr : &*found;
}

bool HasSameInterface(const NodeModel& a, const NodeModel& b) {
  return a.category == b.category && a.ports.size() == b.ports.size() &&
         std::all_of(a.ports.begin(), a.ports.end(), [&b](const PortModel& port) {
           const PortModel* other = b.FindPort(port.name);
           return other && other->direction == port.direction && other->type == port.type &&
                  other->default_text == port.default_text;
         });
}

std::vector<NodeModel> ReadModels(const Document& document, const Element& tree_nodes_model,
                                  std::uint32_t number, Diagnostics& diagnostics) {
  std::vector<NodeModel> models;
  Reader reader(document, diagnostics);
  for (ElementIndex i = tree_nodes_model.first_child; i != kNoElement;
       i = document.element(i).next_sibling) {
    if (std::optional<NodeModel> model = reader.Read(i)) {
      model->document = number;
      models.push_back(*std::move(model));
    }
  }
  return models;
}

}  // namespace coppice
