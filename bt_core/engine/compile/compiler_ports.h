// The ports of a node: each attribute becomes the slot of a key, a literal of the port's type, or a
// script.
#ifndef COPPICE_BT_CORE_ENGINE_COMPILE_COMPILER_PORTS_H_
#define COPPICE_BT_CORE_ENGINE_COMPILE_COMPILER_PORTS_H_

#include <string_view>
#include <vector>

#include "bt_core/engine/compile/compiler_problems.h"
#include "bt_core/engine/compile/compiler_scripts.h"
#include "bt_core/engine/compile/compiler_types.h"
#include "bt_core/engine/compile/keys.h"
#include "bt_core/engine/compiler_site.h"
#include "bt_core/engine/program.h"

namespace coppice {

class PortBinder {
 public:
  PortBinder(KeyTable& keys, SlotTypes& types, ScriptTable& scripts, Problems& problems)
      : keys_(keys), types_(types), scripts_(scripts), problems_(problems) {}

  /// Appends one binding for each declared port of the node, in the order of the declarations. A
  /// literal that the node copies to an output, as SetBlackboard does, gets the type of the key.
  void Bind(const Registry::Entry& entry, const Site& site, std::vector<PortBinding>& ports);

 private:
  // A port of a node, and what the XML or else the declaration gives to it.
  struct Given {
    const Registry::Entry& entry;
    const PortDeclaration& port;
    const Site& site;
    const Attribute* attribute;  // null: the default
    std::string_view text;
    std::uint32_t offset;
  };

  void CheckNames(const Registry::Entry& entry, const Site& site);
  PortBinding BindPort(const Registry::Entry& entry, const PortDeclaration& port, const Site& site);
  SlotIndex BindKey(const Given& given, std::string_view key);
  ScriptIndex BindScript(const Given& given);
  SlotIndex BindLiteral(const Given& given);
  SlotIndex ReportNoKey(const Given& given);
  SlotIndex BindUntypedLiteral(const Given& given);
  void BindCopies(const Registry::Entry& entry, const Site& site, const PortBinding* ports);
  void ReportLiteral(const Given& given);

  KeyTable& keys_;
  SlotTypes& types_;
  ScriptTable& scripts_;
  Problems& problems_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_COMPILE_COMPILER_PORTS_H_
