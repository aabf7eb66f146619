// What the verbs `export` and `diff` have in common: options that say how a picture looks.
#ifndef COPPICE_EDITOR_EXPORT_VERB_OPTIONS_H_
#define COPPICE_EDITOR_EXPORT_VERB_OPTIONS_H_

#include <string>
#include <vector>

#include "bt_core/base/command_line.h"
#include "bt_core/base/outcome.h"
#include "editor/export/write_picture.h"
#include "editor/scene/forest.h"

namespace coppice::editor {

struct PictureOrder {
  std::string path;                 ///< empty: no picture
  float pixels = 2;                 ///< of a PNG
  std::vector<std::string> models;  ///< files
  TreePainting painting;            ///< without trees
};

std::vector<CommandOption> PictureOptions();

/// A problem if a value is not what was expected.
Expected<PictureOrder> ReadPictureOrder(const Options& options);

/// What is known of the types in the forest; also by these files.
NodeModels ModelsFor(const Forest& forest, const std::vector<std::string>& files,
                     Diagnostics& diagnostics);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_EXPORT_VERB_OPTIONS_H_
