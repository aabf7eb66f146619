// The node types of a Registry as an XML schema: for text editors that complete and check XML.
//
// It allows what is right and refuses misspelt nodes and ports, missing ones, wrong numbers of
// children and literals that are no number. It does not see keys, scripts and SubTrees: for these
// there is `coppice check`.
#ifndef COPPICE_BT_CORE_ENGINE_COMPILE_SCHEMA_H_
#define COPPICE_BT_CORE_ENGINE_COMPILE_SCHEMA_H_

#include <string>

#include "bt_core/engine/registry.h"

namespace coppice {

/// An XML Schema 1.0 document (W3C, 2004). Nodes may be written in the compact form, <Drive
/// goal="1"/>, and in the generic one, <Action ID="Drive" goal="1"/>, whose ports are not checked.
std::string WriteSchema(const Registry& registry);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_COMPILE_SCHEMA_H_
