// The command line of coppice-edit.
#ifndef COPPICE_EDITOR_APP_EDIT_OPTIONS_H_
#define COPPICE_EDITOR_APP_EDIT_OPTIONS_H_

#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/command_line.h"
#include "editor/theme/palette.h"

namespace coppice::editor {

struct EditOptions {
  std::optional<int> exit;  ///< as in Options
  std::vector<std::string> files;
  std::vector<std::string> robots;  ///< host:port
  std::vector<std::string> models;
  std::string picture;       ///< PNG file; empty: none
  double picture_every = 0;  ///< seconds; 0: at the end only
  int width = 0;             ///< 0: as the last time
  int height = 0;
  std::optional<PaletteName> palette;  ///< nothing: as the last time
  bool reduce_motion = false;
  bool headless = false;
  double run_for = 0;  ///< seconds; 0: until told to end
};

const Command& EditCommand();

EditOptions ParseEditOptions(const std::vector<std::string>& arguments);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_APP_EDIT_OPTIONS_H_
