// Stand-ins for the leaves and decorators that only a robot's program knows: they have the ports
// that the tree gives them, so keys are there and can be set and seen, but leaves can do nothing:
// scripts play them. A decorator returns what its child returns, but only if a model says that
// there is such a decorator: without one it may be misspelt.
//
//   auto registry = ScenarioRegistry(*project);
//   auto program = Compile(project, registry, diagnostics);
#ifndef COPPICE_BT_CORE_TESTING_STAND_IN_H_
#define COPPICE_BT_CORE_TESTING_STAND_IN_H_

#include <memory>

#include "bt_core/engine/registry.h"
#include "bt_core/model/project.h"

namespace coppice {

/// The nodes of `known` (without it the built-in ones), and a stand-in for every other leaf or
/// decorator of the project. Its ports are those of its model in the project, in `models` (may be
/// null) or among those of well-known programs (shipped_models.h), or without a model the
/// attributes that it has anywhere in the project, of any type.
std::shared_ptr<const Registry> ScenarioRegistry(const Project& project,
                                                 const Project* models = nullptr,
                                                 std::shared_ptr<Registry> known = nullptr);

/// True for the type of a leaf's stand-in.
bool IsStandIn(const Registry::Entry& entry);

/// True for a type that only a script can play: a leaf's stand-in, or a decorator without model.
bool NeedsScript(const Registry::Entry& entry);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_TESTING_STAND_IN_H_
