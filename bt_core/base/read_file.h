// The whole of a file at once.
#ifndef COPPICE_BT_CORE_BASE_READ_FILE_H_
#define COPPICE_BT_CORE_BASE_READ_FILE_H_

#include <cstddef>
#include <optional>
#include <string>

#include "bt_core/base/diagnostic.h"

namespace coppice {

/// A longer one is no file that people write: /dev/zero has no end.
inline constexpr std::size_t kLongestFile = std::size_t{64} << 20;

/// Its bytes; nothing if it cannot be read, is a folder or too long; what is no file may not be
/// longer than kLongestFile. Does not wait for a pipe that nobody writes, nor for a device.
std::optional<std::string> ReadFile(const std::string& path, std::size_t longest = kLongestFile);

/// The same; the reason is in `diagnostics`.
std::optional<std::string> ReadFile(const std::string& path, Diagnostics& diagnostics,
                                    std::size_t longest = kLongestFile);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_BASE_READ_FILE_H_
