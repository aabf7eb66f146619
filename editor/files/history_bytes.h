// The undo history as bytes, so that it can be kept on the disk. Documents are not among them: who
// reads the steps again parses what he needs.
#ifndef COPPICE_EDITOR_FILES_HISTORY_BYTES_H_
#define COPPICE_EDITOR_FILES_HISTORY_BYTES_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/files/history.h"

namespace coppice::editor {

/// A file of the history as it is behind the steps that are done.
struct KnownText {
  std::string path;
  std::uint64_t size = 0;
  std::uint32_t checksum = 0;  ///< CRC-32C
};

KnownText DescribeText(std::string path, std::string_view text);
inline bool IsText(const KnownText& known, std::string_view text) {
  const KnownText there = DescribeText({}, text);
  return there.size == known.size && there.checksum == known.checksum;
}

struct StoredHistory {
  std::vector<KnownText> texts;
  std::vector<Step> steps;  ///< each later than the one before it
  std::size_t done = 0;     ///< so many of them are done
};

/// At most about so many bytes: steps that are further away from what is shown are left out.
std::string WriteHistory(const StoredHistory& history, std::size_t limit);

/// Nothing if these are not the bytes of a history, or if some of them were changed.
std::optional<StoredHistory> ReadHistory(std::string_view bytes);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_FILES_HISTORY_BYTES_H_
