// The scripts of a tree: those in ports of type ScriptCode and those of guards and hooks. They are
// gathered while the ports are bound and compiled at the end: only then it is known which type the
// ports give to a key.
#ifndef COPPICE_BT_CORE_ENGINE_COMPILE_COMPILER_SCRIPTS_H_
#define COPPICE_BT_CORE_ENGINE_COMPILE_COMPILER_SCRIPTS_H_

#include <cstdint>
#include <string_view>
#include <vector>

#include "bt_core/engine/compile/compiler_problems.h"
#include "bt_core/engine/compile/compiler_types.h"
#include "bt_core/engine/compile/keys.h"
#include "bt_core/engine/compiler_site.h"
#include "bt_core/engine/program.h"

namespace coppice {

class ScriptTable {
 public:
  ScriptTable(KeyTable& keys, const SlotTypes& types, Problems& problems)
      : keys_(keys), types_(types), problems_(problems) {}

  /// A script that stands in an attribute of a node; returns its number in Program::scripts. The
  /// document must outlive the table.
  ScriptIndex Add(const Site& site, const Attribute& attribute, ScriptUse use);

  /// A script that is the default of a port. `text` must outlive the table.
  ScriptIndex AddDefault(const Site& site, std::string_view text, ScriptUse use);

  /// About what they take when they are compiled.
  std::size_t bytes() const { return bytes_; }

  /// Compiles what was added. Without a problem script k lies at `scripts[k]` afterwards.
  void Compile(const ScriptConstants& constants, std::vector<Script>& scripts);

 private:
  struct Pending {
    const Document* document;
    const Attribute* attribute;  // null for a default
    std::uint32_t offset;        // of the element
    std::string_view text;
    ScopeIndex scope;
    ScriptUse use;
  };

  ScriptIndex Add(const Pending& pending);
  void Report(const Pending& pending, ScriptProblem problem);

  KeyTable& keys_;
  const SlotTypes& types_;
  Problems& problems_;
  std::vector<Pending> pending_;
  std::size_t bytes_ = 0;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_COMPILE_COMPILER_SCRIPTS_H_
