// Whether files are still there, asked by what is painted again and again.
#ifndef COPPICE_EDITOR_FILES_PATH_CHECK_H_
#define COPPICE_EDITOR_FILES_PATH_CHECK_H_

#include <map>
#include <string>

namespace coppice::editor {

/// Looks at the disk at most once a second for each path; a slow disk slows no frame between.
class PathCheck {
 public:
  /// Whether it is there. `now`: seconds of the editor.
  bool IsThere(const std::string& path, double now);

 private:
  struct Seen {
    bool is_there;
    double at;
  };
  std::map<std::string, Seen> seen_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_FILES_PATH_CHECK_H_
