// Node types of well-known programs, by the model files in bt_core/engine/models: their trees can
// be checked and edited where nobody gives a model. A set counts when a project uses two of its
// types as the set describes them, so a leaf that has its name by chance stays what it was.
#ifndef COPPICE_BT_CORE_ENGINE_COMPILE_SHIPPED_MODELS_H_
#define COPPICE_BT_CORE_ENGINE_COMPILE_SHIPPED_MODELS_H_

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "bt_core/engine/registry.h"
#include "bt_core/model/project.h"

namespace coppice {

struct ShippedModels {
  std::string name;  ///< of the program: "Nav2"
  Project models;
};

/// All sets. Made at the first call; good for as long as the program runs.
const std::vector<ShippedModels>& AllShippedModels();

/// What the documents tell about one set.
struct ShippedTypes {
  const ShippedModels* set = nullptr;
  /// The types that are known by the set from now on: all that nobody else describes, but for those
  /// that a document uses in another way.
  std::vector<const NodeModel*> types;
  std::vector<Diagnostic> misfits;  ///< one for each type that is used in another way
};

/// The sets that count for these documents. `is_known` tells of the ID of a type whether somebody
/// else describes it.
std::vector<ShippedTypes> FindShippedTypes(const std::vector<const Document*>& documents,
                                           const std::function<bool(std::string_view)>& is_known);

/// Adds those types to the registry, and what is used in another way as warnings.
void AddShippedModels(const Project& project, Registry& registry, Diagnostics& diagnostics);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_COMPILE_SHIPPED_MODELS_H_
