// The files of the editor for browsers, which lie in one folder.
//
//   const WebFiles files("/usr/share/coppice/web");
//   files.Find("/");                                  // index.html
#ifndef COPPICE_BT_CORE_LIVE_WEB_FILES_H_
#define COPPICE_BT_CORE_LIVE_WEB_FILES_H_

#include <optional>
#include <string>
#include <string_view>

namespace coppice {

struct WebFile {
  const char* type;  ///< a media type
  std::string bytes;
};

class WebFiles {
 public:
  explicit WebFiles(std::string folder) : folder_(std::move(folder)) {}

  /// `target` is that of an HTTP request; any bytes may be handed in. Nothing outside the folder
  /// and nothing that is no part of a page is ever given.
  std::optional<WebFile> Find(std::string_view target) const;

 private:
  const std::string folder_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_WEB_FILES_H_
