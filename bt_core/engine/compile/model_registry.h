// Node types that are known from a file only: good for checking trees where the robot's own program
// is not at hand. Trees that use them cannot run.
#ifndef COPPICE_BT_CORE_ENGINE_COMPILE_MODEL_REGISTRY_H_
#define COPPICE_BT_CORE_ENGINE_COMPILE_MODEL_REGISTRY_H_

#include <vector>

#include "bt_core/base/diagnostic.h"
#include "bt_core/engine/registry.h"
#include "bt_core/model/project.h"

namespace coppice {

/// Adds the models of the project (what WriteModels writes, or the peer's generator) that the
/// registry does not know yet. A type that the engine does not know takes any text; two ports of
/// different unknown types do not fit together. Whether an input is mandatory is not in a model, so
/// none is.
void AddModels(const Project& models, Registry& registry);
/// The same for these.
void AddModels(const std::vector<const NodeModel*>& models, Registry& registry);

/// A model that contradicts the built-in node of the same name speaks of another node: the built-in
/// one is taken out of the registry, with a warning at the model. To contradict is to be of another
/// category, to have a port that the other has not, or not to have one that it needs.
void RemoveContradicted(const Project& models, Registry& registry, Diagnostics& diagnostics);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_COMPILE_MODEL_REGISTRY_H_
