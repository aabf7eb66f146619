// The files of the editor for browsers, which lie in one folder.
//
//   const WebFiles files("/usr/share/coppice/web");
//   files.Find("/");                                  // index.html
//
// Beside a file may lie the same compressed: index.wasm.gz. Who accepts it gets that.
#ifndef COPPICE_BT_CORE_LIVE_WEB_WEB_FILES_H_
#define COPPICE_BT_CORE_LIVE_WEB_WEB_FILES_H_

#include <optional>
#include <string>
#include <string_view>

namespace coppice {

struct WebFile {
  const char* type;  ///< a media type
  std::string path;
  bool is_gzipped = false;  ///< the path is that of the compressed file
};

/// Whether a client takes gzip, by the field Accept-Encoding of its request (RFC 9110, 12.5.3).
bool AcceptsGzip(std::string_view accept_encoding);

class WebFiles {
 public:
  explicit WebFiles(std::string folder) : folder_(std::move(folder)) {}

  /// `target` is that of an HTTP request; any bytes may be handed in. Nothing outside the folder
  /// and nothing that is no part of a page is ever given. A compressed file that is older than the
  /// other is not looked at.
  std::optional<WebFile> Find(std::string_view target, bool accepts_gzip = false) const;

 private:
  const std::string folder_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_WEB_WEB_FILES_H_
