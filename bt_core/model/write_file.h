// Saving without risk: at every moment, also when the power goes, the file is either the old one or
// the new one.
#ifndef COPPICE_BT_CORE_MODEL_WRITE_FILE_H_
#define COPPICE_BT_CORE_MODEL_WRITE_FILE_H_

#include <cstdint>
#include <string>
#include <string_view>

#include "bt_core/base/diagnostic.h"

namespace coppice {

/// Who may read what was written.
enum class FileReaders : std::uint8_t {
  kUsual,      ///< as with the file that was there; of a new one as the process's mask says
  kOwnerOnly,  ///< mode 0600, whatever it was before
};

/// What a file is called until it is whole, beside `path`: another name each time. WriteFile
/// removes what killed programs have left under such names.
std::string DraftName(const std::string& path);

/// Writes a temporary file beside `path`, waits until it is on the disk, renames it, and removes
/// what killed programs left over an hour ago, for which it looks every ten minutes. A symbolic
/// link stays one, its target is replaced; what is no file (a device, a pipe, a folder) is not.
/// False, with the reason in `diagnostics`, if that fails; then the old file is as it was.
bool WriteFile(const std::string& path, std::string_view text, Diagnostics& diagnostics,
               FileReaders readers = FileReaders::kUsual);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_MODEL_WRITE_FILE_H_
