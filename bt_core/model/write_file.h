// Saving without risk: at every moment, also when the power goes, the file is either the old one or
// the new one.
#ifndef COPPICE_BT_CORE_MODEL_WRITE_FILE_H_
#define COPPICE_BT_CORE_MODEL_WRITE_FILE_H_

#include <string>
#include <string_view>

#include "bt_core/base/diagnostic.h"

namespace coppice {

/// Writes a temporary file beside `path`, waits until it is on the disk, and renames it.
/// Permissions of an existing file are kept; a symbolic link stays one, and its target is replaced.
/// What is no file (a device, a pipe, a folder) is not.
/// False, with the reason in `diagnostics`, if that fails; then the old file is as it was.
bool WriteFile(const std::string& path, std::string_view text, Diagnostics& diagnostics);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_MODEL_WRITE_FILE_H_
