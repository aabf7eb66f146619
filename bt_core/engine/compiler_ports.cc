#include "bt_core/engine/compiler_ports.h"

#include <algorithm>
#include <string>
#include <utility>

#include "bt_core/data/literal.h"

namespace coppice {
namespace {

bool IsScript(const PortDeclaration& port) { return port.type == &TypeOf<ScriptCode>(); }

}  // namespace

void PortBinder::Bind(const Registry::Entry& entry, const Site& site,
                      std::vector<PortBinding>& ports) {
  CheckNames(entry, site);
  for (const PortDeclaration& port : entry.declarations) {
    ports.push_back({BindPort(entry, port, site)});
  }
}

void PortBinder::CheckNames(const Registry::Entry& entry, const Site& site) {
  const std::vector<PortDeclaration>& ports = entry.manifest.ports;
  for (const Attribute& attribute : site) {
    if (IsReservedAttribute(attribute.name)) continue;
    const auto is_meant = [&](const PortDeclaration& port) { return port.name == attribute.name; };
    if (std::any_of(ports.begin(), ports.end(), is_meant)) continue;
    std::vector<std::string> names;
    for (const PortDeclaration& port : ports) names.push_back(port.name);
    problems_.Error(site.document, attribute.name_offset,
                    entry.manifest.id + " has no port " + Quoted(attribute.name),
                    DidYouMean(attribute.name, names));
  }
}

std::uint32_t PortBinder::BindPort(const Registry::Entry& entry, const PortDeclaration& port,
                                   const Site& site) {
  if (port.direction == PortDirection::kMailbox) return keys_.AddSlot("", site.scope, port.type);
  const Attribute* attribute = site.document.FindAttribute(site.element, port.name);
  if (!attribute && !port.default_text) {
    if (port.required) {
      problems_.Error(site.document, site.element.offset,
                      entry.manifest.id + " needs its port " + Quoted(port.name), port.description);
    }
    return kNoSlot;
  }
  const Given given{entry,
                    port,
                    site,
                    attribute,
                    attribute ? attribute->value : std::string_view(*port.default_text),
                    attribute ? attribute->value_offset : site.element.offset};
  if (IsScript(port)) return BindScript(given);
  const std::string_view key = KeyOf(given.text, port.name);
  return key.empty() ? BindLiteral(given) : BindKey(given, key);
}

std::uint32_t PortBinder::BindScript(const Given& given) {
  return given.attribute ? scripts_.Add(given.site, *given.attribute)
                         : scripts_.AddDefault(given.site, given.text);
}

std::uint32_t PortBinder::BindKey(const Given& given, std::string_view key) {
  const SlotIndex slot = keys_.Resolve(key, given.site.scope);
  keys_.SetType(slot, given.entry.manifest.id, given.port, given.site.document, given.offset);
  return slot;
}

std::uint32_t PortBinder::BindLiteral(const Given& given) {
  const PortDeclaration& port = given.port;
  if (port.direction != PortDirection::kInput) {
    problems_.Error(
        given.site.document, given.offset,
        std::string(ToString(port.direction)) + " " + Quoted(port.name) + " needs a key",
        "write {key}");
    return kNoSlot;
  }
  Value value;
  if (!port.type) {
    value = GuessValue(given.text);
  } else if (!value.Parse(*port.type, given.text)) {
    ReportLiteral(given);
  }
  return keys_.AddSlot("", given.site.scope, port.type, std::move(value));
}

void PortBinder::ReportLiteral(const Given& given) {
  problems_.Error(given.site.document, given.offset,
                  Quoted(given.text) + " is not a value for port " + Quoted(given.port.name) +
                      " of " + given.entry.manifest.id,
                  std::string("expected ") + given.port.type->name);
}

}  // namespace coppice
