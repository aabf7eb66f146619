// The attributes of a node that begin with an underscore: guards, hooks and what editors leave.
//
// None may be ignored silently: a tree that relies on a guard would run without it.
#ifndef COPPICE_BT_CORE_ENGINE_COMPILE_COMPILER_GUARDS_H_
#define COPPICE_BT_CORE_ENGINE_COMPILE_COMPILER_GUARDS_H_

#include <vector>

#include "bt_core/engine/compile/compiler_problems.h"
#include "bt_core/engine/compile/compiler_scripts.h"
#include "bt_core/engine/compiler_site.h"
#include "bt_core/engine/program.h"

namespace coppice {

class GuardReader {
 public:
  GuardReader(ScriptTable& scripts, Problems& problems) : scripts_(scripts), problems_(problems) {}

  /// Reads the guards and hooks of a node, which is the highest so far, and appends them. False if
  /// it has none.
  bool Read(const Site& site, NodeIndex node, std::vector<GuardRecord>& guards);

 private:
  void CheckMetadata(const Site& site, const Attribute& attribute);

  ScriptTable& scripts_;
  Problems& problems_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_COMPILE_COMPILER_GUARDS_H_
