// What is known of the node types: category, description and ports by ID.
//
// The built-in types are known from the engine. The others come from a <TreeNodesModel>, which
// stands in a project's file, in a file of its own, or in what a running robot sends.
#ifndef COPPICE_EDITOR_SCENE_NODE_MODELS_H_
#define COPPICE_EDITOR_SCENE_NODE_MODELS_H_

#include <map>
#include <string>
#include <string_view>

#include "bt_core/model/document.h"
#include "bt_core/model/node_model.h"

namespace coppice::editor {

inline constexpr char kBuiltIn[] = "built-in";

/// `document` is not used: models come from several projects and robots.
struct KnownModel : NodeModel {
  std::string source;  ///< kBuiltIn, "file:line" of the model, or who told it
};

class NodeModels {
 public:
  /// Knows the built-in types.
  NodeModels();

  /// Adds the models of every <TreeNodesModel> in the document; a type that is known already is
  /// replaced, but for the built-in ones. What is no model is left out: the check of the file
  /// reports it.
  void AddFrom(const Document& document);
  /// The same of a text that no file holds: `teller` is the source of its models.
  void AddTold(const Document& document, const std::string& teller);

  /// The model of that ID, or null.
  const KnownModel* Find(std::string_view id) const;

  const std::map<std::string, KnownModel, std::less<>>& all() const { return models_; }

 private:
  void Add(const Document& document, const std::string* teller);

  std::map<std::string, KnownModel, std::less<>> models_;
};

/// The type of a port in words: what models write for a port of any type says nothing to users.
std::string_view TypeText(std::string_view type);

/// What is known of the types in these trees: the built-in ones, what `given` describes, what the
/// trees describe themselves (the last one counts), and, where none of them does, the nodes of
/// well-known programs (shipped_models.h).
NodeModels ModelsFor(const std::vector<const Document*>& given,
                     const std::vector<const Document*>& trees);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_SCENE_NODE_MODELS_H_
